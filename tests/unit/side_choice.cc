// Who is slave and master of a surface that meets itself: chains of faces that
// are opposite each other, as folds, corners and meshes make them.

#include "print.h"

#include <stickslip/contact/pairing/side_choice.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

using namespace stickslip;

namespace
{
  FaceId
  name(const unsigned int i)
  {
    FaceId id;
    id.cell[0] = i;
    return id;
  }



  /// A line of faces of a size; face i has the nodes i and i + 1.
  std::vector<SidedFace>
  line(const unsigned int n, const double size = 1.)
  {
    std::vector<SidedFace> faces;
    for (unsigned int i = 0; i < n; ++i)
      faces.push_back({name(i), {i, i + 1}, size, true, true, Side::neither});
    return faces;
  }



  /// Face i and face n - 1 - i of a line that is folded in the middle, except
  /// for the @p root innermost ones; the distance grows from the root.
  std::vector<OppositeFaces>
  fold(const unsigned int n, const unsigned int root, const double slope)
  {
    std::vector<OppositeFaces> opposite;
    for (unsigned int i = 0; i + root < n / 2; ++i)
      opposite.push_back({name(i), name(n - 1 - i), slope * (n / 2 - i)});
    return opposite;
  }



  /// s, m and - for all faces.
  std::string
  sides(std::vector<SidedFace> faces, const std::vector<OppositeFaces> &both)
  {
    choose_sides(faces, both);
    std::string text;
    for (const auto &face : faces)
      text += face.side == Side::slave    ? 's'
              : face.side == Side::master ? 'm'
                                          : '-';
    return text;
  }
} // namespace



int
main(int argc, char *argv[])
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);

  print("nothing opposite: " + sides(line(6), {}));
  print("a fold that is closed to its root: " +
        sides(line(12), fold(12, 0, 0.)));
  print("one that is open at its root: " + sides(line(20), fold(20, 6, 0.2)));
  {
    auto opposite = fold(12, 0, 0.1);
    std::reverse(opposite.begin(), opposite.end());
    for (auto &both : opposite)
      std::swap(both.a, both.b);
    print("in another order: " + sides(line(12), opposite));
  }
  {
    auto faces = line(12);
    for (unsigned int i = 6; i < 12; ++i)
      faces[i].diameter = 0.5;
    print("the finer one is slave: " + sides(faces, fold(12, 0, 0.)));
    faces[0].side  = Side::slave;
    faces[11].side = Side::master;
    print("but what touches stays what it is: " +
          sides(faces, fold(12, 0, 0.)));
  }
  {
    auto faces = line(12);
    for (unsigned int i = 6; i < 10; ++i)
      faces[i].side = Side::slave;
    print("what most of it was: " + sides(faces, fold(12, 0, 1.)));
    for (auto &face : faces)
      face.may_be_master = &face - faces.data() < 6;
    print("what it may be: " + sides(faces, fold(12, 0, 1.)));
  }
  {
    // three layers: the middle ones are front and back of a body
    auto faces = line(12);
    for (unsigned int i = 4; i < 8; ++i)
      faces[i].nodes = {i + 100, i + 101};
    std::vector<OppositeFaces> opposite;
    for (unsigned int i = 0; i < 4; ++i)
      {
        opposite.push_back({name(i), name(4 + i), 0.});
        opposite.push_back({name(4 + i), name(8 + i), 0.05 * (1. + i)});
      }
    print("between two: " + sides(faces, opposite));
  }
  {
    // the sides of a triangular hole: no two colours, the nearest count
    auto faces     = line(3);
    faces[2].nodes = {2, 0};
    print("three that are opposite each other: " +
          sides(faces,
                {{name(0), name(1), 0.5},
                 {name(0), name(2), 0.1},
                 {name(1), name(2), 0.2}}));
  }
}
