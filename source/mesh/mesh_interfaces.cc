#include <stickslip/mesh/mesh_interfaces.h>

#include <stickslip/mesh/free_faces.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

namespace stickslip
{
  std::string
  in_words(const MeshGroup &group)
  {
    const std::string number =
      group.number < 0 ? "" : std::to_string(group.number);
    if (group.name.empty())
      return number;
    return "'" + group.name + "'" + (number.empty() ? "" : " (" + number + ")");
  }



  namespace
  {
    double
    distance_to_segment(const Point<3> &p, const Point<3> &a, const Point<3> &b)
    {
      const Tensor<1, 3> ab     = b - a;
      const double       square = ab.norm_square();
      const double       s =
        square > 0. ? std::min(std::max((p - a) * ab / square, 0.), 1.) : 0.;
      return p.distance(a + s * ab);
    }



    double
    distance_to_triangle(const Point<3> &p,
                         const Point<3> &a,
                         const Point<3> &b,
                         const Point<3> &c)
    {
      const Tensor<1, 3> normal    = cross_product_3d(b - a, c - a);
      const double       square    = normal.norm_square();
      const auto         is_inside = [&](const Point<3> &v, const Point<3> &w) {
        return cross_product_3d(w - v, p - v) * normal >= 0.;
      };
      if (square > 0. && is_inside(a, b) && is_inside(b, c) && is_inside(c, a))
        return std::abs((p - a) * normal) / std::sqrt(square);
      return std::min({distance_to_segment(p, a, b),
                       distance_to_segment(p, b, c),
                       distance_to_segment(p, c, a)});
    }



    /// Boxes of equal size that know what lies in them.
    class PointBins
    {
    public:
      explicit PointBins(const double size)
        : size(size)
      {}

      void
      add(const Point<3> &low, const Point<3> &high, const std::size_t item)
      {
        const auto first = bin_of(low), last = bin_of(high);
        for (long i = first[0]; i <= last[0]; ++i)
          for (long j = first[1]; j <= last[1]; ++j)
            for (long k = first[2]; k <= last[2]; ++k)
              bins[key({{i, j, k}})].push_back(item);
      }

      const std::vector<std::size_t> &
      at(const Point<3> &point) const
      {
        static const std::vector<std::size_t> none;
        const auto found = bins.find(key(bin_of(point)));
        return found == bins.end() ? none : found->second;
      }

    private:
      std::array<long, 3>
      bin_of(const Point<3> &point) const
      {
        std::array<long, 3> bin;
        for (unsigned int d = 0; d < 3; ++d)
          bin[d] = static_cast<long>(std::floor(point[d] / size));
        return bin;
      }

      static std::uint64_t
      key(const std::array<long, 3> &bin)
      {
        return (bin[0] * 73856093ULL) ^ (bin[1] * 19349663ULL) ^
               (bin[2] * 83492791ULL);
      }

      double                                                      size;
      std::unordered_map<std::uint64_t, std::vector<std::size_t>> bins;
    };



    template <int dim>
    class InterfaceSearch
    {
    public:
      InterfaceSearch(const MeshFile                  &file,
                      const std::vector<std::size_t>  &cells,
                      const std::vector<unsigned int> &bodies,
                      const double                     extent);

      MeshInterfaces
      run();

    private:
      void
      collect_groups();

      void
      find_coincident_points();

      void
      look_around(const unsigned int point);

      double
      distance(const std::size_t face, const Point<3> &point) const;

      void
      add_near(const unsigned int point,
               const std::size_t  face,
               const double       gap);

      const MeshFile                           &file;
      const FreeFaces<dim>                      faces;
      const double                              tolerance;
      std::unordered_map<std::size_t, unsigned> body_of_cell;

      /// Free points: their body, groups of their faces, and the first point
      /// that is at the same place.
      std::map<unsigned int, unsigned int>           body_of_point;
      std::map<unsigned int, std::set<unsigned int>> groups_of_point;
      std::vector<std::set<unsigned int>>            groups_of_face;
      std::map<unsigned int, unsigned int>           first_at_place;

      struct Near
      {
        NearSurfaces           surfaces;
        std::set<unsigned int> points, first_groups, second_groups;
      };
      std::map<std::pair<unsigned int, unsigned int>, Near> near;

      double         reach = 0.;
      PointBins      bins{1.};
      MeshInterfaces result;
    };



    template <int dim>
    InterfaceSearch<dim>::InterfaceSearch(
      const MeshFile                  &file,
      const std::vector<std::size_t>  &cells,
      const std::vector<unsigned int> &bodies,
      const double                     extent)
      : file(file)
      , faces(file, cells, "The mesh ")
      , tolerance(1e-6 * extent)
    {
      for (std::size_t c = 0; c < cells.size(); ++c)
        body_of_cell[cells[c]] = bodies[c];
      for (std::size_t f = 0; f < faces.size(); ++f)
        for (const unsigned int point : faces.vertices(f))
          body_of_point[point] = body_of_cell[faces.cell(f)];
      collect_groups();
    }



    template <int dim>
    void
    InterfaceSearch<dim>::collect_groups()
    {
      groups_of_face.resize(faces.size());
      for (std::size_t e = 0; e < file.n_elements(); ++e)
        if (file.dimension(e) == dim - 1 && !file.groups_of(e).empty())
          if (const std::size_t f = faces.find(file, e); f < faces.size())
            for (const unsigned int g : file.groups_of(e))
              {
                groups_of_face[f].insert(g);
                for (const unsigned int point : faces.vertices(f))
                  groups_of_point[point].insert(g);
              }
    }



    template <int dim>
    void
    InterfaceSearch<dim>::find_coincident_points()
    {
      PointBins    places(4. * tolerance);
      Tensor<1, 3> margin;
      for (unsigned int d = 0; d < 3; ++d)
        margin[d] = tolerance;
      for (const auto &[point, body] : body_of_point)
        {
          const Point<3> &x     = file.points[point];
          first_at_place[point] = point;
          for (const std::size_t other : places.at(x))
            if (x.distance(file.points[other]) <= tolerance)
              {
                first_at_place[point] = other;
                ++result.n_coincident;
                if (body_of_point[other] == body && ++result.n_crack == 1)
                  result.crack_place = x;
                break;
              }
          if (first_at_place[point] == point)
            places.add(x - margin, x + margin, point);
        }
    }



    template <int dim>
    double
    InterfaceSearch<dim>::distance(const std::size_t face,
                                   const Point<3>   &point) const
    {
      const auto v = faces.vertices(face);
      if (dim == 2)
        return distance_to_segment(point, file.points[v[0]], file.points[v[1]]);
      if (v.size() == 3)
        return distance_to_triangle(point,
                                    file.points[v[0]],
                                    file.points[v[1]],
                                    file.points[v[2]]);
      return std::min(distance_to_triangle(point,
                                           file.points[v[0]],
                                           file.points[v[1]],
                                           file.points[v[3]]),
                      distance_to_triangle(point,
                                           file.points[v[0]],
                                           file.points[v[3]],
                                           file.points[v[2]]));
    }



    template <int dim>
    void
    InterfaceSearch<dim>::add_near(const unsigned int point,
                                   const std::size_t  face,
                                   const double       gap)
    {
      const unsigned int own      = body_of_point[point];
      const unsigned int other    = body_of_cell[faces.cell(face)];
      const bool         is_first = own < other;
      auto [found, is_new] =
        near.insert({{std::min(own, other), std::max(own, other)}, Near()});
      Near         &pair     = found->second;
      NearSurfaces &surfaces = pair.surfaces;
      if (is_new || gap < surfaces.gap)
        {
          surfaces.gap   = gap;
          surfaces.place = file.points[point];
        }
      pair.points.insert(point);
      const auto &groups = groups_of_point[point];
      (is_first ? pair.first_groups : pair.second_groups)
        .insert(groups.begin(), groups.end());
      (is_first ? pair.second_groups : pair.first_groups)
        .insert(groups_of_face[face].begin(), groups_of_face[face].end());
    }



    template <int dim>
    void
    InterfaceSearch<dim>::look_around(const unsigned int point)
    {
      bool hangs = false;
      for (const std::size_t face : bins.at(file.points[point]))
        {
          const auto   vertices = faces.vertices(face);
          const double gap      = distance(face, file.points[point]);
          if (body_of_cell[faces.cell(face)] != body_of_point[point])
            {
              if (gap <= reach)
                add_near(point, face, gap);
            }
          else if (gap <= tolerance)
            hangs = hangs || std::none_of(vertices.begin(),
                                          vertices.end(),
                                          [&](const unsigned int v) {
                                            return first_at_place[v] ==
                                                   first_at_place[point];
                                          });
        }
      if (hangs && ++result.n_hanging == 1)
        result.hanging_place = file.points[point];
    }



    template <int dim>
    MeshInterfaces
    InterfaceSearch<dim>::run()
    {
      find_coincident_points();
      double sum = 0., largest = 0.;
      for (std::size_t f = 0; f < faces.size(); ++f)
        {
          const auto   v    = faces.vertices(f);
          const double size = file.points[v[0]].distance(file.points[v.back()]);
          sum += size;
          largest = std::max(largest, size);
        }
      reach = sum / std::max<std::size_t>(faces.size(), 1);
      bins  = PointBins(std::max({2. * reach, largest / 20., tolerance}));
      for (std::size_t f = 0; f < faces.size(); ++f)
        {
          Point<3> low = file.points[faces.vertices(f)[0]], high = low;
          for (const unsigned int point : faces.vertices(f))
            for (unsigned int d = 0; d < 3; ++d)
              {
                low[d]  = std::min(low[d], file.points[point][d] - reach);
                high[d] = std::max(high[d], file.points[point][d] + reach);
              }
          bins.add(low, high, f);
        }
      for (const auto &[point, body] : body_of_point)
        look_around(point);

      for (auto &[bodies, pair] : near)
        {
          pair.surfaces.first    = bodies.first;
          pair.surfaces.second   = bodies.second;
          pair.surfaces.n_points = pair.points.size();
          for (const unsigned int g : pair.first_groups)
            pair.surfaces.first_surfaces.push_back(in_words(file.groups[g]));
          for (const unsigned int g : pair.second_groups)
            pair.surfaces.second_surfaces.push_back(in_words(file.groups[g]));
          for (const unsigned int point : pair.points)
            if (first_at_place[point] != point &&
                body_of_point[first_at_place[point]] != body_of_point[point])
              pair.surfaces.has_matching_nodes = true;
          result.near_surfaces.push_back(pair.surfaces);
        }
      std::stable_sort(result.near_surfaces.begin(),
                       result.near_surfaces.end(),
                       [](const NearSurfaces &a, const NearSurfaces &b) {
                         return a.gap < b.gap;
                       });
      return result;
    }
  } // namespace



  template <int dim>
  MeshInterfaces
  find_interfaces(const MeshFile                  &file,
                  const std::vector<std::size_t>  &cells,
                  const std::vector<unsigned int> &bodies,
                  const double                     extent)
  {
    return InterfaceSearch<dim>(file, cells, bodies, extent).run();
  }



  template MeshInterfaces
  find_interfaces<2>(const MeshFile &,
                     const std::vector<std::size_t> &,
                     const std::vector<unsigned int> &,
                     const double);
  template MeshInterfaces
  find_interfaces<3>(const MeshFile &,
                     const std::vector<std::size_t> &,
                     const std::vector<unsigned int> &,
                     const double);
} // namespace stickslip
