#ifndef stickslip_contact_pairing_segment_search_h
#define stickslip_contact_pairing_segment_search_h

#include <stickslip/contact/pairing/master_patch.h>
#include <stickslip/contact/pairing/side_choice.h>
#include <stickslip/contact/surface/mortar_segments.h>
#include <stickslip/contact/surface/weighting_functions.h>

#include <deal.II/lac/full_matrix.h>

#include <functional>
#include <vector>

namespace stickslip
{
  /// A slave face that takes part in mortar integrals of this rank.
  template <int dim>
  struct MortarFace
  {
    SurfaceFace<dim> face;
    double           area = 0.; ///< undeformed
    /// weighting_functions() of the whole face, standard ones and those in use
    FullMatrix<double> extended;
    FullMatrix<double> weighting;
    WeightingFunctions weighting_kind = WeightingFunctions::standard;
    MissingNodes       missing;
    /// Without contact whatever the face is: those of a surface that meets
    /// itself miss more where its slave and master sides meet.
    MissingNodes        always_missing;
    Side                side = Side::slave;
    std::vector<double> gap_offsets; ///< per node; empty: none

    std::vector<Tensor<1, dim>> positions;     ///< now
    std::vector<Tensor<1, dim>> old_positions; ///< at the start of the step

    /// The other side of a fold does not turn the normals of this one.
    bool
    counts_for_normals() const
    {
      return side != Side::master;
    }
  };



  /// The segments of one slave face with the master faces opposite.
  template <int dim>
  struct FaceSegments
  {
    std::vector<unsigned int>      masters; ///< numbers in the patch
    std::vector<FaceId>            master_ids;
    std::vector<SegmentPoint<dim>> points; ///< `master` counts in `masters`
    std::vector<SegmentEnd<dim>>   ends;   ///< likewise
  };



  /**
   * The segments of @p slave in the present configuration: with all master
   * faces that look at it and lie within the search distance along its normal;
   * of those that lie behind each other with the nearest. Of a surface that
   * meets itself only those that @p is_master says count, but the others hide
   * what is behind them, too. Not collective.
   */
  template <int dim>
  FaceSegments<dim>
  find_segments(const MortarFace<dim>                     &slave,
                const SegmentRule<dim>                    &rule,
                const MasterPatch<dim>                    &patch,
                const std::function<bool(const FaceId &)> &is_master = {});

  /// The faces of the patch that find_segments() may take, whatever they are,
  /// with their mean distances. Not collective.
  template <int dim>
  std::vector<OppositeFaces>
  find_opposite(const MortarFace<dim>  &slave,
                const SegmentRule<dim> &rule,
                const MasterPatch<dim> &patch);
} // namespace stickslip

#endif
