#include <stickslip/mesh/mesh_size.h>

#include <stickslip/base/user_error.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// The number at the beginning of a file like memory.max; -1 without one.
    double
    number_in_file(const std::string &name)
    {
      std::ifstream file(name);
      double        value = 0.;
      return file >> value ? value : -1.;
    }



    /// What this node can still give [byte]; infinity if it does not say.
    double
    free_memory_of_node()
    {
      double        free = std::numeric_limits<double>::infinity();
      std::ifstream file("/proc/meminfo");
      std::string   word;
      double        kilobytes = 0.;
      while (file >> word)
        if (word == "MemAvailable:" && file >> kilobytes)
          free = 1024. * kilobytes;
      // A container may have less.
      const double limit = number_in_file("/sys/fs/cgroup/memory.max");
      const double used  = number_in_file("/sys/fs/cgroup/memory.current");
      if (limit > 0. && used >= 0.)
        free = std::min(free, limit - used);
      return free;
    }



    std::string
    bytes_in_words(const double bytes)
    {
      const char *const unit  = bytes < 1e9 ? "MB" : bytes < 1e12 ? "GB" : "TB";
      const double      scale = bytes < 1e9 ? 1e6 : bytes < 1e12 ? 1e9 : 1e12;
      char              text[32];
      std::snprintf(text, sizeof(text), "%.3g %s", bytes / scale, unit);
      return text;
    }



    std::string
    cells_in_words(const double n)
    {
      char text[32];
      std::snprintf(text, sizeof(text), n < 1e15 ? "%.0f" : "%.3g", n);
      return std::string(text) + " cells";
    }



    double
    refined(const double       n_cells,
            const unsigned int n_refinements,
            const unsigned int dim)
    {
      return n_cells * std::pow(2., 1. * dim * n_refinements);
    }



    /// " 5 refinements (32768 cells) would fit."
    template <typename Fits>
    std::string
    what_would_fit(const double       n_cells,
                   unsigned int       n_refinements,
                   const unsigned int dim,
                   const Fits        &fits)
    {
      while (n_refinements > 0 && !fits(refined(n_cells, n_refinements, dim)))
        --n_refinements;
      return fits(refined(n_cells, n_refinements, dim))
               ? " What fits at most: " + std::to_string(n_refinements) + " (" +
                   cells_in_words(refined(n_cells, n_refinements, dim)) + ")."
               : "";
    }
  } // namespace



  double
  MeshSize::bytes_of_mesh_cell(const unsigned int dim)
  {
    return dim == 2 ? 250. : 500.;
  }



  MeshSize::MeshSize(const unsigned int dim, const MPI_Comm communicator)
    : dim(dim)
  {
    MPI_Comm node;
    int      ierr = MPI_Comm_split_type(
      communicator, MPI_COMM_TYPE_SHARED, 0, MPI_INFO_NULL, &node);
    AssertThrowMPI(ierr);
    const unsigned int n_ranks_of_node = Utilities::MPI::n_mpi_processes(node);
    ierr                               = MPI_Comm_free(&node);
    AssertThrowMPI(ierr);
    const double share = free_memory_of_node() / n_ranks_of_node;
    free_per_rank      = Utilities::MPI::min(share, communicator);
    free_in_all        = Utilities::MPI::sum(share, communicator);
  }



  void
  MeshSize::check_coarse(const double       n_cells,
                         const std::string &path,
                         const std::string &what) const
  {
    const double need = n_cells * bytes_of_mesh_cell(dim);
    if (need > free_per_rank)
      throw UserError(path + ": " + what + cells_in_words(n_cells) +
                      ", which take at least " + bytes_in_words(need) +
                      " on each rank; " + bytes_in_words(free_per_rank) +
                      " are free there.");
  }



  void
  MeshSize::check_coarse_refinements(const double       n_cells,
                                     const unsigned int n_refinements,
                                     const std::string &path) const
  {
    const auto fits = [&](const double n) {
      return n * bytes_of_mesh_cell(dim) <= free_per_rank;
    };
    const double n_refined = refined(n_cells, n_refinements, dim);
    if (!fits(n_refined))
      throw UserError(path + ": " + std::to_string(n_refinements) +
                      " refinements of " + cells_in_words(n_cells) + " make " +
                      cells_in_words(n_refined) + ", which take at least " +
                      bytes_in_words(n_refined * bytes_of_mesh_cell(dim)) +
                      " on each rank; " + bytes_in_words(free_per_rank) +
                      " are free there." +
                      what_would_fit(n_cells, n_refinements, dim, fits));
  }



  void
  MeshSize::check_refinements(const double       n_cells,
                              const unsigned int n_refinements,
                              const double       bytes_per_cell,
                              const bool         on_one_rank,
                              const std::string &path) const
  {
    const double of_mesh = bytes_of_mesh_cell(dim);
    const double of_all  = of_mesh + bytes_per_cell;
    const auto   fits    = [&](const double n) {
      return n * of_all <= free_in_all &&
             (!on_one_rank || n * of_mesh <= free_per_rank);
    };
    const double n_refined = refined(n_cells, n_refinements, dim);
    if (fits(n_refined))
      return;
    const bool is_too_much_in_all = (n_refined * of_all > free_in_all);
    throw UserError(
      path + ": " + std::to_string(n_refinements) + " refinements of " +
      cells_in_words(n_cells) + " make " + cells_in_words(n_refined) +
      ", which take at least " +
      bytes_in_words(n_refined * (is_too_much_in_all ? of_all : of_mesh)) +
      (is_too_much_in_all ? " in all; " : " on one rank; ") +
      bytes_in_words(is_too_much_in_all ? free_in_all : free_per_rank) +
      " are free there." + what_would_fit(n_cells, n_refinements, dim, fits));
  }



  void
  MeshSize::check_locally_refined(const double       n_cells,
                                  const double       bytes_per_cell,
                                  const std::string &what) const
  {
    const double need = n_cells * (bytes_of_mesh_cell(dim) + bytes_per_cell);
    if (need > free_in_all)
      throw UserError(
        what + " makes at least " + cells_in_words(n_cells) +
        ", which take at least " + bytes_in_words(need) + " in all; " +
        bytes_in_words(free_in_all) +
        " are free there. Take fewer levels or a smaller region.");
  }
} // namespace stickslip
