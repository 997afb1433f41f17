// The search for master faces over a distributed surface.

#include "print.h"

#include <stickslip/contact/pairing/partner_search.h>

#include <stickslip/mesh/mesh_builder.h>

#include <stickslip/problem/dof_layout.h>

#include <deal.II/base/function.h>
#include <deal.II/base/mpi.h>

#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <limits>
#include <memory>
#include <sstream>
#include <vector>

using namespace stickslip;

namespace
{
  template <int dim>
  Point<dim - 1>
  face_point(const double first, const double second)
  {
    Point<dim - 1> xi;
    xi[0] = first;
    if (dim == 3)
      xi[dim - 2] = second;
    return xi;
  }



  /// A point with what the search has to find.
  template <int dim>
  struct Probe
  {
    Tensor<1, dim> x, slave_normal, n;
    FaceId         id;
    Point<dim - 1> xi;
    double         gap = 0.;

    /// At rest, alone, on a body of any thickness.
    SearchingPoint<dim>
    searching() const
    {
      static const std::vector<Tensor<1, dim>> none;
      return {
        x, x, slave_normal, std::numeric_limits<double>::infinity(), &none};
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &x &slave_normal &n &id &xi &gap;
    }
  };



  /// A distributed body with bumps; its master surface is at y = 1 and, if
  /// @p both_sides, at y = 0, too.
  template <int dim>
  class MasterSurface
  {
  public:
    MasterSurface(const unsigned int degree,
                  const bool         smoothed,
                  const std::string &height, ///< of the upper side
                  const bool         both_sides = false,
                  const double       amplitude  = 0.) ///< of displacements
      : mesh(make_mesh(height, degree))
      , dofs(*mesh.triangulation, degree, {})
      , shape(degree)
      , amplitude(amplitude)
    {
      const auto modulus = [](const types::material_id) { return 1.; };
      auto       faces =
        collect_faces<dim>(dofs.mapping,
                           dofs.dof_handler,
                           mesh.bodies.global_boundary_ids(
                             "ground",
                             both_sides ? std::vector<std::string>{"2", "3"}
                                        : std::vector<std::string>{"3"},
                             ""),
                           modulus,
                           true);
      if (smoothed)
        add_nodal_normals(faces, shape, numbers::PI / 3.);
      for (const auto &face : faces)
        if (face.cell->is_locally_owned())
          owned.push_back(face.face);
      patch = std::make_unique<MasterPatch<dim>>(
        owned, shape, PairingTolerances{0.6, 0.05, 0.01, 0.5}, MPI_COMM_WORLD);
    }

    Tensor<1, dim>
    displacement(const Point<dim> &p) const
    {
      Tensor<1, dim> u;
      u[0] = 0.5 * amplitude * std::cos(4. * p[0]);
      u[1] = amplitude * std::sin(5. * p[0] + 3. * p[dim - 1]);
      u[dim - 1] += 0.3 * amplitude * p[0];
      return u;
    }

    /// Positions of one of this rank's faces and its stencil.
    MasterConfiguration<dim>
    configuration(const SurfaceFace<dim> &face) const
    {
      MasterConfiguration<dim> result;
      for (const auto &x : face.reference_positions)
        result.positions.push_back(Tensor<1, dim>(x) + displacement(x));
      update_nodal_normals(face, result);
      return result;
    }

    /// Points at distance @p gap over some parametric points of each face, on
    /// all ranks in the same order.
    std::vector<Probe<dim>>
    probes(const std::vector<Point<dim - 1>> &xis, const double gap) const
    {
      std::vector<Probe<dim>> own;
      MasterPoint<dim>        master;
      for (const auto &face : owned)
        for (const auto &xi : xis)
          {
            evaluate_master_point(face, configuration(face), shape, xi, master);
            Probe<dim> probe;
            probe.x            = master.x + gap * master.n;
            probe.n            = master.n;
            probe.slave_normal = master.n;
            probe.id           = face.id;
            probe.xi           = xi;
            probe.gap          = gap;
            own.push_back(probe);
          }
      std::vector<Probe<dim>> all;
      for (const auto &of_rank :
           Utilities::MPI::all_gather(MPI_COMM_WORLD, own))
        all.insert(all.end(), of_rank.begin(), of_rank.end());
      std::stable_sort(all.begin(),
                       all.end(),
                       [](const auto &a, const auto &b) {
                         return a.id < b.id;
                       });
      return all;
    }

    /// Deals the points out to the ranks and finds them; all frames on all
    /// ranks.
    std::vector<Pairing<dim>>
    find(const std::vector<Probe<dim>> &probes)
    {
      const unsigned int n_ranks =
        Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
      const unsigned int rank =
        Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
      std::vector<BoundingBox<dim>> boxes;
      for (unsigned int i = 0; i < probes.size(); ++i)
        if (i % n_ranks == rank)
          boxes.emplace_back(std::vector<Point<dim>>{Point<dim>(probes[i].x)});
      LA::Vector owned_u(dofs.owned, MPI_COMM_WORLD);
      VectorTools::interpolate(dofs.mapping,
                               dofs.dof_handler,
                               Displacement(*this),
                               owned_u);
      LA::Vector u(dofs.owned, dofs.relevant, MPI_COMM_WORLD);
      u = owned_u;
      patch->fetch(boxes, u, 0.);
      IndexSet   needed     = dofs.relevant;
      const auto patch_dofs = patch->dofs();
      needed.add_indices(patch_dofs.begin(), patch_dofs.end());
      u.reinit(dofs.owned, needed, MPI_COMM_WORLD);
      u = owned_u;
      patch->update(u, u);

      std::vector<Found> own;
      for (unsigned int i = 0; i < probes.size(); ++i)
        if (i % n_ranks == rank)
          {
            const Pairing<dim> frame = find_partner(*patch,
                                                    probes[i].searching(),
                                                    Pairing<dim>(),
                                                    EdgeRetention());
            own.push_back(
              {i,
               frame.paired,
               frame.face_id,
               frame.xi,
               frame.n,
               std::vector<bool>(frame.free.begin(), frame.free.end())});
          }
      std::vector<Pairing<dim>> frames(probes.size());
      for (const auto &of_rank :
           Utilities::MPI::all_gather(MPI_COMM_WORLD, own))
        for (const Found &found : of_rank)
          {
            Pairing<dim> &frame = frames[found.index];
            frame.paired        = found.paired;
            frame.face_id       = found.id;
            frame.xi            = found.xi;
            frame.n             = found.n;
            std::copy(found.free.begin(), found.free.end(), frame.free.begin());
          }
      return frames;
    }

    Mesh<dim>                         mesh;
    const DofLayout<dim>              dofs;
    const FaceShape<dim>              shape;
    std::vector<SurfaceFace<dim>>     owned;
    std::unique_ptr<MasterPatch<dim>> patch;
    const double                      amplitude;

  private:
    class Displacement : public Function<dim>
    {
    public:
      explicit Displacement(const MasterSurface &surface)
        : Function<dim>(dim)
        , surface(surface)
      {}

      double
      value(const Point<dim> &p, const unsigned int component) const override
      {
        return surface.displacement(p)[component];
      }

    private:
      const MasterSurface &surface;
    };

    struct Found
    {
      unsigned int      index;
      bool              paired;
      FaceId            id;
      Point<dim - 1>    xi;
      Tensor<1, dim>    n;
      std::vector<bool> free;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &index &paired &id &xi &n &free;
      }
    };

    static Mesh<dim>
    make_mesh(const std::string &height, const unsigned int degree)
    {
      MeshParameters parameters;
      parameters.degree = degree;
      BodyParameters ground;
      ground.generator = "subdivided_hyper_rectangle";
      ground.arguments =
        dim == 2 ? "8,2 : 0,0 : 4,1 : true" : "4,1,4 : 0,0,0 : 2,1,2 : true";
      ground.coordinates = "x; y*(" + height + ")" + (dim == 3 ? "; z" : "");
      ground.material    = "steel";
      return build_mesh<dim>(parameters,
                             {{"ground", ground}},
                             {},
                             MPI_COMM_WORLD);
    }
  };



  std::string
  text_of(const FaceId &id)
  {
    std::string text;
    for (const unsigned int part : id.cell)
      text += std::to_string(part) + "/";
    return text + std::to_string(id.face);
  }



  /// Every point over the bumpy surface is found again, on any number of ranks.
  template <int dim>
  void
  test_search(const unsigned int degree, const bool smoothed)
  {
    MasterSurface<dim> surface(degree,
                               smoothed,
                               dim == 2 ? "1 + 0.1*sin(2.5*x)"
                                        : "1 + 0.1*sin(2.5*x)*cos(2*z)",
                               false,
                               0.04);
    double             xi_error = 0., n_error = 0.;
    unsigned int       n_points = 0, n_wrong = 0, n_on_edges = 0;
    Tensor<1, dim>     sum;
    for (const double gap : {-0.05, 0.02})
      {
        const auto probes = surface.probes({face_point<dim>(0.2, 0.9),
                                            face_point<dim>(0.5, 0.5),
                                            face_point<dim>(0.9, 0.4)},
                                           gap);
        const auto frames = surface.find(probes);
        for (unsigned int i = 0; i < probes.size(); ++i, ++n_points)
          {
            const bool is_right =
              frames[i].paired && frames[i].face_id == probes[i].id;
            n_wrong += is_right ? 0 : 1;
            n_on_edges += frames[i].is_interior() ? 0 : 1;
            sum += frames[i].n;
            if (is_right)
              xi_error =
                std::max(xi_error, (frames[i].xi - probes[i].xi).norm());
            n_error = std::max(n_error, (frames[i].n - probes[i].n).norm());
          }
      }
    std::ostringstream text;
    text << dim << "D degree " << degree << ", "
         << (smoothed ? "smoothed" : "facet") << " normals: " << n_points
         << " points, " << n_wrong << " on a wrong face, " << n_on_edges
         << " on edges; sum of the normals " << std::setprecision(9) << sum;
    print(text.str());
    print("  exact positions and normals", xi_error < 1e-11 && n_error < 1e-11);
  }



  template <int dim>
  void
  print_frame(const std::string &what, const Pairing<dim> &frame)
  {
    std::ostringstream text;
    text << what << ": ";
    if (!frame.paired)
      text << "not paired";
    else
      {
        text << "face " << text_of(frame.face_id) << ", xi "
             << std::setprecision(9) << frame.xi << ", free";
        for (const bool is_free : frame.free)
          text << (is_free ? " yes" : " no");
      }
    print(text.str());
  }



  template <int dim>
  Probe<dim>
  probe_at(const double x, const double y, const double z, const double down)
  {
    Probe<dim> probe;
    probe.x[0]            = x;
    probe.x[1]            = y;
    probe.slave_normal[1] = -down;
    if (dim == 3)
      probe.x[dim - 1] = z;
    return probe;
  }



  /// A roof with its ridge on the facets' border at x = 1.
  template <int dim>
  void
  test_edges()
  {
    MasterSurface<dim> roof(1, false, "1.5 - 0.3*abs(x - 1)");
    const auto         frames = roof.find({probe_at<dim>(1., 1.6, 0.3, 1.),
                                           probe_at<dim>(1.01, 1.6, 0.3, 1.),
                                           probe_at<dim>(-0.02, 1.21, 0.3, 1.),
                                           probe_at<dim>(-0.2, 1.14, 0.3, 1.),
                                           probe_at<dim>(0.4, 2.2, 0.3, 1.),
                                           probe_at<dim>(1., 1.6, -0.01, 1.)});
    print_frame("over the ridge", frames[0]);
    print_frame("almost over the ridge", frames[1]);
    print_frame("a little beyond the end", frames[2]);
    print_frame("far beyond the end", frames[3]);
    print_frame("out of reach", frames[4]);
    if (dim == 3)
      print_frame("over the end of the ridge", frames[5]);

    // the valley: of two facets the nearer one
    MasterSurface<dim> valley(1, false, "1 + 0.3*abs(x - 1)");
    const auto         below = valley.find({probe_at<dim>(0.98, 1.15, 0.3, 1.),
                                            probe_at<dim>(1.02, 1.15, 0.3, 1.),
                                            probe_at<dim>(1.02, 0.95, 0.3, 1.)});
    print_frame("over the valley, left", below[0]);
    print_frame("over the valley, right", below[1]);
    print_frame("below the valley", below[2]);
  }



  /// Points over shared edges and nodes of a flat surface: always the face with
  /// the smaller name, whoever owns it.
  template <int dim>
  void
  test_ties()
  {
    MasterSurface<dim>      flat(1, false, "1");
    std::vector<Probe<dim>> probes;
    for (const double x : {0.5, 1., 1.5})
      for (const double z : {0.25, 0.5, 1.})
        if (dim == 3 || z == 0.5)
          for (const double y : {0.98, 1.3})
            probes.push_back(probe_at<dim>(x, y, z, 1.));
    for (const auto &frame : flat.find(probes))
      print_frame("tie", frame);
  }



  /// A thin plate, both sides of which are master.
  template <int dim>
  void
  test_thin_body()
  {
    MasterSurface<dim> plate(1, false, "0.1", true);
    const auto         frames = plate.find({probe_at<dim>(0.3, 0.01, 0.3, 1.),
                                            probe_at<dim>(0.3, 0.01, 0.3, -1.),
                                            probe_at<dim>(0.3, 0.09, 0.3, -1.)});
    print_frame("thin plate, slave from above", frames[0]);
    print_frame("thin plate, slave from below", frames[1]);
    print_frame("thin plate, deep from below", frames[2]);
  }



  /// A point stays with its face over the overlap and not farther. One rank
  /// looks for it; the faces may be anywhere.
  template <int dim>
  void
  test_hint()
  {
    MasterSurface<dim> roof(1, false, "1.5 - 0.3*abs(x - 1)");
    const auto         found = roof.find({probe_at<dim>(0.8, 1.44, 0.3, 1.),
                                          probe_at<dim>(0.8, 1.44, 0.3, 1.),
                                          probe_at<dim>(0.8, 1.44, 0.3, 1.),
                                          probe_at<dim>(0.8, 1.44, 0.3, 1.)});
    std::string        text;
    for (const double x : {0.99, 1.003, 1.02})
      {
        Pairing<dim> hint = found[0];
        roof.patch->relocate(hint);
        const auto probe = probe_at<dim>(x, 1.49, 0.3, 1.);
        const auto frame =
          find_partner(*roof.patch, probe.searching(), hint, {1., false});
        bool keeps = frame.paired && frame.face_id == found[0].face_id;
        text += keeps ? " kept" : " changed";
      }
    const auto texts = Utilities::MPI::all_gather(MPI_COMM_WORLD, text);
    for (const auto &other : texts)
      if (other != text)
        text = " THE RANKS DISAGREE";
    print("from face to face:" + text);
  }



  template <int dim>
  void
  test_all()
  {
    for (const unsigned int degree : {1, 2})
      for (const bool smoothed : {false, true})
        test_search<dim>(degree, smoothed);
    test_edges<dim>();
    test_ties<dim>();
    test_thin_body<dim>();
    test_hint<dim>();
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_all<2>();
  test_all<3>();
}
