#ifndef stickslip_solid_history_fields_h
#define stickslip_solid_history_fields_h

#include <stickslip/solid/constitutive_law.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * The history variables of all laws of a case as fields, one per name. In two
   * dimensions without the components _xz and _yz of tensors, which are zero.
   */
  class HistoryFields
  {
  public:
    /// @p laws by material id; null pointers have no history.
    HistoryFields(
      const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
      const unsigned int                                         dim);

    /// Each name once, in the order of the laws.
    const std::vector<std::string> &
    names() const;

    /// The variables of a point in the order of names(), 0 for those of other
    /// laws.
    std::vector<double>
    values(const unsigned int             material,
           const ArrayView<const double> &history) const;

  private:
    std::vector<std::string> all_names;
    /// By material id: place of each of the law's variables among the names,
    /// or numbers::invalid_unsigned_int.
    std::vector<std::vector<unsigned int>> places;
  };
} // namespace stickslip

#endif
