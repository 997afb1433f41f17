#include <stickslip/solid/plane_stress.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace stickslip
{
  namespace
  {
    /// Newton's next out-of-plane stretch from force and slope, kept positive
    /// and within a factor of two of the last one.
    double
    next_plane_stress_stretch(const double stretch,
                              const double P_33,
                              const double slope)
    {
      // On a falling branch Newton would run away from the root: pressed
      // material (P_33 < 0) has to become thicker, pulled material thinner.
      if (!(slope > 0.))
        return P_33 < 0. ? 1.5 * stretch : stretch / 1.5;
      return std::clamp(stretch - P_33 / slope, 0.5 * stretch, 2. * stretch);
    }



    /// A_ijkl - A_ij33 A_33kl / A_3333
    void
    condense_out_of_plane(Tensor<4, 3> &A)
    {
      const double       pivot = A[2][2][2][2];
      const Tensor<2, 3> row   = A[2][2];
      Tensor<2, 3>       column;
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          column[i][j] = A[i][j][2][2];
      for (unsigned int i = 0; i < 3; ++i)
        for (unsigned int j = 0; j < 3; ++j)
          A[i][j] -= column[i][j] / pivot * row;
    }
  } // namespace



  PlaneStress::PlaneStress(const std::shared_ptr<ConstitutiveLaw> &law)
    : law(law)
    , n_of_law(law->n_history_variables())
  {}



  void
  PlaneStress::add_parameters(ParameterHandler &prm)
  {
    law->add_parameters(prm);
  }



  void
  PlaneStress::read_files(const std::string &path,
                          const std::string &directory,
                          const MPI_Comm     communicator)
  {
    law->read_files(path, directory, communicator);
  }



  void
  PlaneStress::check(const std::string &path) const
  {
    law->check(path);
  }



  std::vector<std::string>
  PlaneStress::history_names() const
  {
    std::vector<std::string> names = law->history_names();
    names.push_back("out_of_plane_stretch");
    return names;
  }



  void
  PlaneStress::initialize_history(const ArrayView<double> &history) const
  {
    law->initialize_history(ArrayView<double>(history.data(), n_of_law));
    history[n_of_law] = 1.;
  }



  bool
  PlaneStress::evaluate(const Tensor<2, 3>            &F,
                        const ArrayView<const double> &old_history,
                        const ArrayView<double>       &new_history,
                        Tensor<2, 3>                  &P,
                        Tensor<4, 3>                  *dP_dF) const
  {
    const ArrayView<const double> old_of_law(old_history.data(), n_of_law);
    const ArrayView<double>       new_of_law(new_history.data(), n_of_law);

    // Rounding limits what can be asked for: stresses of the size of the
    // modulus cancel in P_33.
    const double       tolerance        = 1e-13 * law->longitudinal_modulus();
    const double       coarse_tolerance = 1e-9 * law->longitudinal_modulus();
    const unsigned int max_iterations   = 50;

    Tensor<2, 3> F_full = F;
    F_full[2][2]        = old_history[n_of_law];
    Tensor<4, 3>  local_tangent;
    Tensor<4, 3> &A         = (dP_dF != nullptr ? *dP_dF : local_tangent);
    double        last_P_33 = std::numeric_limits<double>::max();

    for (unsigned int iteration = 0; iteration < max_iterations; ++iteration)
      {
        if (!law->evaluate(F_full, old_of_law, new_of_law, P, &A))
          return false;

        const double P_33  = P[2][2];
        const double slope = A[2][2][2][2];
        const bool   stagnates =
          std::abs(P_33) >= last_P_33 && std::abs(P_33) <= coarse_tolerance;
        if (slope > 0. && (std::abs(P_33) <= tolerance || stagnates))
          {
            new_history[n_of_law] = F_full[2][2];
            P[2][2]               = 0.;
            if (dP_dF != nullptr)
              condense_out_of_plane(A);
            return true;
          }
        last_P_33    = std::abs(P_33);
        F_full[2][2] = next_plane_stress_stretch(F_full[2][2], P_33, slope);
      }
    return false;
  }



  Tensor<2, 3>
  PlaneStress::full_deformation_gradient(
    const Tensor<2, 3>            &F,
    const ArrayView<const double> &history) const
  {
    Tensor<2, 3> F_full = F;
    F_full[2][2]        = history[n_of_law];
    return law->full_deformation_gradient(
      F_full, ArrayView<const double>(history.data(), n_of_law));
  }



  SymmetricTensor<2, 3>
  PlaneStress::cauchy_stress(const Tensor<2, 3> &F, const Tensor<2, 3> &P) const
  {
    return law->cauchy_stress(F, P);
  }



  SymmetricTensor<2, 3>
  PlaneStress::strain(const Tensor<2, 3> &F) const
  {
    return law->strain(F);
  }



  double
  PlaneStress::longitudinal_modulus() const
  {
    return law->longitudinal_modulus();
  }



  bool
  PlaneStress::is_geometrically_linear() const
  {
    return law->is_geometrically_linear();
  }
} // namespace stickslip
