#include <stickslip/mesh/body.h>

#include <stickslip/base/nearest_name.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/exceptions.h>

#include <iterator>

namespace stickslip
{
  namespace
  {
    /// 0 is what deal.II gives the faces of ghost cells behind which lie cells
    /// that only other ranks know (fully distributed triangulations).
    constexpr types::boundary_id first_boundary_id = 1;
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
    types::boundary_id first = first_boundary_id;
    for (unsigned int b = 0; b < body; ++b)
      first += bodies[b].boundary_ids.size();

    const auto &ids      = bodies[body].boundary_ids;
    const auto  position = ids.find(local);
    Assert(position != ids.end(), ExcInternalError());
    return first + std::distance(ids.begin(), position);
  }



  std::set<types::boundary_id>
  Bodies::global_boundary_ids(const std::string              &body,
                              const std::vector<std::string> &labels,
                              const std::string &parameter_path) const
  {
    const unsigned int b          = index_of(body, parameter_path);
    const auto        &present    = bodies[b].boundary_ids;
    const LabelledIds &boundaries = bodies[b].boundaries;
    const std::string  known =
      " Boundaries of this body: " + boundaries.in_words(present) + ".";

    if (labels.empty())
      throw UserError(parameter_path + ": no boundary is given for body '" +
                      body + "'." + known);

    std::set<types::boundary_id> result;
    for (const std::string &label : labels)
      {
        if (label == "all" && boundaries.ids(label).empty())
          {
            result = all_boundary_ids(b);
            continue;
          }
        bool marks_any = false;
        for (const types::boundary_id local : boundaries.ids(label))
          if (present.count(local) > 0)
            {
              result.insert(global_boundary_id(b, local));
              marks_any = true;
            }
        if (!marks_any)
          throw UserError(
            parameter_path + ": boundary '" + label +
            "' marks no face of body '" + body + "'." +
            (boundaries.is_elsewhere(label)
               ? " The mesh file has it, but not on the surface of this body."
               : did_you_mean(label, boundaries.names(present))) +
            known);
      }
    return result;
  }



  types::boundary_id
  Bodies::single_boundary_id(const std::string &body,
                             const std::string &label,
                             const std::string &parameter_path) const
  {
    const auto ids = global_boundary_ids(body, {label}, parameter_path);
    if (ids.size() > 1)
      throw UserError(parameter_path + ": faces of boundary '" + label +
                      "' of body '" + body +
                      "' belong to other boundaries, too. Here it must not "
                      "share faces with others.");
    return *ids.begin();
  }



  std::set<types::boundary_id>
  Bodies::all_boundary_ids(const unsigned int body) const
  {
    std::set<types::boundary_id> ids;
    for (const types::boundary_id local : bodies[body].boundary_ids)
      ids.insert(global_boundary_id(body, local));
    return ids;
  }



  unsigned int
  Bodies::body_of_boundary(const types::boundary_id global) const
  {
    types::boundary_id end = first_boundary_id;
    for (unsigned int b = 0; b < bodies.size(); ++b)
      {
        end += bodies[b].boundary_ids.size();
        if (global < end && global >= first_boundary_id)
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
