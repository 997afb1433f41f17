#ifndef stickslip_contact_cycling_law_continuation_h
#define stickslip_contact_cycling_law_continuation_h

#include <stickslip/contact/assembly/contact_assembler.h>

namespace stickslip
{
  /**
   * A way past statuses that chase each other: Newton's method for a contact
   * law with rounded corners (law_corners.h), which are made sharp again while
   * it converges. All points then have a pressure and a friction force, and
   * none has to be put on one side before its neighbours are right: on long
   * surfaces of bodies that bend (strips, bands, thin rings) statuses move by a
   * node or two per iteration, or never settle.
   *
   * The widths begin at the mean pressure of the closed points and the longest
   * Lambda + r_t d_t of the last state and become smaller by a factor whenever
   * the merit has fallen enough, until the law is exact. Where Newton's method
   * gets stuck on the way, too, it is exact at once. (The largest pressure may
   * be that of an edge, or of a node under a roller; all open points around
   * then press with a good part of it.)
   *
   * B. Chen and P. T. Harker, SIAM J. Matrix Anal. Appl. 14 (1993); for contact
   * with friction P. W. Christensen and J.-S. Pang, in: Reformulation (1998).
   */
  template <int dim>
  class LawContinuation
  {
  public:
    explicit LawContinuation(ContactAssembler<dim> &contact);

    ~LawContinuation();

    LawContinuation(const LawContinuation &) = delete;
    LawContinuation &
    operator=(const LawContinuation &) = delete;

    /// Rounds the corners by what the last residual has seen. False, and
    /// nothing done, if nothing presses, statuses are frozen or it was done
    /// before. Collective.
    bool
    begin();

    /// Corners are rounded.
    bool
    acts() const
    {
      return contact.rounding.acts();
    }

    /// The merit of the last residual.
    void
    observe(const double merit);

    double
    observed_merit() const
    {
      return last_merit;
    }

    /// After an iteration: sharper corners if it is time. True if the law is
    /// another one now.
    bool
    advance();

    /// The rounded equations are solved: sharper corners.
    void
    sharpen();

    /// Corners as they are in the equations of the case.
    void
    end();

  private:
    ContactAssembler<dim> &contact;
    bool                   has_begun        = false;
    bool                   law_is_new       = false;
    double                 first_width      = 0.; ///< [stress]
    double                 merit_of_new_law = 0.;
    double                 last_merit       = 0.;
    unsigned int           n_iterations     = 0; ///< with this law
    unsigned int           n_stuck          = 0; ///< laws that were not solved

    void
    change_width(const double factor);
  };
} // namespace stickslip

#endif
