#ifndef stickslip_problem_automatic_pairs_h
#define stickslip_problem_automatic_pairs_h

#include <stickslip/base/parameter_file.h>

#include <stickslip/contact/point/automatic_contact.h>

#include <stickslip/mesh/mesh_builder.h>

#include <stickslip/solid/boundary_condition_parameters.h>
#include <stickslip/solid/material_parameters.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// Contact pairs that the user need not name.
  struct AutomaticPairs
  {
    NamedList<ContactPairParameters> pairs;
    std::vector<std::string>         reasons; ///< who is slave of whom, and why
  };

  /**
   * Pairs between all bodies of @p mesh that none of the @p explicit_pairs
   * names together and of which one can deform, one for two bodies: all
   * boundaries of the slave, so that its edges have corner normals, against the
   * whole boundary of the master. Left out are symmetry planes and
   * periodic boundaries; of a slave also boundaries whose displacement is
   * prescribed. The roles are chosen as a user is advised to:
   *
   * 1. what is rigid, or moved as a whole, is master;
   * 2. of flat surfaces opposite each other the smaller one is slave: it does
   *    not slide over the end of the other one;
   * 3. the softer body is slave;
   * 4. the one with the finer mesh is slave.
   *
   * With AutomaticContact::self_contact also one for each body that can deform
   * and that no explicit pair pairs with itself.
   *
   * The same on all ranks, and on any number of them. Throws UserError if there
   * is nothing to pair. Collective.
   */
  template <int dim>
  AutomaticPairs
  automatic_pairs(const Mesh<dim>                              &mesh,
                  const AutomaticContact                       &parameters,
                  const NamedList<ContactPairParameters>       &explicit_pairs,
                  const NamedList<BoundaryConditionParameters> &conditions,
                  const NamedList<MaterialParameters>          &materials);
} // namespace stickslip

#endif
