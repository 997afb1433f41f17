#include <stickslip/simulation/checkpoint_directory.h>

#include <stickslip/output/output_directory.h>

#include <stickslip/simulation/checkpoint_damage.h>

#include <filesystem>
#include <fstream>
#include <sstream>

namespace stickslip
{
  namespace
  {
    const std::string checkpoint_slots[2] = {"checkpoint-a", "checkpoint-b"};



    std::string
    path_of_latest(const std::string &directory)
    {
      return directory + "/checkpoint.latest";
    }



    /// All of checkpoint.latest; "" if it is not there.
    std::string
    content_of_latest(const std::string &directory)
    {
      std::ifstream      file(path_of_latest(directory), std::ios::binary);
      std::ostringstream content;
      content << file.rdbuf();
      return content.str();
    }



    /// Name of the directory of the valid checkpoint; "" if there is none.
    std::string
    latest_slot(const std::string &directory)
    {
      const std::string content = content_of_latest(directory);
      for (const std::string &slot : checkpoint_slots)
        if (content == slot + "\n")
          return slot;
      return "";
    }
  } // namespace



  std::string
  path_of_description(const std::string &checkpoint)
  {
    return checkpoint + "/description";
  }



  std::string
  path_of_cells(const std::string &checkpoint, const unsigned int file)
  {
    return checkpoint + "/cells." + std::to_string(file);
  }



  std::string
  prepare_next_checkpoint(const std::string &directory, std::string &checkpoint)
  {
    const bool a_is_valid = latest_slot(directory) == checkpoint_slots[0];
    checkpoint = directory + "/" + checkpoint_slots[a_is_valid ? 1 : 0];
    std::error_code error;
    std::filesystem::create_directories(checkpoint, error);
    if (!error) // from now on it is not a checkpoint
      std::filesystem::remove(path_of_description(checkpoint), error);
    return error ? "Cannot write a checkpoint into '" + checkpoint +
                     "': " + error.message() + "."
                 : "";
  }



  std::string
  declare_complete(const std::string &checkpoint,
                   const std::string &description,
                   const unsigned int n_files)
  {
    std::error_code error;
    for (unsigned int file = n_files;
         std::filesystem::remove(path_of_cells(checkpoint, file), error);
         ++file)
      {}
    const std::string failure =
      write_file_atomically(path_of_description(checkpoint), description);
    const std::filesystem::path path(checkpoint);
    return failure.empty()
             ? write_file_atomically(path_of_latest(path.parent_path()),
                                     path.filename().string() + "\n")
             : failure;
  }



  void
  retire_checkpoints(const std::string &directory)
  {
    std::error_code error;
    std::filesystem::remove(path_of_latest(directory), error);
  }



  std::string
  find_checkpoint(const std::string &directory, std::string &error)
  {
    const std::string slot = latest_slot(directory);
    if (!slot.empty())
      return directory + "/" + slot;
    std::error_code no_matter; // a name that is too long is no checkpoint
    if (std::filesystem::exists(path_of_description(directory), no_matter))
      return directory;
    error = content_of_latest(directory).empty()
              ? "--restart: there is no checkpoint in '" + directory +
                  "'. A run writes one at its end and with 'Output/Checkpoint "
                  "every n steps'."
              : "--restart: '" + path_of_latest(directory) + "' is damaged.";
    for (const std::string &earlier : checkpoint_slots)
      if (find_damage(directory + "/" + earlier).empty())
        error += " There is '" + directory + "/" + earlier +
                 "' of an earlier time or run, which --restart accepts, too.";
    return "";
  }



  std::string
  make_latest_checkpoint(const std::string &checkpoint,
                         const std::string &output_directory)
  {
    std::error_code error;
    for (const std::string &slot : checkpoint_slots)
      if (std::filesystem::equivalent(checkpoint,
                                      output_directory + "/" + slot,
                                      error) &&
          latest_slot(output_directory) != slot)
        return write_file_atomically(path_of_latest(output_directory),
                                     slot + "\n");
    return "";
  }



  std::string
  checkpoint_beside(const std::string &checkpoint)
  {
    for (unsigned int s = 0; s < 2; ++s)
      {
        const auto at = checkpoint.rfind("/" + checkpoint_slots[s]);
        if (at != std::string::npos)
          return checkpoint.substr(0, at + 1) + checkpoint_slots[1 - s];
      }
    return "";
  }



  bool
  checkpoint_is_in(const std::string &directory,
                   const std::string &output_directory,
                   const MPI_Comm    &communicator)
  {
    bool is_in = false;
    if (Utilities::MPI::this_mpi_process(communicator) == 0)
      {
        std::error_code error;
        is_in = std::filesystem::equivalent(directory, output_directory, error);
        for (const std::string &slot : checkpoint_slots)
          is_in =
            is_in || std::filesystem::equivalent(directory,
                                                 output_directory + "/" + slot,
                                                 error);
      }
    return Utilities::MPI::broadcast(communicator, is_in, 0);
  }
} // namespace stickslip
