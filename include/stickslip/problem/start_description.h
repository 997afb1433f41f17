#ifndef stickslip_problem_start_description_h
#define stickslip_problem_start_description_h

#include <stickslip/problem/contact_at_start.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// A line per pair, and warnings about pairs that can never meet, are given
  /// twice, or share a surface that is slave of one and master of the other.
  template <int dim>
  std::vector<std::string>
  describe(const ContactAssembler<dim>            &contact,
           const std::vector<ContactAtStart<dim>> &start);
} // namespace stickslip

#endif
