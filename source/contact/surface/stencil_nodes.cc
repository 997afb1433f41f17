#include <stickslip/contact/surface/stencil_nodes.h>

namespace stickslip
{
  template <int dim>
  void
  StencilNodes<dim>::append(const StencilNodes &others, const unsigned int j)
  {
    const unsigned int n = n_nodes_of_dofs();
    for (unsigned int c = 0; c < dim; ++c)
      dofs.push_back(others.dofs[j * dim + c]);
    if (!images.empty() || !others.images.empty())
      set_image(n,
                others.name(j).second,
                others.rotation(j),
                !rotations.empty() || !others.rotations.empty());
  }



  template <int dim>
  void
  StencilNodes<dim>::set_image(const unsigned int    j,
                               const unsigned int    image,
                               const Tensor<2, dim> &rotation,
                               const bool            is_turned)
  {
    images.resize(n_nodes_of_dofs(), 0);
    images[j] = image;
    if (!is_turned)
      return;
    rotations.resize(n_nodes_of_dofs(), unit_symmetric_tensor<dim>());
    rotations[j] = rotation;
  }



  template <int dim>
  void
  StencilNodes<dim>::turn_back(const unsigned int first,
                               Vector<double>    &forces) const
  {
    for (unsigned int j = 0; j < rotations.size(); ++j)
      {
        Tensor<1, dim> f;
        for (unsigned int c = 0; c < dim; ++c)
          f[c] = forces[first + j * dim + c];
        f = f * rotations[j];
        for (unsigned int c = 0; c < dim; ++c)
          forces[first + j * dim + c] = f[c];
      }
  }



  template <int dim>
  void
  StencilNodes<dim>::turn_back(const unsigned int  first,
                               FullMatrix<double> &matrix) const
  {
    for (unsigned int j = 0; j < rotations.size(); ++j)
      for (unsigned int k = 0; k < matrix.m(); ++k)
        {
          Tensor<1, dim> column;
          for (unsigned int c = 0; c < dim; ++c)
            column[c] = matrix(first + j * dim + c, k);
          column = column * rotations[j];
          for (unsigned int c = 0; c < dim; ++c)
            matrix(first + j * dim + c, k) = column[c];
        }
    for (unsigned int j = 0; j < rotations.size(); ++j)
      for (unsigned int k = 0; k < matrix.m(); ++k)
        {
          Tensor<1, dim> row;
          for (unsigned int c = 0; c < dim; ++c)
            row[c] = matrix(k, first + j * dim + c);
          row = row * rotations[j];
          for (unsigned int c = 0; c < dim; ++c)
            matrix(k, first + j * dim + c) = row[c];
        }
  }

  template struct StencilNodes<2>;
  template struct StencilNodes<3>;
} // namespace stickslip
