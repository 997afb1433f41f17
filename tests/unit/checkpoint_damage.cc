// A checkpoint of two files with cells, one of them empty. Each bit of each
// file is flipped, each file is cut at each length, lost or replaced by that of
// another checkpoint: all of it has to be found. Printed are the places where
// nothing is found, and what is said about some others.

#include <stickslip/simulation/cell_records.h>
#include <stickslip/simulation/checkpoint_damage.h>
#include <stickslip/simulation/checkpoint_description.h>
#include <stickslip/simulation/checkpoint_directory.h>

#include <deal.II/base/mpi.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>
#include <string>
#include <vector>

namespace
{
  using namespace stickslip;

  std::string
  content_of(const std::string &name)
  {
    std::ifstream      file(name, std::ios::binary);
    std::ostringstream content;
    content << file.rdbuf();
    return content.str();
  }



  void
  write(const std::string &name, const std::string &content)
  {
    std::ofstream(name, std::ios::binary) << content;
  }



  void
  write_checkpoint(const std::string &directory, const std::uint64_t identity)
  {
    std::filesystem::create_directories(directory);
    CheckpointDescription description;
    description.identity                                = identity;
    description.n_files                                 = 2;
    description.scalars.control.load_stepping.time      = 0.7;
    description.scalars.control.load_stepping.step_size = 0.05;
    description.scalars.control.last_iterations         = {5, 3, 4};
    description.scalars.work.external                   = 1.25e-3;
    description.problem.properties = {{"dimension", "2"}, {"cells", "3"}};
    description.problem.geometry   = {0.1, 0.2, 10.};
    description.physics            = {{"Materials/soft/Young's modulus", "10"}};
    write(path_of_description(directory), description.text());
    CellRecordWriter full(path_of_cells(directory, 0), identity);
    for (unsigned int cell = 0; cell < 3; ++cell)
      full.add({{cell, 7, 8, 9}}, std::vector<double>(2 + cell, 0.1 * cell));
    CellRecordWriter empty(path_of_cells(directory, 1), identity);
    std::cout << full.finish() << empty.finish();
  }



  /// Says which changes of @p file are not found.
  template <typename Change>
  void
  change_file(const std::string &directory,
              const std::string &file,
              const std::string &what,
              const unsigned int n_changes,
              const Change      &change)
  {
    const std::string name    = directory + "/" + file;
    const std::string content = content_of(name);
    std::string       missed;
    for (unsigned int i = 0; i < n_changes; ++i)
      {
        write(name, change(content, i));
        if (find_damage(directory).empty())
          missed += " " + std::to_string(i);
      }
    write(name, content);
    std::cout << file << ", " << what << ": "
              << (missed.empty() ? "all found" : "missed" + missed)
              << std::endl;
  }
} // namespace



int
main(int argc, char **argv)
{
  dealii::Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const std::string results   = "checkpoint_damage_results";
  const std::string directory = results + "/checkpoint-a";
  const std::string other     = results + "/checkpoint-b";
  write_checkpoint(directory, 0x1234567890abcdefull);
  write_checkpoint(other, 42);
  std::cout << "whole: '" << find_damage(directory) << "', '"
            << find_damage(other) << "'" << std::endl;
  for (const std::string file : {"description", "cells.0", "cells.1"})
    {
      const std::string  content = content_of(directory + "/" + file);
      const unsigned int n       = content.size();
      change_file(directory,
                  file,
                  "bits flipped",
                  8 * n,
                  [](std::string text, const unsigned int i) {
                    text[i / 8] ^= 1 << (i % 8);
                    return text;
                  });
      change_file(directory,
                  file,
                  "cut",
                  n,
                  [](const std::string &text, const unsigned int i) {
                    return text.substr(0, i);
                  });
      change_file(directory,
                  file,
                  "a byte more",
                  256,
                  [](const std::string &text, const unsigned int i) {
                    return text + static_cast<char>(i);
                  });
      change_file(directory,
                  file,
                  "of another checkpoint",
                  1,
                  [&](const std::string &, const unsigned int) {
                    return content_of(other + "/" + file);
                  });
    }
  std::filesystem::remove(path_of_cells(directory, 1));
  std::cout << describe_damage(directory, find_damage(directory)) << std::endl;
  std::filesystem::remove(path_of_description(other));
  std::cout << describe_damage(directory, find_damage(directory)) << std::endl;
}
