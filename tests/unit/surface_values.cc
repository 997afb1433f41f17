// Contact at points and along lines of slave surfaces, on made-up faces: a
// linear pressure and a gap that jumps where faces meet (there the mean
// counts), flat and curved faces, any distribution of the faces over ranks.
// What is off the surface is refused.

#include <stickslip/base/user_error.h>

#include <stickslip/output/contact_lines.h>
#include <stickslip/output/surface_values.h>

#include <deal.II/base/quadrature_lib.h>

#include "print.h"

#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  /// Height of the surface: linear along a face of degree 1, else a parabola.
  double
  height(const double x, const unsigned int degree)
  {
    return degree == 1 ? 1. : 1. + 0.1 * x * x;
  }



  /// Faces [f, f+1] along x (3D: of depth 1 in y), each on another rank;
  /// pressure 10 (1 + x), gap f, traction -f along x, displaced by 0.5 x along
  /// x.
  template <int dim>
  std::vector<ContactFaceResult<dim>>
  make_faces(const unsigned int n, const unsigned int degree)
  {
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
    const QGaussLobatto<dim - 1>        nodes(degree + 1);
    std::vector<ContactFaceResult<dim>> faces;
    for (unsigned int f = rank; f < n; f += n_ranks)
      {
        ContactFaceResult<dim> face;
        face.pair   = 1;
        face.degree = degree;
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            Point<dim> x;
            x[0] = f + nodes.point(i)[0];
            if (dim == 3)
              x[1] = nodes.point(i)[dim - 2];
            x[dim - 1] = height(x[0], degree);
            Tensor<1, dim> displacement, traction;
            displacement[0] = 0.5 * x[0];
            traction[0]     = -1. * f;
            face.reference_positions.push_back(x);
            face.displacements.push_back(displacement);
            face.lambda_n.push_back(-10. * (1. + x[0]));
            face.Lambda.emplace_back();

            ContactPointResult<dim> point{};
            point.reference_weight    = nodes.weight(i);
            point.state               = ContactState::stick;
            point.gap                 = f;
            point.tangential_traction = traction;
            point.shape_values.assign(nodes.size(), 0.);
            point.shape_values[i] = 1.;
            face.points.push_back(point);
          }
        faces.push_back(face);
      }
    return faces;
  }



  template <int dim>
  Point<dim>
  on_surface(const double x, const unsigned int degree)
  {
    Point<dim> point;
    point[0]       = x;
    point[dim - 1] = height(x, degree);
    if (dim == 3)
      point[1] = 0.7;
    return point;
  }



  template <int dim>
  void
  test_points(const unsigned int degree)
  {
    const auto                     faces = make_faces<dim>(3, degree);
    std::vector<SurfacePoint<dim>> points;
    for (const double x : {0., 0.3, 1., 1.75, 3.})
      points.push_back({1, on_surface<dim>(x, degree), "A"});
    const auto values = values_on_surface(points, faces, MPI_COMM_WORLD);
    for (unsigned int p = 0; p < points.size(); ++p)
      {
        std::ostringstream text;
        text << dim << "D, degree " << degree
             << ", x = " << points[p].reference_position[0] << ": pressure "
             << values[p].pressure << ", gap " << values[p].gap << ", traction "
             << values[p].tangential_traction << ", displacement "
             << values[p].displacement;
        print(text.str());
      }
    const auto refuse = [&](const unsigned int pair, const Point<dim> &point) {
      try
        {
          values_on_surface<dim>({{pair, point, "Output/Points/A/Position"}},
                                 faces,
                                 MPI_COMM_WORLD);
          print("accepted");
        }
      catch (const UserError &error)
        {
          print(error.what());
        }
    };
    refuse(1, on_surface<dim>(3.2, degree));
    refuse(1,
           on_surface<dim>(0.5, degree) +
             0.2 * Point<dim>::unit_vector(dim - 1));
    refuse(0, on_surface<dim>(0.5, degree)); // another pair
  }



  void
  test_line()
  {
    OutputParameters      parameters;
    ContactLineParameters line;
    line.contact_pair     = "second";
    line.from             = {0.25, 1.};
    line.to               = {2.75, 1.};
    line.n_points         = 3;
    parameters.directory  = ".";
    parameters.pair_names = {"first", "second"};
    parameters.lines      = {{"across", line}};
    const auto faces      = make_faces<2>(3, 1);
    {
      ContactLines<2> lines(parameters, MPI_COMM_WORLD);
      lines.write(1, 0.5, faces);
      lines.write(2, 1., faces);
    }
    ContactLines<2> lines(parameters, MPI_COMM_WORLD);
    lines.resume(0.5);
    lines.write(2, 0.75, faces);
    if (Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      {
        std::ifstream file("line_across.csv");
        std::string   row;
        while (std::getline(file, row))
          print(row);
      }
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_points<2>(1);
  test_points<2>(2);
  test_points<3>(1);
  test_points<3>(2);
  test_line();
}
