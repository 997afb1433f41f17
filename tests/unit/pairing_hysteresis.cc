// What a contact point's changes of facet and partner mean for its next
// pairing: nothing unless it learns, and in later steps what it has learnt.

#include <stickslip/contact/point/contact_point.h>

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



  /// Changes to and fro between two facets; ends at @p xi of the second one.
  void
  hop(ContactPoint<2> &point, const unsigned int n_changes, const double xi)
  {
    for (unsigned int i = 0; i < n_changes; ++i)
      point.set_frame(on_facet((n_changes - i) % 2, 0.5));
    point.pairing.xi[0] = xi;
  }



  /// Loses and finds its partner at the end of the master surface.
  void
  come_and_go(ContactPoint<2> &point, const unsigned int n_changes)
  {
    Pairing<2> at_the_end = on_facet(1, 1.);
    at_the_end.free.fill(false);
    for (unsigned int i = 0; i < n_changes; ++i)
      point.set_frame(point.pairing.paired ? Pairing<2>() : at_the_end);
  }



  void
  print(const std::string &title, const ContactPoint<2> &point)
  {
    const PairingMemory memory = point.pairing_memory();
    std::cout << title << ": " << (point.hops_between_facets() ? "hops, " : "")
              << (point.hops_over_the_end() ? "comes and goes, " : "")
              << "overlap x " << memory.overlap_factor
              << (memory.clings ? ", clings" : "") << std::endl;
  }



  ContactPoint<2>
  new_point(const bool learns)
  {
    ContactPoint<2> point;
    point.pairing = on_facet(1, 0.5);
    point.learns  = learns;
    point.accept_frame();
    return point;
  }



  void
  test_facets()
  {
    for (const unsigned int n : {4, 6, 12, 18})
      for (const bool learns : {false, true})
        {
          ContactPoint<2> point = new_point(learns);
          hop(point, n, 0.5);
          print(std::to_string(n) + " changes of facet" +
                  (learns ? ", learns" : ""),
                point);
        }

    ContactPoint<2> point = new_point(true);
    hop(point, 6, 1.005);
    point.accept_frame();
    point.learns = false;
    print("accepted beyond its facet", point);
    hop(point, 6, 1.005);
    print("6 changes more without learning", point);
    point.accept_frame();
    print("accepted", point);
    point.learns = true;
    hop(point, 6, 0.5);
    print("6 changes more, learns", point);
    point.restore_frame();
    print("the step fails", point);
    point.pairing = on_facet(1, 0.5);
    point.accept_frame();
    print("accepted inside its facet", point);
  }



  void
  test_end()
  {
    for (const unsigned int n : {2, 4})
      for (const bool learns : {false, true})
        {
          ContactPoint<2> point = new_point(learns);
          come_and_go(point, n);
          print("partner lost and found, " + std::to_string(n) + " changes" +
                  (learns ? ", learns" : ""),
                point);
          point.accept_frame();
          point.learns = false;
          print("  accepted", point);
        }
    ContactPoint<2> point = new_point(true);
    come_and_go(point, 4);
    point.accept_frame();
    point.learns = false;
    point.set_frame(on_facet(1, 0.5));
    point.accept_frame();
    print("and inside again", point);
  }
} // namespace



int
main()
{
  test_facets();
  test_end();
}
