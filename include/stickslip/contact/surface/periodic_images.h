#ifndef stickslip_contact_surface_periodic_images_h
#define stickslip_contact_surface_periodic_images_h

#include <stickslip/base/types.h>

#include <stickslip/contact/surface/surface_face.h>

#include <stickslip/mesh/periodic_nodes.h>

#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  /**
   * The motions of the whole space that bring a model with periodic boundaries
   * onto itself, and the nodes that are images of others.
   *
   * The motions of the boundaries, where they differ, generate them all: up to
   * five periods to each side of a shift, all sectors of a rotation. Image 0 is
   * what the mesh has. Without periodic boundaries there is no other.
   */
  template <int dim>
  class PeriodicImages
  {
  public:
    /// @p communicator is that of all ranks of the model.
    PeriodicImages(const std::vector<PeriodicBoundary> &boundaries,
                   const PeriodicNodes<dim>            &periodic_nodes,
                   const MPI_Comm                      &communicator);

    const PeriodicMotion &
    motion(const unsigned int image) const
    {
      return motions[image];
    }

    /// Image @p second of what is image @p first of something; nothing if that
    /// is too far away.
    std::optional<unsigned int>
    after(const unsigned int second, const unsigned int first) const;

    unsigned int
    inverse(const unsigned int image) const;

    /**
     * The images of the surface of @p body, whose @p faces this rank knows: by
     * the motions of its own periodic boundaries, and by those between whose
     * images it has room. Without the surface itself, sorted. Collective.
     */
    std::vector<unsigned int>
    images_of(const unsigned int                     body,
              const std::vector<CollectedFace<dim>> &faces) const;

    /// Throws UserError if periodic boundaries cut the body @p master, but not
    /// the body @p slave of pair @p path, which has no room between its images
    /// either; its @p faces this rank knows. Collective.
    void
    check_slave(const std::string                     &path,
                const unsigned int                     master,
                const unsigned int                     slave,
                const std::vector<CollectedFace<dim>> &faces) const;

    /// Image @p image of @p face; nothing if it, or a part of it, is too far
    /// away.
    std::optional<SurfaceFace<dim>>
    image_of(const SurfaceFace<dim> &face, const unsigned int image) const;

    /**
     * What lies on a second periodic boundary gets the displacements of the
     * first one, and all @p faces (sorted, ghosts included) that meet at a node
     * at one of its places are added to those at the others, as images.
     */
    void
    name_nodes(std::vector<CollectedFace<dim>> &faces) const;

    /// Dof @p first of a node, or that of the node that it is an image of.
    types::global_dof_index
    original(const types::global_dof_index first) const;

    /// The displacements of nodes that others are images of.
    const std::set<types::global_dof_index> &
    original_dofs() const
    {
      return originals;
    }

  private:
    /// Generates images by its powers.
    struct Generator
    {
      PeriodicMotion         motion;
      unsigned int           order = 0;    ///< of a rotation; 0: a shift
      Tensor<1, 3>           axis;         ///< of a rotation
      Point<3>               centre;       ///< on it
      std::set<unsigned int> bodies;       ///< with such boundaries
      int                    lowest   = 0; ///< power
      int                    n_powers = 1;
    };

    std::vector<Generator>        generators;
    std::vector<std::vector<int>> powers{{}}; ///< [image][generator]
    std::vector<PeriodicMotion>   motions{PeriodicMotion()}; ///< [image]
    MPI_Comm                      communicator     = MPI_COMM_SELF;
    bool                          has_rotations    = false;
    double                        largest_distance = 0.; ///< [length]
    /// By the first dof of a node: that of its original, and its image.
    std::map<types::global_dof_index,
             std::pair<types::global_dof_index, unsigned int>>
                                      nodes;
    std::set<types::global_dof_index> originals;

    std::optional<unsigned int>
    number_of(const std::vector<int> &power) const;

    /// Makes node @p j an image of what it is now.
    void
    make_image(const unsigned int j,
               const unsigned int image,
               SurfaceFace<dim>  &face) const;

    unsigned int
    image_by(const PeriodicMotion &motion) const;

    /// Whether what @p faces have fits between the images of @p generator.
    bool
    has_room(const Generator                       &generator,
             const std::vector<CollectedFace<dim>> &faces) const;
  };
} // namespace stickslip

#endif
