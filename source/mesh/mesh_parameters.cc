#include <stickslip/mesh/mesh_parameters.h>

#include <stickslip/base/expert_parameter.h>
#include <stickslip/base/user_error.h>

namespace stickslip
{
  const Choices<Partitioner> &
  all_partitioners()
  {
    static const Choices<Partitioner> choices = {{"automatic",
                                                  Partitioner::automatic},
                                                 {"p4est", Partitioner::p4est},
                                                 {"METIS", Partitioner::metis}};
    return choices;
  }



  bool
  MeshParameters::has_use_for_curves() const
  {
    return degree > 1 || global_refinements > 0 || !refinements.empty() ||
           !later_refinement.empty() || goes_on_refined;
  }



  void
  MeshParameters::add_parameters(ParameterHandler &prm)
  {
    add_choice(prm,
               "Partitioner",
               partitioner,
               all_partitioners(),
               expert(
                 "How cells are distributed: p4est (along a space-filling "
                 "curve, body after body) or METIS (graph partitioning: all "
                 "ranks have as many cells and as many slave faces; one rank "
                 "holds the whole mesh for that; models with triangles or "
                 "tetrahedra always). automatic: METIS for named contact pairs "
                 "on several ranks, if the mesh has at most 100,000 cells, 20 "
                 "on each rank, and is not refined locally."));
    prm.add_parameter("Global refinements",
                      global_refinements,
                      "Uniform refinements of all bodies, after those of each "
                      "body.",
                      Patterns::Integer(0, 12));
    prm.add_parameter(
      "Contact weight",
      contact_weight,
      expert("What a slave face costs, in cells, where p4est distributes "
             "them. 0: only cells count. A run can be continued "
             "(--restart) with another weight, which distributes it again."),
      Patterns::Double(0., 1000.));
  }

} // namespace stickslip
