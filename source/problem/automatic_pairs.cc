#include <stickslip/problem/automatic_pairs.h>

#include <stickslip/base/user_error.h>

#include <stickslip/problem/body_surfaces.h>

#include <algorithm>
#include <cctype>
#include <limits>
#include <sstream>
#include <tuple>

namespace stickslip
{
  namespace
  {
    /// Quantities whose ratio is less decide nothing.
    constexpr double clearly = 1.2;

    /// Extents of flat surfaces likewise.
    constexpr double slightly = 1.01;

    /// Flat surfaces look at each other if the cosine of their mean normals is
    /// below, and can meet if they are no farther apart than this times the
    /// smaller one.
    constexpr double opposite = -0.9;
    constexpr double reach    = 0.5;



    template <int dim>
    using SurfacePointers = std::vector<const BodySurface<dim> *>;



    template <int dim>
    double
    softest(const SurfacePointers<dim> &surfaces)
    {
      double modulus = std::numeric_limits<double>::infinity();
      for (const auto *surface : surfaces)
        modulus = std::min(modulus, surface->modulus);
      return modulus;
    }



    template <int dim>
    double
    mean_face_size(const SurfacePointers<dim> &surfaces)
    {
      double sum = 0., n = 0.;
      for (const auto *surface : surfaces)
        {
          sum += surface->sum_of_face_sizes;
          n += surface->n_faces;
        }
      return n > 0. ? sum / n : 0.;
    }



    /// Two flat surfaces that look at each other and may meet.
    template <int dim>
    struct FlatPair
    {
      const BodySurface<dim> *a = nullptr, *b = nullptr;
    };



    template <int dim>
    FlatPair<dim>
    flat_surfaces_opposite(const SurfacePointers<dim> &of_a,
                           const SurfacePointers<dim> &of_b)
    {
      FlatPair<dim> nearest;
      double        least = std::numeric_limits<double>::infinity();
      for (const auto *a : of_a)
        for (const auto *b : of_b)
          if (a->is_flat() && b->is_flat() &&
              a->mean_normal() * b->mean_normal() < opposite)
            {
              const double distance = a->distance(*b);
              if (distance < least &&
                  distance <= reach * std::min(a->extent(), b->extent()))
                {
                  least   = distance;
                  nearest = {a, b};
                }
            }
      return nearest;
    }



    /// The roles of two bodies.
    struct Roles
    {
      bool        first_is_slave = true;
      std::string reason;
    };



    std::string
    comparison(const std::string &what, const double slave, const double master)
    {
      std::ostringstream text;
      text << what << " (" << slave << " against " << master << ")";
      return text.str();
    }



    /// The one with the clearly smaller value is slave; no reason if there is
    /// none.
    Roles
    smaller_is_slave(const double       a,
                     const double       b,
                     const double       ratio,
                     const std::string &what)
    {
      Roles roles;
      if (std::max(a, b) > ratio * std::min(a, b))
        roles = {a < b, comparison(what, std::min(a, b), std::max(a, b))};
      return roles;
    }



    /// Of two bodies that may both be slaves.
    template <int dim>
    Roles
    choose_roles(const SurfacePointers<dim> &a, const SurfacePointers<dim> &b)
    {
      const FlatPair<dim> flat = flat_surfaces_opposite(a, b);
      Roles               roles;
      if (flat.a != nullptr)
        roles = smaller_is_slave(flat.a->extent(),
                                 flat.b->extent(),
                                 slightly,
                                 "the smaller one of two flat surfaces");
      if (roles.reason.empty())
        roles =
          smaller_is_slave(softest(a), softest(b), clearly, "the softer body");
      if (roles.reason.empty())
        roles = smaller_is_slave(mean_face_size(a),
                                 mean_face_size(b),
                                 clearly,
                                 "the finer mesh");
      if (roles.reason.empty())
        roles.reason = "the first of two equal ones";
      return roles;
    }



    /// What can stand in an expression.
    std::string
    as_word(std::string text)
    {
      for (char &c : text)
        if (!std::isalnum(static_cast<unsigned char>(c)))
          c = '_';
      return text;
    }



    bool
    are_paired(const NamedList<ContactPairParameters> &pairs,
               const std::string                      &a,
               const std::string                      &b)
    {
      return std::any_of(pairs.begin(), pairs.end(), [&](const auto &pair) {
        const auto &[slave, master] =
          std::tie(pair.second.slave_body, pair.second.master_body);
        return (slave == a && master == b) || (slave == b && master == a);
      });
    }



    /// The pair of a slave and a master.
    template <int dim>
    ContactPairParameters
    pair_of(const Bodies               &bodies,
            const AutomaticContact     &parameters,
            const SurfacePointers<dim> &slave_surfaces,
            const SurfacePointers<dim> &master_surfaces)
    {
      ContactPairParameters pair  = parameters.pair();
      const Body           &slave = bodies.bodies[slave_surfaces.front()->body];
      pair.slave_body             = slave.name;
      pair.master_body = bodies.bodies[master_surfaces.front()->body].name;
      for (const auto *surface : slave_surfaces)
        {
          const auto local = bodies.local_boundary_id(surface->id);
          const auto known = slave.boundaries.names({local});
          pair.slave_boundary.push_back(
            known.empty() ? std::to_string(slave.boundaries.number(local))
                          : known.front());
          pair.slave_ids.insert(surface->id);
        }
      for (const auto *surface : master_surfaces)
        pair.master_ids.insert(surface->id);
      return pair;
    }
  } // namespace



  template <int dim>
  AutomaticPairs
  automatic_pairs(const Mesh<dim>                              &mesh,
                  const AutomaticContact                       &parameters,
                  const NamedList<ContactPairParameters>       &explicit_pairs,
                  const NamedList<BoundaryConditionParameters> &conditions,
                  const NamedList<MaterialParameters>          &materials)
  {
    AutomaticPairs result;
    if (!parameters.active)
      return result;
    const Bodies &bodies = mesh.bodies;
    const auto    surfaces =
      body_surfaces(mesh, conditions, laws_of_regions(materials, bodies));
    const auto of_body = [&](const unsigned int b, const bool as_slave) {
      SurfacePointers<dim> found;
      for (const auto &surface : surfaces)
        if (surface.body == b && surface.is_free &&
            !(as_slave && surface.is_prescribed))
          found.push_back(&surface);
      return found;
    };
    for (unsigned int a = 0; a < bodies.n_bodies(); ++a)
      for (unsigned int b = a + 1; b < bodies.n_bodies(); ++b)
        {
          if (are_paired(explicit_pairs,
                         bodies.bodies[a].name,
                         bodies.bodies[b].name))
            continue;
          const auto slave_a = of_body(a, true), slave_b = of_body(b, true);
          Roles      roles;
          if (slave_a.empty() && slave_b.empty())
            continue;
          if (slave_a.empty() || slave_b.empty())
            roles = {!slave_a.empty(),
                     "all of the other one is rigid or prescribed"};
          else
            roles = choose_roles<dim>(slave_a, slave_b);
          const unsigned int master = roles.first_is_slave ? b : a;
          const auto         on     = of_body(master, false);
          if (on.empty())
            continue;
          const auto pair = pair_of<dim>(
            bodies, parameters, roles.first_is_slave ? slave_a : slave_b, on);
          const std::string name =
            as_word(pair.slave_body + "_on_" + pair.master_body);
          result.pairs.emplace_back(name, pair);
          result.reasons.push_back(
            "automatic contact: '" + pair.slave_body + "' is slave of '" +
            pair.master_body + "', " + roles.reason + "; pair '" + name + "'");
        }
    if (parameters.self_contact)
      for (unsigned int b = 0; b < bodies.n_bodies(); ++b)
        {
          const std::string &body  = bodies.bodies[b].name;
          const auto         slave = of_body(b, true);
          if (slave.empty() || are_paired(explicit_pairs, body, body))
            continue;
          const std::string name = as_word(body + "_on_itself");
          result.pairs.emplace_back(
            name, pair_of<dim>(bodies, parameters, slave, of_body(b, false)));
          result.reasons.push_back("automatic contact: '" + body +
                                   "' may meet itself; pair '" + name + "'");
        }
    for (unsigned int p = 0; p < result.pairs.size(); ++p)
      for (const auto &other : explicit_pairs)
        if (result.pairs[p].first == other.first)
          throw UserError("'Contact/" + other.first +
                          "' is also the name of an automatic pair. Give it "
                          "another name.");
    if (result.pairs.empty() && explicit_pairs.empty())
      throw UserError(
        "'Contact/Automatic = true', but no two bodies have free "
        "boundaries that could touch, of which one can deform. For one "
        "body that meets itself: 'Contact/Automatic self contact = true'.");
    return result;
  }

#define INSTANTIATE(dim)                            \
  template AutomaticPairs automatic_pairs(          \
    const Mesh<dim> &,                              \
    const AutomaticContact &,                       \
    const NamedList<ContactPairParameters> &,       \
    const NamedList<BoundaryConditionParameters> &, \
    const NamedList<MaterialParameters> &);
  INSTANTIATE(2)
  INSTANTIATE(3)
#undef INSTANTIATE
} // namespace stickslip
