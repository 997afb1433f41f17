#include <stickslip/output/output_directory.h>

#include <stickslip/base/user_error.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include <unistd.h>

namespace stickslip
{
  using namespace dealii;

  namespace
  {
    std::string
    create_and_test_directory(const std::string &name)
    {
      std::error_code error;
      std::filesystem::create_directories(name, error);
      if (error)
        return error.message();
      if (!std::filesystem::is_directory(name, error))
        return "it exists and is not a directory";

      // Permission bits do not tell all (read-only or full file systems).
      const std::string test_file =
        name + "/.write-test-" + std::to_string(getpid());
      errno = 0;
      const bool works =
        static_cast<bool>(std::ofstream(test_file) << "test\n"
                                                   << std::flush);
      const std::string reason = std::strerror(errno);
      std::filesystem::remove(test_file, error);
      return works ? "" : reason;
    }
  } // namespace



  void
  prepare_output_directory(const std::string &name, const MPI_Comm communicator)
  {
    std::string error;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        const std::string reason = create_and_test_directory(name);
        if (!reason.empty())
          error = "Output/Directory: cannot write into '" + name +
                  "': " + reason + ".";
      }
    throw_collectively(error, communicator);
  }



  std::string
  write_file_atomically(const std::string &name, const std::string &text)
  {
    const std::string temporary_name = name + ".part";
    errno                            = 0;
    {
      std::ofstream file(temporary_name, std::ios::binary);
      file << text << std::flush;
      if (!file)
        return "Cannot write '" + temporary_name +
               "': " + std::strerror(errno) + ".";
    }
    std::error_code error;
    std::filesystem::rename(temporary_name, name, error);
    return error ? "Cannot write '" + name + "': " + error.message() + "." : "";
  }

} // namespace stickslip
