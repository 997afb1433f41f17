// Cycles of contact statuses: states are put into the points by hand, as
// functions of iteration and position, and must be found again on any number
// of ranks.

#include "print.h"

#include <stickslip/contact/cycling/status_history.h>

#include <stickslip/problem/contact_problem.h>

#include <algorithm>
#include <cctype>
#include <functional>
#include <memory>
#include <sstream>
#include <vector>

using namespace stickslip;

namespace
{
  /// A block with six slave faces on another one.
  template <int dim>
  Mesh<dim>
  make_mesh()
  {
    BodyParameters upper, lower;
    upper.generator = lower.generator = "subdivided_hyper_rectangle";
    upper.arguments =
      dim == 2 ? "6,1 : 0,1 : 6,2 : true" : "6,1,1 : 0,1,0 : 6,2,1 : true";
    lower.arguments =
      dim == 2 ? "3,2 : 0,0 : 6,1 : true" : "3,2,1 : 0,0,0 : 6,1,1 : true";
    upper.material = lower.material = "rubber";
    return build_mesh<dim>(MeshParameters(),
                           {{"upper", upper}, {"lower", lower}},
                           {},
                           MPI_COMM_WORLD);
  }



  template <int dim>
  std::unique_ptr<ContactProblem<dim>>
  make_problem(Mesh<dim> &mesh)
  {
    NamedList<MaterialParameters> materials(1);
    materials[0].first = "rubber";
    ParameterHandler prm;
    materials[0].second.choose_law("St Venant-Kirchhoff", "Materials/rubber");
    materials[0].second.add_parameters(prm);
    prm.set("Young's modulus", 10.);
    prm.set("Poisson's ratio", 0.3);

    ContactPairParameters pair;
    pair.quadrature           = ContactRule::nodal;
    pair.slave_body           = "upper";
    pair.slave_boundary       = {"2"};
    pair.master_body          = "lower";
    pair.master_boundary      = {"3"};
    pair.friction             = Friction::Coulomb;
    pair.friction_coefficient = 0.4;
    pair.quadrature           = ContactRule::Gauss;
    pair.quadrature_order     = 2;
    return std::make_unique<ContactProblem<dim>>(
      mesh,
      1,
      materials,
      NamedList<BoundaryConditionParameters>(),
      NamedList<ContactPairParameters>{{"pair", pair}},
      false);
  }



  /// What the points on slave face 0 ... 5 do in an iteration, a letter of
  /// StatusHistory::text(); capital letters: on another facet.
  using Script =
    std::function<char(const unsigned int iteration, const unsigned int face)>;

  template <int dim>
  void
  act(ContactPoint<dim> &point, const char letter, const FaceId &home)
  {
    const char lower      = std::tolower(letter);
    point.pairing.paired  = lower != 'u';
    point.pairing.face_id = home;
    point.pairing.face_id.face += letter != lower;
    point.pairing.free.fill(true);
    point.observed = ObservedState<dim>();
    switch (lower)
      {
        case 'o':
          point.observed.state = ContactState::open;
          break;
        case 's':
          point.observed.state = ContactState::stick;
          break;
        case 'f':
        case 'b':
          point.observed.state             = ContactState::slip;
          point.observed.slip_direction[0] = lower == 'f' ? 1. : -1.;
          break;
        case 'c':
          point.observed.state = ContactState::slip;
          break;
        default:
          break;
      }
  }



  /// Lines of all ranks, sorted.
  std::string
  gathered(const std::vector<std::string> &lines)
  {
    std::vector<std::string> all;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(MPI_COMM_WORLD, lines))
      all.insert(all.end(), of_rank.begin(), of_rank.end());
    std::sort(all.begin(), all.end());
    std::string text;
    for (const std::string &line : all)
      text += "\n    " + line;
    return text;
  }



  template <int dim>
  std::string
  describe(const StatusHistory<dim>    &history,
           const ContactAssembler<dim> &contact)
  {
    std::vector<std::string> lines;
    for (const PointCycle &cycle : history.cycling_points())
      {
        std::ostringstream line;
        line << "face "
             << static_cast<unsigned int>(contact.contact_pairs()[cycle.pair]
                                            ->points[cycle.point]
                                            .geometry.reference_position[0])
             << ": " << history.text(cycle.pair, cycle.point) << ", "
             << name_of(cycle.kind) << ", period " << cycle.period
             << (cycle.changes_facet ? ", changes facet" : "") << ", "
             << history.n_facet_changes(cycle.pair, cycle.point)
             << " facet changes";
        lines.push_back(line.str());
      }
    return "period " + std::to_string(history.cycle().period) + " after " +
           std::to_string(history.n_records()) + gathered(lines);
  }



  template <int dim>
  void
  play(const std::string     &title,
       ContactAssembler<dim> &contact,
       const unsigned int     n_iterations,
       const Script          &script)
  {
    static StatusHistory<dim> history;
    history.clear();
    auto &points = contact.contact_pairs()[0]->points;
    for (unsigned int k = 0; k < n_iterations; ++k)
      {
        for (auto &point : points)
          act(point,
              script(k,
                     static_cast<unsigned int>(
                       point.geometry.reference_position[0])),
              FaceId());
        history.record(contact);
      }
    print("  " + title + ": " + describe(history, contact));
  }



  /// Face 0 repeats @p sequence, the others do @p rest.
  Script
  repeating(const std::string &sequence, const char rest = 's')
  {
    return [=](const unsigned int k, const unsigned int face) {
      return face == 0 ? sequence[k % sequence.size()] : rest;
    };
  }



  template <int dim>
  void
  test()
  {
    print(std::to_string(dim) + "D");
    Mesh<dim>  mesh    = make_mesh<dim>();
    const auto problem = make_problem<dim>(mesh);
    auto      &contact = problem->contact();

    play("constant", contact, 20, repeating("s"));
    play("two periods are no proof", contact, 5, repeating("os"));
    play("three periods are", contact, 6, repeating("os"));
    play("longer than the memory", contact, 101, repeating("os"));
    play("stick and slip", contact, 12, repeating("ssf"));
    play("to and fro", contact, 12, repeating("fb"));
    play("backward is a matter of view", contact, 12, repeating("bf", 'b'));
    play("from facet to facet", contact, 12, repeating("sS"));
    play("opens on the other facet", contact, 12, repeating("sO"));
    play("paired and unpaired", contact, 12, repeating("uo"));
    play("of period 6", contact, 18, repeating("ooosss"));
    play("of period 7", contact, 32, repeating("oooosss"));
    play("without friction", contact, 12, repeating("oc", 'c'));
    play("periods 2 and 3 make 6",
         contact,
         18,
         [](const unsigned int k, const unsigned int face) {
           return face == 0 ? "os"[k % 2] : face == 5 ? "fss"[k % 3] : 's';
         });
    play("one point alone repeats, another goes on",
         contact,
         32,
         [](const unsigned int k, const unsigned int face) {
           return face == 0 ? "os"[k % 2] : face == 5 && k >= 29 ? 'f' : 's';
         });
    play("ends in a fixed point",
         contact,
         14,
         [](const unsigned int k, const unsigned int face) {
           return face == 0 && k < 12 ? "os"[k % 2] : 's';
         });

    // what add_residual() observes
    LA::BlockVector x = problem->zero_state();
    for (const auto &node : contact.multipliers().owned_nodes())
      {
        x.block(1)(node.first_dof)     = -1.;
        x.block(1)(node.first_dof + 1) = 2.;
      }
    x.compress(VectorOperation::insert);
    problem->begin_step(0., problem->zero_state());
    problem->begin_iteration(x);
    problem->residual(x);
    StatusHistory<dim> history;
    history.record(contact);
    std::vector<std::string> texts;
    for (unsigned int i = 0; i < contact.contact_pairs()[0]->points.size(); ++i)
      texts.push_back(history.text(0, i));
    print("  pressed and pushed beyond the cone:" + gathered(texts));
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test<2>();
  test<3>();
}
