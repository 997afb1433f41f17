#include <stickslip/output/parallel_files.h>

#include <deal.II/base/exceptions.h>

#include <hdf5.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>
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



    /// What went wrong on any rank, in words. Collective.
    std::string
    reason_of_mpi(const int error, const MPI_Comm communicator)
    {
      const int worst = Utilities::MPI::max(error, communicator);
      if (worst == MPI_SUCCESS)
        return "";
      std::array<char, MPI_MAX_ERROR_STRING> text;
      int                                    length = 0;
      MPI_Error_string(worst, text.data(), &length);
      return std::string(text.data(), length);
    }



    /// Writes the texts of all ranks, one after the other, at @p position,
    /// which it moves behind them. Returns MPI's error code. Collective.
    int
    append(const std::string &text,
           const MPI_File     file,
           const MPI_Comm     communicator,
           std::uint64_t     &position)
    {
      const std::uint64_t length = text.size();
      AssertThrow(length <= std::numeric_limits<int>::max(),
                  ExcMessage("A piece of a file has more than 2 GB."));
      std::uint64_t before = 0;
      const int     ierr =
        MPI_Exscan(&length, &before, 1, MPI_UINT64_T, MPI_SUM, communicator);
      AssertThrowMPI(ierr);
      if (is_root(communicator))
        before = 0; // is not set by MPI
      const int error =
        MPI_File_write_at_all(file,
                              static_cast<MPI_Offset>(position) +
                                static_cast<MPI_Offset>(before),
                              text.data(),
                              static_cast<int>(length),
                              MPI_CHAR,
                              MPI_STATUS_IGNORE);
      position += Utilities::MPI::sum(length, communicator);
      return error;
    }



    /// Of a rank by itself.
    std::string
    write_pieces(const VtuPieces             &pieces,
                 const DataOutBase::VtkFlags &flags,
                 const std::string           &name)
    {
      errno = 0;
      try
        {
          std::ofstream file(name);
          DataOutBase::write_vtu_header(file, flags);
          for (unsigned int k = 0; k < std::max(1U, pieces.n); ++k)
            pieces.write(k, file);
          DataOutBase::write_vtu_footer(file);
          file.close();
          AssertThrow(file, ExcIO());
        }
      catch (const StandardExceptions::ExcIO &)
        {
          return std::strerror(errno);
        }
      return "";
    }



    /// Of several ranks: in each round a piece of each. Collective.
    std::string
    write_pieces_of_all(const VtuPieces             &pieces,
                        const DataOutBase::VtkFlags &flags,
                        const std::string           &name,
                        const MPI_Comm               communicator)
    {
      std::string reason = open_once(name, communicator);
      if (!reason.empty())
        return reason;
      MPI_File file;
      reason = reason_of_mpi(MPI_File_open(communicator,
                                           name.c_str(),
                                           MPI_MODE_WRONLY,
                                           MPI_INFO_NULL,
                                           &file),
                             communicator);
      if (!reason.empty())
        return reason;
      // ParaView does not take empty pieces before others
      const unsigned int n_most = Utilities::MPI::max(pieces.n, communicator);
      const unsigned int n_own =
        n_most == 0 && is_root(communicator) ? 1 : pieces.n;
      const unsigned int n_rounds = std::max(1U, n_most);
      std::uint64_t      position = 0;
      int                error    = MPI_SUCCESS;
      // The first round is the header, the last one the footer.
      for (unsigned int round = 0; round < n_rounds + 2; ++round)
        {
          std::ostringstream text;
          if (round == 0 && is_root(communicator))
            DataOutBase::write_vtu_header(text, flags);
          else if (round == n_rounds + 1 && is_root(communicator))
            DataOutBase::write_vtu_footer(text);
          else if (round > 0 && round <= n_own)
            pieces.write(round - 1, text);
          error =
            std::max(error, append(text.str(), file, communicator, position));
        }
      // without it the end is missing at times on several nodes
      error = std::max(error, MPI_File_sync(file));
      error = std::max(error, MPI_File_close(&file));
      return reason_of_mpi(error, communicator);
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



  std::string
  write_vtu_pieces(const VtuPieces             &pieces,
                   const DataOutBase::VtkFlags &flags,
                   const std::string           &name,
                   const MPI_Comm               communicator)
  {
    const std::string part = temporary_name(name);
    const std::string reason =
      Utilities::MPI::n_mpi_processes(communicator) == 1
        ? write_pieces(pieces, flags, part)
        : write_pieces_of_all(pieces, flags, part, communicator);
    return reason.empty() ? give_name(name, communicator) : reason;
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
