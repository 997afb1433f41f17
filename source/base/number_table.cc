#include <stickslip/base/number_table.h>
#include <stickslip/base/user_error.h>

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>

#include <boost/serialization/utility.hpp>
#include <boost/serialization/vector.hpp>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

namespace stickslip
{
  namespace
  {
    /// Numbers of a line that are separated by commas, semicolons or blanks;
    /// empty if one of them is no number.
    std::vector<double>
    numbers_in(std::string line)
    {
      for (char &letter : line)
        if (letter == ',' || letter == ';' || letter == '\t' || letter == '\r')
          letter = ' ';
      std::vector<double> numbers;
      for (const std::string &word :
           Utilities::split_string_list(Utilities::trim(line), ' '))
        if (!word.empty())
          try
            {
              numbers.push_back(Utilities::string_to_double(word));
            }
          catch (const ExceptionBase &)
            {
              return {};
            }
      return numbers;
    }



    NumberTable
    read_table(const std::string               &file_name,
               const std::vector<unsigned int> &columns,
               const std::string               &path)
    {
      std::ifstream   input(file_name);
      std::error_code error;
      if (!input || std::filesystem::is_directory(file_name, error))
        throw UserError(path + ": the file '" + file_name +
                        "' cannot be opened for reading.");
      NumberTable  table;
      std::string  line;
      unsigned int n_lines  = 0;
      bool         is_first = true;
      while (std::getline(input, line))
        {
          ++n_lines;
          line = Utilities::trim(line.substr(0, line.find('#')));
          if (line.empty() || line == "\r")
            continue;
          const std::vector<double> numbers = numbers_in(line);
          const unsigned int        needed  = std::max(columns[0], columns[1]);
          if (numbers.size() < needed && !(is_first && numbers.empty()))
            throw UserError(file_name + ":" + std::to_string(n_lines) +
                            ": expected a line with at least " +
                            std::to_string(needed) + " numbers (" + path +
                            "), found '" + line.substr(0, 60) + "'.");
          if (!numbers.empty())
            table.emplace_back(numbers[columns[0] - 1],
                               numbers[columns[1] - 1]);
          is_first = false;
        }
      return table;
    }
  } // namespace



  NumberTable
  read_number_table(const std::string               &file_name,
                    const std::string               &directory,
                    const std::vector<unsigned int> &columns,
                    const std::string               &path,
                    const MPI_Comm                   communicator)
  {
    const std::string file =
      (std::filesystem::path(directory) / file_name).string();
    NumberTable table;
    on_first_rank([&] { table = read_table(file, columns, path); },
                  communicator);
    return Utilities::MPI::broadcast(communicator, table);
  }
} // namespace stickslip
