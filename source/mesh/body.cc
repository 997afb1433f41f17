#include <stickslip/mesh/body.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/exceptions.h>

#include <iterator>

namespace stickslip
{
  namespace
  {
    std::string
    boundary_id_list(const std::set<types::boundary_id> &ids)
    {
      std::string list;
      for (const types::boundary_id id : ids)
        list += (list.empty() ? "" : ", ") + std::to_string(id);
      return list.empty() ? "none" : list;
    }
  } // namespace



  unsigned int
  Bodies::index_of(const std::string &name,
                   const std::string &parameter_path) const
  {
    std::vector<std::string> names;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        if (bodies[b].name == name)
          return b;
        names.push_back(bodies[b].name);
      }
    throw UserError(parameter_path + ": there is no body '" + name + "'." +
                    did_you_mean(name, names) +
                    " Bodies: " + quoted_list(names) + ".");
  }



  types::boundary_id
  Bodies::global_boundary_id(const unsigned int       body,
                             const types::boundary_id local) const
  {
    types::boundary_id first = 0;
    for (unsigned int b = 0; b < body; ++b)
      first += bodies[b].boundary_ids.size();

    const auto &ids      = bodies[body].boundary_ids;
    const auto  position = ids.find(local);
    Assert(position != ids.end(), ExcInternalError());
    return first + std::distance(ids.begin(), position);
  }



  std::set<types::boundary_id>
  Bodies::global_boundary_ids(const std::string               &body,
                              const std::vector<unsigned int> &local_ids,
                              const std::string &parameter_path) const
  {
    const unsigned int b   = index_of(body, parameter_path);
    const auto        &ids = bodies[b].boundary_ids;

    if (local_ids.empty())
      throw UserError(
        parameter_path + ": no boundary id is given for body '" + body +
        "'. Boundary ids present: " + boundary_id_list(ids) + ".");

    std::set<types::boundary_id> result;
    for (const unsigned int local : local_ids)
      {
        if (ids.count(local) == 0)
          throw UserError(
            parameter_path + ": boundary id " + std::to_string(local) +
            " marks no face of body '" + body +
            "'. Boundary ids present: " + boundary_id_list(ids) + ".");
        result.insert(global_boundary_id(b, local));
      }
    return result;
  }



  unsigned int
  Bodies::body_of_boundary(const types::boundary_id global) const
  {
    types::boundary_id end = 0;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        end += bodies[b].boundary_ids.size();
        if (global < end)
          return b;
      }
    AssertThrow(false, ExcInternalError());
    return numbers::invalid_unsigned_int;
  }



  types::boundary_id
  Bodies::local_boundary_id(const types::boundary_id global) const
  {
    const unsigned int b     = body_of_boundary(global);
    const auto        &ids   = bodies[b].boundary_ids;
    const auto         first = global_boundary_id(b, *ids.begin());
    return *std::next(ids.begin(), global - first);
  }
} // namespace stickslip
