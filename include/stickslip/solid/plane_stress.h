#ifndef stickslip_solid_plane_stress_h
#define stickslip_solid_plane_stress_h

#include <stickslip/solid/constitutive_law.h>

#include <memory>
#include <string>
#include <vector>

namespace stickslip
{
  /**
   * Plane stress for any law: finds, by a local Newton iteration, the
   * out-of-plane stretch F_33 for which P_33 = 0, and condenses it out of the
   * tangent,
   *
   *   A_ijkl - A_ij33 A_33kl / A_3333    (i,j,k,l in the plane).
   *
   * The shears F_13, F_23 stay zero, which is right for isotropic laws and
   * for those whose third axis is a symmetry axis. F_33 is kept as the last
   * history variable, behind those of the law: the iteration starts from it.
   * P is the force per area of the undeformed thickness.
   */
  class PlaneStress : public ConstitutiveLaw
  {
  public:
    explicit PlaneStress(const std::shared_ptr<ConstitutiveLaw> &law);

    void
    add_parameters(ParameterHandler &prm) override;

    void
    read_files(const std::string &path,
               const std::string &directory,
               const MPI_Comm     communicator) override;

    void
    check(const std::string &path) const override;

    /// Those of the law and "out_of_plane_stretch".
    std::vector<std::string>
    history_names() const override;

    void
    initialize_history(const ArrayView<double> &history) const override;

    /// Returns false if the law does, or if the local iteration finds no
    /// stretch.
    bool
    evaluate(const Tensor<2, 3>            &F,
             const ArrayView<const double> &old_history,
             const ArrayView<double>       &new_history,
             Tensor<2, 3>                  &P,
             Tensor<4, 3>                  *dP_dF) const override;

    Tensor<2, 3>
    full_deformation_gradient(
      const Tensor<2, 3>            &F,
      const ArrayView<const double> &history) const override;

    SymmetricTensor<2, 3>
    cauchy_stress(const Tensor<2, 3> &F, const Tensor<2, 3> &P) const override;

    SymmetricTensor<2, 3>
    strain(const Tensor<2, 3> &F) const override;

    double
    longitudinal_modulus() const override;

    bool
    is_geometrically_linear() const override;

  private:
    const std::shared_ptr<ConstitutiveLaw> law;
    const unsigned int                     n_of_law; ///< its history variables
  };
} // namespace stickslip

#endif
