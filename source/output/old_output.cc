#include <stickslip/output/old_output.h>

#include <filesystem>
#include <functional>
#include <limits>
#include <regex>
#include <string>
#include <system_error>
#include <vector>

namespace stickslip
{
  namespace
  {
    /// The step that a file belongs to by its name; none: not such a file.
    constexpr unsigned int no_step = std::numeric_limits<unsigned int>::max();



    /// solution-0007.0.vtu, contact-0007.h5, contact_points-0007.csv,
    /// diagnosis-0007.vtu, and the same with ".part" if the run ended there
    unsigned int
    step_of_file(const std::string &name)
    {
      static const std::regex pattern(
        "(solution|contact|contact_points|diagnosis)-([0-9]{4,9})"
        "(\\.[0-9]+)?\\.(vtu|pvtu|h5|csv)(\\.part)?");
      std::smatch parts;
      return std::regex_match(name, parts, pattern)
               ? static_cast<unsigned int>(std::stoul(parts[2]))
               : no_step;
    }



    /// Files of all steps.
    bool
    is_table_or_index(const std::string &name)
    {
      static const std::regex pattern(
        "(solution|contact)\\.(pvd|xdmf)(\\.part)?|"
        "(points|resultants|reactions|statistics)\\.(csv|txt)(\\.part)?|"
        "line_.*\\.csv(\\.part)?");
      return std::regex_match(name, pattern);
    }



    std::string
    remove_files(const std::string                              &directory,
                 const std::function<bool(const std::string &)> &is_old)
    {
      std::error_code                           error;
      const std::filesystem::directory_iterator files(directory, error);
      std::vector<std::filesystem::path>        old;
      if (!error)
        for (const auto &file : files)
          if (is_old(file.path().filename().string()))
            old.push_back(file.path());
      for (const auto &path : old)
        if (!std::filesystem::remove(path, error) && error)
          return "Output/Directory: '" + path.string() +
                 "' of an earlier run cannot be removed: " + error.message() +
                 ".";
      return "";
    }
  } // namespace



  std::string
  remove_old_output(const std::string &directory)
  {
    return remove_files(directory, [](const std::string &name) {
      return is_table_or_index(name) || step_of_file(name) != no_step;
    });
  }



  std::string
  remove_output_after(const std::string &directory, const unsigned int step)
  {
    return remove_files(directory, [step](const std::string &name) {
      const unsigned int step_of_it = step_of_file(name);
      return step_of_it != no_step && step_of_it > step &&
             name.find("diagnosis") != 0;
    });
  }
} // namespace stickslip
