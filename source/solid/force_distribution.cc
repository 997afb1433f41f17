#include <stickslip/solid/force_distribution.h>

#include <stickslip/base/in_space.h>

#include <stickslip/mesh/by_kind.h>
#include <stickslip/mesh/reference_cells.h>

#include <stickslip/solid/direction_parameters.h>
#include <stickslip/solid/symmetry_cuts.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/numbers.h>

#include <deal.II/fe/fe_values.h>

#include <functional>
#include <memory>
#include <vector>

namespace stickslip
{
  namespace
  {
    template <int dim>
    Tensor<1, dim>
    in_model(const Tensor<1, 3> &v)
    {
      Tensor<1, dim> result;
      for (unsigned int d = 0; d < dim; ++d)
        result[d] = v[d];
      return result;
    }



    /// Of the space that @p directions span (none is a multiple of another).
    template <int dim>
    std::vector<Tensor<1, 3>>
    orthonormal(const std::vector<Tensor<1, dim>> &directions)
    {
      constexpr double          none = 1e-6;
      std::vector<Tensor<1, 3>> basis;
      for (const auto &direction : directions)
        {
          Tensor<1, 3> n = in_space<dim>(direction);
          for (const auto &m : basis)
            n -= (n * m) * m;
          if (n.norm() > none)
            basis.push_back(n / n.norm());
        }
      return basis;
    }



    /// Calls @p at_point with all points of this rank's faces of the boundary,
    /// and with the area that each stands for.
    template <int dim>
    void
    for_each_point(const hp::MappingCollection<dim>        &mapping,
                   const DoFHandler<dim>                   &dof_handler,
                   const std::set<types::boundary_id>      &boundary,
                   const CrossSection                      &section,
                   const UpdateFlags                        flags,
                   const std::function<void(const FEFaceValues<dim> &,
                                            const unsigned int,
                                            const double)> &at_point)
    {
      const ByKind<FEFaceValues<dim>> values_of(
        dof_handler.get_fe_collection(),
        [&](const FiniteElement<dim> &fe, const unsigned int kind) {
          return std::make_unique<FEFaceValues<dim>>(
            mapping[kind],
            fe,
            gauss_quadrature<dim - 1>(faces_of<dim>(fe.reference_cell()),
                                      fe.degree + 2),
            flags | update_quadrature_points | update_JxW_values);
        });
      for (const auto &cell : dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() && cell->at_boundary())
          for (const unsigned int f : cell->face_indices())
            if (cell->face(f)->at_boundary() &&
                boundary.count(cell->face(f)->boundary_id()) > 0)
              {
                FEFaceValues<dim> &values = values_of[cell];
                values.reinit(cell, f);
                for (const unsigned int q : values.quadrature_point_indices())
                  at_point(values,
                           q,
                           values.JxW(q) *
                             section.circumference(values.quadrature_point(q)));
              }
    }
  } // namespace



  template <int dim>
  ForceDistribution<dim>::ForceDistribution(
    const BoundaryConditionParameters      &parameters,
    const std::shared_ptr<const Amplitude> &amplitude,
    const std::string                      &path)
    : reference_point(
        axis_of<dim>(parameters.rotation_axis, parameters.rotation_centre, path)
          .second)
  {
    const auto law = [&](const std::string &text,
                         const unsigned int n,
                         const std::string &name) {
      std::shared_ptr<SpaceTimeFunction<dim>> function;
      if (!text.empty())
        {
          function =
            std::make_shared<SpaceTimeFunction<dim>>(text, n, path + name);
          function->multiply_by(amplitude);
        }
      return function;
    };
    force_law  = law(parameters.force, dim, "/Force");
    torque_law = law(parameters.torque, dim == 2 ? 1 : 3, "/Torque");
  }



  template <int dim>
  void
  ForceDistribution<dim>::measure(
    const hp::MappingCollection<dim>               &mapping,
    const DoFHandler<dim>                          &dof_handler,
    const std::set<types::boundary_id>             &boundary,
    const CrossSection                             &section,
    const std::vector<PrescribedDisplacement<dim>> &conditions)
  {
    const auto cuts =
      normals_of_symmetry_cuts(mapping, dof_handler, boundary, conditions);
    const MPI_Comm communicator = dof_handler.get_communicator();
    Tensor<1, dim> first_moment;
    area = 0.;
    for_each_point<dim>(mapping,
                        dof_handler,
                        boundary,
                        section,
                        update_default,
                        [&](const auto &values, const auto q, const double dA) {
                          area += dA;
                          first_moment += dA * values.quadrature_point(q);
                        });
    area   = Utilities::MPI::sum(area, communicator);
    centre = Point<dim>(Utilities::MPI::sum(first_moment, communicator) / area);
    arm    = in_space<dim>(reference_point - centre);
    for (const Tensor<1, 3> &n : orthonormal<dim>(cuts))
      arm -= (arm * n) * n;
    turning = 0.;
    if (section.is_axisymmetric) // no rotations
      return;

    Tensor<2, 3> inertia;
    for_each_point<dim>(mapping,
                        dof_handler,
                        boundary,
                        section,
                        update_default,
                        [&](const auto &values, const auto q, const double dA) {
                          const Tensor<1, 3> r =
                            in_space<dim>(values.quadrature_point(q) - centre);
                          inertia +=
                            dA * (r.norm_square() * unit_symmetric_tensor<3>() -
                                  outer_product(r, r));
                        });
    inertia = Utilities::MPI::sum(inertia, communicator);
    if (dim == 2) // rotations about z alone
      turning[2][2] = 1. / inertia[2][2];
    else
      turning = invert(inertia);
    if (dim == 3 && cuts.size() == 1)
      {
        const Tensor<1, 3> n = in_space<dim>(cuts[0]);
        turning += outer_product(n / (n * (inertia * n)) - turning * n, n);
      }
  }



  template <int dim>
  Tensor<1, 3>
  ForceDistribution<dim>::torque(const double time) const
  {
    Tensor<1, 3> result;
    if (!torque_law)
      return result;
    if (dim == 2)
      result[2] = torque_law->value(reference_point, time);
    else
      for (unsigned int k = 0; k < 3; ++k)
        result[k] = torque_law->value(reference_point, time, k);
    return result;
  }



  template <int dim>
  Tensor<1, dim>
  ForceDistribution<dim>::traction(const Point<dim> &X, const double time) const
  {
    const Tensor<1, dim> force =
      force_law ? force_law->vector(reference_point, time) : Tensor<1, dim>();
    const Tensor<1, 3> about_centre =
      torque(time) + cross_product_3d(arm, in_space<dim>(force));
    return force / area +
           in_model<dim>(cross_product_3d(turning * about_centre,
                                          in_space<dim>(X - centre)));
  }



  template <int dim>
  RigidReaction<dim>
  ForceDistribution<dim>::mean_motion(
    const hp::MappingCollection<dim>   &mapping,
    const DoFHandler<dim>              &dof_handler,
    const std::set<types::boundary_id> &boundary,
    const CrossSection                 &section,
    const LA::Vector                   &u,
    const double                        time) const
  {
    const FEValuesExtractors::Vector vector(0);
    std::vector<Tensor<1, dim>>      displacements;
    Tensor<1, dim>                   sum;
    Tensor<1, 3>                     moment;
    for_each_point<dim>(
      mapping,
      dof_handler,
      boundary,
      section,
      update_values,
      [&](const auto &values, const auto q, const double dA) {
        if (q == 0)
          {
            displacements.resize(values.n_quadrature_points);
            values[vector].get_function_values(u, displacements);
          }
        sum += dA * displacements[q];
        moment +=
          dA *
          cross_product_3d(in_space<dim>(values.quadrature_point(q) - centre),
                           in_space<dim>(displacements[q]));
      });
    const MPI_Comm     communicator = dof_handler.get_communicator();
    const Tensor<1, 3> rotation =
      transpose(turning) * Utilities::MPI::sum(moment, communicator);
    RigidReaction<dim> result;
    result.displacement = Utilities::MPI::sum(sum, communicator) / area +
                          in_model<dim>(cross_product_3d(rotation, arm));
    const Tensor<1, 3> torque_now = torque(time);
    for (unsigned int k = 0; k < RigidReaction<dim>::n_rotations; ++k)
      {
        const unsigned int d = dim == 2 ? 2 : k;
        result.moment[k]     = torque_now[d];
        result.rotation[k]   = 180. / numbers::PI * rotation[d];
      }
    return result;
  }

  template class ForceDistribution<2>;
  template class ForceDistribution<3>;
} // namespace stickslip
