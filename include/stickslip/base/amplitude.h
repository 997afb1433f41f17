#ifndef stickslip_base_amplitude_h
#define stickslip_base_amplitude_h

#include <deal.II/base/mpi.h>
#include <deal.II/base/parameter_handler.h>

#include <stickslip/base/parameter_file.h>

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace stickslip
{
  enum class AmplitudeInterpolation
  {
    linear,
    smooth,
    step
  };

  /// One member of the section "Amplitudes".
  struct AmplitudeParameters
  {
    std::vector<std::pair<double, double>> table; ///< (load time, factor)
    std::string                            file;
    std::vector<unsigned int>              columns = {1, 2};
    AmplitudeInterpolation interpolation = AmplitudeInterpolation::linear;
    bool                   repeat        = false;

    void
    add_parameters(dealii::ParameterHandler &prm);

    /// Throws UserError unless there is either a table or a file.
    void
    check(const std::string &path) const;
  };

  /**
   * A factor over the load time, from a table (t_i, f_i) with increasing t_i.
   * Between two points: linear; smooth, f_i + (f_i+1 - f_i) s^3 (10 - 15 s +
   * 6 s^2) with s = (t - t_i)/(t_i+1 - t_i), whose first and second derivatives
   * vanish at the points; or f_i (step). Before the first point f is that of
   * the first, after the last that of the last, unless the table is repeated.
   */
  class Amplitude
  {
  public:
    Amplitude(std::vector<std::pair<double, double>> table,
              const AmplitudeInterpolation           interpolation,
              const bool                             repeat);

    double
    value(const double time) const;

  private:
    std::vector<std::pair<double, double>> table;
    AmplitudeInterpolation                 interpolation;
    bool                                   repeat;
  };

  using Amplitudes = std::map<std::string, std::shared_ptr<const Amplitude>>;

  /**
   * Reads the files, relative to @p directory, on one rank. Collective. Throws
   * UserError, on all ranks, for a file that is no table and for times that do
   * not increase.
   */
  Amplitudes
  make_amplitudes(const NamedList<AmplitudeParameters> &parameters,
                  const std::string                    &directory,
                  const MPI_Comm                        communicator);

  /// The amplitude that a parameter names; throws UserError, which blames
  /// @p path, if there is none.
  std::shared_ptr<const Amplitude>
  amplitude_called(const std::string &name,
                   const Amplitudes  &amplitudes,
                   const std::string &path);
} // namespace stickslip

#endif
