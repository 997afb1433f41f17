// partition_cells(): every rank has its share of the cells and of the faces in
// contact, of two bodies of which only one has such faces; few common faces.
#include <stickslip/mesh/cell_partition.h>

#include <deal.II/grid/grid_generator.h>

#include <algorithm>
#include <iostream>
#include <vector>

using namespace stickslip;

namespace
{
  constexpr unsigned int n_per_edge = 12;

  /// Two cubes that share nothing.
  void
  make_cubes(Triangulation<3> &mesh)
  {
    Triangulation<3>                lower, upper;
    const std::vector<unsigned int> n(3, n_per_edge);
    GridGenerator::subdivided_hyper_rectangle(lower,
                                              n,
                                              Point<3>(0, 0, 0),
                                              Point<3>(1, 1, 1));
    GridGenerator::subdivided_hyper_rectangle(upper,
                                              n,
                                              Point<3>(0, 0, 2),
                                              Point<3>(1, 1, 3));
    GridGenerator::merge_triangulations(lower, upper, mesh);
  }



  bool
  is_in_contact(const CellAccessor<3> &cell)
  {
    return cell.center()[2] > 2. && cell.center()[2] < 2. + 1. / n_per_edge;
  }



  /// The largest share over the mean one.
  double
  imbalance(const std::vector<double> &sums)
  {
    double total = 0.;
    for (const double sum : sums)
      total += sum;
    return *std::max_element(sums.begin(), sums.end()) * sums.size() / total;
  }



  struct Partition
  {
    double       cells          = 0.; ///< imbalance
    double       contact        = 0.;
    unsigned int n_common_faces = 0;
  };



  Partition
  partition(const unsigned int n_ranks, const bool with_contact)
  {
    Triangulation<3> mesh;
    make_cubes(mesh);
    std::vector<std::vector<unsigned int>> costs(
      1, std::vector<unsigned int>(mesh.n_active_cells(), 1));
    if (with_contact)
      {
        costs.emplace_back();
        for (const auto &cell : mesh.active_cell_iterators())
          costs.back().push_back(is_in_contact(*cell));
      }
    partition_cells(n_ranks, costs, mesh);

    std::vector<double> cells(n_ranks, 0.), contact(n_ranks, 0.);
    Partition           result;
    for (const auto &cell : mesh.active_cell_iterators())
      {
        cells.at(cell->subdomain_id()) += 1.;
        contact.at(cell->subdomain_id()) += is_in_contact(*cell);
        for (const unsigned int f : cell->face_indices())
          if (!cell->at_boundary(f) &&
              cell->neighbor(f)->subdomain_id() > cell->subdomain_id())
            ++result.n_common_faces;
      }
    result.cells   = imbalance(cells);
    result.contact = imbalance(contact);
    return result;
  }



  const char *
  answer(const bool is_so)
  {
    return is_so ? "yes" : "no";
  }
} // namespace



int
main()
{
  for (const unsigned int n_ranks : {1, 2, 3, 8, 16})
    {
      const Partition one = partition(n_ranks, false);
      const Partition two = partition(n_ranks, true);
      std::cout << n_ranks << (n_ranks == 1 ? " rank" : " ranks")
                << "\n  as many cells on each (5 %): "
                << answer(one.cells < 1.05)
                << "\n  with contact: " << answer(two.cells < 1.05)
                << ", as much contact (30 %): " << answer(two.contact < 1.3)
                << "\n  at most 1.5 times the common faces, or one layer: "
                << answer(two.n_common_faces <=
                          std::max(1.5 * one.n_common_faces,
                                   1. * n_per_edge * n_per_edge))
                << '\n';
    }
}
