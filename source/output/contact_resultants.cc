#include <stickslip/output/contact_resultants.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace stickslip
{
  using namespace dealii;

  namespace
  {
    /// Everything that is summed over points and ranks, for one MPI call.
    template <int dim>
    struct ContactSums
    {
      static constexpr unsigned int n_values = 3 * dim + 3 + 10;

      explicit ContactSums(double *values)
        : normal_force(values)
        , friction_force(values + dim)
        , first_moment(values + 2 * dim)
        , moment(values + 3 * dim)
        , scalars(values + 3 * dim + 3)
      {}

      enum Scalar
      {
        pressure_integral,
        reference_area,
        current_area,
        friction_work,
        n_unpaired,
        n_open,
        n_stick,
        n_slip,
        n_closed, ///< without friction
        n_tied
      };

      double *normal_force;
      double *friction_force;
      double *first_moment; ///< of the pressure: sum w p x
      double *moment;
      double *scalars;
    };



    /// x times f; in 2D only the out-of-plane component.
    template <int dim>
    Tensor<1, 3>
    moment_of_force(const Point<dim> &position, const Tensor<1, dim> &force)
    {
      Tensor<1, 3> x, f;
      for (unsigned int d = 0; d < dim; ++d)
        {
          x[d] = position[d];
          f[d] = force[d];
        }
      return cross_product_3d(x, f);
    }



    template <int dim>
    void
    add_contact_point(const ContactPointResult<dim> &point,
                      const ContactSums<dim>        &sums)
    {
      using Sums = ContactSums<dim>;

      const double   w              = point.reference_weight;
      Tensor<1, dim> normal_force   = w * point.pressure * point.normal;
      Tensor<1, dim> friction_force = w * point.tangential_traction;
      Point<dim>     centre         = point.centre_of_force;
      if (point.image) // the forces count where the master itself is
        {
          const PeriodicMotion back = point.image->inverse();
          const Tensor<2, dim> Q    = back.rotation_matrix<dim>();
          normal_force              = Q * normal_force;
          friction_force            = Q * friction_force;
          centre                    = Point<dim>(back(Tensor<1, dim>(centre)));
        }
      const Tensor<1, 3> moment =
        moment_of_force(centre, normal_force + friction_force);

      for (unsigned int d = 0; d < dim; ++d)
        {
          sums.normal_force[d] += normal_force[d];
          sums.friction_force[d] += friction_force[d];
          sums.first_moment[d] += w * point.pressure * centre[d];
        }
      for (unsigned int d = 0; d < 3; ++d)
        sums.moment[d] += moment[d];

      sums.scalars[Sums::pressure_integral] += w * point.pressure;
      if (is_closed(point.state))
        {
          sums.scalars[Sums::reference_area] += w;
          sums.scalars[Sums::current_area] += w * point.area_ratio;
        }
      sums.scalars[Sums::friction_work] +=
        w * (point.tangential_traction * point.slip);
      sums.scalars[Sums::n_unpaired + static_cast<unsigned int>(point.state)] +=
        1.;
    }



    template <int dim>
    ContactResultants<dim>
    resultants_from_sums(const ContactSums<dim> &sums,
                         const double            max_pressure)
    {
      using Sums = ContactSums<dim>;

      const auto count = [&](const unsigned int scalar) {
        return static_cast<unsigned int>(std::lround(sums.scalars[scalar]));
      };

      ContactResultants<dim> result;
      const double total_pressure = sums.scalars[Sums::pressure_integral];
      for (unsigned int d = 0; d < dim; ++d)
        {
          result.normal_force[d]   = sums.normal_force[d];
          result.friction_force[d] = sums.friction_force[d];
          if (total_pressure > 0.)
            result.centre_of_pressure[d] =
              sums.first_moment[d] / total_pressure;
        }
      for (unsigned int d = 0; d < 3; ++d)
        result.moment[d] = sums.moment[d];

      result.reference_area = sums.scalars[Sums::reference_area];
      result.current_area   = sums.scalars[Sums::current_area];
      result.friction_work  = sums.scalars[Sums::friction_work];
      result.max_pressure   = max_pressure;
      result.n_unpaired     = count(Sums::n_unpaired);
      result.n_stick        = count(Sums::n_stick) + count(Sums::n_tied);
      result.n_slip         = count(Sums::n_slip);
      result.n_frictionless = count(Sums::n_closed);
      result.n_points =
        result.n_unpaired + count(Sums::n_open) + result.n_closed();
      return result;
    }
  } // namespace



  template <int dim>
  std::vector<NamedResultant>
  ContactResultants<dim>::named_values() const
  {
    constexpr std::array<char, 3> axis{{'x', 'y', 'z'}};

    std::vector<NamedResultant> values;
    const auto                  add_component = [&](const std::string    &vector,
                                   const unsigned int    d,
                                   const double          value,
                                   const ResultantFamily family) {
      values.push_back({vector + "_" + axis[d], value, family});
    };
    const auto add_vector = [&](const std::string    &name,
                                const auto           &vector,
                                const ResultantFamily family) {
      for (unsigned int d = 0; d < dim; ++d)
        add_component(name, d, vector[d], family);
    };
    const auto add_single = [&](const std::string &name, const double value) {
      values.push_back({name, value, ResultantFamily::single});
    };
    add_vector("force", force(), ResultantFamily::force);
    add_vector("normal_force", normal_force, ResultantFamily::force);
    add_vector("friction_force", friction_force, ResultantFamily::force);
    for (unsigned int d = (dim == 2 ? 2 : 0); !is_axisymmetric && d < 3; ++d)
      add_component("moment", d, moment[d], ResultantFamily::moment);
    add_vector("centre_of_pressure",
               centre_of_pressure,
               ResultantFamily::position);
    add_single("contact_area", current_area);
    add_single("reference_contact_area", reference_area);
    add_single("max_pressure", max_pressure);
    add_single("friction_work", friction_work);
    add_single("closed_points", n_closed());
    add_single("stick_points", n_stick);
    add_single("slip_points", n_slip);
    add_single("unpaired_points", n_unpaired);
    return values;
  }



  template <int dim>
  std::vector<ContactResultants<dim>>
  compute_contact_resultants(const std::vector<ContactFaceResult<dim>> &faces,
                             const unsigned int                         n_pairs,
                             const MPI_Comm      communicator,
                             const CrossSection &cross_section)
  {
    constexpr unsigned int n_values = ContactSums<dim>::n_values;

    std::vector<double> values(n_pairs * n_values, 0.);
    std::vector<double> max_pressures(n_pairs, 0.);
    for (const ContactFaceResult<dim> &face : faces)
      {
        AssertIndexRange(face.pair, n_pairs);
        const ContactSums<dim> sums(&values[face.pair * n_values]);
        for (const ContactPointResult<dim> &point : face.points)
          {
            add_contact_point(point, sums);
            max_pressures[face.pair] =
              std::max(max_pressures[face.pair], point.pressure);
          }
      }

    if (n_pairs > 0)
      {
        Utilities::MPI::sum(values, communicator, values);
        Utilities::MPI::max(max_pressures, communicator, max_pressures);
      }

    std::vector<ContactResultants<dim>> result;
    for (unsigned int pair = 0; pair < n_pairs; ++pair)
      {
        result.push_back(
          resultants_from_sums(ContactSums<dim>(&values[pair * n_values]),
                               max_pressures[pair]));
        result.back().is_axisymmetric = cross_section.is_axisymmetric;
      }
    return result;
  }



  template struct ContactResultants<2>;
  template struct ContactResultants<3>;
  template std::vector<ContactResultants<2>>
  compute_contact_resultants(const std::vector<ContactFaceResult<2>> &,
                             const unsigned int,
                             const MPI_Comm,
                             const CrossSection &);
  template std::vector<ContactResultants<3>>
  compute_contact_resultants(const std::vector<ContactFaceResult<3>> &,
                             const unsigned int,
                             const MPI_Comm,
                             const CrossSection &);
} // namespace stickslip
