#include <stickslip/output/parallel_files.h>

#include <deal.II/base/exceptions.h>

#include <hdf5.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace stickslip
{
  namespace
  {
    bool
    is_root(const MPI_Comm communicator)
    {
      return Utilities::MPI::this_mpi_process(communicator) == 0;
    }



    std::string
    temporary_name(const std::string &name)
    {
      return name + ".part";
    }



    /// The complete file gets its name, from one rank. Returns what went wrong.
    std::string
    give_name(const std::string &name, const MPI_Comm communicator)
    {
      MPI_Barrier(communicator);
      std::error_code error;
      if (is_root(communicator))
        std::filesystem::rename(temporary_name(name), name, error);
      return error ? error.message() : "";
    }



    /// Empties the file. Returns why it cannot be written, on all ranks.
    std::string
    open_once(const std::string &name, const MPI_Comm communicator)
    {
      std::string reason;
      if (is_root(communicator))
        {
          errno = 0;
          const std::ofstream file(name);
          if (!file)
            reason = std::strerror(errno);
        }
      return Utilities::MPI::broadcast(communicator, reason, 0);
    }



    /// The innermost entry of HDF5's error stack: what went wrong first.
    std::string
    reason_of_hdf5()
    {
      std::string reason;
      H5Ewalk2(
        H5E_DEFAULT,
        H5E_WALK_UPWARD,
        [](const unsigned int n, const H5E_error2_t *error, void *text) {
          if (n == 0 && error->desc != nullptr)
            *static_cast<std::string *>(text) = error->desc;
          return herr_t(0);
        },
        &reason);
      return reason.empty() ? "the HDF5 library reports an error" : reason;
    }
  } // namespace



  template <int dim, int spacedim>
  std::string
  write_vtu_file(const DataOutInterface<dim, spacedim> &data,
                 const std::string                     &name,
                 const MPI_Comm                         communicator)
  {
    try
      {
        if (Utilities::MPI::n_mpi_processes(communicator) > 1)
          data.write_vtu_in_parallel(temporary_name(name), communicator);
        else
          {
            // the parallel way keeps the whole text in memory
            errno = 0;
            std::ofstream file(temporary_name(name));
            data.write_vtu(file);
            file.close();
            AssertThrow(file, ExcIO());
          }
      }
    catch (const StandardExceptions::ExcFileNotOpen &)
      {
        return "the file cannot be opened"; // on all ranks
      }
    catch (const StandardExceptions::ExcIO &)
      {
        return std::strerror(errno);
      }
    return give_name(name, communicator);
  }



  template <int dim, int spacedim>
  std::string
  write_hdf5_file(const DataOutInterface<dim, spacedim> &data,
                  const DataOutBase::DataOutFilter      &filter,
                  const std::string                     &name,
                  const MPI_Comm                         communicator)
  {
    // deal.II looks at all return codes; HDF5 would also print its error stack
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
    std::string reason = open_once(temporary_name(name), communicator);
    if (!reason.empty())
      return reason;
    try
      {
        data.write_hdf5_parallel(filter, temporary_name(name), communicator);
      }
    catch (const ExceptionBase &)
      {
        reason = reason_of_hdf5();
        if (Utilities::MPI::n_mpi_processes(communicator) > 1)
          throw std::runtime_error("Cannot write '" + name + "': " + reason +
                                   ".");
        return reason;
      }
    return give_name(name, communicator);
  }



  template std::string
  write_vtu_file(const DataOutInterface<2, 2> &,
                 const std::string &,
                 const MPI_Comm);
  template std::string
  write_vtu_file(const DataOutInterface<3, 3> &,
                 const std::string &,
                 const MPI_Comm);
  template std::string
  write_vtu_file(const DataOutInterface<1, 2> &,
                 const std::string &,
                 const MPI_Comm);
  template std::string
  write_vtu_file(const DataOutInterface<2, 3> &,
                 const std::string &,
                 const MPI_Comm);
  template std::string
  write_hdf5_file(const DataOutInterface<2, 2> &,
                  const DataOutBase::DataOutFilter &,
                  const std::string &,
                  const MPI_Comm);
  template std::string
  write_hdf5_file(const DataOutInterface<3, 3> &,
                  const DataOutBase::DataOutFilter &,
                  const std::string &,
                  const MPI_Comm);
  template std::string
  write_hdf5_file(const DataOutInterface<1, 2> &,
                  const DataOutBase::DataOutFilter &,
                  const std::string &,
                  const MPI_Comm);
  template std::string
  write_hdf5_file(const DataOutInterface<2, 3> &,
                  const DataOutBase::DataOutFilter &,
                  const std::string &,
                  const MPI_Comm);
} // namespace stickslip
