#ifndef stickslip_mesh_file_point_numbers_h
#define stickslip_mesh_file_point_numbers_h

#include <stickslip/mesh/file/mesh_file.h>

#include <string>
#include <unordered_map>

namespace stickslip
{
  /// The numbers that a file gives its nodes, and the indices of the points.
  class PointNumbers
  {
  public:
    /// False if there is a node @p number already.
    bool
    add(const long number, const unsigned int index)
    {
      return indices.insert({number, index}).second;
    }

    /// False if there is no node @p number.
    bool
    find(const long number, unsigned int &index) const
    {
      const auto found = indices.find(number);
      if (found != indices.end())
        index = found->second;
      return found != indices.end();
    }

  private:
    std::unordered_map<long, unsigned int> indices;
  };
} // namespace stickslip

#endif
