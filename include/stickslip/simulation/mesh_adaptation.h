#ifndef stickslip_simulation_mesh_adaptation_h
#define stickslip_simulation_mesh_adaptation_h

#include <stickslip/mesh/mesh_builder.h>

#include <stickslip/output/contact_resultants.h>
#include <stickslip/output/statistics_table.h>

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/checkpoint_description.h>
#include <stickslip/simulation/estimated_error.h>

#include <deal.II/distributed/tria.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Decides whether and where the mesh is adapted, and keeps what the
   * statistics say about it. What an adaptation does to the state is the
   * business of Simulation.
   */
  template <int dim>
  class MeshAdaptation
  {
  public:
    /// @p mesh must outlive this object.
    MeshAdaptation(const AdaptationParameters &parameters, Mesh<dim> &mesh);

    bool
    is_active() const
    {
      return parameters.is_active();
    }

    /// A step begins: nothing is known of its solution.
    void
    begin_step();

    /**
     * The step has been solved: its solution is @p x. Flags cells and returns true
     * if it has to be solved once more, on the adapted mesh. Collective.
     */
    bool
    wants_repetition(ContactProblem<dim> &problem, const LA::BlockVector &x);

    /// Step number @p step has been accepted. Flags cells and returns true if
    /// the mesh is to be another one before the next step. Once that has been
    /// made there is no estimate, and the answer is no. Collective.
    bool
    wants_other_mesh(const unsigned int step);

    /// A step has been accepted with the state @p x, whose error the statistics and
    /// fields() show. Collective.
    void
    accept_step(ContactProblem<dim> &problem, const LA::BlockVector &x);

    /// Of the step that has been accepted: an error target that the bounds of
    /// the mesh do not let it reach, once. Collective.
    std::vector<std::string>
    warnings_of_step();

    /// Cell by cell.
    NamedCellValues
    fields() const
    {
      return error.fields(*mesh.triangulation);
    }

    /// The mesh has been adapted and has the state @p x: a rule may want it still
    /// finer, which needs no further solution. Flags cells and returns true if
    /// so. Collective.
    bool
    wants_another_level(ContactProblem<dim> &problem, const LA::BlockVector &x);

    /// Of the estimate; empty without one.
    Vector<double>
    indicators() const
    {
      return error.get() == nullptr ? Vector<double>()
                                    : error.get()->indicators;
    }

    /**
     * The cells have been adapted and are expected to have these indicators
     * (StateTransfer::expected_indicators()): cells with more than their share
     * of an error target still need another level, for which no solution has to
     * be waited. Flags them and returns true if there are any. Collective.
     */
    bool
    expects_finer(const Vector<double> &expected);

    /// The triangulation, for those who change it.
    parallel::distributed::Triangulation<dim> &
    triangulation() const
    {
      return *p4est;
    }

    /// The mesh is another one since the last call; @p residual is the relative
    /// imbalance of the state on it. Returns what it has become, in words.
    /// Collective.
    std::string
    record_new_mesh(const double residual);

    /// The state has been brought to equilibrium on the new mesh, which took
    /// @p iterations; contact forces @p before and now. Returns it in words.
    std::string
    record_equilibrium(const unsigned int                         iterations,
                       const std::vector<ContactResultants<dim>> &before,
                       const std::vector<ContactResultants<dim>> &now);

    /// Since the start of the run.
    const AdaptationProgress &
    progress() const
    {
      return done;
    }

    /// What a checkpoint has beside that; null if the mesh has been
    /// adapted to the state already.
    const ErrorEstimate *
    estimate() const
    {
      return error.get();
    }

    /**
     * The run goes on with the state @p x of a checkpoint, whose @p scalars and
     * @p indicators these are. @p is_same: its estimator was this one. The estimate
     * cannot be made again then: slips of the step that has led to the state
     * are over. Collective.
     */
    void
    resume(const CheckpointScalars &scalars,
           const Vector<double>    &indicators,
           const bool               is_same,
           ContactProblem<dim>     &problem,
           const LA::BlockVector   &x);

    /// Columns about meshes and what they have done since the last row.
    void
    add_to(StatisticsTable &statistics);

  private:
    const AdaptationParameters                 parameters;
    EstimatedError<dim>                        error;
    Mesh<dim>                                 &mesh;
    parallel::distributed::Triangulation<dim> *p4est;
    AdaptationProgress                         done;
    unsigned int repetitions = 0;     ///< of this step
    unsigned int levels      = 0;     ///< of this adaptation
    bool         has_warned  = false; ///< of bounds

    // since the last row
    unsigned int transfer_iterations = 0;
    double       transfer_residual   = 0.;
    double       force_change        = 0.; ///< relative

    /// Cells that shall be, over all ranks.
    struct Flagged
    {
      double refined          = 0.;
      double error_of_refined = 0.; ///< sum of their indicators
      double coarsened        = 0.;
    };

    /// By @p estimate.
    Flagged
    mark(const ErrorEstimate &estimate);

    /// By the present estimate.
    Flagged
    mark()
    {
      return mark(*error.get());
    }

    /// Whether the step that the present estimate is of, or one that has been
    /// repeated already, is a first step (Repetition::first_step).
    bool
    is_first_of_its_kind() const;

    /// By the present estimate: whether it is worth another mesh.
    bool
    should_be_finer(const Flagged &flagged) const;

    void
    clear_coarsen_flags();

    /// Of the error at @p x.
    void
    make_estimate(ContactProblem<dim> &problem, const LA::BlockVector &x);
  };
} // namespace stickslip

#endif
