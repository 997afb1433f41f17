#ifndef stickslip_solid_constitutive_law_h
#define stickslip_solid_constitutive_law_h

#include <stickslip/base/types.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>
#include <deal.II/base/symmetric_tensor.h>
#include <deal.II/base/tensor.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * What a material answers to a deformation at one point: stress, its
   * derivative and the new history. Pure functions of tensors: no finite
   * elements, no MPI.
   *
   * All tensors are 3x3. A two-dimensional body hands in a deformation
   * gradient with F_33 = 1 and F_13 = F_23 = F_31 = F_32 = 0, which is plane
   * strain; plane stress is the adaptor PlaneStress around any law.
   *
   * Stresses are in the unit of the parameters. A law may have a history (any
   * number of doubles per point), and its tangent need not be symmetric.
   */
  class ConstitutiveLaw
  {
  public:
    virtual ~ConstitutiveLaw() = default;

    /// Declares the law's own parameters in the current subsection.
    virtual void
    add_parameters(ParameterHandler &prm) = 0;

    /**
     * Reads the files that the parameters name, whose names are relative to
     * @p directory: none by default. Between reading the parameters and
     * check(). Collective. Throws UserError, on all ranks.
     */
    virtual void
    read_files(const std::string & /*path*/,
               const std::string & /*directory*/,
               const MPI_Comm /*communicator*/)
    {}

    /// Throws UserError for values that no pattern can catch; @p path is the
    /// law's section, e.g. "Materials/steel".
    virtual void
    check(const std::string &path) const = 0;

    /**
     * The doubles per point that the law remembers, by the names that they
     * have in the output: none by default. The same name means the same
     * quantity in all laws.
     */
    virtual std::vector<std::string>
    history_names() const
    {
      return {};
    }

    /// How many there are.
    unsigned int
    n_history_variables() const
    {
      return history_names().size();
    }

    /// Writes the history of the virgin material.
    virtual void
    initialize_history(const ArrayView<double> &history) const;

    /**
     * First Piola-Kirchhoff stress P(F) and, unless @p dP_dF is a null
     * pointer, its derivative dP_ij/dF_kl (with the history update
     * differentiated, i.e. the algorithmic tangent). @p old_history is the
     * accepted one of the last step, @p new_history (same size) is written.
     *
     * Returns false, and throws nothing, if the state is locally impossible
     * (negative volume, local iteration without result): the step is then to
     * be cut. P, dP_dF and new_history are unusable in that case.
     */
    virtual bool
    evaluate(const Tensor<2, 3>            &F,
             const ArrayView<const double> &old_history,
             const ArrayView<double>       &new_history,
             Tensor<2, 3>                  &P,
             Tensor<4, 3>                  *dP_dF) const = 0;

    /**
     * The deformation gradient including what the law itself determines from
     * the in-plane part (plane stress: F_33, kept in @p history). To be
     * handed to cauchy_stress() and strain().
     */
    virtual Tensor<2, 3>
    full_deformation_gradient(const Tensor<2, 3>            &F,
                              const ArrayView<const double> &history) const;

    /// Cauchy stress P F^T / det F for output; geometrically linear laws,
    /// which know one stress only, return P.
    virtual SymmetricTensor<2, 3>
    cauchy_stress(const Tensor<2, 3> &F, const Tensor<2, 3> &P) const;

    /// The strain that the law uses, for output: Green-Lagrange unless the
    /// law says otherwise.
    virtual SymmetricTensor<2, 3>
    strain(const Tensor<2, 3> &F) const;

    /// lambda + 2 mu at rest: the scale for contact parameters and for the
    /// diagonal of constrained rows.
    virtual double
    longitudinal_modulus() const = 0;

    /// True if det F <= 0 does not bother the law (small strains).
    virtual bool
    is_geometrically_linear() const
    {
      return false;
    }

    /// True if P is a linear function of F - I and of nothing else, with a
    /// stored energy: dP_dF is then symmetric and the same in all states.
    virtual bool
    is_linear() const
    {
      return false;
    }
  };

  /// A law by its name in the parameter file, with default parameters. Throws
  /// UserError with the nearest and the known names; @p parameter_path says
  /// where the name was found.
  std::unique_ptr<ConstitutiveLaw>
  create_constitutive_law(const std::string &name,
                          const std::string &parameter_path);

  /**
   * Adds a law of a program that links the library, so that parameter files
   * may name it: `Materials/<material>/Law = name`. To be called on all ranks
   * before run_program(). @p description goes on in lower case and ends
   * without a full stop; @p create returns a law with default parameters.
   * Throws UserError if the name is taken.
   */
  void
  register_constitutive_law(
    const std::string                                       &name,
    const std::string                                       &description,
    const std::function<std::unique_ptr<ConstitutiveLaw>()> &create);

  /// All names that create_constitutive_law() knows.
  std::vector<std::string>
  constitutive_law_names();

  /// What each law is, for the documentation of the parameter.
  std::string
  constitutive_law_descriptions();
} // namespace stickslip

#endif
