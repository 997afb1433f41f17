#ifndef stickslip_mesh_labelled_ids_h
#define stickslip_mesh_labelled_ids_h

#include <map>
#include <set>
#include <string>
#include <vector>

namespace stickslip
{
  /// The number (-1: none) and name (may be empty) of a group of faces or
  /// cells.
  struct GroupLabel
  {
    int         number = -1;
    std::string name;
  };

  /**
   * What a user may call the faces or cells of a body, beside the ids that the
   * triangulation has for them: names, and numbers of groups that share some
   * of their faces. A face has one id, whereas a file may put it into several
   * groups: each combination of groups then gets an id of its own, and a label
   * stands for several ids.
   *
   * An id without labels is its own number: those of generators.
   */
  class LabelledIds
  {
  public:
    /// Ids from here on are ours. The user's have at most 9 digits.
    static constexpr unsigned int first_own_id = 1000000000;

    /// The id of what belongs to all @p groups and to no other one; 0 without
    /// groups.
    unsigned int
    id_of(const std::vector<GroupLabel> &groups);

    /// A further id that @p label stands for. A number stands for itself.
    unsigned int
    id_of(const std::string &label);

    /// All ids that a name or number stands for, whether they occur or not.
    /// Empty if the name is not known. Names have to be written as they are,
    /// except for upper and lower case if that is unambiguous.
    std::set<unsigned int>
    ids(const std::string &label) const;

    /// The number that `id` means in conditions: the id, or the first number
    /// among the groups of a combination (0 if none has a number).
    unsigned int
    number(const unsigned int id) const;

    /// All names whose ids are among @p present.
    std::vector<std::string>
    names(const std::set<unsigned int> &present) const;

    /// "'top' (3), 'bottom', 5": names, and numbers without a name, of the
    /// ids @p present; "none" without ids.
    std::string
    in_words(const std::set<unsigned int> &present) const;

    /// Remembers a group that the file has, but not in this body.
    void
    add_elsewhere(const std::string &name)
    {
      groups_elsewhere.insert(name);
    }

    bool
    is_elsewhere(const std::string &name) const
    {
      return groups_elsewhere.count(name) > 0;
    }

  private:
    void
    add(const GroupLabel &label, const unsigned int id);

    std::map<std::string, std::set<unsigned int>>  ids_of_name;
    std::map<unsigned int, std::set<unsigned int>> ids_of_number;
    std::map<std::string, int>                     number_of_name;
    std::map<unsigned int, unsigned int>           number_of_own_id;
    std::map<std::string, unsigned int>            own_id_of_name;
    std::set<std::string>                          groups_elsewhere;
    unsigned int                                   next_own_id = first_own_id;
  };

  /// Is @p label a number of at most 9 digits?
  bool
  is_id(const std::string &label);
} // namespace stickslip

#endif
