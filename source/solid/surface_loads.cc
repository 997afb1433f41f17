#include <stickslip/solid/surface_loads.h>

#include <stickslip/mesh/reference_cells.h>

#include <memory>

namespace stickslip
{
  namespace
  {
    template <int dim>
    Tensor<2, dim>
    part_in_plane(const Tensor<2, 3> &F)
    {
      Tensor<2, dim> part;
      for (unsigned int i = 0; i < dim; ++i)
        for (unsigned int J = 0; J < dim; ++J)
          part[i][J] = F[i][J];
      return part;
    }



    /// In 2D the cofactor has the stretch normal to the plane as a factor.
    template <int dim>
    double
    stretch_off_plane(const Tensor<2, 3> &F)
    {
      return dim == 2 ? F[2][2] : 1.;
    }
  } // namespace



  template <int dim>
  SurfaceLoads<dim>::SurfaceLoads(const hp::MappingCollection<dim> &mapping,
                                  const DoFHandler<dim>            &dof_handler,
                                  const std::vector<Load<dim>>     &loads)
    : values_of_faces(
        dof_handler.get_fe_collection(),
        [&](const FiniteElement<dim> &fe, const unsigned int kind) {
          return std::make_unique<FEFaceValues<dim>>(
            mapping[kind],
            fe.base_element(0),
            gauss_quadrature<dim - 1>(faces_of<dim>(fe.reference_cell()),
                                      fe.degree + 1),
            update_values | update_gradients | update_quadrature_points |
              update_normal_vectors | update_JxW_values);
        })
  {
    for (const Load<dim> &load : loads)
      for (const types::boundary_id id : load.boundary_ids)
        loads_of[id].push_back(&load);
  }



  template <int dim>
  bool
  SurfaceLoads<dim>::act_on(
    const typename DoFHandler<dim>::active_cell_iterator &cell) const
  {
    if (!loads_of.empty() && cell->at_boundary())
      for (const unsigned int face : cell->face_indices())
        if (cell->face(face)->at_boundary() &&
            loads_of.count(cell->face(face)->boundary_id()) > 0)
          return true;
    return false;
  }



  template <int dim>
  void
  SurfaceLoads<dim>::add_cell(
    const typename DoFHandler<dim>::active_cell_iterator &cell,
    const double                                          time,
    const bool                                            with_tangent,
    ElementArrays<dim>                                   &element)
  {
    if (loads_of.empty() || !cell->at_boundary())
      return;
    for (const unsigned int face : cell->face_indices())
      {
        if (!cell->face(face)->at_boundary())
          continue;
        const auto loads = loads_of.find(cell->face(face)->boundary_id());
        if (loads == loads_of.end())
          continue;
        FEFaceValues<dim> &fe_face_values = values_of_faces[cell];
        fe_face_values.reinit(
          typename Triangulation<dim>::active_cell_iterator(cell), face);
        for (const Load<dim> *load : loads->second)
          if (load->active.contains(time))
            add_load(*load, fe_face_values, time, with_tangent, element);
      }
  }



  template <int dim>
  void
  SurfaceLoads<dim>::add_load(const Load<dim>         &load,
                              const FEFaceValues<dim> &fe_face_values,
                              const double             time,
                              const bool               with_tangent,
                              ElementArrays<dim>      &element) const
  {
    const bool is_spring = load.type == BoundaryConditionType::spring;
    const bool follows = load.type == BoundaryConditionType::follower_pressure;
    for (const unsigned int q : fe_face_values.quadrature_point_indices())
      {
        Tensor<2, 3>   F;
        Tensor<1, dim> u;
        if (follows)
          {
            element.set_gradients(fe_face_values, q);
            F = element.deformation_gradient();
          }
        if (is_spring)
          u = element.displacement(fe_face_values, q);
        const Tensor<1, dim> force =
          surface_force(load,
                        fe_face_values.quadrature_point(q),
                        fe_face_values.normal_vector(q),
                        F,
                        u,
                        time);
        if (is_spring)
          element.add_load(fe_face_values, q, -force, element.internal);
        else
          element.add_load(fe_face_values, q, force, element.external);
        if (with_tangent)
          add_tangent(load, fe_face_values, q, F, time, element);
      }
  }



  template <int dim>
  void
  SurfaceLoads<dim>::add_tangent(const Load<dim>         &load,
                                 const FEFaceValues<dim> &fe_face_values,
                                 const unsigned int       q,
                                 const Tensor<2, 3>      &F,
                                 const double             time,
                                 ElementArrays<dim>      &element) const
  {
    if (load.type == BoundaryConditionType::spring)
      element.add_load_tangent(fe_face_values, q, load.stiffness);
    // An external force: its derivative enters the tangent with a minus.
    if (load.type == BoundaryConditionType::follower_pressure)
      {
        const Tensor<1, dim> &N          = fe_face_values.normal_vector(q);
        const Tensor<2, dim>  F_in_plane = part_in_plane<dim>(F);
        const double          p =
          load.pressure(fe_face_values.quadrature_point(q), time);
        element.add_load_gradient_tangent(fe_face_values,
                                          q,
                                          (stretch_off_plane<dim>(F) * p) *
                                            cofactor_derivative(F_in_plane, N),
                                          p * (cofactor(F_in_plane) * N));
      }
  }



  template <int dim>
  Tensor<1, dim>
  surface_force(const Load<dim>      &load,
                const Point<dim>     &X,
                const Tensor<1, dim> &N,
                const Tensor<2, 3>   &F,
                const Tensor<1, dim> &u,
                const double          time)
  {
    switch (load.type)
      {
        case BoundaryConditionType::traction:
          return load.vector(X, time);
        case BoundaryConditionType::distributed_force:
          return load.active.contains(time)
                   ? load.distribution->traction(X, time)
                   : Tensor<1, dim>();
        case BoundaryConditionType::pressure:
          return -load.pressure(X, time) * N;
        case BoundaryConditionType::follower_pressure:
          return -load.pressure(X, time) * stretch_off_plane<dim>(F) *
                 (cofactor(part_in_plane<dim>(F)) * N);
        case BoundaryConditionType::spring:
          return load.active.contains(time) ? -1. * (load.stiffness * u)
                                            : Tensor<1, dim>();
        default:
          Assert(false, ExcInternalError());
          return {};
      }
  }



  template <>
  Tensor<2, 2>
  cofactor(const Tensor<2, 2> &F)
  {
    Tensor<2, 2> result;
    result[0][0] = F[1][1];
    result[0][1] = -F[1][0];
    result[1][0] = -F[0][1];
    result[1][1] = F[0][0];
    return result;
  }



  template <>
  Tensor<2, 3>
  cofactor(const Tensor<2, 3> &F)
  {
    // Row i is the cross product of the two rows that follow it cyclically.
    Tensor<2, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      result[i] = cross_product_3d(F[(i + 1) % 3], F[(i + 2) % 3]);
    return result;
  }



  template <>
  Tensor<3, 2>
  cofactor_derivative(const Tensor<2, 2> & /*F*/, const Tensor<1, 2> &N)
  {
    // cof(F) N = (F_22 N_1 - F_21 N_2, F_11 N_2 - F_12 N_1)
    Tensor<3, 2> result;
    result[0][1][1] = N[0];
    result[0][1][0] = -N[1];
    result[1][0][0] = N[1];
    result[1][0][1] = -N[0];
    return result;
  }



  template <>
  Tensor<3, 3>
  cofactor_derivative(const Tensor<2, 3> &F, const Tensor<1, 3> &N)
  {
    // (cof(F) N)_i = (F_j x F_k) . N with rows j = i+1, k = i+2 (cyclic), and
    // (a x b) . N = a . (b x N) = b . (N x a).
    Tensor<3, 3> result;
    for (unsigned int i = 0; i < 3; ++i)
      {
        const unsigned int j = (i + 1) % 3;
        const unsigned int k = (i + 2) % 3;
        result[i][j]         = cross_product_3d(F[k], N);
        result[i][k]         = cross_product_3d(N, F[j]);
      }
    return result;
  }



#define INSTANTIATE(dim)                                        \
  template class SurfaceLoads<dim>;                             \
  template Tensor<1, dim> surface_force(const Load<dim> &,      \
                                        const Point<dim> &,     \
                                        const Tensor<1, dim> &, \
                                        const Tensor<2, 3> &,   \
                                        const Tensor<1, dim> &, \
                                        const double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
