#ifndef stickslip_contact_assembly_contact_quantities_h
#define stickslip_contact_assembly_contact_quantities_h

#include <stickslip/base/freezable_quantity.h>

#include <stickslip/contact/assembly/contact_assembler.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace stickslip
{
  /// Brings the contact assembler to the configuration of a solution vector.
  /// With `true` the master patches may be fetched anew.
  using ConfigureContact =
    std::function<void(const LA::BlockVector &, const bool)>;

  /**
   * Pairing, projection and local frame of all contact points. Its change is
   * the paper's Res(geom): the largest displacement change since the last
   * refresh over the largest displacement.
   */
  template <int dim>
  class ContactGeometry : public FreezableQuantity
  {
  public:
    ContactGeometry(ContactAssembler<dim>  &contact,
                    const ConfigureContact &configure);

    std::string
    name() const override;

    void
    set_live(const bool live) override;

    void
    evaluate(const LA::BlockVector &x) override;

    double
    change() const override;

    void
    accept() override;

  private:
    ContactAssembler<dim>                 &contact;
    ConfigureContact                       configure;
    std::vector<std::vector<Pairing<dim>>> pairings; ///< [pair][point]
    LA::Vector                             evaluated_at;
    LA::Vector                             accepted_at;
  };



  /**
   * Friction threshold of all contact points. Its change is the paper's
   * Res(seuil), the largest change over the largest threshold.
   */
  template <int dim>
  class FrictionThresholdField : public FreezableQuantity
  {
  public:
    FrictionThresholdField(ContactAssembler<dim>  &contact,
                           const ConfigureContact &configure);

    std::string
    name() const override;

    void
    set_live(const bool live) override;

    void
    evaluate(const LA::BlockVector &x) override;

    double
    change() const override;

    void
    accept() override;

  private:
    ContactAssembler<dim>           &contact;
    ConfigureContact                 configure;
    std::vector<std::vector<double>> thresholds; ///< [pair][point]
  };



  /// Contact status S_c of all points. Its change is the number of flips.
  template <int dim>
  class ContactStatusField : public FreezableQuantity
  {
  public:
    ContactStatusField(ContactAssembler<dim>  &contact,
                       const ConfigureContact &configure);

    std::string
    name() const override;

    void
    set_live(const bool live) override;

    void
    evaluate(const LA::BlockVector &x) override;

    double
    change() const override;

    void
    accept() override;

    /// Of the set of closed points.
    std::uint64_t
    fingerprint() const override;

  private:
    ContactAssembler<dim>         &contact;
    ConfigureContact               configure;
    std::vector<std::vector<bool>> closed; ///< [pair][point]
  };
} // namespace stickslip

#endif
