#include <stickslip/output/output_series.h>

#include <stickslip/base/user_error.h>

#include <stickslip/output/output_directory.h>
#include <stickslip/output/parallel_files.h>

#include <deal.II/base/config.h>

#include <deal.II/base/utilities.h>

#include <deal.II/grid/reference_cell.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>

namespace stickslip
{
  namespace
  {
    std::string
    read_whole_file(const std::string &name)
    {
      std::ifstream     file(name, std::ios::binary);
      std::stringstream content;
      content << file.rdbuf();
      return content.str();
    }

    /// All parts of @p text from @p begin to @p end, both included.
    std::vector<std::string>
    parts_between(const std::string &text,
                  const std::string &begin,
                  const std::string &end)
    {
      std::vector<std::string> parts;
      std::size_t              first = text.find(begin);
      while (first != std::string::npos)
        {
          const std::size_t last = text.find(end, first);
          if (last == std::string::npos)
            break;
          parts.push_back(text.substr(first, last + end.size() - first));
          first = text.find(begin, last);
        }
      return parts;
    }

    /// The number in attribute="..." of an XML text; NaN without it.
    double
    number_in_attribute(const std::string &text, const std::string &attribute)
    {
      const std::string key   = attribute + "=\"";
      const std::size_t start = text.find(key);
      return start == std::string::npos
               ? std::numeric_limits<double>::quiet_NaN()
               : std::stod(text.substr(start + key.size()));
    }

    constexpr char xdmf_grid_begin[] =
      "<Grid Name=\"mesh\" GridType=\"Uniform\"";
    constexpr char xdmf_grid_end[] = "</Grid>";
  } // namespace



  OutputSeries::OutputSeries(const OutputParameters &parameters,
                             const std::string      &name,
                             const MPI_Comm          communicator)
    : directory(parameters.directory + "/")
    , name(name)
    , is_hdf5(parameters.format == FieldFormat::hdf5)
    , n_ranks(Utilities::MPI::n_mpi_processes(communicator))
    , n_grouped_files(parameters.grouped_files == 0
                        ? n_ranks
                        : std::min(parameters.grouped_files, n_ranks))
    , communicator(communicator)
  {}



  void
  OutputSeries::resume(const double time)
  {
    entries.clear();
    std::string error;
    if (Utilities::MPI::this_mpi_process(communicator) == 0 &&
        std::filesystem::exists(path_of_index()))
      {
        read_index(time);
        error = write_file_atomically(path_of_index(), index_text());
      }
    throw_collectively(error, communicator);
  }



  std::string
  OutputSeries::path_of_index() const
  {
    return directory + name + (is_hdf5 ? ".xdmf" : ".pvd");
  }



  void
  OutputSeries::read_index(const double time)
  {
    const std::string              index = read_whole_file(path_of_index());
    const std::vector<std::string> steps =
      is_hdf5 ? parts_between(index, xdmf_grid_begin, xdmf_grid_end)
              : parts_between(index, "<DataSet ", "/>");

    const double tolerance = 1e-12 * std::abs(time);
    for (const std::string &step : steps)
      {
        const double step_time =
          is_hdf5
            ? number_in_attribute(step.substr(step.find("<Time ")), "Value")
            : number_in_attribute(step, "timestep");
        if (step_time <= time + tolerance)
          entries.push_back({step_time, step});
      }
  }



  template <int dim, int spacedim>
  void
  OutputSeries::write(const DataOutInterface<dim, spacedim> &data,
                      const unsigned int                     step,
                      const double                           time,
                      const ReferenceCell                   &cell,
                      const bool has_lagrange_hexahedra)
  {
    const std::string step_name = name_of_step(step);
    std::string       text, error;
    if (is_hdf5)
      write_hdf5(data, step_name, time, cell, text);
    else
      {
        error = write_vtu(
          data,
          [&](const std::string &file, const MPI_Comm group) {
            return write_vtu_file(data, file, group);
          },
          step_name,
          has_lagrange_hexahedra ? n_ranks : n_grouped_files);
        text = vtu_entry(step_name, time);
      }
    add_entry(time, text, error);
  }



  template <int dim, int spacedim>
  void
  OutputSeries::write(const DataOutInterface<dim, spacedim> &data,
                      const VtuPieces                       &pieces,
                      const DataOutBase::VtkFlags           &flags,
                      const unsigned int                     step,
                      const double                           time)
  {
    const std::string step_name = name_of_step(step);
    const std::string error     = write_vtu(
      data,
      [&](const std::string &file, const MPI_Comm group) {
        return write_vtu_pieces(pieces, flags, file, group);
      },
      step_name,
      n_grouped_files);
    add_entry(time, vtu_entry(step_name, time), error);
  }



  std::string
  OutputSeries::name_of_step(const unsigned int step) const
  {
    return name + "-" + Utilities::int_to_string(step, 4);
  }



  std::string
  OutputSeries::vtu_entry(const std::string &step_name, const double time) const
  {
    std::ostringstream data_set;
    data_set << "<DataSet timestep=\"" << std::setprecision(15) << time
             << "\" group=\"\" part=\"0\" file=\"" << step_name << ".pvtu\"/>";
    return data_set.str();
  }



  void
  OutputSeries::add_entry(const double       time,
                          const std::string &text,
                          std::string        error)
  {
    if (error.empty() && Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        entries.push_back({time, text});
        error = write_file_atomically(path_of_index(), index_text());
      }
    throw_collectively(error, communicator);
  }



  template <int dim, int spacedim>
  std::string
  OutputSeries::write_vtu(const DataOutInterface<dim, spacedim> &data,
                          const FileWriter                      &write_file,
                          const std::string                     &step_name,
                          const unsigned int                     n_files) const
  {
    const auto piece_name = [&](const unsigned int group) {
      return step_name + "." + std::to_string(group) + ".vtu";
    };

    const unsigned int rank  = Utilities::MPI::this_mpi_process(communicator);
    const unsigned int group = rank % n_files;
    const std::string  piece = directory + piece_name(group);

    MPI_Comm  group_communicator;
    const int ierr = MPI_Comm_split(communicator,
                                    static_cast<int>(group),
                                    static_cast<int>(rank),
                                    &group_communicator);
    AssertThrowMPI(ierr);
    const std::string reason = write_file(piece, group_communicator);
    MPI_Comm_free(&group_communicator);
    throw_collectively(reason.empty()
                         ? ""
                         : "Cannot write '" + piece + "': " + reason + ".",
                       communicator);

    // Only now may the record name the pieces.
    if (rank != 0)
      return "";

    std::vector<std::string> pieces;
    for (unsigned int g = 0; g < n_files; ++g)
      pieces.push_back(piece_name(g));
    std::ostringstream record;
    data.write_pvtu_record(record, pieces);
    return write_file_atomically(directory + step_name + ".pvtu", record.str());
  }



  template <int dim, int spacedim>
  void
  OutputSeries::write_hdf5(const DataOutInterface<dim, spacedim> &data,
                           const std::string                     &step_name,
                           const double                           time,
                           [[maybe_unused]] const ReferenceCell  &cell,
                           std::string                           &grid) const
  {
    // Nodes are not merged: stresses jump between cells.
    DataOutBase::DataOutFilter filter(
      DataOutBase::DataOutFilterFlags(/*filter_duplicate_vertices=*/false,
                                      /*xdmf_hdf5_output=*/true));
    data.write_filtered_data(filter);

    // deal.II 9.4 looks at the first cell of every rank, but a rank may have
    // no part of a surface: only those with cells take part.
    const unsigned int rank = Utilities::MPI::this_mpi_process(communicator);
    const bool         has_cells = filter.n_nodes() > 0;
    MPI_Comm           writers;
    const int          ierr = MPI_Comm_split(communicator,
                                    has_cells ? 0 : MPI_UNDEFINED,
                                    static_cast<int>(rank),
                                    &writers);
    AssertThrowMPI(ierr);
    const std::string file = step_name + ".h5";
    std::string       description, reason;
    if (has_cells)
      {
        reason = write_hdf5_file(data, filter, directory + file, writers);
        const XDMFEntry entry =
          data.create_xdmf_entry(filter, file, time, writers);
        if (Utilities::MPI::this_mpi_process(writers) == 0)
#if DEAL_II_VERSION_GTE(9, 5, 0)
          description = entry.get_xdmf_content(3);
#else
          description = entry.get_xdmf_content(3, cell);
#endif
        MPI_Comm_free(&writers);
      }
    throw_collectively(reason.empty() ? ""
                                      : "Cannot write '" + directory + file +
                                          "': " + reason + ".",
                       communicator);

    // Rank 0 keeps the index; without any cells there is nothing to describe.
    const unsigned int first_writer =
      Utilities::MPI::min(has_cells ? rank : n_ranks, communicator);
    if (first_writer == n_ranks)
      return;
    description =
      Utilities::MPI::broadcast(communicator, description, first_writer);
    const std::vector<std::string> grids =
      parts_between(description, xdmf_grid_begin, xdmf_grid_end);
    Assert(grids.size() == 1, ExcInternalError());
    grid = grids.front();
  }



  std::string
  OutputSeries::index_text() const
  {
    std::ostringstream text;
    text << "<?xml version=\"1.0\" ?>\n";
    if (is_hdf5)
      text << "<!DOCTYPE Xdmf SYSTEM \"Xdmf.dtd\" []>\n"
           << "<Xdmf Version=\"2.0\">\n  <Domain>\n"
           << "    <Grid Name=\"CellTime\" GridType=\"Collection\" "
           << "CollectionType=\"Temporal\">\n";
    else
      text << "<VTKFile type=\"Collection\" version=\"0.1\" "
           << "ByteOrder=\"LittleEndian\">\n  <Collection>\n";

    for (const Entry &entry : entries)
      if (!entry.text.empty())
        text << (is_hdf5 ? "      " : "    ") << entry.text << '\n';

    text << (is_hdf5 ? "    </Grid>\n  </Domain>\n</Xdmf>\n"
                     : "  </Collection>\n</VTKFile>\n");
    return text.str();
  }



  template void
  OutputSeries::write(const DataOutInterface<2, 2> &,
                      const unsigned int,
                      const double,
                      const ReferenceCell &,
                      const bool);
  template void
  OutputSeries::write(const DataOutInterface<3, 3> &,
                      const unsigned int,
                      const double,
                      const ReferenceCell &,
                      const bool);
  template void
  OutputSeries::write(const DataOutInterface<1, 2> &,
                      const unsigned int,
                      const double,
                      const ReferenceCell &,
                      const bool);
  template void
  OutputSeries::write(const DataOutInterface<2, 3> &,
                      const unsigned int,
                      const double,
                      const ReferenceCell &,
                      const bool);
  template void
  OutputSeries::write(const DataOutInterface<2, 2> &,
                      const VtuPieces &,
                      const DataOutBase::VtkFlags &,
                      const unsigned int,
                      const double);
  template void
  OutputSeries::write(const DataOutInterface<3, 3> &,
                      const VtuPieces &,
                      const DataOutBase::VtkFlags &,
                      const unsigned int,
                      const double);
} // namespace stickslip
