#include <stickslip/mesh/body_mesh.h>

#include <stickslip/base/parsed_expression.h>
#include <stickslip/base/user_error.h>
#include <stickslip/mesh/bent_cells.h>
#include <stickslip/mesh/condition_list.h>
#include <stickslip/mesh/generator_arguments.h>
#include <stickslip/mesh/mesh_checks.h>
#include <stickslip/mesh/mesh_from_file.h>
#include <stickslip/mesh/quadratic_manifold.h>
#include <stickslip/mesh/simplex_cut.h>
#include <stickslip/mesh/transformed_manifold.h>

#include <deal.II/base/utilities.h>

#include <deal.II/grid/grid_tools.h>
#include <deal.II/grid/manifold_lib.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace stickslip
{
  namespace
  {
    /// The sides of all cells, of their children too, follow the curved cells.
    template <int dim>
    void
    bend_sides(BodyMesh<dim> &body)
    {
      if (!body.curved_cells)
        return;
      constexpr types::manifold_id id = 0;
      body.triangulation.set_all_manifold_ids(id);
      body.triangulation.set_manifold(
        id, QuadraticManifold<dim>(body.curved_cells));
    }



    /// Moves the vertices, and the nodes of degree 2 between them, to where the
    /// expressions say.
    template <int dim>
    void
    reshape_body(const std::string &coordinates,
                 const std::string &parameter_path,
                 const bool         has_use_for_curves,
                 BodyMesh<dim>     &body)
    {
      const std::vector<std::string> expressions =
        Utilities::split_string_list(coordinates, ';');
      if (expressions.size() != dim)
        throw UserError(parameter_path + ": '" + coordinates + "' has " +
                        std::to_string(expressions.size()) +
                        " expressions, expected " + std::to_string(dim) +
                        ", separated by ';'.");

      const auto new_coordinates =
        parse_expressions<dim>(dim == 2 ? "x,y" : "x,y,z",
                               expressions,
                               parameter_path);
      const auto move = [&](const Point<dim> &x) {
        Point<dim> moved;
        for (unsigned int d = 0; d < dim; ++d)
          {
            moved[d] = new_coordinates->value(x, d);
            if (!std::isfinite(moved[d]))
              throw UserError(parameter_path + ": '" + expressions[d] +
                              "' is not a finite number at the node " +
                              coordinates_in_message(x) + ".");
          }
        return moved;
      };
      const bool are_new = !body.curved_cells;
      if (are_new && has_use_for_curves)
        body.curved_cells = quadratic_cells_of(body.triangulation);
      // The generator's curves have no meaning on the new shape.
      body.triangulation.reset_all_manifolds();
      body.triangulation.set_all_manifold_ids(numbers::flat_manifold_id);
      GridTools::transform(move, body.triangulation);
      if (!body.curved_cells)
        return;
      body.curved_cells->transform(move);
      if (!are_new)
        {
          check_curved_cells(*body.curved_cells, parameter_path);
          return;
        }
      // Straight cells are the better ones where they are the body.
      if (has_straight_boundary(body.triangulation, *body.curved_cells))
        body.curved_cells.reset();
      else if (cells_inside_out(*body.curved_cells).n_cells > 0)
        {
          body.curved_cells.reset();
          body.warnings.push_back(
            parameter_path +
            " moves the points of a cell so differently "
            "that its curved sides would turn it inside out: all cells stay "
            "straight between their vertices. 'Refinements' makes smaller "
            "cells before they are bent.");
        }
    }



    template <int dim>
    Tensor<1, dim>
    body_vector(const std::vector<double> &numbers,
                const std::string         &parameter_path)
    {
      if (numbers.size() < dim ||
          (dim == 2 && numbers.size() > 2 && numbers[2] != 0.))
        throw UserError(parameter_path + ": expected " + std::to_string(dim) +
                        " numbers" +
                        (dim == 2 ? " (or a third that is 0)" : "") +
                        ", found " + std::to_string(numbers.size()) + ".");
      Tensor<1, dim> vector;
      for (unsigned int d = 0; d < dim; ++d)
        vector[d] = numbers[d];
      return vector;
    }



    /**
     * Copies the manifolds of the ids in use to where @p map takes the body.
     * Transfinite interpolation holds on to its own triangulation, so it ends
     * with it: its interior cells go on flat between curved boundaries.
     */
    template <int dim>
    void
    collect_manifolds(const AffineMap<dim> &map, BodyMesh<dim> &body)
    {
      for (const types::manifold_id id : body.triangulation.get_manifold_ids())
        {
          if (id == numbers::flat_manifold_id)
            continue;
          const Manifold<dim> &manifold = body.triangulation.get_manifold(id);
          // Ids from files have no manifold object: deal.II returns flat.
          if (dynamic_cast<const FlatManifold<dim> *>(&manifold) != nullptr ||
              dynamic_cast<const TransfiniteInterpolationManifold<dim> *>(
                &manifold) != nullptr)
            continue;
          body.manifolds[id] = manifold.clone();
          if (!map.is_identity())
            body.manifolds[id] =
              std::make_unique<TransformedManifold<dim>>(manifold.clone(), map);
        }
    }



    template <int dim>
    std::set<unsigned int>
    present_boundary_ids(const Triangulation<dim> &triangulation)
    {
      const auto ids = triangulation.get_boundary_ids();
      return {ids.begin(), ids.end()};
    }



    template <int dim>
    void
    mark_boundaries(const ConditionList &conditions,
                    const std::string   &parameter_path,
                    BodyMesh<dim>       &body)
    {
      conditions.check_groups(body.boundaries,
                              present_boundary_ids(body.triangulation));
      for (unsigned int i = 0; i < conditions.size(); ++i)
        {
          const types::boundary_id id =
            body.boundaries.id_of(conditions.label(i));
          bool marks_any = false;
          for (const auto &face : body.triangulation.active_face_iterators())
            if (face->at_boundary() && conditions.holds(i,
                                                        face->center(),
                                                        face->boundary_id(),
                                                        body.boundaries))
              {
                face->set_boundary_id(id);
                marks_any = true;
              }
          if (!marks_any)
            throw UserError(
              parameter_path + ": '" + conditions.label(i) + ": " +
              conditions.expression(i) +
              "' marks no face. Boundaries present: " +
              body.boundaries.in_words(
                present_boundary_ids(body.triangulation)) +
              "; conditions are tested at face centres of the moved body.");
        }
    }



    /// Decides on each cell's material name, then numbers the names in use.
    template <int dim>
    void
    mark_materials(const BodyParameters &parameters,
                   const std::string    &path,
                   const LabelledIds    &ids,
                   BodyMesh<dim>        &body)
    {
      const std::string      parameter_path = path + "/Material regions";
      const ConditionList    conditions(parameters.material_regions,
                                     parameter_path);
      std::vector<bool>      marks_any(conditions.size(), false);
      std::set<unsigned int> present;
      for (const auto &cell : body.triangulation.active_cell_iterators())
        present.insert(cell->material_id());
      conditions.check_groups(ids, present);
      for (const auto &cell : body.triangulation.active_cell_iterators())
        {
          const types::material_id old_id = cell->material_id();
          std::string              name   = parameters.material;
          for (unsigned int i = 0; i < conditions.size(); ++i)
            if (conditions.holds(i, cell->center(), old_id, ids))
              {
                name         = conditions.label(i);
                marks_any[i] = true;
              }
          if (name.empty() && !parameters.moves_as_a_whole())
            throw UserError(path + ": some cells (of group " +
                            ids.in_words({old_id}) +
                            ") are in none of the 'Material regions', and "
                            "'Material' for the rest is not given.");

          auto known =
            std::find(body.materials.begin(), body.materials.end(), name);
          if (known == body.materials.end())
            known = body.materials.insert(known, name);
          cell->set_material_id(known - body.materials.begin());
        }

      for (unsigned int i = 0; i < conditions.size(); ++i)
        if (!marks_any[i])
          throw UserError(parameter_path + ": '" + conditions.label(i) + ": " +
                          conditions.expression(i) +
                          "' holds in no cell (tested at the centres).");
    }
  } // namespace



  template <int dim>
  AffineMap<dim>
  body_motion(const BodyParameters &parameters, const std::string &path)
  {
    std::vector<double> factors = parameters.scale;
    if (factors.size() == 1)
      factors.resize(dim, factors[0]);
    else if (factors.size() != dim)
      throw UserError(path + "/Scale: expected one factor or " +
                      std::to_string(dim) + ", found " +
                      std::to_string(factors.size()) + ".");
    Tensor<1, dim> scale;
    std::copy(factors.begin(), factors.end(), scale.begin_raw());

    return AffineMap<dim>::from_motion(
      scale,
      body_vector<3>(parameters.rotation_axis, path + "/Rotation axis"),
      parameters.rotation_angle * numbers::PI / 180.,
      body_vector<dim>(parameters.rotation_centre, path + "/Rotation centre"),
      body_vector<dim>(parameters.translation, path + "/Translation"));
  }



  template <int dim>
  std::unique_ptr<BodyMesh<dim>>
  make_body_mesh(const BodyParameters &parameters,
                 const std::string    &path,
                 const MeshParameters &mesh,
                 MeshFiles            &files,
                 const MeshSize       &size)
  {
    auto                body          = std::make_unique<BodyMesh<dim>>();
    Triangulation<dim> &triangulation = body->triangulation;
    LabelledIds         materials;

    if (!parameters.generator.empty())
      {
        size.check_coarse(estimated_cells(parameters.generator,
                                          parameters.arguments,
                                          dim),
                          path + "/Arguments",
                          "'" + parameters.arguments + "' makes ");
        generate_mesh(parameters.generator,
                      parameters.arguments,
                      path,
                      triangulation);
      }
    else
      body->curved_cells = make_triangulation(
        files.read(parameters.mesh_file, parameters.mesh_format, path),
        parameters.mesh_groups,
        path + "/Mesh file: '" + parameters.mesh_file + "' ",
        path,
        triangulation,
        body->boundaries,
        materials);
    body->has_nodes_between_vertices = body->curved_cells != nullptr;
    check_cell_types(triangulation, path);

    check_cell_shapes(triangulation, path);
    if (body->curved_cells)
      check_curved_cells(*body->curved_cells, path);
    bend_sides(*body);
    size.check_coarse_refinements(triangulation.n_active_cells(),
                                  parameters.refinements,
                                  path + "/Refinements");
    if (parameters.simplices)
      size.check_coarse(n_simplices_per_cell(dim) *
                          triangulation.n_active_cells() *
                          std::pow(2., 1. * dim * parameters.refinements),
                        path + "/Simplices",
                        "true makes ");
    triangulation.refine_global(parameters.refinements);
    if (!parameters.coordinates.empty())
      {
        reshape_body(parameters.coordinates,
                     path + "/Coordinates",
                     mesh.has_use_for_curves() || parameters.simplices,
                     *body);
        check_cell_shapes(triangulation, path);
        bend_sides(*body);
      }
    if (parameters.simplices)
      {
        cut_into_simplices(path, triangulation);
        bend_sides(*body);
      }

    const AffineMap<dim> map = body_motion<dim>(parameters, path);
    collect_manifolds(map, *body);
    if (!map.is_identity())
      GridTools::transform(map, triangulation);
    check_cell_shapes(triangulation, path);
    body->warnings.push_back(warning_about_seams(triangulation, path));

    const std::string parameter_path = path + "/Boundary ids";
    mark_boundaries(ConditionList(parameters.boundary_ids, parameter_path),
                    parameter_path,
                    *body);
    mark_materials(parameters, path, materials, *body);
    return body;
  }



  template AffineMap<2>
  body_motion(const BodyParameters &, const std::string &);
  template AffineMap<3>
  body_motion(const BodyParameters &, const std::string &);
  template std::unique_ptr<BodyMesh<2>>
  make_body_mesh<2>(const BodyParameters &,
                    const std::string &,
                    const MeshParameters &,
                    MeshFiles &,
                    const MeshSize &);
  template std::unique_ptr<BodyMesh<3>>
  make_body_mesh<3>(const BodyParameters &,
                    const std::string &,
                    const MeshParameters &,
                    MeshFiles &,
                    const MeshSize &);
} // namespace stickslip
