#include <stickslip/contact/surface/surface_face.h>

#include <stickslip/mesh/by_kind.h>
#include <stickslip/mesh/reference_cells.h>

#include <deal.II/fe/fe_values.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <utility>

namespace stickslip
{
  namespace
  {
    /// The same on a face of a simplex, in the order of @p shape.
    template <int dim>
    std::vector<unsigned int>
    simplex_face_nodes(const std::vector<Point<dim>> &unit_points,
                       const unsigned int             f,
                       const FaceShape<dim>          &shape)
    {
      const ReferenceCell cell           = ReferenceCells::get_simplex<dim>();
      const auto          vertex_of_face = [&](const unsigned int v) {
        return cell.template vertex<dim>(cell.face_to_cell_vertices(f, v, 1));
      };
      const Point<dim>          origin = vertex_of_face(0);
      std::vector<unsigned int> nodes;
      for (unsigned int j = 0; j < shape.n_nodes(); ++j)
        {
          Point<dim> place = origin;
          for (unsigned int d = 0; d < dim - 1; ++d)
            place += shape.node(j)[d] * (vertex_of_face(d + 1) - origin);
          const auto nearest =
            std::min_element(unit_points.begin(),
                             unit_points.end(),
                             [&](const Point<dim> &a, const Point<dim> &b) {
                               return a.distance(place) < b.distance(place);
                             });
          nodes.push_back(nearest - unit_points.begin());
        }
      return nodes;
    }



    /// Cell-local scalar support points on face @p f, lexicographic on the face.
    template <int dim>
    std::vector<unsigned int>
    lexicographic_face_nodes(const std::vector<Point<dim>> &unit_points,
                             const unsigned int             f)
    {
      const unsigned int        normal_direction = f / 2;
      std::vector<unsigned int> nodes;
      for (unsigned int i = 0; i < unit_points.size(); ++i)
        if (std::abs(unit_points[i][normal_direction] - (f % 2)) < 1e-12)
          nodes.push_back(i);
      std::sort(nodes.begin(),
                nodes.end(),
                [&](const unsigned int i, const unsigned int j) {
                  for (int d = dim - 1; d >= 0; --d)
                    if (std::abs(unit_points[i][d] - unit_points[j][d]) > 1e-12)
                      return unit_points[i][d] < unit_points[j][d];
                  return false;
                });
      return nodes;
    }



    /// -1 if the normal that surface_normal() makes of the tangents of face @p f
    /// points out of the cell, else 1: the same for all cells, whose Jacobian
    /// determinants are positive. So the unit cell tells. (The vertices of a
    /// curved cell do not: their centre may lie beyond the middle of a face.)
    template <int dim>
    double
    orientation_of_face(const FiniteElement<dim> &fe,
                        const unsigned int        f,
                        const FaceShape<dim>     &shape)
    {
      const FaceShapeValues<dim> &centre = shape.at_centre();
      std::vector<Tensor<1, dim>> nodes;
      for (const unsigned int i : nodes_of_face(fe, f, shape))
        nodes.emplace_back(fe.unit_support_point(i));
      const Tensor<1, dim> outward =
        interpolate<dim>(centre.value, nodes) -
        fe.reference_cell().template barycenter<dim>();
      const Tensor<1, dim> normal =
        surface_normal<dim>(surface_tangents<dim>(centre.gradient, nodes));
      return normal * outward > 0. ? -1. : 1.;
    }



    template <int dim>
    std::array<Tensor<1, dim>, dim - 1>
    reference_tangents(const SurfaceFace<dim>                &face,
                       const std::vector<Tensor<1, dim - 1>> &gradients)
    {
      std::array<Tensor<1, dim>, dim - 1> a;
      for (unsigned int j = 0; j < face.n_nodes; ++j)
        for (unsigned int d = 0; d < dim - 1; ++d)
          a[d] += gradients[j][d] * Tensor<1, dim>(face.reference_positions[j]);
      return a;
    }



    template <int dim>
    double
    face_area(const SurfaceFace<dim> &face, const FaceShape<dim> &shape)
    {
      const Quadrature<dim - 1> quadrature =
        gauss_quadrature<dim - 1>(shape.reference_cell(), shape.degree() + 1);
      FaceShapeValues<dim> values;
      double               area = 0.;
      for (unsigned int q = 0; q < quadrature.size(); ++q)
        {
          shape.evaluate(quadrature.point(q), values);
          area += quadrature.weight(q) *
                  surface_normal<dim>(reference_tangents(face, values.gradient))
                    .norm();
        }
      return area;
    }



    /// What is the same for the faces of all cells of one kind.
    template <int dim>
    struct FacesOfCell
    {
      FacesOfCell(const Mapping<dim> &mapping, const FiniteElement<dim> &fe)
        : shape(fe.degree, faces_of<dim>(fe.reference_cell()))
        , fe_values(mapping,
                    fe,
                    Quadrature<dim>(
                      fe.base_element(0).get_unit_support_points()),
                    update_quadrature_points)
        , height_factor(fe.reference_cell().is_simplex() ? dim : 1.)
      {
        for (const unsigned int f : fe.reference_cell().face_indices())
          orientations.push_back(
            orientation_of_face(fe.base_element(0), f, shape));
      }

      FaceShape<dim>      shape;
      FEValues<dim>       fe_values; ///< at the nodes
      std::vector<double> orientations;
      /// A simplex is higher than its volume over the area of its face.
      double height_factor;
    };
  } // namespace



  std::vector<double>
  direction_weights(const std::vector<Tensor<1, 2>>   &gradient,
                    const std::array<Tensor<1, 3>, 2> &A,
                    const Tensor<1, 3>                &e)
  {
    // e = c^alpha A_alpha, so d/de = c^alpha d/dxi_alpha
    Tensor<2, 2> metric;
    for (unsigned int d = 0; d < 2; ++d)
      for (unsigned int b = 0; b < 2; ++b)
        metric[d][b] = A[d] * A[b];
    const Tensor<1, 2>  c = invert(metric) * Tensor<1, 2>({A[0] * e, A[1] * e});
    std::vector<double> weights;
    for (const Tensor<1, 2> &of_node : gradient)
      weights.push_back(c * of_node);
    return weights;
  }



  template <int dim>
  std::vector<unsigned int>
  nodes_of_face(const FiniteElement<dim> &fe,
                const unsigned int        f,
                const FaceShape<dim>     &shape)
  {
    const std::vector<Point<dim>> &nodes = fe.get_unit_support_points();
    return fe.reference_cell().is_simplex()
             ? simplex_face_nodes(nodes, f, shape)
             : lexicographic_face_nodes(nodes, f);
  }



  template <int dim>
  std::vector<CollectedFace<dim>>
  collect_faces(const hp::MappingCollection<dim>   &mapping,
                const DoFHandler<dim>              &dof_handler,
                const std::set<types::boundary_id> &boundary_ids,
                const std::function<double(const types::material_id)> &modulus,
                const bool with_ghosts)
  {
    const ByKind<FacesOfCell<dim>> faces_of_cells(
      dof_handler.get_fe_collection(),
      [&](const FiniteElement<dim> &fe, const unsigned int kind) {
        return std::make_unique<FacesOfCell<dim>>(mapping[kind], fe);
      });
    std::vector<types::global_dof_index> cell_dofs;
    std::vector<CollectedFace<dim>>      result;
    for (const auto &cell : dof_handler.active_cell_iterators())
      {
        if (!(cell->is_locally_owned() || (with_ghosts && cell->is_ghost())))
          continue;
        for (const unsigned int f : cell->face_indices())
          {
            if (!cell->at_boundary(f) ||
                boundary_ids.count(cell->face(f)->boundary_id()) == 0)
              continue;
            const FiniteElement<dim> &fe = cell->get_fe();
            FacesOfCell<dim>         &of = faces_of_cells[cell];
            of.fe_values.reinit(
              typename Triangulation<dim>::active_cell_iterator(cell));
            cell_dofs.resize(fe.n_dofs_per_cell());
            cell->get_dof_indices(cell_dofs);

            SurfaceFace<dim> face;
            face.id.cell = cell->id().template to_binary<dim>();
            face.id.face = f;
            face.owner   = cell->subdomain_id();
            for (const unsigned int i :
                 nodes_of_face(fe.base_element(0), f, of.shape))
              {
                face.reference_positions.push_back(
                  of.fe_values.quadrature_point(i));
                for (unsigned int c = 0; c < dim; ++c)
                  face.dofs.push_back(
                    cell_dofs[fe.component_to_system_index(c, i)]);
              }
            face.n_nodes  = face.reference_positions.size();
            face.diameter = cell->face(f)->diameter();

            face.orientation       = of.orientations[f];
            const double stiffness = modulus(cell->material_id());
            face.compliance        = std::isinf(stiffness)
                                       ? 0.
                                       : of.height_factor * cell->measure() /
                                    face_area(face, of.shape) / stiffness;
            result.push_back({face, cell, f});
          }
      }
    std::sort(result.begin(), result.end(), [](const auto &a, const auto &b) {
      return a.face.id < b.face.id;
    });
    return result;
  }



  template <int dim>
  double
  softest_modulus_of(
    const std::vector<CollectedFace<dim>>                 &faces,
    const std::function<double(const types::material_id)> &modulus)
  {
    double smallest = std::numeric_limits<double>::infinity();
    for (const auto &face : faces)
      smallest = std::min(smallest, modulus(face.cell->material_id()));
    return smallest;
  }



  template <int dim>
  void
  drop_faces_on_axis(const CrossSection              &cross_section,
                     std::vector<CollectedFace<dim>> &faces)
  {
    const auto is_on_axis = [&](const CollectedFace<dim> &collected) {
      const auto nodes = collected.face.undeformed_nodes();
      return std::all_of(nodes.begin(), nodes.end(), [&](const auto &X) {
        return cross_section.is_on_axis(X);
      });
    };
    faces.erase(std::remove_if(faces.begin(), faces.end(), is_on_axis),
                faces.end());
  }



  template <int dim>
  void
  add_nodal_normals(std::vector<CollectedFace<dim>> &faces,
                    const FaceShape<dim>            &shape,
                    const double                     angle)
  {
    const unsigned int                n_nodes = shape.n_nodes();
    std::vector<FaceShapeValues<dim>> at_node(n_nodes);
    for (unsigned int j = 0; j < n_nodes; ++j)
      shape.evaluate(shape.node(j), at_node[j]);

    // who meets at a node
    std::map<NodeName, std::vector<std::pair<unsigned int, unsigned int>>>
      faces_at_node;
    for (unsigned int f = 0; f < faces.size(); ++f)
      for (unsigned int j = 0; j < n_nodes; ++j)
        faces_at_node[faces[f].face.name(j)].emplace_back(f, j);

    const auto normal_at = [&](const unsigned int f, const unsigned int j) {
      const Tensor<1, dim> v =
        faces[f].face.orientation *
        surface_normal<dim>(
          reference_tangents(faces[f].face, at_node[j].gradient));
      return v / v.norm();
    };

    std::vector<SurfaceFace<dim>> extended;
    for (unsigned int f = 0; f < faces.size(); ++f)
      {
        SurfaceFace<dim> face = faces[f].face;
        if (faces[f].is_owned())
          {
            std::map<NodeName, unsigned int> stencil;
            for (unsigned int j = 0; j < n_nodes; ++j)
              stencil[face.name(j)] = j;
            face.nodal_normals.resize(n_nodes);
            for (unsigned int j = 0; j < n_nodes; ++j)
              for (const auto &[g, k] : faces_at_node[faces[f].face.name(j)])
                {
                  if (normal_at(f, j) * normal_at(g, k) < std::cos(angle))
                    continue;
                  const SurfaceFace<dim> &neighbour = faces[g].face;
                  NormalContribution<dim> contribution;
                  contribution.orientation = neighbour.orientation;
                  for (unsigned int l = 0; l < n_nodes; ++l)
                    {
                      const Tensor<1, dim - 1> &gradient =
                        at_node[k].gradient[l];
                      if (gradient.norm() < 1e-14)
                        continue;
                      const auto [entry, is_new] =
                        stencil.emplace(neighbour.name(l),
                                        face.n_stencil_nodes());
                      if (is_new)
                        {
                          face.append(neighbour, l);
                          face.reference_positions.push_back(
                            neighbour.reference_positions[l]);
                        }
                      contribution.nodes.push_back(entry->second);
                      contribution.gradients.push_back(gradient);
                    }
                  face.nodal_normals[j].push_back(contribution);
                }
          }
        extended.push_back(face);
      }
    std::vector<CollectedFace<dim>> owned;
    for (unsigned int f = 0; f < faces.size(); ++f)
      if (faces[f].is_owned())
        owned.push_back({extended[f], faces[f].cell, faces[f].face_no});
    faces = owned;
  }

#define INSTANTIATE(dim)                                                       \
  template std::vector<unsigned int> nodes_of_face(const FiniteElement<dim> &, \
                                                   const unsigned int,         \
                                                   const FaceShape<dim> &);    \
  template std::vector<CollectedFace<dim>> collect_faces(                      \
    const hp::MappingCollection<dim> &,                                        \
    const DoFHandler<dim> &,                                                   \
    const std::set<types::boundary_id> &,                                      \
    const std::function<double(const types::material_id)> &,                   \
    const bool);                                                               \
  template double softest_modulus_of(                                          \
    const std::vector<CollectedFace<dim>> &,                                   \
    const std::function<double(const types::material_id)> &);                  \
  template void drop_faces_on_axis(const CrossSection &,                       \
                                   std::vector<CollectedFace<dim>> &);         \
  template void add_nodal_normals(std::vector<CollectedFace<dim>> &,           \
                                  const FaceShape<dim> &,                      \
                                  const double);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
