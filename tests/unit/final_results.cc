// The results at the end of a run: what is printed as zero because it is
// roundoff relative to values of its family, and what is not.

#include <stickslip/simulation/final_results.h>

#include <iostream>
#include <string>

using namespace stickslip;

namespace
{
  void
  print(const std::string &title, const FinalResults &results)
  {
    std::cout << "-- " << title << '\n';
    results.print(std::cout);
  }



  /// Forces are compared with those of all pairs, whatever their names.
  void
  test_forces()
  {
    FinalResults results;
    results.add_of_pair("upper", {"load_x", 30., ResultantFamily::force});
    results.add_of_pair("upper", {"load_y", 2e10, ResultantFamily::force});
    results.add_of_pair("lower", {"force_x", 50., ResultantFamily::force});
    results.add_of_pair("lower", {"force_y", 300., ResultantFamily::force});
    print("forces of two pairs", results);
  }



  /// Moments and positions are compared within their pair, and not with each
  /// other.
  void
  test_vectors_of_a_pair()
  {
    FinalResults results;
    for (const std::string pair : {"upper", "lower"})
      {
        const double size = pair == "upper" ? 1e10 : 10.;
        results.add_of_pair(pair,
                            {"moment_x", 1e3 * size, ResultantFamily::moment});
        results.add_of_pair(pair,
                            {"moment_y", 1e-6 * size, ResultantFamily::moment});
        results.add_of_pair(
          pair, {"centre_of_pressure_x", size, ResultantFamily::position});
        results.add_of_pair(pair,
                            {"centre_of_pressure_y",
                             1e-6 * size,
                             ResultantFamily::position});
      }
    print("vectors of two pairs", results);
  }



  /// A single value is never roundoff: there is nothing to compare it with.
  void
  test_single_values()
  {
    FinalResults results;
    results.add_of_pair("pair", {"force_y", 1e16, ResultantFamily::force});
    results.add_of_pair("pair",
                        {"friction_work", -5., ResultantFamily::single});
    results.add_of_pair("pair", {"work_force_x", 7., ResultantFamily::single});
    print("single values", results);
  }



  /// What the pairs themselves say.
  template <int dim>
  void
  test_families()
  {
    const char *const names[] = {"force", "moment", "position", "single"};
    std::cout << "-- families in " << dim << "D\n";
    for (const NamedResultant &resultant :
         ContactResultants<dim>().named_values())
      std::cout << resultant.name << ": "
                << names[static_cast<int>(resultant.family)] << '\n';
  }
} // namespace



int
main()
{
  test_forces();
  test_vectors_of_a_pair();
  test_single_values();
  test_families<2>();
  test_families<3>();
}
