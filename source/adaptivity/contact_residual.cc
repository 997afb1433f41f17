#include <stickslip/adaptivity/contact_residual.h>

#include <stickslip/adaptivity/contact_samples.h>

#include <stickslip/mesh/reference_cells.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace stickslip
{
  namespace
  {
    // What is sent about a face, of n numbers for its nodes: n forces, n
    // tractions at the nodes, what is left of the contact law.

    unsigned int
    first_traction(const unsigned int n)
    {
      return n;
    }

    unsigned int
    law_error_at(const unsigned int n)
    {
      return 2 * n;
    }

    unsigned int
    message_size(const unsigned int n)
    {
      return 2 * n + 1;
    }



    template <int dim>
    void
    add_force(const std::vector<double> &N,
              const Tensor<1, dim>      &force,
              std::vector<double>       &numbers)
    {
      for (unsigned int j = 0; j < N.size(); ++j)
        for (unsigned int c = 0; c < dim; ++c)
          numbers[j * dim + c] += N[j] * force[c];
    }



    /// See ContactResidual; per area.
    template <int dim>
    double
    law_error(const SampledPoint<dim> &point, const ContactSample<dim> &sample)
    {
      const double k           = point.stiffness;
      const double penetration = std::max(sample.d_n, 0.);
      double       error       = k * penetration * penetration;
      if (!point.closed)
        return error;
      // n points into the master, away from which the slave is pressed
      const double         p       = -(point.traction * point.n);
      const Tensor<1, dim> t_t     = point.traction + p * point.n;
      const double         s       = point.threshold;
      const double         outside = std::max(t_t.norm() - s, 0.);
      const double         tension = std::max(-p, 0.);
      error += std::max(p, 0.) * std::abs(sample.d_n);
      error += std::max(s * sample.d_t.norm() + t_t * sample.d_t, 0.);
      error += (outside * outside + tension * tension) / k;
      return error;
    }



    /// Tractions of a pair with the nodal rule, whose points are the nodes: no
    /// forces are needed, which would oscillate when projected. A node without
    /// a point takes the mean of the others of its face.
    template <int dim>
    void
    add_tractions_at_nodes(ContactAssembler<dim> &contact,
                           ContactPair<dim>      &pair,
                           const unsigned int     n,
                           FaceMessages<dim>     &messages)
    {
      const unsigned int n_nodes = pair.displacement_shape.n_nodes();
      std::vector<std::map<unsigned int, Tensor<1, dim>>> known(
        pair.slave_faces.size());
      for (const ContactPoint<dim> &point : pair.points)
        {
          const auto &N =
            pair.table.displacement[point.geometry.quadrature_index].value;
          const unsigned int k =
            std::max_element(N.begin(), N.end()) - N.begin();
          const SurfaceFace<dim> &face =
            pair.slave_faces[point.geometry.slave_face].face;
          if (pair.excluded_keys().count(face.dofs[k * dim]) > 0)
            continue; // a support has what there would be
          const ContactEvaluation<dim> &state = contact.evaluate(pair, point);
          known[point.geometry.slave_face][k] =
            point.pairing.paired && state.status.closed
              ? -1. * state.response.traction
              : Tensor<1, dim>();
        }
      for (unsigned int f = 0; f < known.size(); ++f)
        {
          if (known[f].empty())
            continue;
          Tensor<1, dim> mean;
          for (const auto &entry : known[f])
            mean += entry.second / static_cast<double>(known[f].size());
          std::vector<double> &numbers =
            messages.to(pair.slave_faces[f].face, message_size(n));
          for (unsigned int k = 0; k < n_nodes; ++k)
            {
              const auto           entry = known[f].find(k);
              const Tensor<1, dim> t =
                entry != known[f].end() ? entry->second : mean;
              for (unsigned int c = 0; c < dim; ++c)
                numbers[first_traction(n) + k * dim + c] += t[c];
            }
        }
    }



    /// Tractions of the master surfaces of pairs without segments, from the
    /// forces on their nodes over the areas of the nodes. The force of a single
    /// point acts on one face, also if the point is opposite to a vertex; that
    /// of a node is shared by all faces around it.
    template <int dim>
    class NodalTractions
    {
    public:
      explicit NodalTractions(const DofLayout<dim> &dofs)
        : dofs(dofs)
        , forces(dofs.owned, dofs.dof_handler.get_communicator())
        , areas(forces)
      {}

      void
      add(const ContactSample<dim> &sample, const Tensor<1, dim> &force)
      {
        for (unsigned int j = 0; j < sample.N_master.size(); ++j)
          for (unsigned int c = 0; c < dim; ++c)
            forces(sample.master.dofs[j * dim + c]) +=
              sample.N_master[j] * force[c];
      }

      /// Sends the tractions at the nodes of the owned master faces of the
      /// pairs. Collective.
      void
      send(const ContactAssembler<dim> &contact, FaceMessages<dim> &messages)
      {
        const auto for_each_face = [&](const auto &visit) {
          for (const auto &pair : contact.contact_pairs())
            if (!pair->mortar && pair->patch->tool() == nullptr)
              for (const SurfaceFace<dim> &face : pair->patch->owned_faces())
                visit(face, pair->displacement_shape);
        };
        // a face may be in several pairs; its nodes have the forces of all
        std::set<FaceId> seen;
        for_each_face([&](const auto &face, const auto &shape) {
          if (seen.insert(face.id).second)
            add_areas(face, shape);
        });
        seen.clear();
        const LA::Vector all_forces = ghosted(forces);
        const LA::Vector all_areas  = ghosted(areas);
        for_each_face([&](const auto &face, const auto &) {
          if (!seen.insert(face.id).second)
            return;
          const unsigned int   n       = face.n_nodes * dim;
          std::vector<double> &numbers = messages.to(face, message_size(n));
          for (unsigned int i = 0; i < n; ++i)
            numbers[first_traction(n) + i] +=
              nodal_value(face, i, all_forces, all_areas);
        });
      }

    private:
      const DofLayout<dim> &dofs;
      LA::Vector            forces, areas;

      void
      add_areas(const SurfaceFace<dim> &face, const FaceShape<dim> &shape)
      {
        const auto quadrature =
          gauss_quadrature<dim - 1>(shape.reference_cell(), shape.degree() + 1);
        const auto           nodes = face.undeformed_nodes();
        FaceShapeValues<dim> values;
        for (unsigned int q = 0; q < quadrature.size(); ++q)
          {
            shape.evaluate(quadrature.point(q), values);
            const double area =
              quadrature.weight(q) *
              surface_normal<dim>(surface_tangents<dim>(values.gradient, nodes))
                .norm();
            for (unsigned int j = 0; j < face.n_nodes; ++j)
              for (unsigned int c = 0; c < dim; ++c)
                areas(face.dofs[j * dim + c]) += values.value[j] * area;
          }
      }

      /// Force over area; of a node without area (vertices of quadratic
      /// triangles) those of all nodes of the face.
      static double
      nodal_value(const SurfaceFace<dim> &face,
                  const unsigned int      i,
                  const LA::Vector       &forces,
                  const LA::Vector       &areas)
      {
        const double negligible = 1e-8 * std::pow(face.diameter, dim - 1.);
        if (areas(face.dofs[i]) > negligible)
          return forces(face.dofs[i]) / areas(face.dofs[i]);
        double force = 0., area = 0.;
        for (unsigned int j = i % dim; j < face.n_nodes * dim; j += dim)
          {
            force += forces(face.dofs[j]);
            area += areas(face.dofs[j]);
          }
        return force / area;
      }

      LA::Vector
      ghosted(LA::Vector &sums) const
      {
        sums.compress(VectorOperation::add);
        LA::Vector all(dofs.owned,
                       dofs.relevant,
                       dofs.dof_handler.get_communicator());
        all = sums;
        return all;
      }
    };



    template <int dim>
    bool
    has_points_at_nodes(const ContactPair<dim> &pair)
    {
      return !pair.mortar &&
             has_one_multiplier_per_point(pair.parameters.quadrature);
    }



    /// Fills the messages about all faces. Collective.
    template <int dim>
    void
    collect(ContactProblem<dim> &problem,
            const unsigned int   n,
            FaceMessages<dim>   &messages)
    {
      ContactAssembler<dim> &contact = problem.contact();
      NodalTractions<dim>    on_masters(problem.layout());
      for_each_sample<dim>(
        contact,
        [&](const ContactPair<dim>   &pair,
            const SampledPoint<dim>  &point,
            const ContactSample<dim> &sample) {
          const Tensor<1, dim> force = sample.weight * point.traction;
          std::vector<double> &slave =
            messages.to(sample.slave, message_size(n));
          if (!has_points_at_nodes(pair))
            add_force(sample.N_slave, force, slave);
          // shape functions of degree 2 are negative somewhere; errors are not
          if (!pair.parameters.is_bilateral())
            slave[law_error_at(n)] +=
              std::abs(sample.weight) * law_error(point, sample);
          if (pair.patch->tool() != nullptr)
            return; // nothing in a tool has an error
          if (!pair.mortar)
            return on_masters.add(sample, -force);
          add_force(sample.N_master,
                    -force,
                    messages.to(sample.master, message_size(n)));
        });
      for (const auto &pair : contact.contact_pairs())
        if (has_points_at_nodes(*pair))
          add_tractions_at_nodes(contact, *pair, n, messages);
      on_masters.send(contact, messages);
    }
  } // namespace



  template <int dim>
  ContactResidual<dim>::ContactResidual(ContactProblem<dim> &problem)
  {
    const DofLayout<dim> &dofs          = problem.layout();
    const auto           &triangulation = dofs.dof_handler.get_triangulation();
    const FaceShape<dim>  shape(dofs.degree(), faces_of<dim>(dofs.cells()));
    const unsigned int    n = shape.n_nodes() * dim;
    FaceMessages<dim>     messages;
    errors.reinit(triangulation.n_active_cells());

    collect(problem, n, messages);
    for (const auto &received : messages.exchange(triangulation))
      {
        const CellIterator cell(&triangulation,
                                received.cell->level(),
                                received.cell->index(),
                                &dofs.dof_handler);
        take_forces(problem, cell, received.face, received.numbers);
        const auto nodes =
          nodes_of_face(dofs.fe().base_element(0), received.face, shape);
        auto &at_nodes = tractions[{cell->active_cell_index(), received.face}];
        for (unsigned int j = 0; j < nodes.size(); ++j)
          for (unsigned int c = 0; c < dim; ++c)
            at_nodes[nodes[j]][c] +=
              received.numbers[first_traction(n) + j * dim + c];
        errors[cell->active_cell_index()] += received.numbers[law_error_at(n)];
      }
  }



  template <int dim>
  const std::map<unsigned int, Tensor<1, dim>> *
  ContactResidual<dim>::tractions_on(const CellIterator &cell,
                                     const unsigned int  face) const
  {
    const auto found = tractions.find({cell->active_cell_index(), face});
    return found == tractions.end() ? nullptr : &found->second;
  }



  template <int dim>
  void
  ContactResidual<dim>::take_forces(const ContactProblem<dim> &problem,
                                    const CellIterator        &cell,
                                    const unsigned int         face,
                                    const std::vector<double> &forces)
  {
    const DofLayout<dim>     &dofs = problem.layout();
    const FiniteElement<dim> &fe   = dofs.fe().base_element(0);
    const FaceShape<dim>      shape(dofs.degree(), faces_of<dim>(dofs.cells()));
    const auto                nodes = nodes_of_face(fe, face, shape);
    FEFaceValues<dim>         fe_values(
      dofs.mapping[0],
      fe,
      gauss_quadrature<dim - 1>(shape.reference_cell(), fe.degree + 1),
      update_values | update_JxW_values);
    fe_values.reinit(typename Triangulation<dim>::active_cell_iterator(cell),
                     face);
    FullMatrix<double> mass(nodes.size(), nodes.size());
    for (const unsigned int q : fe_values.quadrature_point_indices())
      for (unsigned int i = 0; i < nodes.size(); ++i)
        for (unsigned int j = 0; j < nodes.size(); ++j)
          mass(i, j) += fe_values.shape_value(nodes[i], q) *
                        fe_values.shape_value(nodes[j], q) * fe_values.JxW(q);
    mass.gauss_jordan();
    auto &at_nodes = tractions[{cell->active_cell_index(), face}];
    for (unsigned int i = 0; i < nodes.size(); ++i)
      for (unsigned int j = 0; j < nodes.size(); ++j)
        for (unsigned int c = 0; c < dim; ++c)
          at_nodes[nodes[i]][c] += mass(i, j) * forces[j * dim + c];
  }

  template class ContactResidual<2>;
  template class ContactResidual<3>;
} // namespace stickslip
