#include <stickslip/solid/periodic_conditions.h>

#include <stickslip/base/user_error.h>

#include <stickslip/solid/direction_parameters.h>

#include <cmath>
#include <string>

namespace stickslip
{
  template <int dim>
  unsigned int
  periodic_axis(const BoundaryConditionParameters &condition,
                const std::string                 &path)
  {
    const Tensor<1, dim> vector = condition.unit_direction<dim>(path);
    for (unsigned int d = 0; d < dim; ++d)
      if (std::abs(std::abs(vector[d]) - 1.) < 1e-12)
        return d;
    throw UserError(path + "/Direction is '" + condition.direction +
                    "', but a periodic condition has to be along an axis.");
  }

  template unsigned int
  periodic_axis<2>(const BoundaryConditionParameters &, const std::string &);
  template unsigned int
  periodic_axis<3>(const BoundaryConditionParameters &, const std::string &);



  namespace
  {
    template <int dim>
    void
    read_motion(const BoundaryConditionParameters &condition,
                PeriodicRequest                   &request)
    {
      const std::string &path = request.parameter_path;
      request.is_cyclic =
        condition.type == BoundaryConditionType::cyclic_symmetry;
      if (!request.is_cyclic)
        {
          request.direction = periodic_axis<dim>(condition, path);
          return;
        }
      const auto [axis, centre] =
        axis_of<dim>(condition.rotation_axis, condition.rotation_centre, path);
      request.axis = axis;
      for (unsigned int d = 0; d < dim; ++d)
        request.centre[d] = centre[d];
    }
  } // namespace



  std::vector<PeriodicRequest>
  periodic_requests(const NamedList<BoundaryConditionParameters> &conditions,
                    const unsigned int                            dimension)
  {
    std::vector<PeriodicRequest> requests;
    for (const auto &[name, condition] : conditions)
      if (condition.type == BoundaryConditionType::periodic ||
          condition.type == BoundaryConditionType::cyclic_symmetry)
        {
          PeriodicRequest request;
          request.parameter_path = "Boundary conditions/" + name;
          request.body           = condition.body;
          request.first          = condition.boundary.at(0);
          request.second         = condition.second_boundary.at(0);
          if (dimension == 2)
            read_motion<2>(condition, request);
          else
            read_motion<3>(condition, request);
          requests.push_back(request);
        }
    return requests;
  }
} // namespace stickslip
