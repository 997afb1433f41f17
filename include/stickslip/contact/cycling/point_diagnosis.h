#ifndef stickslip_contact_cycling_point_diagnosis_h
#define stickslip_contact_cycling_point_diagnosis_h

#include <stickslip/contact/cycling/status_history.h>

#include <optional>
#include <string>
#include <vector>

namespace stickslip
{
  /// What is known of a contact point when a load step has failed.
  template <int dim>
  struct PointDiagnosis
  {
    unsigned int pair; ///< index
    /// The slave face and the number of the point on it; no partition changes
    /// it.
    std::string name;
    Point<dim>  reference_position;
    Point<dim>  position; ///< current

    ContactState state;
    bool         was_paired;    ///< when the last step was accepted
    bool         is_far;        ///< unpaired, though a master is opposite
    bool         has_threshold; ///< friction threshold above 0

    std::string              history; ///< StatusHistory::text()
    std::optional<CycleKind> cycle;
    unsigned int             period; ///< 0: none
    bool                     changes_facet;
    unsigned int             n_facet_changes; ///< in the history
    PointTreatment           treatment;       ///< of the cycle
    bool keeps_facet; ///< beyond its edge, because it has switched so often

    double      gap; ///< >= 0 open; 0 if unpaired
    double      pressure;
    double      Lambda; ///< |Lambda|
    std::string facet;  ///< of the master; empty if unpaired
  };

  /// Of all contact points of this rank, in the configuration that @p contact
  /// has, in the order of pairs and points. Not collective.
  template <int dim>
  std::vector<PointDiagnosis<dim>>
  diagnose_points(ContactAssembler<dim>    &contact,
                  const StatusHistory<dim> &history);
} // namespace stickslip

#endif
