// The writers of output/ on made-up results: resultants of contact faces,
// tables that survive a restart, values at points, projected stresses and the
// index files of the series. All printed numbers are independent of the number
// of ranks.

#include <stickslip/base/duration.h>
#include <stickslip/base/user_error.h>

#include <stickslip/output/contact_output.h>
#include <stickslip/output/contact_resultants.h>
#include <stickslip/output/csv.h>
#include <stickslip/output/field_output.h>
#include <stickslip/output/output_directory.h>
#include <stickslip/output/output_series.h>
#include <stickslip/output/point_values.h>
#include <stickslip/output/progress.h>
#include <stickslip/output/statistics_table.h>
#include <stickslip/output/stress_projection.h>

#include <deal.II/base/conditional_ostream.h>
#include <deal.II/base/mpi.h>
#include <deal.II/base/quadrature_lib.h>
#include <deal.II/base/utilities.h>

#include <deal.II/distributed/tria.h>

#include <deal.II/dofs/dof_tools.h>

#include <deal.II/fe/fe_q.h>
#include <deal.II/fe/fe_system.h>
#include <deal.II/fe/fe_values.h>
#include <deal.II/fe/mapping_q.h>

#include <deal.II/grid/grid_generator.h>

#include <deal.II/numerics/data_out.h>
#include <deal.II/numerics/vector_tools.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <limits>
#include <map>
#include <numeric>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

using namespace stickslip;

namespace
{
  const std::string directory = "output_writers_results";

  std::string
  content_of(const std::string &file_name)
  {
    std::ifstream     file(file_name);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
  }

  /// Numbers that cancel to roundoff print as 0.
  double
  rounded(const double value)
  {
    return std::abs(value) < 1e-12 ? 0. : value;
  }

  template <int dim>
  Tensor<1, dim>
  unit_vector(const unsigned int direction, const double length = 1.)
  {
    Tensor<1, dim> result;
    result[direction] = length;
    return result;
  }

  /**
   * A slave surface at height 1 over [0,n]x[0,1], one face per unit length,
   * nodal quadrature. Pressure 10 (1+x), friction -3 against a slip of 0.1 in
   * x; the last face is open. Dealt out to the ranks in turn.
   */
  template <int dim>
  std::vector<ContactFaceResult<dim>>
  make_faces(const unsigned int n, const unsigned int degree)
  {
    const unsigned int n_ranks =
      Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
    const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);

    const QGaussLobatto<dim - 1> nodes(degree + 1);

    std::vector<ContactFaceResult<dim>> faces;
    for (unsigned int f = rank; f < n; f += n_ranks)
      {
        const bool is_open = (f == n - 1);

        ContactFaceResult<dim> face;
        face.pair   = 0;
        face.degree = degree;
        for (unsigned int i = 0; i < nodes.size(); ++i)
          {
            Point<dim> x;
            x[0]       = f + nodes.point(i)[0];
            x[dim - 1] = 1.;
            if (dim == 3)
              x[1] = nodes.point(i)[dim - 2];
            const double pressure = is_open ? 0. : 10. * (1. + x[0]);

            face.reference_positions.push_back(x);
            face.displacements.push_back(unit_vector<dim>(0, 0.1));
            face.lambda_n.push_back(-pressure);
            face.Lambda.push_back(unit_vector<dim>(0, is_open ? 0. : 1.));

            ContactPointResult<dim> point;
            point.reference_position = x;
            point.position           = x + face.displacements.back();
            point.centre_of_force    = point.position;
            point.reference_weight   = nodes.weight(i);
            point.area_ratio         = 1.5;
            point.shape_values.assign(nodes.size(), 0.);
            point.shape_values[i]     = 1.;
            point.state               = is_open  ? ContactState::open
                                        : f == 0 ? ContactState::stick
                                                 : ContactState::slip;
            point.gap                 = is_open ? 0.25 : 0.;
            point.normal              = unit_vector<dim>(dim - 1);
            point.pressure            = pressure;
            point.tangential_traction = unit_vector<dim>(0, is_open ? 0. : -3.);
            point.slip                = unit_vector<dim>(0, 0.1);
            point.accumulated_slip    = unit_vector<dim>(0, 0.3);
            face.points.push_back(point);
          }
        faces.push_back(face);
      }
    return faces;
  }

  template <int dim>
  void
  test_contact(const unsigned int degree, ConditionalOStream &out)
  {
    out << "Contact in " << dim << "D, degree " << degree << std::endl;
    const auto faces = make_faces<dim>(5, degree);
    const auto resultants =
      compute_contact_resultants<dim>(faces, 2, MPI_COMM_WORLD);
    for (const auto &resultant : resultants[0].named_values())
      out << "  " << resultant.name << " = " << rounded(resultant.value)
          << std::endl;
    out << "  points " << resultants[0].n_points
        << ", of the second pair: " << resultants[1].n_points << std::endl;

    double sum_of_gaps = 0., sum_of_states = 0.;
    for (const auto &face : faces)
      {
        const ContactNodalFields<dim> fields(face);
        for (const double gap : fields.gap)
          sum_of_gaps += gap;
        sum_of_states += static_cast<unsigned int>(fields.state);
      }
    out << "  sum of nodal gaps "
        << Utilities::MPI::sum(sum_of_gaps, MPI_COMM_WORLD)
        << ", of face states "
        << Utilities::MPI::sum(sum_of_states, MPI_COMM_WORLD) << std::endl;

    // Of an open face whose last point has no master any more.
    ContactFaceResult<dim> half_paired = make_faces<dim>(5, degree).back();
    half_paired.points.back().state    = ContactState::unpaired;
    half_paired.points.back().gap      = 0.;
    const ContactNodalFields<dim> fields(half_paired);
    out << "  with an unpaired point: gap " << fields.gap.front() << " ... "
        << fields.gap.back() << ", paired " << fields.paired.front() << " ... "
        << fields.paired.back() << std::endl;

    OutputParameters parameters;
    parameters.directory      = directory;
    parameters.contact_points = true;
    for (const auto &[format, value] : all_field_formats())
      {
        parameters.format = value;
        ContactOutput<dim> output(parameters, MPI_COMM_WORLD);
        output.write(dim, degree, faces);
        // Surfaces may be empty on some ranks, and on all.
        output.write(dim + 2, degree, {});
      }
  }

  template <int dim>
  Tensor<1, dim>
  exact_displacement(const Point<dim> &x)
  {
    Tensor<1, dim> u;
    for (unsigned int d = 0; d < dim; ++d)
      u[d] = 0.1 * (d + 1.) * x[0] - 0.2 * x[dim - 1] + 0.01 * d;
    return u;
  }

  template <int dim>
  class ExactDisplacement : public Function<dim>
  {
  public:
    ExactDisplacement()
      : Function<dim>(dim)
    {}
    virtual double
    value(const Point<dim> &x, const unsigned int component) const override
    {
      return exact_displacement(x)[component];
    }
  };

  SymmetricTensor<2, 3>
  linear_stress(const double x, const double y)
  {
    SymmetricTensor<2, 3> stress;
    stress[0][0] = 1. + x;
    stress[1][1] = 2. - y;
    stress[2][2] = 0.5 * x;
    stress[0][1] = 3. * x * y;
    return stress;
  }

  template <int dim>
  void
  test_fields(const unsigned int degree, ConditionalOStream &out)
  {
    out << "Fields in " << dim << "D, degree " << degree << std::endl;

    // Two blocks on each other, which share no vertex.
    Triangulation<dim> lower, upper, both;
    Point<dim>         corner, opposite;
    for (unsigned int d = 0; d < dim; ++d)
      opposite[d] = 1.;
    GridGenerator::subdivided_hyper_rectangle(lower,
                                              std::vector<unsigned int>(dim, 2),
                                              corner,
                                              opposite);
    corner[dim - 1]   = 1.;
    opposite[dim - 1] = 2.;
    GridGenerator::subdivided_hyper_rectangle(upper,
                                              std::vector<unsigned int>(dim, 3),
                                              corner,
                                              opposite);
    for (const auto &cell : upper.active_cell_iterators())
      cell->set_material_id(1);
    GridGenerator::merge_triangulations(lower, upper, both, 0.);

    parallel::distributed::Triangulation<dim> triangulation(MPI_COMM_WORLD);
    triangulation.copy_triangulation(both);
    triangulation.refine_global(1);

    Bodies bodies;
    bodies.bodies.resize(2);
    bodies.bodies[0].name = "lower";
    bodies.bodies[1].name = "upper";
    bodies.regions        = {{0, "steel"}, {1, "rubber"}};

    const hp::MappingCollection<dim> mapping{MappingQ<dim>(degree)};
    DoFHandler<dim>                  dof_handler(triangulation);
    dof_handler.distribute_dofs(FESystem<dim>(FE_Q<dim>(degree), dim));
    IndexSet relevant;
    DoFTools::extract_locally_relevant_dofs(dof_handler, relevant);
    LA::Vector owned(dof_handler.locally_owned_dofs(), MPI_COMM_WORLD);
    LA::Vector displacement(dof_handler.locally_owned_dofs(),
                            relevant,
                            MPI_COMM_WORLD);
    VectorTools::interpolate(mapping,
                             dof_handler,
                             ExactDisplacement<dim>(),
                             owned);
    displacement = owned;

    const QGauss<dim>   quadrature(degree + 1);
    FEValues<dim>       fe_values(mapping[0],
                            dof_handler.get_fe(),
                            quadrature,
                            update_quadrature_points);
    MaterialFields<dim> fields;
    fields.history_names = {"equivalent_plastic_strain"};
    fields.evaluate      = [&](const auto &cell) {
      typename MaterialFields<dim>::Values values;
      fe_values.reinit(cell);
      for (const Point<dim> &x : fe_values.get_quadrature_points())
        {
          values.cauchy_stress.push_back(linear_stress(x[0], x[1]));
          values.strain.push_back(0.1 * values.cauchy_stress.back());
          values.history.push_back({3. * x[0] - x[1]});
        }
      return values;
    };

    // A bilinear stress is reproduced exactly.
    const StressProjection<dim> projection(mapping, dof_handler, fields);
    std::map<types::global_dof_index, Point<dim>> supports;
    DoFTools::map_dofs_to_support_points(mapping,
                                         projection.get_dof_handler(),
                                         supports);
    const auto                           names = projection.names();
    double                               error = 0.;
    std::vector<types::global_dof_index> dofs(
      projection.get_dof_handler().get_fe().n_dofs_per_cell());
    for (const auto &cell :
         projection.get_dof_handler().active_cell_iterators())
      if (cell->is_locally_owned())
        {
          cell->get_dof_indices(dofs);
          for (unsigned int i = 0; i < dofs.size(); ++i)
            {
              const Point<dim> x = supports.at(dofs[i]);
              const auto       s = linear_stress(x[0], x[1]);
              for (unsigned int c = 0; c < names.size(); ++c)
                {
                  const double exact =
                    c < 9    ? s[c / 3][c % 3]
                    : c < 18 ? 0.1 * s[c / 3 - 3][c % 3]
                    : names[c] == "equivalent_plastic_strain" ? 3. * x[0] - x[1]
                    : names[c] == "von_mises_stress" ? von_mises_stress(s)
                    : names[c] == "cauchy_stress_zz" ? s[2][2]
                                                     : 0.1 * s[2][2];
                  error =
                    std::max(error,
                             std::abs(projection.get_fields()[c](dofs[i]) -
                                      exact) /
                               std::max(1., std::abs(exact)));
                }
            }
        }
    out << "  stress projection exact: "
        << (Utilities::MPI::max(error, MPI_COMM_WORLD) <
                2. * std::numeric_limits<float>::epsilon()
              ? "yes"
              : "no")
        << std::endl;

    OutputParameters parameters;
    parameters.directory = directory;
    for (const auto &[format, value] : all_field_formats())
      for (const bool deformed : {false, true})
        {
          parameters.format        = value;
          parameters.deformed      = deformed;
          parameters.grouped_files = deformed ? 2 : 1;
          FieldOutput<dim> output(parameters,
                                  bodies,
                                  MPI_COMM_WORLD,
                                  /*cells_of_piece=*/3);
          output.write(dim, 0.1, mapping, dof_handler, displacement, fields);
          output.write(
            dim + 2, 0.2, mapping, dof_handler, displacement, fields);

          // A restart at time 0.1 drops the second step.
          FieldOutput<dim> continued(parameters, bodies, MPI_COMM_WORLD);
          continued.resume(0.1);
          continued.write(
            dim + 4, 0.15, mapping, dof_handler, displacement, {});
        }
    if (out.is_active())
      {
        const auto pieces_of_step = [&](const unsigned int step) {
          std::vector<unsigned int> cells;
          for (const char *group : {".0.vtu", ".1.vtu"})
            {
              const std::string name = directory + "/solution-" +
                                       Utilities::int_to_string(step, 4) +
                                       group;
              const std::string key = "NumberOfCells=\"";
              if (!std::filesystem::exists(name))
                continue;
              const std::string text = content_of(name);
              for (auto i = text.find(key); i != std::string::npos;
                   i      = text.find(key, i + 1))
                cells.push_back(std::stoul(text.substr(i + key.size())));
            }
          return cells;
        };
        const auto small = pieces_of_step(dim), large = pieces_of_step(dim + 4);
        out << "  pieces of at most 3 cells have all of them: "
            << (*std::max_element(small.begin(), small.end()) <= 3 &&
                    std::accumulate(small.begin(), small.end(), 0U) ==
                      std::accumulate(large.begin(), large.end(), 0U)
                  ? "yes"
                  : "no")
            << std::endl;

        const std::string xdmf    = content_of(directory + "/solution.xdmf");
        unsigned int      n_grids = 0;
        for (std::size_t i = xdmf.find("<Grid Name=\"mesh\"");
             i != std::string::npos;
             i = xdmf.find("<Grid Name=\"mesh\"", i + 1))
          ++n_grids;
        out << content_of(directory + "/solution.pvd") << "  XDMF steps "
            << n_grids << std::endl;
      }

    // Points inside a cell, on an edge that ranks share, on the interface
    // (where the body decides), and one that is nowhere.
    std::vector<double> inside(dim, 0.3), shared(dim, 0.5), interface(dim, 0.5),
      outside(dim, 0.5);
    interface[dim - 1] = 1.;
    outside[dim - 1]   = 1.4;
    parameters.points  = {{"inside", {"lower", inside}},
                          {"shared", {"lower", shared}},
                          {"below", {"lower", interface}},
                          {"above", {"upper", interface}}};
    PointValues<dim> points(parameters, bodies, MPI_COMM_WORLD);
    points.locate(mapping, dof_handler);
    for (const Tensor<1, dim> &u : points.evaluate(displacement))
      out << "  u = " << u << std::endl;
    points.write(1, 0.5, displacement);

    parameters.points = {{"nowhere", {"lower", outside}}};
    try
      {
        PointValues<dim>(parameters, bodies, MPI_COMM_WORLD)
          .locate(mapping, dof_handler);
      }
    catch (const UserError &message)
      {
        out << "  " << message.what() << std::endl;
      }
  }

  void
  test_statistics(ConditionalOStream &out)
  {
    const std::string name = directory + "/statistics";
    {
      StatisticsTable table(name, MPI_COMM_WORLD);
      for (unsigned int step = 1; step <= 4; ++step)
        {
          table.add("step", step);
          table.add("time", 0.1 * step);
          table.add("algorithm", step < 3 ? "GNM" : "PNM, then \"GNM\"");
          table.finish_row();
        }
    }
    StatisticsTable table(name, MPI_COMM_WORLD);
    table.resume(0.1 * 3);
    table.add("step", 4);
    table.add("time", 0.35);
    table.add("force", 1. / 3.);
    table.finish_row();
    table.add("step", 5);
    table.add("time", 0.4);
    table.add("force", -2e-30);
    table.finish_row();
    if (out.is_active())
      out << content_of(name + ".csv") << content_of(name + ".txt");
  }

  void
  test_progress(ConditionalOStream &out)
  {
    std::ostringstream text;
    Progress progress(Verbosity::progress, 0., 2., MPI_COMM_WORLD, text);
    progress.resume(1.6);
    for (unsigned int step = 21; step <= 25; ++step)
      progress.accepted_step(step, 0.08 * step, "3 Newton iterations");
    progress.rejected_step(2.1, "Newton: no convergence", 0.04);
    progress.finished(25);
    // how long it takes depends on the machine
    out << std::regex_replace(text.str(),
                              std::regex("(about|in) [0-9ms in]+"),
                              "$1 TIME ");
    for (const double seconds : {3.2, 61., 3725., 100000.})
      out << duration_in_words(seconds) << std::endl;
    for (const std::string text :
         {"3 h",      "90min",    "1 d 12 h", "1.5 h",       "0 s",
          "02:30:00", "1-12",     "1-12:30",  "1-00:00:10",  "",
          "30",       "12:30",    "3 hours",  "-3 h",        "h 3",
          "1:2:3:4",  "02:60:00", "nan s",    "1-12:30:00s", "1e999 h",
          "3 h 2"})
      {
        const auto seconds = seconds_of_duration(text);
        out << "'" << text << "': "
            << (seconds ? exact_number(*seconds) + " s" : "no duration")
            << std::endl;
      }
  }

  void
  test_directories(ConditionalOStream &out)
  {
    prepare_output_directory(directory, MPI_COMM_WORLD);
    if (out.is_active())
      write_file_atomically(directory + "/file", "a file, not a directory\n");
    try
      {
        prepare_output_directory(directory + "/file/results", MPI_COMM_WORLD);
      }
    catch (const UserError &message)
      {
        out << message.what() << std::endl;
      }
  }

  /// The first piece cannot be written: neither it nor the index appears.
  void
  test_failing_piece(const std::string  &name,
                     const unsigned int  grouped_files,
                     ConditionalOStream &out)
  {
    parallel::distributed::Triangulation<2> triangulation(MPI_COMM_WORLD);
    GridGenerator::hyper_cube(triangulation);
    triangulation.refine_global(2);
    const Vector<float> numbers(triangulation.n_active_cells());
    DataOut<2>          data;
    data.attach_triangulation(triangulation);
    data.add_data_vector(numbers, "numbers");
    data.build_patches();

    OutputParameters parameters;
    parameters.directory     = directory;
    parameters.grouped_files = grouped_files;
    OutputSeries series(parameters, name, MPI_COMM_WORLD);
    try
      {
        series.write(data, 1, 0.1);
      }
    catch (const UserError &message)
      {
        // the reason depends on how many ranks write a piece
        const std::string text = message.what();
        out << text.substr(0, text.find("': ") + 1) << std::endl;
      }
    for (const std::string ending : {"-0001.0.vtu", "-0001.pvtu", ".pvd"})
      out << "  " << name << ending << ": "
          << (std::filesystem::exists(directory + "/" + name + ending) ? "there"
                                                                       : "none")
          << std::endl;
  }

  void
  test_failing_pieces(ConditionalOStream &out)
  {
    const std::string full = directory + "/full-0001.0.vtu.part",
                      part = directory + "/blocked-0001.0.vtu.part";
    if (out.is_active())
      {
        std::filesystem::remove(full);
        std::filesystem::create_symlink("/dev/full", full);
        std::filesystem::create_directories(part);
      }
    MPI_Barrier(MPI_COMM_WORLD);
    test_failing_piece("full", 0, out);
    test_failing_piece("blocked", 1, out);
  }
} // namespace

int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  ConditionalOStream               out(std::cout,
                         Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0);

  test_directories(out);
  test_failing_pieces(out);
  test_statistics(out);
  test_progress(out);
  test_contact<2>(1, out);
  test_contact<3>(2, out);
  test_fields<2>(2, out);
  test_fields<3>(1, out);
}
