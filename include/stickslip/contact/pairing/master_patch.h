#ifndef stickslip_contact_pairing_master_patch_h
#define stickslip_contact_pairing_master_patch_h

#include <stickslip/contact/point/pairing_hysteresis.h>
#include <stickslip/contact/surface/normal_projection.h>
#include <stickslip/contact/surface/periodic_images.h>
#include <stickslip/contact/surface/rigid_tool.h>

#include <deal.II/base/bounding_box.h>

#include <deal.II/numerics/rtree.h>

#include <map>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

namespace stickslip
{
  /// Current positions of the first @p n stencil nodes of a face.
  template <int dim>
  void
  read_positions(const SurfaceFace<dim>      &face,
                 const unsigned int           n,
                 const LA::Vector            &u,
                 std::vector<Tensor<1, dim>> &positions);

  /// As in ContactPairParameters; the overlaps and the projection tolerance are
  /// fractions of the face size.
  struct PairingTolerances
  {
    double search_distance; ///< [length]
    double projection_tolerance;
    double facet_overlap;
    double end_overlap;
    /// A master face faces a slave face if the cosine of the angle between the
    /// slave's outward normal and the normal into the master is larger.
    double least_cosine  = 0.1;
    bool   is_own_master = false; ///< one surface that meets itself
  };



  /// The images of a master surface that count as parts of it, without itself.
  template <int dim>
  struct MasterImages
  {
    std::shared_ptr<const PeriodicImages<dim>> all;
    std::vector<unsigned int>                  numbers;
  };



  /**
   * The master faces that the slave points of this rank may meet, copied from
   * the ranks that own them: a rank holds no more of the master surface than
   * what lies around its slave points.
   *
   * A rigid tool is one face without edges, whose nodes are those of its frame:
   * all ranks with slave points have it.
   */
  template <int dim>
  class MasterPatch
  {
  public:
    /// @p owned are the master faces of this rank's cells; where the master is
    /// a rigid @p tool, the one that stands for it.
    MasterPatch(std::vector<SurfaceFace<dim>>         owned,
                const FaceShape<dim>                 &shape,
                const PairingTolerances              &tolerances,
                const MPI_Comm                       &communicator,
                std::shared_ptr<const RigidTool<dim>> tool   = {},
                MasterImages<dim>                     images = {});

    /**
     * Collects the faces within search distance plus @p margin of the
     * @p slave_boxes of every rank; what a rank holds is not sent again. True
     * on all ranks if the patch of any of them changed. Collective.
     */
    bool
    fetch(const std::vector<BoundingBox<dim>> &slave_boxes,
          const LA::Vector                    &u,
          const double                         margin);

    /// Displacement dofs of the patch, to be added to the ghost entries of u.
    std::vector<types::global_dof_index>
    dofs() const;

    /// New configuration from ghosted displacements now and at step start.
    void
    update(const LA::Vector &u, const LA::Vector &u_old);

    /// Sets the number of the face of a pairing made before fetch().
    void
    relocate(Pairing<dim> &pairing) const;

    /// False if the face of a pairing that was relocated is not in the patch.
    bool
    contains(const Pairing<dim> &pairing) const
    {
      return pairing.face < faces.size();
    }

    /// Numbers of the faces whose boxes lie within the search distance of the
    /// box around @p positions, sorted.
    std::vector<unsigned int>
    faces_near(const std::vector<Tensor<1, dim>> &positions) const;

    /// Numbers of the faces whose boxes meet @p box, sorted.
    std::vector<unsigned int>
    faces_in(const BoundingBox<dim> &box) const;

    /// The faces within the search distance of a point by distance of their
    /// boxes [length]: those with the nearest boxes, @p at_most, or ...
    std::vector<std::pair<double, unsigned int>>
    nearest_boxes(const Tensor<1, dim> &x_s, const unsigned int at_most) const;

    /// ... all of them.
    std::vector<std::pair<double, unsigned int>>
    all_boxes(const Tensor<1, dim> &x_s) const;

    /// True if the master has moved so far in this step that, with the motion
    /// @p of_slave [length], a point may have passed through a whole body.
    bool
    may_pass_through(const double of_slave) const
    {
      return largest_motion + of_slave > thickness_of_thinnest;
    }

    unsigned int
    n_faces() const
    {
      return faces.size();
    }

    /// Index of a face of the patch by its name; the number of faces if it is
    /// not there.
    unsigned int
    index_of(const FaceId &id) const;

    const SurfaceFace<dim> &
    face(const unsigned int f) const
    {
      return faces[f];
    }

    /// What brings the master to the image of it that a face is on; nothing if
    /// that is the master itself.
    std::optional<PeriodicMotion>
    motion_to(const unsigned int f) const
    {
      const unsigned int image = faces[f].id.image;
      if (image == 0)
        return {};
      return images.all->motion(image);
    }

    const MasterConfiguration<dim> &
    configuration(const unsigned int f) const
    {
      return current[f];
    }

    const MasterConfiguration<dim> &
    old_configuration(const unsigned int f) const
    {
      return old[f];
    }

    /// Of faces; a rigid tool has none.
    const FaceShape<dim> &
    face_shape() const
    {
      return shape;
    }

    /// The rigid tool that is the master; nullptr: the master is meshed.
    const RigidTool<dim> *
    tool() const
    {
      return rigid_tool.get();
    }

    /// Number of nodes that a master point moves with.
    unsigned int
    n_face_nodes() const
    {
      return rigid_tool ? ToolFrame<dim>::n_nodes : shape.n_nodes();
    }

    /// Their shape functions at a place on a face.
    void
    evaluate_values(const unsigned int    chart,
                    const Point<dim - 1> &xi,
                    std::vector<double>  &N) const;

    /// The master point of a pairing, in one of the configurations of its face.
    void
    evaluate(const Pairing<dim>             &pairing,
             const MasterConfiguration<dim> &configuration,
             MasterPoint<dim>               &point) const;

    const std::vector<SurfaceFace<dim>> &
    owned_faces() const
    {
      return owned;
    }

    const PairingTolerances tolerances;

  private:
    using Box = std::pair<BoundingBox<dim>, unsigned int>;

    /// Of a rank's patch, among the faces of one owner.
    struct Changes
    {
      std::vector<SurfaceFace<dim>> added;
      std::vector<FaceId>           removed;

      template <class Archive>
      void
      serialize(Archive &archive, const unsigned int)
      {
        archive &added &removed;
      }
    };

    std::vector<SurfaceFace<dim>> owned;
    const MasterImages<dim>       images;
    /// An owned face, and which image of it.
    using OwnedImage = std::pair<unsigned int, unsigned int>;
    /// What a rank holds, sorted.
    std::map<unsigned int, std::vector<OwnedImage>> held_by;
    std::vector<SurfaceFace<dim>>                   faces;
    std::vector<MasterConfiguration<dim>>           current;
    std::vector<MasterConfiguration<dim>>           old;
    RTree<Box>                                      tree;
    const FaceShape<dim>                            shape;
    MPI_Comm                                        communicator;
    std::shared_ptr<const RigidTool<dim>>           rigid_tool;
    double thickness_of_thinnest = 0.; ///< of the faces [length]
    double largest_motion        = 0.; ///< of a node in this step [length]

    RTree<Box>
    tree_of_owned_faces(const LA::Vector &u) const;

    std::vector<OwnedImage>
    owned_images_in(const std::vector<BoundingBox<dim>> &boxes,
                    const RTree<Box>                    &tree_of_owned) const;

    void
    apply(const Changes &changes);

    template <typename Hits>
    std::vector<std::pair<double, unsigned int>>
    boxes_within_reach(const Point<dim> &x, const Hits &hits) const;
  };
} // namespace stickslip

#endif
