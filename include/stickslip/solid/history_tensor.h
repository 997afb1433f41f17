#ifndef stickslip_solid_history_tensor_h
#define stickslip_solid_history_tensor_h

#include <deal.II/base/array_view.h>
#include <deal.II/base/symmetric_tensor.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// Name of the equivalent plastic strain among the history variables.
  inline const std::string equivalent_plastic_strain_name =
    "equivalent_plastic_strain";

  /// Appends NAME_xx, _yy, _zz, _xy, _xz, _yz: a symmetric tensor among the
  /// history variables of a law.
  inline void
  append_tensor_names(const std::string &name, std::vector<std::string> &names)
  {
    for (const char *component : {"_xx", "_yy", "_zz", "_xy", "_xz", "_yz"})
      names.push_back(name + component);
  }

  /// The tensor whose components begin at @p first.
  inline dealii::SymmetricTensor<2, 3>
  read_tensor(const dealii::ArrayView<const double> &history,
              const unsigned int                     first)
  {
    dealii::SymmetricTensor<2, 3> tensor;
    for (unsigned int c = 0; c < 6; ++c)
      tensor.access_raw_entry(c) = history[first + c];
    return tensor;
  }

  inline void
  write_tensor(const dealii::SymmetricTensor<2, 3> &tensor,
               const dealii::ArrayView<double>     &history,
               const unsigned int                   first)
  {
    for (unsigned int c = 0; c < 6; ++c)
      history[first + c] = tensor.access_raw_entry(c);
  }
} // namespace stickslip

#endif
