#include <stickslip/solid/surface_loads.h>

#include <stickslip/mesh/reference_cells.h>

namespace stickslip
{
  template <int dim>
  SurfaceLoads<dim>::SurfaceLoads(const Mapping<dim>           &mapping,
                                  const FiniteElement<dim>     &fe,
                                  const std::vector<Load<dim>> &loads)
    : fe_face_values(
        mapping,
        fe.base_element(0),
        gauss_quadrature<dim - 1>(faces_of<dim>(fe.reference_cell()),
                                  fe.degree + 1),
        update_values | update_gradients | update_quadrature_points |
          update_normal_vectors | update_JxW_values)
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
        fe_face_values.reinit(
          typename Triangulation<dim>::active_cell_iterator(cell), face);
        for (const Load<dim> *load : loads->second)
          if (load->active.contains(time))
            add_load(*load, time, with_tangent, element);
      }
  }



  template <int dim>
  void
  SurfaceLoads<dim>::add_load(const Load<dim>    &load,
                              const double        time,
                              const bool          with_tangent,
                              ElementArrays<dim> &element)
  {
    for (const unsigned int q : fe_face_values.quadrature_point_indices())
      {
        const Point<dim>     &X = fe_face_values.quadrature_point(q);
        const Tensor<1, dim> &N = fe_face_values.normal_vector(q);
        switch (load.type)
          {
            case BoundaryConditionType::traction:
              element.add_load(fe_face_values,
                               q,
                               load.vector(X, time),
                               element.external);
              break;
            case BoundaryConditionType::pressure:
              element.add_load(fe_face_values,
                               q,
                               -load.pressure(X, time) * N,
                               element.external);
              break;
            case BoundaryConditionType::follower_pressure:
              add_follower_pressure(load.pressure(X, time),
                                    q,
                                    with_tangent,
                                    element);
              break;
            case BoundaryConditionType::spring:
              element.add_load(fe_face_values,
                               q,
                               load.stiffness *
                                 element.displacement(fe_face_values, q),
                               element.internal);
              if (with_tangent)
                element.add_load_tangent(fe_face_values, q, load.stiffness);
              break;
            default:
              Assert(false, ExcInternalError());
          }
      }
  }



  template <int dim>
  void
  SurfaceLoads<dim>::add_follower_pressure(const double        pressure,
                                           const unsigned int  q,
                                           const bool          with_tangent,
                                           ElementArrays<dim> &element)
  {
    element.set_gradients(fe_face_values, q);
    const Tensor<2, 3> F_full = element.deformation_gradient();
    Tensor<2, dim>     F;
    for (unsigned int i = 0; i < dim; ++i)
      for (unsigned int J = 0; J < dim; ++J)
        F[i][J] = F_full[i][J];

    const Tensor<1, dim> &N = fe_face_values.normal_vector(q);
    element.add_load(fe_face_values,
                     q,
                     -pressure * (cofactor(F) * N),
                     element.external);
    // An external force: its derivative enters the tangent with a minus.
    if (with_tangent)
      element.add_load_gradient_tangent(fe_face_values,
                                        q,
                                        pressure * cofactor_derivative(F, N));
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



  template class SurfaceLoads<2>;
  template class SurfaceLoads<3>;
} // namespace stickslip
