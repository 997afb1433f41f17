#include <stickslip/simulation/motion_warnings.h>

#include <stickslip/base/short_number.h>

#include <stickslip/problem/rigid_part.h>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace stickslip
{
  namespace
  {
    /// Rotations [radian] from which on small strains are wrong by a thousandth
    /// and more: half of the square.
    constexpr double noticeable_rotation = 0.05;



    /// Those of @p motions that no condition holds at other times.
    std::vector<FreeMotion>
    permanently_free(std::vector<FreeMotion> motions,
                     const CaseParameters   &parameters)
    {
      const auto is_held_at_times = [&](const FreeMotion &motion) {
        for (const auto &[name, condition] : parameters.boundary_conditions)
          if (std::count(motion.bodies.begin(),
                         motion.bodies.end(),
                         condition.body) > 0 &&
              !condition.active_interval("Boundary conditions/" + name)
                 .is_always())
            return true;
        return false;
      };
      motions.erase(std::remove_if(motions.begin(),
                                   motions.end(),
                                   is_held_at_times),
                    motions.end());
      return motions;
    }
  } // namespace



  template <int dim>
  MotionWarnings<dim>::MotionWarnings(const CaseParameters      &parameters,
                                      const Bodies              &bodies,
                                      const ContactProblem<dim> &problem)
    : parameters(parameters)
    , bodies(bodies)
    , free(permanently_free(problem.free_motions(), parameters))
  {
    if (bodies.cross_section.is_axisymmetric)
      return; // nothing turns
    const auto is_new = [this](const unsigned int body) {
      return std::none_of(small_strain_bodies.begin(),
                          small_strain_bodies.end(),
                          [body](const auto &other) {
                            return other.body == body;
                          });
    };
    for (const auto &[name, material] : parameters.materials)
      if (material.constitutive_law()->is_geometrically_linear())
        for (const Region &region : bodies.regions)
          if (region.material == name && !bodies.bodies[region.body].is_rigid &&
              is_new(region.body))
            small_strain_bodies.push_back({region.body, name, material.law});
  }



  template <int dim>
  std::vector<std::string>
  MotionWarnings<dim>::of_step(
    const std::vector<ContactResultants<dim>> &resultants,
    const ContactProblem<dim>                 &problem)
  {
    std::vector<std::string> texts;
    find_adrift(resultants, texts);
    look_at_rotations(problem, texts);
    return texts;
  }



  template <int dim>
  void
  MotionWarnings<dim>::find_adrift(
    const std::vector<ContactResultants<dim>> &resultants,
    std::vector<std::string>                  &texts)
  {
    unresisted.clear();
    std::vector<FreeMotion> news;
    for (const FreeMotion &motion : free)
      {
        bool is_touched = false;
        for (unsigned int p = 0; p < resultants.size(); ++p)
          {
            const ContactPairParameters &pair =
              parameters.contact_pairs[p].second;
            is_touched = is_touched || (resultants[p].n_closed() > 0 &&
                                        motion.concerns(pair) &&
                                        pair.slave_body != pair.master_body);
          }
        if (is_touched)
          continue;
        unresisted.push_back(motion);
        if (reported.insert(motion.text()).second)
          news.push_back(motion);
      }
    for (const std::string &line : describe(news))
      texts.push_back("no contact pair is closed that could hold what is " +
                      line +
                      ". Without a load it stays where it is until something "
                      "touches it.");
  }



  template <int dim>
  void
  MotionWarnings<dim>::look_at_rotations(const ContactProblem<dim> &problem,
                                         std::vector<std::string>  &texts)
  {
    if (small_strain_bodies.empty())
      return;
    const auto angles =
      mean_rotations(bodies, problem.layout(), problem.ghosted_displacement());
    for (auto body = small_strain_bodies.begin();
         body != small_strain_bodies.end();)
      {
        const double angle = angles[body->body];
        if (angle < noticeable_rotation)
          {
            ++body;
            continue;
          }
        std::ostringstream text;
        text
          << "body '" << bodies.bodies[body->body].name << "' has turned by "
          << rough_number(angle * 180. / numbers::PI)
          << " degrees, but 'Materials/" << body->material
          << "/Law = " << body->law
          << "' is for small strains and rotations: its strains are wrong by "
             "half the square of the angle ("
          << percent(0.5 * angle * angle)
          << "), and its forces do not balance where it is now. "
             "Take a law for large strains (St Venant-Kirchhoff, "
             "neo-Hookean, Hencky, Simo-Miehe).";
        texts.push_back(text.str());
        body = small_strain_bodies.erase(body);
      }
  }

  template class MotionWarnings<2>;
  template class MotionWarnings<3>;
} // namespace stickslip
