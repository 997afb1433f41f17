#ifndef stickslip_tests_contact_point_problem_h
#define stickslip_tests_contact_point_problem_h

// One contact point with a slave and a master face, at the level of nodal
// coordinates.

#include <stickslip/contact/point/contact_element.h>
#include <stickslip/contact/surface/normal_projection.h>

#include <cmath>
#include <map>
#include <random>
#include <string>
#include <vector>

namespace contact_test
{
  using namespace stickslip;

  /// Numbers in [-1, 1], the same on every machine.
  inline double
  random_number()
  {
    static std::mt19937 generator(7);
    return 2. * (generator() / 4294967295.) - 1.;
  }



  /// The master face in the middle of 3 (3 x 3 in 3D) facets, one of which has
  /// its nodes numbered backwards; the body lies below.
  template <int dim>
  SurfaceFace<dim>
  make_master(const FaceShape<dim> &shape,
              const bool            smoothed,
              const bool            backwards = false)
  {
    const unsigned int p = shape.degree(), n = p + 1;
    const unsigned int n_facets = dim == 2 ? 3 : 9;
    SurfaceFace<dim>   face;
    face.n_nodes     = shape.n_nodes();
    face.orientation = backwards ? 1. : -1.;
    face.diameter    = 1.;

    // number in the grid of all facets and parametric position of a node
    const auto grid_number =
      [&](const unsigned int facet, const unsigned int j, const bool reversed) {
        const unsigned int i = reversed ? p - j % n : j % n;
        return (facet % 3) * p + i + ((facet / 3) * p + j / n) * (3 * p + 1);
      };
    const auto position =
      [&](const unsigned int facet, const unsigned int j, const bool reversed) {
        Point<dim> x;
        x[0] = double(facet % 3) - 1. +
               (reversed ? 1. - shape.node(j)[0] : shape.node(j)[0]);
        if (dim == 3)
          x[1] = double(facet / 3) - 1. + shape.node(j)[dim - 2];
        return x;
      };
    std::map<unsigned int, unsigned int> stencil;
    const unsigned int                   middle = n_facets / 2;
    for (unsigned int j = 0; j < face.n_nodes; ++j)
      {
        stencil[grid_number(middle, j, backwards)] = j;
        face.reference_positions.push_back(position(middle, j, backwards));
      }
    if (!smoothed)
      return face;

    face.nodal_normals.resize(face.n_nodes);
    FaceShapeValues<dim> values;
    for (unsigned int j = 0; j < face.n_nodes; ++j)
      for (unsigned int facet = 0; facet < n_facets; ++facet)
        for (unsigned int k = 0; k < face.n_nodes; ++k)
          {
            const bool reversed =
              facet == middle ? backwards : facet == middle + 1;
            if (grid_number(facet, k, reversed) !=
                grid_number(middle, j, backwards))
              continue;
            shape.evaluate(shape.node(k), values);
            NormalContribution<dim> contribution;
            contribution.orientation = reversed ? 1. : -1.;
            for (unsigned int l = 0; l < face.n_nodes; ++l)
              {
                const auto [entry, is_new] =
                  stencil.emplace(grid_number(facet, l, reversed),
                                  face.reference_positions.size());
                if (is_new)
                  face.reference_positions.push_back(
                    position(facet, l, reversed));
                contribution.nodes.push_back(entry->second);
                contribution.gradients.push_back(values.gradient[l]);
              }
            face.nodal_normals[j].push_back(contribution);
          }
    return face;
  }



  enum class Place
  {
    interior,
    edge, // 3D: one direction is free
    corner
  };



  /// What follows the unknowns.
  struct Live
  {
    bool geometry  = true;
    bool threshold = true;
    bool status    = true;
  };



  struct Setting
  {
    Live          live;
    ThresholdKind threshold = ThresholdKind::augmented; // if live
    bool          friction  = true;
    bool          closed    = false; // if the status is frozen
    LawRounding   rounding  = {};
  };



  template <int dim>
  struct Wanted
  {
    std::string        name;
    double             gap, slip, lambda_n;
    bool               closed, stick;
    Tensor<1, dim - 1> Lambda;
  };



  /// A slave face, a master face and one contact point, with all unknowns in
  /// one vector: slave nodes, master stencil, multipliers.
  template <int dim>
  class PointProblem
  {
  public:
    PointProblem(const unsigned int degree,
                 const bool         smoothed,
                 const Place        place)
      : shape(degree)
      , master(make_master<dim>(shape, smoothed))
      , place(place)
    {
      point.geometry.weight = 0.37;
      Point<dim - 1> eta;
      eta[0] = 0.65;
      if (dim == 3)
        eta[dim - 2] = 0.3;
      shape.evaluate(eta, slave_shape);
      for (unsigned int j = 0; j < shape.n_nodes(); ++j)
        {
          point.geometry.direction_gradients.push_back(
            0.9 * slave_shape.gradient[j][0] +
            0.3 * slave_shape.gradient[j][dim - 2]);
          Tensor<2, dim - 1> rotation;
          const double       angle = dim == 3 ? 0.1 + 0.2 * j : 0.;
          rotation[0][0] = rotation[dim - 2][dim - 2] = std::cos(angle);
          if (dim == 3)
            {
              rotation[0][dim - 2] = -std::sin(angle);
              rotation[dim - 2][0] = std::sin(angle);
            }
          point.nodal_rotations.push_back(rotation);
        }
      const auto bumpy = [&](const double amplitude) {
        std::vector<Tensor<1, dim>> x;
        for (const auto &X : master.reference_positions)
          {
            x.emplace_back(X);
            for (unsigned int c = 0; c < dim; ++c)
              x.back()[c] += amplitude * random_number();
          }
        return x;
      };
      const double amplitude = degree == 1 ? 0.08 : 0.03;
      old_master.positions   = bumpy(amplitude);
      master_now             = bumpy(amplitude);
    }

    /// Places the slave such that the point has the wanted state.
    void
    set_state(const Wanted<dim> &wanted)
    {
      Point<dim - 1> xi;
      xi[0] = place == Place::interior ? 0.6 : 1.;
      if (dim == 3)
        xi[dim - 2] = place == Place::corner ? 1. : 0.35;
      MasterConfiguration<dim> configuration{master_now, {}};
      update_nodal_normals(master, configuration);
      MasterPoint<dim> now, old;
      evaluate_master_point(master, configuration, shape, xi, now);
      evaluate_master_point(master, old_master, shape, xi, old);
      Tensor<1, dim> x = now.x + wanted.gap * now.n;
      // beyond the edges, but where the normal gap stays the same
      if (place != Place::interior)
        {
          Tensor<1, dim> outward = now.a[0];
          if (dim == 3)
            outward -= (now.a[0] * now.a[dim - 2]) /
                       now.a[dim - 2].norm_square() * now.a[dim - 2] *
                       (place == Place::edge ? 1. : -1.);
          x += 0.04 * (outward - (outward * now.n) * now.n) / outward.norm();
        }
      Tensor<1, dim> along = now.a[0] - (now.a[0] * now.n) * now.n;
      along /= along.norm();
      const Tensor<1, dim> x_old =
        x - (now.x - old.x) - wanted.slip * along - 0.013 * now.n;

      const auto scatter = [&](const Tensor<1, dim>        &at,
                               std::vector<Tensor<1, dim>> &nodes) {
        nodes.assign(shape.n_nodes(), Tensor<1, dim>());
        Tensor<1, dim> centre;
        for (unsigned int j = 0; j < nodes.size(); ++j)
          {
            nodes[j][0] = 0.7 * shape.node(j)[0];
            if (dim == 3)
              nodes[j][1] = -0.8 * shape.node(j)[dim - 2];
            for (unsigned int c = 0; c < dim; ++c)
              nodes[j][c] += 0.05 * random_number();
            centre += slave_shape.value[j] * nodes[j];
          }
        for (auto &node : nodes)
          node += at - centre;
      };
      std::vector<Tensor<1, dim>> slave_now;
      scatter(x, slave_now);
      scatter(x_old, slave_old);

      q.clear();
      for (const auto &node : slave_now)
        for (unsigned int c = 0; c < dim; ++c)
          q.push_back(node[c]);
      for (const auto &node : master_now)
        for (unsigned int c = 0; c < dim; ++c)
          q.push_back(node[c]);
      first_multiplier = q.size();
      for (unsigned int l = 0; l < shape.n_nodes(); ++l)
        {
          q.push_back(wanted.lambda_n * (1. + 0.2 * random_number()));
          for (unsigned int d = 0; d < dim - 1; ++d)
            q.push_back(wanted.Lambda[d] + 0.2 * random_number());
        }
      point.pairing = make_frame(q);
    }

    /// Projection and frame for the nodal values @p values.
    Pairing<dim>
    make_frame(const std::vector<double> &values)
    {
      read(values);
      const auto projection =
        place == Place::interior
          ? project_on_face(master, configuration, shape, slave.x, 0.01)
          : project_on_boundary_of_face(master, configuration, shape, slave.x);
      Pairing<dim> frame;
      frame.paired = projection.found;
      frame.xi     = projection.xi;
      frame.free   = projection.free;
      evaluate_master_point(
        master, configuration, shape, frame.xi, state.master);
      frame.n   = state.master.n;
      frame.tau = tangent_basis<dim>(frame.n, slave.direction);
      return frame;
    }

    ContactElement<dim>
    evaluate(const std::vector<double> &values,
             const Setting             &setting,
             const bool                 differentiate)
    {
      const Pairing<dim> frame =
        setting.live.geometry ? make_frame(values) : point.pairing;
      read(values);
      MasterPoint<dim> old;
      evaluate_master_point(
        master, configuration, shape, frame.xi, state.master);
      evaluate_master_point(master, old_master, shape, frame.xi, old);
      evaluate_contact_kinematics(frame,
                                  state.master,
                                  old,
                                  slave,
                                  !configuration.nodal_normals.empty(),
                                  setting.live.geometry,
                                  differentiate,
                                  state.kinematics);
      const Tensor<2, dim> projector =
        restrain_slip(point.restrained.directions,
                      differentiate,
                      state.kinematics);
      ContactElement<dim> element{point,
                                  slave_shape.value,
                                  slave_shape.value,
                                  setting.friction ? dim : 1u,
                                  &master,
                                  &configuration};
      std::vector<double> nodal;
      for (unsigned int i = first_multiplier; i < values.size(); ++i)
        if (setting.friction || (i - first_multiplier) % dim == 0)
          nodal.push_back(values[i]);
      state.multipliers   = interpolate_multipliers(element, nodal);
      state.status.closed = setting.live.status
                              ? is_closed(state.multipliers.lambda_n,
                                          state.kinematics.d_n,
                                          point.regularization)
                              : setting.closed;
      state.status.stick =
        (state.status.closed || setting.rounding.acts()) &&
        is_stick(tangential_vector<dim>(state.multipliers.Lambda,
                                        state.kinematics.tau),
                 state.kinematics.d_t,
                 point.regularization);
      PointLaw law;
      law.r              = point.regularization;
      law.open_row       = point.scales.open_row;
      law.threshold.kind = !setting.friction        ? ThresholdKind::none
                           : setting.live.threshold ? setting.threshold
                                                    : ThresholdKind::given;
      law.threshold.friction_coefficient = 0.4;
      law.threshold.given                = 0.9;
      law.rounding                       = setting.rounding;
      evaluate_contact_law(law,
                           state.kinematics,
                           state.multipliers,
                           state.status,
                           differentiate,
                           state.response);
      restrain_Lambda(state.kinematics,
                      state.multipliers,
                      projector,
                      point.restrained.Lambda,
                      law.r.r_t_law,
                      differentiate,
                      state.response);
      return element;
    }

    Vector<double>
    residual(const std::vector<double> &values, const Setting &setting)
    {
      const auto     element = evaluate(values, setting, false);
      Vector<double> local(element.n_dofs());
      local_residual(element, state, local);
      return local;
    }

    FullMatrix<double>
    tangent(const Setting &setting)
    {
      const auto         element = evaluate(q, setting, true);
      const unsigned int n       = element.n_dofs();
      FullMatrix<double> local(n, n);
      local_tangent(element,
                    state,
                    setting.live.geometry &&
                      !configuration.nodal_normals.empty(),
                    local);
      return local;
    }

    /// The potential with the threshold held fixed and one parameter each.
    double
    potential(const std::vector<double> &values, const Setting &setting)
    {
      evaluate(values, setting, false);
      const Regularization &r   = point.regularization;
      const auto           &k   = state.kinematics;
      const double          lam = state.multipliers.lambda_n;
      const double          g_n = lam - r.r_n_augmentation * k.d_n;
      double phi = ((state.status.closed ? g_n * g_n : 0.) - lam * lam) /
                   (2. * r.r_n_augmentation);
      if (setting.friction)
        {
          const double Lambda_square = state.multipliers.Lambda.norm_square();
          const double g =
            (tangential_vector<dim>(state.multipliers.Lambda, k.tau) +
             r.r_t_augmentation * k.d_t)
              .norm();
          if (state.status.closed)
            phi += state.response.threshold / (2. * r.r_t_augmentation) *
                   ((state.status.stick ? g * g : 2. * g - 1.) - Lambda_square);
          else
            phi -= 0.5 * point.scales.open_row * Lambda_square;
        }
      return point.geometry.weight * phi;
    }

    /// Number of the unknown in q of the local unknown @p i.
    unsigned int
    unknown(const unsigned int i, const Setting &setting) const
    {
      return setting.friction || i < first_multiplier
               ? i
               : first_multiplier + (i - first_multiplier) * dim;
    }

    const FaceShape<dim>        shape;
    SurfaceFace<dim>            master;
    const Place                 place;
    FaceShapeValues<dim>        slave_shape;
    ContactPoint<dim>           point;
    MasterConfiguration<dim>    old_master, configuration;
    std::vector<Tensor<1, dim>> master_now, slave_old;
    std::vector<double>         q;
    unsigned int                first_multiplier = 0;
    SlavePosition<dim>          slave;
    ContactEvaluation<dim>      state;

    void
    read(const std::vector<double> &values)
    {
      const unsigned int n_slave = shape.n_nodes();
      slave                      = SlavePosition<dim>();
      slave.gap_offset           = 0.005;
      for (unsigned int j = 0; j < n_slave; ++j)
        for (unsigned int c = 0; c < dim; ++c)
          {
            const double x = values[j * dim + c];
            slave.x[c] += slave_shape.value[j] * x;
            slave.x_old[c] += slave_shape.value[j] * slave_old[j][c];
            slave.direction[c] += point.geometry.direction_gradients[j] * x;
          }
      configuration.positions.resize(master.n_stencil_nodes());
      for (unsigned int j = 0; j < master.n_stencil_nodes(); ++j)
        for (unsigned int c = 0; c < dim; ++c)
          configuration.positions[j][c] = values[(n_slave + j) * dim + c];
      update_nodal_normals(master, configuration);
    }
  };
} // namespace contact_test

#endif
