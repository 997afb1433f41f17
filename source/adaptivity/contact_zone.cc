#include <stickslip/adaptivity/contact_zone.h>

#include <stickslip/adaptivity/contact_samples.h>

#include <stickslip/contact/pairing/face_boxes.h>
#include <stickslip/contact/results/contact_results.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/mpi.h>

#include <deal.II/grid/cell_id.h>

#include <deal.II/numerics/rtree.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// What counts as a change where it meets something else.
    enum class Regime
    {
      open,
      held,
      slipping
    };

    Regime
    regime_of(const ContactState state)
    {
      if (!is_closed(state))
        return Regime::open;
      return state == ContactState::slip ? Regime::slipping : Regime::held;
    }



    /// Of a face, numbers of which add up over the faces around a node.
    template <int dim>
    class RegimesAtNodes
    {
    public:
      explicit RegimesAtNodes(const DofLayout<dim> &dofs)
        : dofs(dofs)
      {
        for (LA::Vector &n : numbers)
          n.reinit(dofs.owned, dofs.dof_handler.get_communicator());
      }

      void
      add(const types::global_dof_index node, const Regime regime)
      {
        numbers[static_cast<unsigned int>(regime)](node) += 1.;
      }

      /// Collective.
      void
      finish()
      {
        for (LA::Vector &n : numbers)
          {
            n.compress(VectorOperation::add);
            const LA::Vector sum(n);
            n.reinit(dofs.owned,
                     dofs.relevant,
                     dofs.dof_handler.get_communicator());
            n = sum;
          }
      }

      bool
      differ_at(const types::global_dof_index node) const
      {
        unsigned int n_regimes = 0;
        for (const LA::Vector &n : numbers)
          n_regimes += n(node) > 0. ? 1 : 0;
        return n_regimes > 1;
      }

    private:
      const DofLayout<dim>     &dofs;
      std::array<LA::Vector, 3> numbers; ///< of points, by first dof of nodes
    };



    /// Where on the slave faces of this rank, in the present configuration,
    /// points of different regimes are neighbours: half-way between two points
    /// of a face, and at the nodes between two faces. Collective.
    template <int dim>
    std::vector<Point<dim>>
    own_edges(ContactProblem<dim> &problem)
    {
      using Place = std::pair<Regime, Point<dim>>;
      std::vector<Point<dim>> edges;
      const auto              results = contact_results(problem.contact());
      RegimesAtNodes<dim>     at_nodes(problem.layout());
      // the slave faces, in the order of the results
      std::vector<const SurfaceFace<dim> *> faces;
      for (const auto &pair : problem.contact().contact_pairs())
        for (const SlaveFace<dim> &slave : pair->slave_faces)
          faces.push_back(&slave.face);
      const auto position = [&](const unsigned int f, const unsigned int j) {
        return results[f].reference_positions[j] + results[f].displacements[j];
      };

      for (unsigned int f = 0; f < faces.size(); ++f)
        {
          std::vector<Place> places;
          for (const auto &point : results[f].all_points())
            {
              // points of neighbours know where their nodes are, no position
              const Regime   regime = regime_of(point.state);
              Tensor<1, dim> place;
              for (unsigned int j = 0; j < point.shape_values.size(); ++j)
                {
                  place += point.shape_values[j] * position(f, j);
                  // a point at one node says nothing of the others
                  if (std::abs(point.shape_values[j]) > 1e-12)
                    at_nodes.add(faces[f]->dofs[j * dim], regime);
                }
              places.emplace_back(regime, place);
            }
          for (auto a = places.begin(); a != places.end(); ++a)
            for (auto b = places.begin(); b != a; ++b)
              if (a->first != b->first)
                edges.push_back(a->second + 0.5 * (b->second - a->second));
        }

      at_nodes.finish();
      for (unsigned int f = 0; f < faces.size(); ++f)
        for (unsigned int j = 0; j < faces[f]->n_nodes; ++j)
          if (at_nodes.differ_at(faces[f]->dofs[j * dim]))
            edges.push_back(position(f, j));
      return edges;
    }



    template <int dim>
    double
    distance_between(const BoundingBox<dim> &box, const Point<dim> &p)
    {
      Tensor<1, dim> beside;
      for (unsigned int d = 0; d < dim; ++d)
        beside[d] =
          std::max({box.lower_bound(d) - p[d], 0., p[d] - box.upper_bound(d)});
      return beside.norm();
    }
  } // namespace



  template <int dim>
  Vector<double>
  ContactZone<dim>::indicators(ContactProblem<dim> &problem,
                               const LA::BlockVector & /*x*/) const
  {
    const auto &triangulation =
      problem.layout().dof_handler.get_triangulation();
    FaceMessages<dim> in_zone;
    for_each_sample<dim>(
      problem.contact(),
      [&](const ContactPair<dim> &,
          const SampledPoint<dim>  &point,
          const ContactSample<dim> &sample) {
        // beside a node only where it has a share
        if ((point.closed && sample.weight > 0.) || -sample.d_n < distance)
          for (const auto *face : {&sample.slave, &sample.master})
            in_zone.to(*face, 1)[0] = 1.;
      });
    Vector<double> ones(triangulation.n_active_cells());
    for (const auto &received : in_zone.exchange(triangulation))
      ones[received.cell->active_cell_index()] = 1.;
    return ones;
  }



  template <int dim>
  Vector<double>
  ContactEdge<dim>::indicators(ContactProblem<dim> &problem,
                               const LA::BlockVector & /*x*/) const
  {
    ContactAssembler<dim> &contact = problem.contact();
    const auto            &triangulation =
      problem.layout().dof_handler.get_triangulation();
    std::vector<Point<dim>> edges;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(contact.get_communicator(),
                                    own_edges(problem)))
      edges.insert(edges.end(), of_rank.begin(), of_rank.end());
    const auto tree = pack_rtree(edges);

    Vector<double>              ones(triangulation.n_active_cells());
    std::vector<Tensor<1, dim>> positions;
    const auto                  look_at = [&](const SurfaceFace<dim> &face) {
      read_positions(face,
                     face.n_nodes,
                     problem.ghosted_displacement(),
                     positions);
      const BoundingBox<dim> box(
        std::vector<Point<dim>>(positions.begin(), positions.end()));
      const double            reach = std::max(distance, 0.1 * face.diameter);
      std::vector<Point<dim>> near;
      tree.query(boost::geometry::index::intersects(enlarged(box, reach)),
                 std::back_inserter(near));
      for (const Point<dim> &edge : near)
        if (distance_between(box, edge) <= reach)
          ones[triangulation.create_cell_iterator(CellId(face.id.cell))
                 ->active_cell_index()] = 1.;
    };
    for (const auto &pair : contact.contact_pairs())
      {
        for (const SlaveFace<dim> &slave : pair->slave_faces)
          look_at(slave.face);
        for (const SurfaceFace<dim> &master : pair->patch->owned_faces())
          look_at(master);
      }
    return ones;
  }

#define INSTANTIATE(dim)           \
  template class ContactZone<dim>; \
  template class ContactEdge<dim>;
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
