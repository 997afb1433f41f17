#ifndef stickslip_mesh_subdivided_line_h
#define stickslip_mesh_subdivided_line_h

#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Positions along a line. "0, 1, 3" lists them; "0 |4| 1 |10, 5| 3" divides
   * the parts: 4 equal cells, then 10 cells whose sizes form a geometric
   * sequence, the last one 5 times the first. Both can be mixed. Throws
   * UserError blaming @p parameter_path if the positions do not increase.
   */
  std::vector<double>
  subdivided_line(const std::string &text, const std::string &parameter_path);
} // namespace stickslip

#endif
