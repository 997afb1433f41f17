#include <stickslip/mesh/mesh_parameters.h>

#include <stickslip/base/user_error.h>

namespace stickslip
{
  void
  MeshParameters::add_parameters(ParameterHandler &prm)
  {
    prm.add_parameter("Partitioner",
                      partitioner,
                      "How cells are distributed: p4est (along a space-filling "
                      "curve) or METIS "
                      "(graph partitioning).",
                      Patterns::Selection("p4est|METIS"));
    prm.add_parameter("Global refinements",
                      global_refinements,
                      "Uniform refinements of all bodies, after those of each "
                      "body.",
                      Patterns::Integer(0, 12));
    prm.add_parameter("Contact weight",
                      contact_weight,
                      "What a slave face costs, in cells: with several ranks "
                      "cells are distributed such that all have the same work. "
                      "0: only cells count. A run can be continued (--restart) "
                      "with another weight, which distributes it anew.",
                      Patterns::Double(0., 1000.));
  }



  void
  MeshParameters::check(const std::string &path) const
  {
    if (partitioner != "p4est" && partitioner != "METIS")
      throw UserError(path + "/Partitioner: '" + partitioner +
                      "' is unknown. Known: p4est, METIS.");
  }
} // namespace stickslip
