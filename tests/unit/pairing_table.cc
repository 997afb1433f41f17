// Which partners a slave surface finds, in configurations whose partners are
// known: with whole boundaries as surfaces, three rules, and no search
// distance. Two bodies, a slave and a master, are moved as rigid bodies.

#include "case_problem.h"
#include "print.h"

#include <stickslip/contact/pairing/contact_pair.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace
{
  using namespace stickslip;

  /// A generator in two dimensions; in three it is as long as the others.
  struct Shape
  {
    std::string generator;
    std::string arguments;
    std::string arguments_3d;
    std::string coordinates = ""; ///< of x and y
    std::string boundary    = "0, 1, 2, 3";
  };



  /// A rectangle of cells x cells, 1 long in 3D.
  Shape
  block(const double x0,
        const double y0,
        const double x1,
        const double y1,
        const int    cells = 4)
  {
    std::ostringstream flat, solid;
    flat << cells << ", " << cells << " : " << x0 << ", " << y0 << " : " << x1
         << ", " << y1 << " : true";
    solid << cells << ", " << cells << ", 2 : " << x0 << ", " << y0
          << ", 0 : " << x1 << ", " << y1 << ", 1 : true";
    return {"subdivided_hyper_rectangle", flat.str(), solid.str()};
  }



  Shape
  with_boundary(Shape shape, const std::string &boundary)
  {
    shape.boundary = boundary;
    return shape;
  }



  /// A plate of few cells over its thickness.
  Shape
  plate(const double x0, const double y0, const double x1, const double y1)
  {
    std::ostringstream flat, solid;
    flat << "4, 1 : " << x0 << ", " << y0 << " : " << x1 << ", " << y1
         << " : true";
    solid << "4, 1, 2 : " << x0 << ", " << y0 << ", 0 : " << x1 << ", " << y1
          << ", 1 : true";
    return {"subdivided_hyper_rectangle", flat.str(), solid.str()};
  }



  /// Two legs of thickness 0.2, from y = 0 to 1, with a slot of width 1 between
  /// them, and half a ring below. Boundary 2 is its outside, 3 its inside.
  Shape
  channel()
  {
    return {
      "subdivided_hyper_rectangle",
      "12, 1 : 0, 0 : 3, 0.2 : true",
      "12, 1, 2 : 0, 0, 0 : 3, 0.2, 1 : true",
      "if(x < 1, y - 0.7, if(x < 2, (y - 0.7)*cos(pi*(x - 1)), 0.7 - y)); "
      "if(x < 1, 1 - x, if(x < 2, (y - 0.7)*sin(pi*(x - 1)), x - 2))"};
  }



  /// A quarter of a ring. Boundary 0 is its inside, 1 its outside.
  Shape
  ring(const double inner, const double outer)
  {
    std::ostringstream text;
    text << inner << " : " << outer << " : 0 : 90 : 1 : 8 : 1 : 2";
    return {"annular_sector", text.str(), text.str(), "", "0, 1"};
  }



  /// Three quarters of a square from -1 to 1, without that of positive x and y,
  /// where boundary 3 is.
  Shape
  angle()
  {
    // a strip that is bent over its middle; 3 is its inside
    return {"subdivided_hyper_rectangle",
            "8, 4 : -1, 0 : 1, 1 : true",
            "8, 4, 2 : -1, 0, 0 : 1, 1, 1 : true",
            "if(x < 0, y - 1, x*(2 - y) - 1 + y); "
            "if(x < 0, -x*(2 - y) - 1 + y, y - 1)"};
  }



  /// One line of the table.
  struct Configuration
  {
    std::string title;
    Shape       slave, master;
    /// Slave boundary > master boundary and what the gap is, in this order.
    std::string partners;
    double      motion_x = 0.; ///< of the slave in the step
    double      motion_y = 0.;
    /// Master boundaries, if not all.
    std::string master_boundary = "";
    /// Where a rule differs from `partners` by its nature.
    std::map<std::string, std::string> partners_of_rule = {};
  };



  std::vector<Configuration>
  table()
  {
    const Shape base = block(0, 0, 2, 1);
    const Shape unit = block(0, 0, 1, 1);
    return {
      {"blocks 1 apart", block(0, 2, 2, 3), base, "2>3 open"},
      {"blocks 0.6 apart", block(0, 1.6, 2, 2.6), base, "2>3 open"},
      {"blocks 1 apart, coarse", block(0, 2, 2, 3, 1), base, "2>3 open"},
      {"blocks touch", block(0, 1, 2, 2), base, "2>3 touching"},
      {"blocks overlap", block(0, 0.9, 2, 1.9), base, "2>3 overlap"},
      {"blocks overlap by 0.3", block(0.2, 0.7, 1.8, 1.7), base, "2>3 overlap"},
      {"block side by side", block(2.3, 0, 3.3, 1), base, "0>1 open"},
      {"small block over a large one",
       block(0.9, 1.05, 1.1, 1.25, 2),
       base,
       "2>3 open"},
      {"metre beside millimetre", block(400, 1200, 600, 1400), base, "nothing"},
      {"plates apart",
       plate(0, 0.1, 2, 0.15),
       plate(0, 0, 2, 0.05),
       "2>3 open"},
      {"plates pressed",
       plate(0, 0.03, 2, 0.08),
       plate(0, 0, 2, 0.05),
       "2>3 overlap"},
      {"plate through a plate in one step",
       plate(0, 0.07, 2, 0.12),
       plate(0, 0, 2, 0.05),
       "2>3 overlap, 3>2 open",
       0.,
       -0.3},
      {"plate behind a plate",
       plate(0, -0.25, 2, -0.2),
       plate(0, 0, 2, 0.05),
       "3>2 open"},
      {"thick block on a plate",
       block(0, 0.06, 2, 1.06),
       plate(0, 0, 2, 0.05),
       "2>3 open"},
      {"thick block below a plate",
       block(0, -1.01, 2, -0.01),
       plate(0, 0, 2, 0.05),
       "3>2 open"},
      {"block over the end of a plate, above",
       block(1.6, 0.06, 2.6, 1.06),
       plate(0, 0, 2, 0.05),
       "2>3 open"},
      {"block over the end of a plate, on it",
       block(1.6, 0.05, 2.6, 1.05),
       plate(0, 0, 2, 0.05),
       "2>3 touching"},
      {"block over the end of a plate, in it",
       block(1.6, 0.04, 2.6, 1.04),
       plate(0, 0, 2, 0.05),
       "2>3 overlap"},
      {"block over the end of a block, above",
       block(0.6, 1.02, 1.6, 2.02),
       unit,
       "2>3 open"},
      {"block over the end of a block, on it",
       block(0.6, 1, 1.6, 2),
       unit,
       "2>3 touching"},
      {"block over the end of a block, in it",
       block(0.6, 0.95, 1.6, 1.95),
       unit,
       "2>3 overlap"},
      {"block slides over the end",
       block(0.7, 1, 1.7, 2),
       unit,
       "2>3 touching",
       -0.1},
      {"beyond the end of a tool",
       block(1.2, 0.5, 2.2, 1.5),
       unit,
       "nothing",
       0.,
       0.,
       "3"},
      {"beyond the end of a block",
       block(1.2, 0.5, 2.2, 1.5),
       unit,
       "0>1 open"},
      {"corner over a corner", block(0.8, 1.05, 1.8, 2.05), unit, "2>3 open"},
      {"corner in a corner", block(0.8, 0.95, 1.8, 1.95), unit, "2>3 overlap"},
      {"corner in a corner, the other way",
       block(0.95, 0.8, 1.95, 1.8),
       unit,
       "0>1 overlap"},
      {"block in a corner",
       block(0.05, 0.05, 0.55, 0.55),
       angle(),
       "0>3 open, 2>3 open"},
      {"wall in a slot",
       block(-0.4, 0.1, 0.4, 0.9),
       channel(),
       "0>3 open, 1>3 open, 2>3 open"},
      {"wall touches one side of a slot",
       block(-0.5, 0.1, 0.4, 0.9),
       channel(),
       "0>3 touching, 1>3 open, 2>3 open",
       0.,
       0.,
       "",
       // the smoothed normal of the leg leans towards the corner of the wall
       {{"nodal", "0>3 touching, 1>3 open, 2>3 open, 2>3 touching"}}},
      {"slot around a wall",
       channel(),
       block(-0.4, 0.1, 0.4, 0.9),
       "3>0 open, 3>1 open, 3>2 open"},
      {"snap-fit, clipped on",
       channel(),
       block(-0.55, 0.2, 0.55, 0.8),
       "3>0 overlap, 3>1 overlap, 3>2 open"},
      {"beside a leg of a slot",
       with_boundary(block(-1.15, 0.5, -0.75, 0.9, 2), "0, 1"),
       channel(),
       "1>2 open"},
      {"through a leg in one step",
       block(-1.15, 0.5, -0.75, 0.9, 2),
       channel(),
       "0>3 open, 1>2 overlap, 2>3 open",
       0.7},
      {"in the slot, at rest",
       block(-0.25, 0.3, 0.15, 0.7, 2),
       channel(),
       "0>3 open, 1>3 open, 2>3 open"},
      {"pin in a hole", ring(0.3, 0.9), ring(1, 1.4), "1>0 open"},
      {"pin in a hole, pressed", ring(0.3, 1.02), ring(1, 1.4), "1>0 overlap"},
      {"hole around a pin", ring(1, 1.4), ring(0.3, 0.9), "0>1 open"},
      {"nested shells", ring(0.8, 0.85), ring(0.9, 0.95), "1>0 open"},
      {"nested shells, pressed",
       ring(0.82, 0.92),
       ring(0.9, 0.98),
       "1>0 overlap"},
      {"shell through a shell in one step",
       plate(0, 0.3, 2, 0.35),
       plate(0, 0, 2, 0.05),
       "2>3 overlap, 3>2 open",
       0.1,
       -0.45}};
  }



  std::string
  in_dimension(const int dim, const std::string &name, const Shape &shape)
  {
    return "subsection " + name + "\nset Generator = " + shape.generator +
           "\nset Arguments = " +
           (dim == 2 ? shape.arguments : shape.arguments_3d) +
           (shape.coordinates.empty()
              ? ""
              : "\nset Coordinates = " + shape.coordinates +
                  (dim == 3 ? "; z" : "")) +
           "\nset Material = elastic\nend\n";
  }



  std::string
  prm_of(const int dim, const Configuration &line, const std::string &rule)
  {
    return "set Dimension = " + std::to_string(dim) + "\nsubsection Bodies\n" +
           in_dimension(dim, "slave", line.slave) +
           in_dimension(dim, "master", line.master) +
           "end\nsubsection Materials\nsubsection elastic\n"
           "set Law = linear elastic\nset Young's modulus = 1\n"
           "set Poisson's ratio = 0\nend\nend\n"
           "subsection Contact\nsubsection c\nset Slave body = slave\n"
           "set Slave boundary = " +
           line.slave.boundary +
           "\nset Master body = master\nset Master boundary = " +
           (line.master_boundary.empty() ? line.master.boundary
                                         : line.master_boundary) +
           "\nset Quadrature = " + rule + "\nend\nend\n";
  }



  /// Slave and master face of a pairing with the number of the point, and how
  /// far behind the master the point is.
  struct Found
  {
    FaceId       slave, master;
    unsigned int number = 0;
    double       depth  = 0.;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &slave &master &number &depth;
    }

    auto
    name() const
    {
      return std::tie(slave, number, master);
    }

    bool
    operator<(const Found &other) const
    {
      return name() < other.name();
    }
  };



  /// What all rules of a line share.
  template <int dim>
  struct LineMesh
  {
    explicit LineMesh(const Configuration &line)
      : parameters(prm_of(dim, line, "segments"))
      , mesh(build_mesh<dim>(parameters.mesh,
                             parameters.bodies,
                             {},
                             MPI_COMM_WORLD))
    {}

    const TextParameters parameters;
    Mesh<dim>            mesh;
  };



  template <int dim>
  class TableProblem
  {
  public:
    TableProblem(LineMesh<dim> &line, const std::string &prm)
      : mesh(line.mesh)
      , parameters(prm)
      , problem(mesh,
                1,
                parameters.materials,
                {},
                parameters.contact_pairs,
                false)
    {}

    /// After a motion of the slave.
    std::vector<Found>
    pairings(const Tensor<1, dim> &motion)
    {
      auto            &contact = problem.contact();
      const auto      &dofs    = problem.layout();
      const LA::Vector now     = displacement(motion);
      LA::Vector       u(dofs.owned, dofs.relevant, MPI_COMM_WORLD);
      u = now;
      contact.update_patches(u, true);
      u.reinit(dofs.owned, contact.needed_displacements(), MPI_COMM_WORLD);
      const LA::Vector at_start(u);
      u = now;
      contact.configure(u,
                        at_start,
                        LA::Vector(contact.multipliers().locally_owned(),
                                   contact.multipliers().locally_relevant(),
                                   MPI_COMM_WORLD));
      const ContactPair<dim> &pair = *contact.contact_pairs()[0];
      return pair.mortar ? of_segments(pair) : of_points(pair);
    }

    /// The user's boundary ids of all faces, on all ranks.
    std::map<FaceId, unsigned int>
    boundaries() const
    {
      std::vector<std::pair<FaceId, unsigned int>> own;
      for (const auto &cell :
           problem.layout().dof_handler.active_cell_iterators())
        for (const unsigned int f : cell->face_indices())
          if (cell->is_locally_owned() && cell->at_boundary(f))
            own.emplace_back(FaceId{cell->id().template to_binary<dim>(), f},
                             mesh.bodies.local_boundary_id(
                               cell->face(f)->boundary_id()));
      std::map<FaceId, unsigned int> all;
      for (const auto &of_rank :
           Utilities::MPI::all_gather(MPI_COMM_WORLD, own))
        all.insert(of_rank.begin(), of_rank.end());
      return all;
    }

  private:
    Mesh<dim>           &mesh;
    const TextParameters parameters;
    ContactProblem<dim>  problem;

    LA::Vector
    displacement(const Tensor<1, dim> &motion) const
    {
      const auto                          &dofs = problem.layout();
      LA::Vector                           u(dofs.owned, MPI_COMM_WORLD);
      std::vector<types::global_dof_index> cell_dofs(
        dofs.dof_handler.get_fe().n_dofs_per_cell());
      for (const auto &cell : dofs.dof_handler.active_cell_iterators())
        if (cell->is_locally_owned() &&
            mesh.bodies.body_of(cell->material_id()) == 0)
          {
            cell->get_dof_indices(cell_dofs);
            for (unsigned int i = 0; i < cell_dofs.size(); ++i)
              if (dofs.owned.is_element(cell_dofs[i]))
                u(cell_dofs[i]) = motion[dofs.dof_handler.get_fe()
                                           .system_to_component_index(i)
                                           .first];
          }
      u.compress(VectorOperation::insert);
      return u;
    }

    static std::vector<Found>
    of_points(const ContactPair<dim> &pair)
    {
      std::vector<Found>  found;
      std::vector<double> N;
      for (const auto &point : pair.points)
        if (point.pairing.paired)
          {
            const unsigned int f = point.pairing.face;
            pair.patch->face_shape().evaluate_values(point.pairing.xi, N);
            found.push_back(
              {pair.slave_faces[point.geometry.slave_face].face.id,
               point.pairing.face_id,
               point.geometry.quadrature_index,
               point.pairing.n *
                 (pair.slave_position(point).x -
                  interpolate<dim>(N,
                                   pair.patch->configuration(f).positions))});
          }
      return found;
    }

    /// The mean over the segments with one master face.
    static std::vector<Found>
    of_segments(const ContactPair<dim> &pair)
    {
      std::vector<Found>  found;
      std::vector<double> N, N_master;
      const auto         &shape    = pair.patch->face_shape();
      const auto          pairings = pair.find_pairings().segments;
      for (unsigned int f = 0; f < pairings->segments->size(); ++f)
        {
          const MortarFace<dim>   &slave    = pair.mortar->mortar_faces()[f];
          const FaceSegments<dim> &segments = (*pairings->segments)[f];
          const auto n = projection_plane(slave.face, shape, slave.positions).n;
          for (unsigned int m = 0; m < segments.masters.size(); ++m)
            {
              double depth = 0., area = 0.;
              for (const auto &point : segments.points)
                if (point.master == m)
                  {
                    shape.evaluate_values(point.xi, N);
                    shape.evaluate_values(point.eta, N_master);
                    area += point.weight;
                    depth +=
                      point.weight * n *
                      (interpolate<dim>(N, slave.positions) -
                       interpolate<dim>(N_master,
                                        pair.patch
                                          ->configuration(segments.masters[m])
                                          .positions));
                  }
              found.push_back(
                {slave.face.id, segments.master_ids[m], 0, depth / area});
            }
        }
      return found;
    }
  };



  /// The pairings of a kind, and how far from each other the points are.
  struct Kind
  {
    unsigned int n    = 0;
    double       low  = 0.;
    double       high = 0.;
  };

  std::string
  kind_of(const double depth)
  {
    constexpr double roundoff = 1e-9;
    return depth > roundoff    ? "overlap"
           : depth < -roundoff ? "open"
                               : "touching";
  }



  template <int dim>
  bool
  test_line(const Configuration &line,
            LineMesh<dim>       &mesh,
            const std::string   &rule)
  {
    TableProblem<dim> problem(mesh, prm_of(dim, line, rule));
    Tensor<1, dim>    motion;
    motion[0] = line.motion_x;
    motion[1] = line.motion_y;
    std::vector<Found> found;
    for (const auto &of_rank :
         Utilities::MPI::all_gather(MPI_COMM_WORLD, problem.pairings(motion)))
      found.insert(found.end(), of_rank.begin(), of_rank.end());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(),
                            found.end(),
                            [](const auto &a, const auto &b) {
                              return a.name() == b.name();
                            }),
                found.end());

    const auto                  boundaries = problem.boundaries();
    std::map<std::string, Kind> kinds;
    for (const Found &pairing : found)
      {
        const std::string name = std::to_string(boundaries.at(pairing.slave)) +
                                 ">" +
                                 std::to_string(boundaries.at(pairing.master)) +
                                 " " + kind_of(pairing.depth);
        const auto [entry, is_new] =
          kinds.emplace(name, Kind{0, pairing.depth, pairing.depth});
        Kind &kind = entry->second;
        ++kind.n;
        kind.low  = std::min(kind.low, pairing.depth);
        kind.high = std::max(kind.high, pairing.depth);
      }
    std::string        partners;
    std::ostringstream numbers;
    numbers << std::setprecision(4);
    for (const auto &[name, kind] : kinds)
      {
        partners += (partners.empty() ? "" : ", ") + name;
        numbers << "; " << kind.n << " from " << kind.low << " to "
                << kind.high;
      }
    if (partners.empty())
      partners = "nothing";
    const auto  of_rule = line.partners_of_rule.find(rule);
    const auto &expected =
      of_rule == line.partners_of_rule.end() ? line.partners : of_rule->second;
    print("  " + rule + ": " + partners + numbers.str() +
          (partners == expected ? "" : "  WRONG, it should be " + expected));
    return partners == expected;
  }



  template <int dim>
  void
  test_table()
  {
    unsigned int             n_right = 0, n = 0;
    std::vector<std::string> rules{"segments", "nodal"};
    if (dim == 2)
      rules.push_back("Gauss");
    for (const Configuration &line : table())
      {
        print(std::to_string(dim) + "D, " + line.title);
        LineMesh<dim> mesh(line);
        for (const std::string &rule : rules)
          {
            ++n;
            n_right += test_line<dim>(line, mesh, rule) ? 1 : 0;
          }
      }
    print(std::to_string(dim) + "D: " + std::to_string(n_right) + " of " +
          std::to_string(n) + " are right");
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_table<2>();
  test_table<3>();
}
