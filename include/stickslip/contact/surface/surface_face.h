#ifndef stickslip_contact_surface_surface_face_h
#define stickslip_contact_surface_surface_face_h

#include <stickslip/base/types.h>

#include <stickslip/contact/surface/face_shape.h>
#include <stickslip/contact/surface/stencil_nodes.h>

#include <stickslip/mesh/cross_section.h>

#include <deal.II/base/bounding_box.h>
#include <deal.II/base/point.h>

#include <deal.II/dofs/dof_handler.h>

#include <deal.II/hp/mapping_collection.h>

#include <array>
#include <functional>
#include <limits>
#include <set>
#include <tuple>
#include <vector>

namespace stickslip
{
  /// Name of a face that does not depend on the partition.
  struct FaceId
  {
    std::array<unsigned int, 4> cell{};
    unsigned int                face = 0;
    unsigned int image = 0; ///< PeriodicImages; 0: the face itself

    /// The face that this one is an image of.
    FaceId
    original() const
    {
      return {cell, face, 0};
    }

    bool
    operator<(const FaceId &other) const
    {
      return std::tie(cell, face, image) <
             std::tie(other.cell, other.face, other.image);
    }

    bool
    operator==(const FaceId &other) const
    {
      return cell == other.cell && face == other.face && image == other.image;
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &cell &face &image;
    }
  };



  /**
   * One facet's part of an averaged nodal normal: the two (one) tangents of
   * that facet at the node, as linear combinations of stencil nodes.
   */
  template <int dim>
  struct NormalContribution
  {
    double                          orientation = 1.;
    std::vector<unsigned int>       nodes; ///< stencil indices
    std::vector<Tensor<1, dim - 1>> gradients;

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      archive &orientation &nodes &gradients;
    }
  };



  /**
   * A face of a contact surface with all that a rank needs to know about it,
   * whoever owns its cell. The stencil is its own nodes (first `n_nodes`,
   * lexicographic) followed by the neighbours' nodes that its averaged normals
   * depend on.
   */
  template <int dim>
  struct SurfaceFace : StencilNodes<dim>
  {
    FaceId                  id;
    unsigned int            owner   = 0; ///< rank of its cell
    unsigned int            n_nodes = 0;
    std::vector<Point<dim>> reference_positions; ///< of the stencil
    double                  orientation =
      1.; ///< makes orientation * a_1 x a_2 point into the body
    double compliance = 0.; ///< cell height / longitudinal modulus; 0 if rigid
    double diameter   = 0.; ///< of the reference face
    /// How far the undeformed body reaches behind the middle of the face, along
    /// the normal [length] (pairing/local_thickness.h).
    double thickness = std::numeric_limits<double>::infinity();
    std::vector<std::vector<NormalContribution<dim>>>
      nodal_normals; ///< empty: facet normals
    /// How far the smooth surface behind a straight facet is outside of it
    /// where nothing is deformed [length]: over the middles of its edges (of a
    /// quadrilateral edge 2 d + s at xi_d = s, of a triangle edge e from node e
    /// on, one of a line). Empty: it is not. A slave that only touches may have
    /// its master's (pairing/pair_faces.h).
    std::vector<double> rise;

    unsigned int
    n_stencil_nodes() const
    {
      return reference_positions.size();
    }

    /// The undeformed places of the face's own nodes.
    std::vector<Tensor<1, dim>>
    undeformed_nodes() const
    {
      return {reference_positions.begin(),
              reference_positions.begin() + n_nodes};
    }

    template <class Archive>
    void
    serialize(Archive &archive, const unsigned int)
    {
      StencilNodes<dim>::serialize(archive, 0);
      archive &id &owner &n_nodes &reference_positions &orientation &compliance
        &diameter &thickness &nodal_normals &rise;
    }
  };



  /// What a face of a surface that meets itself is at present.
  enum class Side
  {
    neither, ///< nothing within reach; what comes there takes it as a master
    slave,
    master
  };



  /// A slave face: its displacements and its multipliers.
  template <int dim>
  struct SlaveFace
  {
    SurfaceFace<dim> face;
    std::vector<types::global_dof_index>
         multiplier_dofs;    ///< [node * n_comp + c]
    Side side = Side::slave; ///< neither or master: of a surface that meets
                             ///< itself, without contact points at present
  };



  /// Vector orthogonal to the surface tangents @p a (their cross product).
  template <int dim>
  Tensor<1, dim>
  surface_normal(const std::array<Tensor<1, dim>, dim - 1> &a)
  {
    if constexpr (dim == 2)
      return Tensor<1, dim>({-a[0][1], a[0][0]});
    else
      return cross_product_3d(a[0], a[1]);
  }



  /// Derivative of surface_normal() when a_alpha changes by gradient[alpha] dx:
  /// column c is that for dx along axis c.
  template <int dim>
  Tensor<2, dim>
  surface_normal_derivative(const std::array<Tensor<1, dim>, dim - 1> &a,
                            const Tensor<1, dim - 1>                  &gradient)
  {
    Tensor<2, dim> D;
    for (unsigned int c = 0; c < dim; ++c)
      {
        Tensor<1, dim> e;
        e[c] = 1.;
        Tensor<1, dim> column;
        if constexpr (dim == 2)
          column = surface_normal<dim>({{gradient[0] * e}});
        else
          column = cross_product_3d(gradient[0] * e, a[1]) +
                   cross_product_3d(a[0], gradient[1] * e);
        for (unsigned int i = 0; i < dim; ++i)
          D[i][c] = column[i];
      }
    return D;
  }



  /// Tangents a_alpha of a face at a point, from the gradients of its shape
  /// functions there and the positions of its nodes.
  template <int dim>
  std::array<Tensor<1, dim>, dim - 1>
  surface_tangents(const std::vector<Tensor<1, dim - 1>> &gradient,
                   const std::vector<Tensor<1, dim>>     &node_positions)
  {
    std::array<Tensor<1, dim>, dim - 1> a;
    for (unsigned int j = 0; j < node_positions.size(); ++j)
      for (unsigned int d = 0; d < dim - 1; ++d)
        a[d] += gradient[j][d] * node_positions[j];
    return a;
  }



  /// A face together with where its cell is.
  template <int dim>
  struct CollectedFace
  {
    SurfaceFace<dim>                               face;
    typename DoFHandler<dim>::active_cell_iterator cell;
    unsigned int                                   face_no;

    /// Of a cell of this rank, and no image.
    bool
    is_owned() const
    {
      return face.id.image == 0 && cell->is_locally_owned();
    }
  };



  /// Numbers of the shape functions of the scalar element @p fe with a node on
  /// face @p f of a cell, in the order of @p shape.
  template <int dim>
  std::vector<unsigned int>
  nodes_of_face(const FiniteElement<dim> &fe,
                const unsigned int        f,
                const FaceShape<dim>     &shape);

  /**
   * Faces with the given boundary ids on locally owned cells and, if
   * @p with_ghosts, on ghost cells; sorted by FaceId, the nodal normals empty.
   * @p compliance_modulus gives the longitudinal modulus of a cell, or
   * infinity for a rigid one. Not collective.
   */
  template <int dim>
  std::vector<CollectedFace<dim>>
  collect_faces(const hp::MappingCollection<dim>   &mapping,
                const DoFHandler<dim>              &dof_handler,
                const std::set<types::boundary_id> &boundary_ids,
                const std::function<double(const types::material_id)> &modulus,
                const bool with_ghosts);

  /// Smallest @p modulus of the cells behind @p faces; infinity: all rigid.
  template <int dim>
  double
  softest_modulus_of(
    const std::vector<CollectedFace<dim>>                 &faces,
    const std::function<double(const types::material_id)> &modulus);

  /// Removes faces on the axis of bodies of revolution, which has no area.
  template <int dim>
  void
  drop_faces_on_axis(const CrossSection              &cross_section,
                     std::vector<CollectedFace<dim>> &faces);

  /**
   * Fills the nodal normals of the faces on locally owned cells from all given
   * faces (which must contain the ghost ones), averaging only facets whose
   * reference normals at the node differ by less than @p angle [radian], and
   * drops the faces on ghost cells.
   */
  template <int dim>
  void
  add_nodal_normals(std::vector<CollectedFace<dim>> &faces,
                    const FaceShape<dim>            &shape,
                    const double                     angle);



  /// Outward normal of a face with the tangents @p a, not of unit length.
  template <int dim>
  Tensor<1, dim>
  outward_normal(const SurfaceFace<dim>                    &face,
                 const std::array<Tensor<1, dim>, dim - 1> &a)
  {
    return -face.orientation * surface_normal<dim>(a);
  }



  /// Derivative of v / |v| for a change of v.
  template <int dim>
  Tensor<2, dim>
  unit_vector_derivative(const Tensor<1, dim> &v)
  {
    return (Tensor<2, dim>(unit_symmetric_tensor<dim>()) -
            outer_product(v, v) / v.norm_square()) /
           v.norm();
  }



  /// Weights of the nodes of a face with which they sum up to the tangent
  /// @p e at a place with the tangents @p A and gradients of shape functions:
  /// the material direction that e is now.
  std::vector<double>
  direction_weights(const std::vector<Tensor<1, 2>>   &gradient,
                    const std::array<Tensor<1, 3>, 2> &A,
                    const Tensor<1, 3>                &e);



  /// Derivative of the outward unit normal at the place of @p values, per node.
  template <int dim>
  std::vector<Tensor<2, dim>>
  outward_normal_derivative(const SurfaceFace<dim>            &face,
                            const std::vector<Tensor<1, dim>> &positions,
                            const FaceShapeValues<dim>        &values)
  {
    const auto           a = surface_tangents<dim>(values.gradient, positions);
    const Tensor<2, dim> D_unit =
      -face.orientation * unit_vector_derivative(outward_normal(face, a));
    std::vector<Tensor<2, dim>> derivative;
    for (const auto &gradient : values.gradient)
      derivative.push_back(D_unit *
                           surface_normal_derivative<dim>(a, gradient));
    return derivative;
  }
} // namespace stickslip

#endif
