#ifndef stickslip_output_output_series_h
#define stickslip_output_output_series_h

#include <stickslip/output/output_parameters.h>
#include <stickslip/output/parallel_files.h>

#include <deal.II/base/data_out_base.h>
#include <deal.II/base/mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * The files of one kind of output ("solution", "contact") over the steps of
   * a run: per step NAME-0001.pvtu with its pieces, and NAME.pvd that lists
   * the steps with their times; or NAME-0001.h5 and NAME.xdmf.
   *
   * Each index file is replaced by renaming a complete new one, and the pieces
   * of a step are complete before an index names them: what ParaView can open
   * is whole, also after a crash.
   */
  class OutputSeries
  {
  public:
    OutputSeries(const OutputParameters &parameters,
                 const std::string      &name,
                 const MPI_Comm          communicator);

    /**
     * Takes over the steps up to @p time from the index file of an earlier
     * run; later ones are dropped, also in the file. Collective; throws
     * UserError on all ranks if it cannot be written.
     */
    void
    resume(const double time);

    /**
     * Writes the patches of @p data as step @p step. Collective; throws
     * UserError on all ranks if the files cannot be written.
     *
     * @p cell is what all patches are.
     * @p has_lagrange_hexahedra: the VTU files contain hexahedra of degree 2
     * or more. Each rank then writes its own file, because VTK's reader, which
     * renumbers the nodes of such cells, does so repeatedly for the parts of a
     * file that several ranks share (VTK 9.1) and tears the cells apart.
     */
    template <int dim, int spacedim>
    void
    write(const DataOutInterface<dim, spacedim> &data,
          const unsigned int                     step,
          const double                           time,
          const ReferenceCell &cell = ReferenceCells::get_hypercube<dim>(),
          const bool           has_lagrange_hexahedra = false);

    /**
     * The same as VTU files, from @p pieces that are made one after the other,
     * so that there is never more than one in memory. @p data has the names of
     * the fields; it needs no patches. Collective.
     */
    template <int dim, int spacedim>
    void
    write(const DataOutInterface<dim, spacedim> &data,
          const VtuPieces                       &pieces,
          const DataOutBase::VtkFlags           &flags,
          const unsigned int                     step,
          const double                           time);

  private:
    /// What the index file says about one step.
    struct Entry
    {
      double      time;
      std::string text;
    };

    /// Writes a file NAME for the ranks of a communicator, collectively, and
    /// returns what went wrong.
    using FileWriter =
      std::function<std::string(const std::string &, const MPI_Comm)>;

    /// Throws UserError on all ranks if a file of @p write_file cannot be
    /// written. Returns what went wrong with the record of the files, on rank
    /// 0.
    template <int dim, int spacedim>
    std::string
    write_vtu(const DataOutInterface<dim, spacedim> &data,
              const FileWriter                      &write_file,
              const std::string                     &step_name,
              const unsigned int                     n_files) const;

    /// The entry of a step of VTU files.
    std::string
    vtu_entry(const std::string &step_name, const double time) const;

    std::string
    name_of_step(const unsigned int step) const;

    /// Adds an entry to the index, unless there is an @p error of rank 0,
    /// which is thrown on all ranks. Collective.
    void
    add_entry(const double time, const std::string &text, std::string error);

    /// Throws UserError on all ranks if the file cannot be written; if it fails
    /// in the middle on several ranks, an exception that ends them all.
    template <int dim, int spacedim>
    void
    write_hdf5(const DataOutInterface<dim, spacedim> &data,
               const std::string                     &step_name,
               const double                           time,
               const ReferenceCell                   &cell,
               std::string                           &grid) const;

    std::string
    path_of_index() const;

    /// Reads the entries up to @p time from the index file.
    void
    read_index(const double time);

    std::string
    index_text() const;

    const std::string  directory;
    const std::string  name;
    const bool         is_hdf5;
    const unsigned int n_ranks;
    const unsigned int n_grouped_files;
    const MPI_Comm     communicator;

    std::vector<Entry> entries; ///< on rank 0
  };
} // namespace stickslip

#endif
