#ifndef stickslip_output_output_parameters_h
#define stickslip_output_output_parameters_h

#include <stickslip/base/choice.h>
#include <stickslip/base/parameter_file.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  using namespace dealii;

  /**
   * A point whose displacement, and on request stress and history, is recorded
   * after each step. The subsection `Output/Points/<name>`.
   */
  struct PointParameters
  {
    std::string         body;
    std::vector<double> position; ///< in the undeformed body
    bool                material_state = false;
    /// Whose slave surface it is on; empty: none.
    std::string contact_pair = {};

    void
    add_parameters(ParameterHandler &prm);

    /// Throws UserError if no body is named or the position is empty.
    void
    check(const std::string &path) const;
  };



  /// A straight line on a slave surface, along which contact is recorded in
  /// each step with fields. The subsection `Output/Contact lines/<name>`.
  struct ContactLineParameters
  {
    std::string         contact_pair;
    std::vector<double> from, to; ///< in the undeformed body
    unsigned int        n_points = 101;

    void
    add_parameters(ParameterHandler &prm);

    /// Throws UserError if the line has no pair, or its ends have not
    /// @p dimension coordinates.
    void
    check(const std::string &path, const unsigned int dimension) const;
  };



  /// The format of field output.
  enum class FieldFormat
  {
    vtu,
    hdf5
  };

  const Choices<FieldFormat> &
  all_field_formats();

  /// What a run prints on the screen.
  enum class Verbosity
  {
    progress, ///< a line per step, and the results
    results,
    quiet ///< errors only
  };

  /**
   * What is written, where and how often. The section "Output".
   */
  struct OutputParameters
  {
    std::string  directory           = "results";
    unsigned int every_n_steps       = 1;
    FieldFormat  format              = FieldFormat::vtu;
    unsigned int grouped_files       = 1;
    bool         deformed            = false;
    Verbosity    verbosity           = Verbosity::progress;
    unsigned int checkpoint_interval = 0;
    bool         checkpoint_at_end   = true;
    std::string  stop_after; ///< a duration; empty: never
    bool         contact_points = false;

    NamedList<PointParameters>       points;
    NamedList<ContactLineParameters> lines;
    std::vector<std::string> pair_names; ///< of all contact pairs, in order

    /**
     * Declares all parameters but points and lines, whose names the parameter
     * file must have given to the list before (ParameterFile::declare_names()).
     */
    void
    add_parameters(ParameterHandler &prm);

    /// Throws UserError for values that no pattern can catch.
    void
    check(const std::string &path) const;

    /// Fields are written for each n-th accepted step (and for the last).
    bool
    is_written(const unsigned int step) const
    {
      return step % every_n_steps == 0;
    }

    /// True if the state after @p step is to be saved.
    bool
    is_saved(const unsigned int step, const bool is_last) const
    {
      return (checkpoint_interval > 0 && step % checkpoint_interval == 0) ||
             (checkpoint_at_end && is_last);
    }
  };
} // namespace stickslip

#endif
