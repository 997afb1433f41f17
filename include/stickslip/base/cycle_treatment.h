#ifndef stickslip_base_cycle_treatment_h
#define stickslip_base_cycle_treatment_h

namespace stickslip
{
  /// What was found and done about iterates that repeat themselves.
  enum class CycleTreatment
  {
    none,       ///< no cycle, or none that has to be treated
    treated,    ///< the equations of some points are other ones now
    untreatable ///< a cycle, and nothing left to try
  };
} // namespace stickslip

#endif
