#ifndef stickslip_base_parameter_file_h
#define stickslip_base_parameter_file_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <stickslip/base/parameter_file_reader.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * The parameters of a list whose members the user names: the subsections of
   * "Bodies", "Materials", ..., in the order of their first appearance in the
   * file. ParameterHandler keeps references to the members of T, so size the
   * list completely (declare_names()) before the first add_parameters().
   */
  template <typename T>
  using NamedList = std::vector<std::pair<std::string, T>>;

  /// Declares a section with a subsection for each member of @p list, in which
  /// the member declares its parameters.
  template <typename T>
  void
  add_named_list(dealii::ParameterHandler &prm,
                 const std::string        &section,
                 NamedList<T>             &list)
  {
    prm.enter_subsection(section);
    for (auto &[name, member] : list)
      {
        prm.enter_subsection(name);
        member.add_parameters(prm);
        prm.leave_subsection();
      }
    prm.leave_subsection();
  }


  /**
   * The content of a parameter file in deal.II's syntax (`set a = b`,
   * `subsection`, `end`, `include`, `#` comments, lines continued by a
   * backslash), with the place of every statement.
   *
   * ParameterHandler can only read what was declared before; here the file
   * comes first, so that named lists (bodies, materials, ...) can be declared
   * as the user named them, and so that a message about a wrong entry can say
   * where it stands and what is known there.
   *
   * Where it is stricter than deal.II: a parameter must not be set twice in
   * one file (a file may replace what a file that it included has set), every
   * `subsection` needs its `end`, and names contain no '/'. Where it is
   * friendlier: a comment ends with its line, also between continued lines,
   * and the name after `include` is relative to the including file.
   *
   * @code
   *   ParameterFile file("case.prm", MPI_COMM_WORLD);
   *   file.override_with("Bodies/block/Scale factor=2");
   *
   *   NamedList<BodyParameters> bodies;
   *   file.declare_names("Bodies", bodies);
   *
   *   ParameterHandler prm;
   *   prm.enter_subsection("Bodies");
   *   for (auto &[name, body] : bodies)
   *     {
   *       prm.enter_subsection(name);
   *       body.add_parameters(prm);
   *       prm.leave_subsection();
   *     }
   *   prm.leave_subsection();
   *
   *   file.apply_to(prm);
   *   for (const auto &[name, body] : bodies)
   *     body.check("Bodies/" + name);
   * @endcode
   */
  class ParameterFile
  {
  public:
    /// A file without statements: everything keeps its default.
    ParameterFile() = default;

    /**
     * Reads @p file_name and the files it includes on rank 0 and sends the
     * entries to all ranks. Collective. Throws UserError, on all ranks, for a
     * file that cannot be read and for wrong syntax.
     */
    ParameterFile(const std::string &file_name, const MPI_Comm communicator);

    /**
     * Reads statements from a string, on every rank for itself; @p name stands
     * for the file in messages. Throws UserError for wrong syntax.
     */
    static ParameterFile
    from_string(const std::string &text, const std::string &name);

    /**
     * Sets one parameter from "Section/Subsection/Name=value", as `--set`
     * does. The last '/' before the '=' separates the name. Replaces what the
     * file or an earlier override says; cannot add a member to a named list.
     * Throws UserError if the text has another form.
     */
    void
    override_with(const std::string &assignment);

    /**
     * The same file with the values of its constants (NamedConstants) in place
     * of their names, and without the section Constants. Throws UserError that
     * lists all values in which that is not possible.
     */
    ParameterFile
    with_constants_inserted() const;

    /**
     * The names of the subsections of @p section ("Bodies", or "" for the top
     * level) in the order of their first appearance in the file, empty ones
     * included.
     */
    std::vector<std::string>
    subsections_of(const std::string &section) const;

    /**
     * Sizes @p list as subsections_of(section) says and names its members,
     * which are default-constructed.
     */
    template <typename T>
    void
    declare_names(const std::string &section, NamedList<T> &list) const;

    /// The value of a parameter, if the file or an override sets it.
    std::optional<std::string>
    value_of(const std::string &section, const std::string &name) const;

    /**
     * Throws UserError if one of @p names is not set in @p section. For
     * parameters that are mandatory only under a condition; others should be
     * declared with `has_to_be_set` and are then checked by apply_to().
     */
    void
    require(const std::string              &section,
            const std::vector<std::string> &names) const;

    /**
     * Sets all entries in @p prm, which must have everything declared and be
     * at its top level. Throws one UserError that lists every unknown
     * subsection or name (with the nearest known ones), every value that does
     * not match its pattern, and every parameter that has to be set and is
     * not. @p prm is then partly set.
     *
     * What a pattern lets through is not checked again: the default pattern
     * of an unsigned int accepts -1 (and wraps around), so declare it with
     * Patterns::Integer(0).
     */
    void
    apply_to(dealii::ParameterHandler &prm) const;

    /// The name of the file, as given; empty without a file.
    const std::string &
    name() const
    {
      return file_name;
    }

    /**
     * The folder of the file ("." if its name has none): file names in
     * parameters are relative to it.
     */
    std::string
    directory() const;

    /// All statements, overrides included.
    const std::vector<ParameterStatement> &
    entries() const
    {
      return statements.entries;
    }

  private:
    /// nullptr if the parameter is not set.
    const ParameterStatement *
    find(const std::vector<std::string> &path, const std::string &name) const;

    /// Where a section begins; line 0 of the file if it does not occur.
    ParameterStatement
    section_statement(const std::vector<std::string> &path) const;

    std::string         file_name;
    ParameterStatements statements;
  };



  // ---------------------------------------------------------------------------

  template <typename T>
  void
  ParameterFile::declare_names(const std::string &section,
                               NamedList<T>      &list) const
  {
    const std::vector<std::string> names = subsections_of(section);

    // T may be movable only, so no list.resize(n, value).
    list.clear();
    list.reserve(names.size());
    for (const std::string &name : names)
      list.emplace_back(name, T());
  }
} // namespace stickslip

#endif
