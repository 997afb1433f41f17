// What a contact point's changes of facet and partner mean for its next
// pairing: nothing unless the hysteresis is active, and in later steps what is
// left of it.

#include <stickslip/contact/point/pairing_hysteresis.h>

#include <iostream>
#include <string>

using namespace stickslip;

namespace
{
  /// On a facet at @p xi; 0 to 1 is inside.
  Pairing<2>
  on_facet(const unsigned int facet, const double xi)
  {
    Pairing<2> frame;
    frame.paired       = true;
    frame.face_id.face = facet;
    frame.xi[0]        = xi;
    frame.free.fill(true);
    return frame;
  }



  /// A point with its present pairing.
  struct Partner
  {
    Pairing<2>           pairing;
    PairingHysteresis<2> hysteresis;

    void
    move_to(const Pairing<2> &found)
    {
      pairing = found;
      hysteresis.accept_iterate(found);
    }

    void
    accept_step()
    {
      hysteresis.accept_step(pairing);
    }
  };



  /// Changes to and fro between two facets; ends at @p xi of the second one.
  void
  hop(Partner &point, const unsigned int n_changes, const double xi)
  {
    for (unsigned int i = 0; i < n_changes; ++i)
      point.move_to(on_facet((n_changes - i) % 2, 0.5));
    point.pairing.xi[0] = xi;
  }



  /// Loses and finds its partner at the end of the master surface.
  void
  come_and_go(Partner &point, const unsigned int n_changes)
  {
    Pairing<2> at_the_end = on_facet(1, 1.);
    at_the_end.free.fill(false);
    for (unsigned int i = 0; i < n_changes; ++i)
      point.move_to(point.pairing.paired ? Pairing<2>() : at_the_end);
  }



  void
  print(const std::string &title, const Partner &point)
  {
    const EdgeRetention retention = point.hysteresis.retention();
    std::cout << title << ": "
              << (point.hysteresis.switches_facets() ? "switches, " : "")
              << (point.hysteresis.switches_at_end() ? "comes and goes, " : "")
              << "overlap x " << retention.overlap_factor
              << (retention.beyond_end ? ", kept beyond the end" : "")
              << std::endl;
  }



  Partner
  new_point(const bool active)
  {
    Partner point;
    point.pairing = on_facet(1, 0.5);
    point.hysteresis.set_active(active);
    point.accept_step();
    return point;
  }



  void
  test_facets()
  {
    for (const unsigned int n : {4, 6, 12, 18})
      for (const bool active : {false, true})
        {
          Partner point = new_point(active);
          hop(point, n, 0.5);
          print(std::to_string(n) + " changes of facet" +
                  (active ? ", active" : ""),
                point);
        }

    Partner point = new_point(true);
    hop(point, 6, 1.005);
    point.accept_step();
    point.hysteresis.set_active(false);
    print("accepted beyond its facet", point);
    hop(point, 6, 1.005);
    print("6 changes more while not active", point);
    point.accept_step();
    print("accepted", point);
    point.hysteresis.set_active(true);
    hop(point, 6, 0.5);
    print("6 changes more, active", point);
    point.hysteresis.restore();
    print("the step fails", point);
    point.pairing = on_facet(1, 0.5);
    point.accept_step();
    print("accepted inside its facet", point);
  }



  void
  test_end()
  {
    for (const unsigned int n : {2, 4})
      for (const bool active : {false, true})
        {
          Partner point = new_point(active);
          come_and_go(point, n);
          print("partner lost and found, " + std::to_string(n) + " changes" +
                  (active ? ", active" : ""),
                point);
          point.accept_step();
          point.hysteresis.set_active(false);
          print("  accepted", point);
        }
    Partner point = new_point(true);
    come_and_go(point, 4);
    point.accept_step();
    point.hysteresis.set_active(false);
    point.move_to(on_facet(1, 0.5));
    point.accept_step();
    print("and inside again", point);
  }
} // namespace



int
main()
{
  test_facets();
  test_end();
}
