// What the names of the algorithms stand for: live or frozen, the order in
// which `automatic` tries them, what a user is advised to choose.

#include <stickslip/strategy/solution_strategy.h>

#include <deal.II/base/parameter_handler.h>

#include <iostream>
#include <string>

using namespace stickslip;

namespace
{
  class Quantity : public FreezableQuantity
  {
  public:
    std::string
    name() const override
    {
      return "quantity";
    }
    void
    set_live(const bool) override
    {}
    void
    evaluate(const LA::BlockVector &) override
    {}
    double
    change() const override
    {
      return 0.;
    }
    void
    accept() override
    {}
  };



  void
  print_strategy(const Algorithm            algorithm,
                 const AlgorithmParameters &parameters)
  {
    Quantity               quantity;
    SolveCounts            counts;
    const SolutionStrategy strategy = strategy_of(algorithm, parameters);
    const auto             loops    = make_loops(strategy,
                                  parameters,
                                  {{&quantity, &quantity, &quantity}},
                                  counts);
    std::cout << name_of(algorithm) << ':';
    for (const FixedPointLoop &loop : loops)
      std::cout << (loop.is_live ? " live" : " frozen");
    if (strategy.increment_solver ==
        IncrementSolver::projected_conjugate_gradient)
      std::cout << ", projected conjugate gradient";
    if (needs_law_per_multiplier(algorithm))
      std::cout << ", nodal quadrature only";
    const unsigned int n = loops[1].n_failures_outlived;
    std::cout << "; the threshold loop outlives "
              << (n > 1000 ? "all" : std::to_string(n)) << " failures\n";
  }



  void
  print_sequence(const Algorithm chosen, const bool has_contact)
  {
    std::cout << name_of(chosen)
              << (has_contact ? " with contact:" : " without contact:");
    for (const Algorithm algorithm : fallback_sequence(chosen, has_contact))
      std::cout << ' ' << name_of(algorithm);
    std::cout << '\n';
  }



  /// The algorithm parameters of a case with these lines.
  void
  read(AlgorithmParameters &parameters, const std::string &text)
  {
    dealii::ParameterHandler prm;
    parameters.add_parameters(prm);
    prm.parse_input_from_string(text);
  }
} // namespace



int
main()
{
  AlgorithmParameters parameters;
  std::cout << "Geometry, threshold, status:\n";
  for (const auto &[name, algorithm] : all_algorithms())
    if (algorithm != Algorithm::automatic)
      print_strategy(algorithm, parameters);

  read(parameters,
       "set Name = custom\n"
       "set Tangent = quasi\n"
       "subsection Threshold\n set Treatment = fixed point\nend\n"
       "subsection Geometry\n set Acceleration = none\nend\n");
  std::cout << "As a .prm says:\n";
  print_strategy(parameters.name, parameters);
  std::cout << "quasi tangent: "
            << (parameters.tangent == Tangent::quasi ? "yes" : "NO")
            << ", no acceleration of the geometry loop: "
            << (parameters.geometry.acceleration == Acceleration::none ? "yes"
                                                                       : "NO")
            << '\n';

  for (const bool has_contact : {true, false})
    for (const Algorithm chosen :
         {Algorithm::automatic, Algorithm::fpm, Algorithm::custom})
      print_sequence(chosen, has_contact);
  std::cout << advice_to_freeze_geometry() << "\n"
            << advice_to_fall_back() << "\n"
            << advice_to_avoid_loops() << "\n";
}
