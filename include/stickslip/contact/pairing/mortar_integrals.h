#ifndef stickslip_contact_pairing_mortar_integrals_h
#define stickslip_contact_pairing_mortar_integrals_h

#include <stickslip/contact/pairing/segment_search.h>
#include <stickslip/contact/point/mortar_node.h>

#include <limits>
#include <vector>

namespace stickslip
{
  /// Integrals over one slave face and the master faces opposite. Where only a
  /// part of the face has a master, the weighting functions are dual on that
  /// part (Cichosz and Bischoff, Comput. Methods Appl. Mech. Engrg. 200, 2011).
  template <int dim>
  struct FaceIntegrals
  {
    FullMatrix<double>              weighting; ///< psi_l = sum_m W[l][m] L_m
    std::vector<double>             area;      ///< of psi_l
    std::vector<double>             variation; ///< of |psi_l|
    FullMatrix<double>              D;         ///< psi_l N_k: [l][slave node]
    std::vector<FullMatrix<double>> M;         ///< [master][l][master node]
    /// Of psi_l times the rise of both surfaces (facet_rise.h).
    std::vector<double> rise;
    /// Of psi_l times the depth of the slave's points in the master, along the
    /// normal in the middle of the face, and the largest depth of a point.
    std::vector<double> depth;
    double              deepest = std::numeric_limits<double>::lowest();
  };



  /// sum_m weighting[l][m] L_m
  double
  combination(const FullMatrix<double>  &weighting,
              const unsigned int         l,
              const std::vector<double> &L);



  /// Integrals over slave faces, and the averages of nodes from them.
  template <int dim>
  class MortarIntegrals
  {
  public:
    MortarIntegrals(const FaceShape<dim> &displacement_shape,
                    const FaceShape<dim> &multiplier_shape);

    /// From the facets around a node, or at a corner from the master's.
    MortarFrame<dim>
    frame_at(const MortarNode<dim>                &node,
             const std::vector<MortarFace<dim>>   &faces,
             const std::vector<FaceSegments<dim>> &segments,
             const MasterPatch<dim>               &patch) const;

    FaceIntegrals<dim>
    integrate(const MortarFace<dim>   &slave,
              const FaceSegments<dim> &segments,
              const MasterPatch<dim>  &patch) const;

    /// From the @p integrals of all faces. Nodes that are not @p reached are
    /// not paired.
    MortarAverage<dim>
    average(const MortarNode<dim>                 &node,
            const bool                             reached,
            const std::vector<MortarFace<dim>>    &faces,
            const std::vector<FaceSegments<dim>>  &segments,
            const std::vector<FaceIntegrals<dim>> &integrals,
            const MasterPatch<dim>                &patch) const;

  private:
    /// The mean of a rigid tool's normals opposite a corner, with the weights
    /// that the node averages positions with; false: there are none.
    bool
    find_tool_normal(const MortarNode<dim>                &node,
                     const std::vector<MortarFace<dim>>   &faces,
                     const std::vector<FaceSegments<dim>> &segments,
                     const MasterPatch<dim>               &patch,
                     MortarFrame<dim>                     &frame) const;

    void
    average_normals(const MortarNode<dim>              &node,
                    const std::vector<MortarFace<dim>> &faces,
                    MortarFrame<dim>                   &frame) const;

    const FaceShape<dim> displacement_shape;
    const FaceShape<dim> multiplier_shape;
  };
} // namespace stickslip

#endif
