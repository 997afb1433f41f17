#include <stickslip/solid/pretension.h>

#include <stickslip/base/user_error.h>

#include <algorithm>

namespace stickslip
{
  template <int dim>
  Pretension<dim>::Pretension(const std::string                 &name,
                              const BoundaryConditionParameters &parameters,
                              const Bodies                      &bodies,
                              const std::shared_ptr<const Amplitude> &amplitude)
    : name(name)
  {
    const std::string  path = "Boundary conditions/" + name;
    const std::string &second_body =
      parameters.second_body.empty() ? parameters.body : parameters.second_body;
    sides[0].body         = bodies.index_of(parameters.body, path + "/Body");
    sides[0].boundary_ids = bodies.global_boundary_ids(parameters.body,
                                                       parameters.boundary,
                                                       path + "/Boundary");
    sides[1].body         = bodies.index_of(second_body, path + "/Second body");
    sides[1].boundary_ids =
      bodies.global_boundary_ids(second_body,
                                 parameters.second_boundary,
                                 path + "/Second boundary");
    for (const Side &side : sides)
      if (bodies.bodies[side.body].is_rigid)
        throw UserError(path + ": body '" + bodies.bodies[side.body].name +
                        "' is rigid. A bolt has to be deformable.");
    const auto is_on_both = [this](const types::boundary_id id) {
      return sides[1].boundary_ids.count(id) > 0;
    };
    if (std::any_of(sides[0].boundary_ids.begin(),
                    sides[0].boundary_ids.end(),
                    is_on_both))
      throw UserError(path +
                      ": 'Boundary' and 'Second boundary' are the same.");

    force_law = std::make_shared<SpaceTimeFunction<dim>>(parameters.force,
                                                         1,
                                                         path + "/Force");
    force_law->multiply_by(amplitude);
    drawn = parameters.drawn_interval(path);
  }

  template struct Pretension<2>;
  template struct Pretension<3>;
} // namespace stickslip
