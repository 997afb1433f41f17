#include <stickslip/problem/body_surfaces.h>

#include <deal.II/base/mpi.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

namespace stickslip
{
  namespace
  {
    /// A surface is flat if its mean normal is this long.
    constexpr double length_of_flat = 0.9999;

    /// Area times outward normal of a face with straight edges.
    template <int dim, typename Face>
    Tensor<1, dim>
    area_normal_of(const Face &face, const Point<dim> &inside)
    {
      Tensor<1, dim> normal;
      if constexpr (dim == 2)
        normal = cross_product_2d(face->vertex(1) - face->vertex(0));
      else if (face->n_vertices() == 3)
        normal = 0.5 * cross_product_3d(face->vertex(1) - face->vertex(0),
                                        face->vertex(2) - face->vertex(0));
      else
        normal = 0.5 * cross_product_3d(face->vertex(3) - face->vertex(0),
                                        face->vertex(2) - face->vertex(1));
      return normal * (face->vertex(0) - inside) < 0. ? -1. * normal : normal;
    }



    /// That of a boundary id: they are consecutive.
    template <int dim>
    BodySurface<dim> &
    surface_of(std::vector<BodySurface<dim>> &surfaces,
               const types::boundary_id       id)
    {
      const unsigned int i = id - surfaces.front().id;
      AssertIndexRange(i, surfaces.size());
      return surfaces[i];
    }



    /// Of the faces of this rank.
    template <int dim>
    void
    look_at_faces(
      const Mesh<dim>                                           &mesh,
      const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws,
      std::vector<BodySurface<dim>>                             &surfaces)
    {
      for (const auto &cell : mesh.triangulation->active_cell_iterators())
        if (cell->is_locally_owned())
          for (const auto &face : cell->face_iterators())
            {
              if (!face->at_boundary())
                continue;
              BodySurface<dim> &surface =
                surface_of(surfaces, face->boundary_id());
              const Tensor<1, dim> normal =
                area_normal_of<dim>(face, cell->center());
              surface.n_faces += 1.;
              surface.area += normal.norm();
              surface.area_normal += normal;
              surface.sum_of_face_sizes +=
                std::pow(normal.norm(), 1. / (dim - 1));
              const auto &law = laws[cell->material_id()];
              if (law)
                surface.modulus =
                  std::min(surface.modulus, law->longitudinal_modulus());
              for (unsigned int v = 0; v < face->n_vertices(); ++v)
                for (unsigned int c = 0; c < dim; ++c)
                  {
                    surface.low[c] =
                      std::min(surface.low[c], face->vertex(v)[c]);
                    surface.high[c] =
                      std::max(surface.high[c], face->vertex(v)[c]);
                  }
            }
    }



    /// Three reductions, however many surfaces there are.
    template <int dim>
    void
    take_over_ranks(std::vector<BodySurface<dim>> &surfaces,
                    const MPI_Comm                &communicator)
    {
      std::vector<double *> sums, minima, maxima;
      for (auto &surface : surfaces)
        {
          sums.insert(sums.end(),
                      {&surface.n_faces,
                       &surface.area,
                       &surface.sum_of_face_sizes});
          minima.push_back(&surface.modulus);
          for (unsigned int c = 0; c < dim; ++c)
            {
              sums.push_back(&surface.area_normal[c]);
              minima.push_back(&surface.low[c]);
              maxima.push_back(&surface.high[c]);
            }
        }
      const auto reduce = [](const std::vector<double *> &entries,
                             const auto                  &reduction) {
        std::vector<double> values;
        for (const double *entry : entries)
          values.push_back(*entry);
        reduction(values);
        for (unsigned int i = 0; i < entries.size(); ++i)
          *entries[i] = values[i];
      };
      reduce(sums, [&](auto &v) { Utilities::MPI::sum(v, communicator, v); });
      reduce(minima, [&](auto &v) { Utilities::MPI::min(v, communicator, v); });
      reduce(maxima, [&](auto &v) { Utilities::MPI::max(v, communicator, v); });
    }



    /// True if all displacements are prescribed, everywhere on the boundary and
    /// all the time.
    bool
    prescribes_all(const BoundaryConditionParameters &condition)
    {
      if (!condition.where.empty() || !condition.active_from.empty() ||
          !condition.active_until.empty())
        return false;
      return condition.type == BoundaryConditionType::rigid_motion ||
             (condition.type == BoundaryConditionType::displacement &&
              condition.value.find("free") == std::string::npos);
    }



    template <int dim>
    void
    look_at_conditions(const Bodies                                 &bodies,
                       const NamedList<BoundaryConditionParameters> &conditions,
                       std::vector<BodySurface<dim>>                &surfaces)
    {
      for (auto &surface : surfaces)
        {
          surface.is_prescribed = bodies.bodies[surface.body].is_rigid;
          // the axis is no surface
          if (bodies.cross_section.is_on_axis(surface.high))
            surface.is_free = false;
        }
      for (const auto &[name, condition] : conditions)
        {
          const std::string  path = "Boundary conditions/" + name;
          const unsigned int body =
            bodies.index_of(condition.body, path + "/Body");
          const bool is_cut =
            condition.type == BoundaryConditionType::symmetry ||
            condition.type == BoundaryConditionType::periodic ||
            condition.type == BoundaryConditionType::cyclic_symmetry ||
            condition.type == BoundaryConditionType::pretension;
          const bool is_prescribed = prescribes_all(condition);
          if (!is_cut && !is_prescribed)
            continue;
          std::set<types::boundary_id> ids = bodies.all_boundary_ids(body);
          if (!condition.boundary.empty())
            ids = bodies.global_boundary_ids(condition.body,
                                             condition.boundary,
                                             path + "/Boundary");
          if (!condition.second_boundary.empty())
            ids.merge(bodies.global_boundary_ids(condition.second_body.empty()
                                                   ? condition.body
                                                   : condition.second_body,
                                                 condition.second_boundary,
                                                 path + "/Second boundary"));
          for (const auto id : ids)
            if (is_cut)
              surface_of(surfaces, id).is_free = false;
            else
              surface_of(surfaces, id).is_prescribed = true;
        }
    }
  } // namespace



  template <int dim>
  bool
  BodySurface<dim>::is_flat() const
  {
    return area_normal.norm() > length_of_flat * area;
  }



  template <int dim>
  double
  BodySurface<dim>::distance(const BodySurface &other) const
  {
    Tensor<1, dim> way;
    for (unsigned int c = 0; c < dim; ++c)
      way[c] = std::max({0., low[c] - other.high[c], other.low[c] - high[c]});
    return way.norm();
  }



  template <int dim>
  std::vector<BodySurface<dim>>
  body_surfaces(const Mesh<dim>                              &mesh,
                const NamedList<BoundaryConditionParameters> &conditions,
                const std::vector<std::shared_ptr<const ConstitutiveLaw>> &laws)
  {
    std::vector<BodySurface<dim>> surfaces;
    for (unsigned int b = 0; b < mesh.bodies.n_bodies(); ++b)
      for (const auto id : mesh.bodies.all_boundary_ids(b))
        {
          surfaces.emplace_back();
          BodySurface<dim> &surface = surfaces.back();
          surface.id                = id;
          AssertDimension(id - surfaces.front().id, surfaces.size() - 1);
          surface.body    = b;
          surface.modulus = std::numeric_limits<double>::infinity();
          for (unsigned int c = 0; c < dim; ++c)
            {
              surface.low[c]  = std::numeric_limits<double>::max();
              surface.high[c] = std::numeric_limits<double>::lowest();
            }
        }
    look_at_faces(mesh, laws, surfaces);
    take_over_ranks(surfaces, mesh.triangulation->get_communicator());
    look_at_conditions(mesh.bodies, conditions, surfaces);
    return surfaces;
  }

#define INSTANTIATE(dim)                                \
  template struct BodySurface<dim>;                     \
  template std::vector<BodySurface<dim>> body_surfaces( \
    const Mesh<dim> &,                                  \
    const NamedList<BoundaryConditionParameters> &,     \
    const std::vector<std::shared_ptr<const ConstitutiveLaw>> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
