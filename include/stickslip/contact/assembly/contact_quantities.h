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
   * A quantity with one @p Value at each contact point, live or frozen there.
   * change() and accept() follow evaluate(), with the same points.
   */
  template <int dim, typename Value>
  class PointQuantity : public FreezableQuantity
  {
  public:
    std::string
    name() const override
    {
      return label;
    }

    void
    set_live(const bool live) override
    {
      contact.live.*flag = live;
    }

    void
    evaluate(const LA::BlockVector &x) override;

    void
    accept() override;

  protected:
    ContactAssembler<dim> &contact;

    /// @p flag says whether the quantity is live.
    PointQuantity(const std::string &name,
                  bool Liveness::*const   flag,
                  ContactAssembler<dim>  &contact,
                  const ConfigureContact &configure);

    /// In the present configuration.
    virtual Value
    value_at(const ContactPair<dim>  &pair,
             const ContactPoint<dim> &point) const = 0;

    virtual void
    freeze(ContactPoint<dim> &point, const Value &value) const = 0;

    /// Calls @p visit(point, value) for all points with their evaluated values.
    template <typename Visitor>
    void
    for_each_value(const Visitor &visit) const;

  private:
    std::string label;
    bool Liveness::*const flag;
    ConfigureContact      configure;
    std::vector<Value>    values; ///< in the order of for_each_point()
  };



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
    ContactAssembler<dim>          &contact;
    ConfigureContact                configure;
    std::vector<FoundPairings<dim>> pairings; ///< [pair]
    LA::Vector                      evaluated_at;
    LA::Vector                      accepted_at;
  };



  /**
   * Friction threshold of all contact points. Its change is the paper's
   * Res(seuil), the largest change over the largest threshold.
   */
  template <int dim>
  class FrictionThresholdField : public PointQuantity<dim, double>
  {
  public:
    FrictionThresholdField(ContactAssembler<dim>  &contact,
                           const ConfigureContact &configure);

    double
    change() const override;

  private:
    double
    value_at(const ContactPair<dim>  &pair,
             const ContactPoint<dim> &point) const override
    {
      return this->contact.live_threshold(pair, point);
    }

    void
    freeze(ContactPoint<dim> &point, const double &threshold) const override
    {
      point.frozen.threshold = threshold;
    }
  };



  /// Contact status S_c of all points. Its change is the number of flips.
  template <int dim>
  class ContactStatusField : public PointQuantity<dim, bool>
  {
  public:
    ContactStatusField(ContactAssembler<dim>  &contact,
                       const ConfigureContact &configure);

    double
    change() const override;

    /// Of the set of closed points.
    std::uint64_t
    fingerprint() const override;

  private:
    bool
    value_at(const ContactPair<dim>  &pair,
             const ContactPoint<dim> &point) const override
    {
      return this->contact.live_closed(pair, point);
    }

    void
    freeze(ContactPoint<dim> &point, const bool &closed) const override
    {
      point.frozen.closed = closed;
    }
  };
} // namespace stickslip

#endif
