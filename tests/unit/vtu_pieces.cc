// VTU files that ranks write piece by piece, each another number of them:
// everything is in the file once, and what goes wrong is said.

#include "print.h"

#include <stickslip/output/parallel_files.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

using namespace stickslip;

namespace
{
  std::string
  text_of(const unsigned int rank, const unsigned int k)
  {
    return "<Piece rank=\"" + std::to_string(rank) + "\" k=\"" +
           std::to_string(k) + "\">" + std::string(1000 * k, '.') +
           "</Piece>\n";
  }



  unsigned int
  count(const std::string &text, const std::string &part)
  {
    unsigned int n = 0;
    for (auto at = text.find(part); at != std::string::npos;
         at      = text.find(part, at + 1))
      ++n;
    return n;
  }



  VtuPieces
  pieces_of(const unsigned int rank)
  {
    return {(3 * rank + 2) % 5, // 2, 0, 3, 1
            [rank](const unsigned int k, std::ostream &out) {
              out << text_of(rank, k);
            }};
  }
} // namespace



int
main(int argc, char *argv[])
{
  const Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  const unsigned int rank = Utilities::MPI::this_mpi_process(MPI_COMM_WORLD);
  const unsigned int n    = Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);

  const std::string file = "pieces.vtu";
  const std::string reason =
    write_vtu_pieces(pieces_of(rank), {}, file, MPI_COMM_WORLD);
  print("written", reason.empty());
  std::ostringstream content;
  content << std::ifstream(file).rdbuf();
  const std::string text         = content.str();
  bool              all_are_once = true;
  unsigned int      total        = 0;
  for (unsigned int r = 0; r < n; ++r)
    for (unsigned int k = 0; k < pieces_of(r).n; ++k, ++total)
      all_are_once = all_are_once && count(text, text_of(r, k)) == 1;
  print("each piece once", all_are_once && count(text, "<Piece") == total);
  print("the header before them",
        count(text, "<VTKFile") == 1 &&
          text.find("<VTKFile") < text.find("<Piece"));
  const std::string end = "</VTKFile>\n";
  print("and the end behind them",
        text.size() > end.size() &&
          text.substr(text.size() - end.size()) == end);
  print("no temporary file is left", !std::filesystem::exists(file + ".part"));

  const std::string failure =
    write_vtu_pieces(pieces_of(rank), {}, "nowhere/pieces.vtu", MPI_COMM_WORLD);
  print("all ranks know why there is no file",
        failure == "No such file or directory");
}
