// The assembled tangent of two bodies in contact against differences of the
// assembled residual, for all live/frozen combinations, on any number of ranks.

#include "print.h"

#include <stickslip/problem/contact_problem.h>

#include <deal.II/dofs/dof_tools.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iomanip>
#include <map>
#include <sstream>
#include <vector>

using namespace stickslip;

namespace
{
  struct Case
  {
    std::string  name;
    unsigned int degree;
    std::string  normals       = "facet";
    std::string  quadrature    = "nodal";
    std::string  friction      = "Coulomb";
    std::string  threshold     = "augmented";
    std::string  space         = "displacement trace";
    bool         hanging_nodes = false;
    bool         held_master   = false;      // its surface does not move
    std::string  weighting     = "standard"; // of segments
    unsigned int order         = 0;          // of segments
    bool         simplices     = false;
    bool         hanging_slave = false;     // one corner of the slave surface
    std::string  law           = "contact"; // Contact/<pair>/Law
    bool         corners       = false;     // two sides of the body are slaves
    bool         axisymmetric  = false;     // x is the radius
    bool         mixed         = false; // cells of the master: the other kind
    bool         symmetric     = false; // the bodies end at z = 0.1
  };



  std::string
  text_of(const double value)
  {
    std::ostringstream text;
    text << std::fixed << std::setprecision(5) << value;
    return text.str();
  }



  /// Two blocks with bumpy, non-matching surfaces; the upper one, the slave,
  /// hangs over on one side.
  template <int dim>
  Mesh<dim>
  make_mesh(const unsigned int degree,
            const bool         hanging_nodes,
            const bool         simplices_above,
            const bool         simplices_below,
            const bool         hanging_slave,
            const bool         axisymmetric,
            const bool         symmetric)
  {
    BodyParameters upper, lower;
    upper.generator = lower.generator = "subdivided_hyper_rectangle";
    if (dim == 2)
      {
        upper.arguments   = "5,2 : 0.1,1.1 : 1.52,2 : true";
        lower.arguments   = "4,2 : 0,0 : 1.5,1 : true";
        lower.coordinates = "x; y + 0.05*y*sin(3*x)";
        upper.coordinates = "x; y + 0.05*sin(3*x)";
      }
    else
      {
        upper.arguments = "3,1,2 : 0.1,1.1,0.1 : 1.52,2,0.95 : true";
        lower.arguments = "2,1,3 : 0,0,0 : 1.5,1,1 : true";
        if (symmetric) // both bodies
          lower.arguments = "2,1,3 : 0,0,0.1 : 1.5,1,1 : true";
        lower.coordinates = "x; y + 0.05*y*sin(3*x + 2*z); z";
        upper.coordinates = "x + 0.05*z; y + 0.05*sin(3*x + 2*z); z";
      }
    upper.simplices = simplices_above;
    lower.simplices = simplices_below;
    upper.material = lower.material = "rubber";
    MeshParameters parameters;
    parameters.degree = degree;
    parameters.goes_on_refined =
      hanging_nodes || hanging_slave; // refined below
    parameters.is_axisymmetric = axisymmetric;
    Mesh<dim>  mesh            = build_mesh<dim>(parameters,
                                     {{"upper", upper}, {"lower", lower}},
                                     {},
                                     MPI_COMM_WORLD);
    const auto is_refined      = [&](const Point<dim> &p) {
      return (hanging_nodes && p[0] < 0.5 && p[1] > 0.5 && p[1] < 1.5) ||
             (hanging_slave && p[0] < 0.5 && p[1] > 1.1 && p[dim - 1] < 1.6 &&
              (dim == 2 || p[dim - 1] < 0.5));
    };
    if (hanging_nodes || hanging_slave)
      {
        for (const auto &cell : mesh.triangulation->active_cell_iterators())
          if (cell->is_locally_owned() && is_refined(cell->center()))
            cell->set_refine_flag();
        mesh.triangulation->execute_coarsening_and_refinement();
      }
    return mesh;
  }



  NamedList<MaterialParameters>
  make_materials()
  {
    NamedList<MaterialParameters> materials(1);
    materials[0].first = "rubber";
    ParameterHandler prm;
    materials[0].second.choose_law("St Venant-Kirchhoff", "Materials/rubber");
    materials[0].second.add_parameters(prm);
    prm.set("Young's modulus", 10.);
    prm.set("Poisson's ratio", 0.3);
    return materials;
  }



  ContactPairParameters
  make_pair(const Case &c)
  {
    ContactPairParameters pair;
    pair.slave_body     = "upper";
    pair.slave_boundary = {"2"};
    if (c.corners)
      pair.slave_boundary = {"0", "1", "2"};
    pair.master_body          = "lower";
    pair.master_boundary      = {"3"};
    pair.law                  = value_of(c.law, all_pair_laws());
    pair.friction             = value_of(c.friction, all_frictions());
    pair.friction_coefficient = 0.4;
    pair.tresca_threshold     = 0.7;
    pair.threshold_form       = value_of(c.threshold, all_threshold_forms());
    pair.multiplier_space     = value_of(c.space, all_multiplier_spaces());
    pair.quadrature           = value_of(c.quadrature, all_contact_rules());
    // as many points as multipliers, at least
    pair.quadrature_order = c.space == "displacement trace" ? c.degree + 1 : 2;
    if (c.order > 0)
      pair.quadrature_order = c.order;
    pair.weighting     = value_of(c.weighting, all_weighting_functions());
    pair.normals       = value_of(c.normals, all_normals());
    pair.gap_offset    = "0.003*x";
    auto &r            = pair.regularization;
    r.scale            = RegularizationScale::plain;
    r.r_n_status       = "11";
    r.r_n_augmentation = "7";
    r.r_n_law          = "5";
    r.r_t_status       = "9";
    r.r_t_augmentation = "6";
    r.r_t_law          = "5";
    return pair;
  }



  /// Any states and directions, as smooth functions of the position.
  template <int dim>
  class States
  {
  public:
    States(ContactProblem<dim> &problem)
      : problem(problem)
    {
      DoFTools::map_dofs_to_support_points(problem.layout().mapping,
                                           problem.layout().dof_handler,
                                           points);
      IndexSet all(problem.layout().owned.size());
      for (unsigned int c = 0; c < dim; ++c)
        {
          const IndexSet dofs =
            DoFTools::extract_dofs(problem.layout().dof_handler,
                                   ComponentMask([&] {
                                     std::vector<bool> selected(dim, false);
                                     selected[c] = true;
                                     return selected;
                                   }()));
          for (const auto i : dofs)
            component[i] = c;
        }
    }

    /// The upper body moves by about @p motion against the lower one.
    LA::BlockVector
    state(const Tensor<1, dim> &motion, const double phase) const
    {
      LA::BlockVector x = problem.zero_state();
      for (const auto &[i, c] : component)
        {
          const Point<dim> &p = points.at(i);
          x.block(0)(i) =
            0.03 * std::sin(phase + 2. * p[0] + p[1] + 3. * p[dim - 1] + c) +
            (is_above_interface(p) ? motion[c] : 0.);
        }
      set_multipliers(x, [&](const Point<dim> &p, const unsigned int c) {
        return c == 0 ? -1. + 1.7 * std::sin(phase + 4. * p[0] + p[dim - 1])
                      : 0.5 * std::cos(phase + 5. * p[0] + 2. * c);
      });
      x.compress(VectorOperation::insert);
      problem.distribute(x);
      return x;
    }

    LA::BlockVector
    direction(const double k) const
    {
      LA::BlockVector v = problem.zero_state();
      for (const auto &[i, c] : component)
        {
          const Point<dim> &p = points.at(i);
          v.block(0)(i) =
            std::cos(k * (7. * p[0] - 5. * p[1] + 3. * p[dim - 1]) + 2. * c);
        }
      set_multipliers(v, [&](const Point<dim> &p, const unsigned int c) {
        return std::sin(k * (6. * p[0] + 2. * p[dim - 1]) + 3. * c + 0.5);
      });
      v.compress(VectorOperation::insert);
      return v;
    }

    /// A translation of everything.
    LA::BlockVector
    translation(const unsigned int c) const
    {
      LA::BlockVector v = problem.zero_state();
      for (const auto &[i, component_of_i] : component)
        v.block(0)(i) = component_of_i == c ? 1. : 0.;
      v.compress(VectorOperation::insert);
      return v;
    }

  private:
    ContactProblem<dim>                            &problem;
    std::map<types::global_dof_index, Point<dim>>   points;
    std::map<types::global_dof_index, unsigned int> component; ///< owned ones

    static bool
    is_above_interface(const Point<dim> &p)
    {
      const double phase = 3. * p[0] + (dim == 3 ? 2. * p[dim - 1] : 0.);
      return p[1] - 0.05 * std::sin(phase) > 1.05;
    }

    template <typename Formula>
    void
    set_multipliers(LA::BlockVector &x, const Formula &formula) const
    {
      const auto &contact = problem.contact();
      for (const auto &node : contact.multipliers().owned_nodes())
        for (unsigned int c = 0;
             c < contact.contact_pairs()[node.pair]->n_multiplier_components();
             ++c)
          x.block(1)(node.first_dof + c) = formula(points.at(node.key), c);
    }
  };



  /// Number of points that are unpaired, open, stick, slip.
  template <int dim>
  std::string
  count_states(ContactProblem<dim> &problem)
  {
    std::array<unsigned int, 5> n{};
    for (const auto &pair : problem.contact().contact_pairs())
      for (const auto &point : pair->points)
        {
          const auto &status = problem.contact().evaluate(*pair, point).status;
          if (!point.pairing.paired)
            ++n[0];
          else
            ++n[!status.closed ? 1 : status.stick ? 2 : 3];
          if (point.pairing.paired && !point.pairing.is_interior())
            ++n[4];
        }
    std::string text;
    for (const unsigned int count : n)
      text += " " + std::to_string(Utilities::MPI::sum(count, MPI_COMM_WORLD));
    return text;
  }



  /// Of the lambda_n rows: those of Lambda have a scale of their own.
  template <int dim>
  double
  norm_of_gaps(ContactProblem<dim> &problem, const LA::BlockVector &rhs)
  {
    double sum = 0.;
    for (const auto &node : problem.contact().multipliers().owned_nodes())
      sum += rhs.block(1)(node.first_dof) * rhs.block(1)(node.first_dof);
    return std::sqrt(Utilities::MPI::sum(sum, MPI_COMM_WORLD));
  }



  /// One where nothing is constrained, else zero: distribute() changes there
  /// what has no relation to the other entries.
  template <int dim>
  LA::BlockVector
  unconstrained(ContactProblem<dim> &problem)
  {
    LA::BlockVector before = problem.zero_state();
    for (unsigned int b = 0; b < 2; ++b)
      for (const auto i : before.block(b).locally_owned_elements())
        before.block(b)(i) = 2. + std::sin(1.7 * i + b); // not zero
    before.compress(VectorOperation::insert);
    LA::BlockVector free = before;
    problem.distribute(free);
    for (unsigned int b = 0; b < 2; ++b)
      for (const auto i : free.block(b).locally_owned_elements())
        free.block(b)(i) =
          std::abs(free.block(b)(i) - before.block(b)(i)) > 1e-10 ? 0. : 1.;
    free.compress(VectorOperation::insert);
    return free;
  }



  /// Zeroes what is constrained.
  void
  restrict_to(const LA::BlockVector &free, LA::BlockVector &x)
  {
    x.scale(free);
  }



  /// The threshold of each friction row of segments with a live one, else 1.
  template <int dim>
  LA::Vector
  thresholds_of_rows(ContactProblem<dim> &problem)
  {
    auto      &contact = problem.contact();
    LA::Vector result(problem.zero_state().block(1));
    result = 1.;
    for_each_point(contact, [&](const auto &pair, const auto &point) {
      const double s = contact.evaluate(pair, point).response.threshold;
      if (!pair.mortar || !contact.live.threshold || s <= 0.)
        return;
      const auto &dofs =
        pair.slave_faces[point.geometry.slave_face].multiplier_dofs;
      for (unsigned int c = 1; c < dim; ++c)
        result(dofs[point.geometry.quadrature_index * dim + c]) = s;
    });
    result.compress(VectorOperation::insert);
    return result;
  }



  /// Minus the residual. Newton's method sees the friction rows of segments
  /// divided by their threshold; here they are multiplied with @p thresholds
  /// again, which belong to another state.
  template <int dim>
  LA::BlockVector
  rows_with(const LA::Vector &thresholds, ContactProblem<dim> &problem)
  {
    LA::BlockVector  result  = problem.right_hand_side();
    const LA::Vector present = thresholds_of_rows(problem);
    LA::Vector      &rows    = result.block(1);
    for (const auto i : rows.locally_owned_elements())
      {
        const double row = rows(i);
        rows(i)          = row * thresholds(i) / present(i);
      }
    rows.compress(VectorOperation::insert);
    return result;
  }



  template <int dim>
  void
  test_case(const Case &c)
  {
    Mesh<dim>                              mesh = make_mesh<dim>(c.degree,
                                    c.hanging_nodes,
                                    c.simplices,
                                    c.simplices != c.mixed,
                                    c.hanging_slave,
                                    c.axisymmetric,
                                    c.symmetric);
    NamedList<BoundaryConditionParameters> conditions;
    if (c.held_master)
      {
        BoundaryConditionParameters held;
        held.body     = "lower";
        held.boundary = {"3"};
        held.value    = dim == 2 ? "0; 0" : "0; 0; 0";
        conditions.emplace_back("held", held);
      }
    for (const std::string body : {"upper", "lower"})
      if (c.symmetric)
        {
          BoundaryConditionParameters symmetry;
          symmetry.type     = BoundaryConditionType::symmetry;
          symmetry.body     = body;
          symmetry.boundary = {"4"};
          conditions.emplace_back("symmetry of " + body, symmetry);
        }
    ContactProblem<dim> problem(mesh,
                                c.degree,
                                make_materials(),
                                conditions,
                                {{"pair", make_pair(c)}},
                                false);
    Tensor<1, dim>      shear, more_shear;
    shear[0] = -0.03;
    shear[1] = -0.1;
    shear[dim - 1] += -0.02;
    more_shear[0] = 0.09;
    more_shear[1] = -0.13;

    problem.begin_step(0.5, problem.zero_state());
    problem.begin_iteration(problem.zero_state()); // the constraints
    const States<dim> states(problem);
    // the step starts from one state, quantities freeze in another
    problem.begin_step(1., states.state(shear, 0.2));
    const auto x_frozen = states.state(0.5 * (shear + more_shear), 0.5);
    const auto x        = states.state(more_shear, 0.6);

    LA::BlockVector       v    = states.direction(1.3);
    const LA::BlockVector free = unconstrained(problem);
    problem.distribute(v);
    LA::BlockVector v_free = v;
    restrict_to(free, v_free);

    const std::string name = std::to_string(dim) +
                             (c.simplices ? "D P" : "D Q") +
                             std::to_string(c.degree) +
                             (c.mixed ? " on the other kind, " : " ") + c.name;
    double       worst = 0.;
    const double h     = 2e-6;
    for (unsigned int combination = 0; combination < 8; ++combination)
      {
        const auto quantities = problem.quantities();
        for (FreezableQuantity *quantity : quantities)
          {
            quantity->set_live(true);
            quantity->evaluate(x_frozen);
            quantity->accept();
          }
        for (unsigned int i = 0; i < 3; ++i)
          quantities[i]->set_live((combination >> i) % 2 == 0);
        problem.begin_iteration(x);

        problem.assemble(x);
        LA::BlockVector product = problem.zero_state();
        problem.matrix().vmult(product, v_free);
        const LA::BlockVector rhs = problem.right_hand_side();
        if (combination == 0)
          {
            print(name + ": unpaired, open, stick, slip, on edges:" +
                  count_states(problem));
            print("  norm of the forces " + text_of(rhs.block(0).l2_norm()) +
                  ", of the gaps " + text_of(norm_of_gaps(problem, rhs)));
            problem.residual(x);
            LA::BlockVector sum = rhs;
            sum.block(0) += problem.nodal_forces();
            restrict_to(free, sum);
            // rows of what is constrained are no equations
            LA::BlockVector in_free_rows = rhs, product_there = product;
            restrict_to(free, in_free_rows);
            restrict_to(free, product_there);
            in_free_rows -= rhs;
            product_there -= product;
            print("  constrained rows are empty",
                  in_free_rows.linfty_norm() + product_there.linfty_norm() <
                    1e-12);
            print("  right hand side is minus the residual",
                  sum.block(0).linfty_norm() < 1e-12);
            double resultant = 0.;
            // radial forces balance whatever they are
            for (unsigned int d = c.axisymmetric ? 1 : 0; d < dim; ++d)
              resultant = std::max(resultant,
                                   std::abs(states.translation(d).block(0) *
                                            problem.nodal_forces()));
            print("  forces balance", resultant < 1e-12);
          }

        const LA::Vector thresholds = thresholds_of_rows(problem);
        LA::BlockVector  displaced  = x;
        displaced.add(-h, v);
        problem.assemble(displaced);
        LA::BlockVector difference = rows_with(thresholds, problem);
        displaced.add(2. * h, v);
        problem.assemble(displaced);
        difference -= rows_with(thresholds, problem);
        difference /= 2. * h;
        difference -= product;
        restrict_to(free, difference);
        restrict_to(free, product);
        for (unsigned int b = 0; b < 2; ++b)
          worst = std::max(worst,
                           difference.block(b).linfty_norm() /
                             product.block(b).linfty_norm());
      }
    print("  tangents within 1e-7 of differences: " +
          (worst < 1e-7 ? std::string("yes") : "NO, " + std::to_string(worst)));
  }



  /// The derivative of the integrals is that of what the rule makes of them up
  /// to the error of the rule: with many points none of them is seen.
  template <int dim>
  void
  test_segments()
  {
    for (const unsigned int degree : {1, 2})
      for (const std::string weighting : {"standard", "dual"})
        if (dim == 2 || degree == 1)
          {
            Case c{"segments " + weighting, degree, "smoothed", "segments"};
            c.weighting = weighting;
            c.order     = dim == 2 ? 8 : 7;
            test_case<dim>(c);
          }
    Case c{"segments vertices", 2, "smoothed", "segments", "Coulomb"};
    c.space     = "vertices";
    c.weighting = "dual";
    c.order     = dim == 2 ? 8 : 7;
    test_case<dim>(c);
    c.name     = "segments frictionless";
    c.degree   = 1;
    c.space    = "displacement trace";
    c.friction = "none";
    test_case<dim>(c);
  }



  /// Faces of different levels, on both sides. In 3D slave nodes hang, whose
  /// multipliers others take over.
  template <int dim>
  void
  test_hanging_nodes()
  {
    const auto test = [](const unsigned int degree,
                         const std::string &quadrature,
                         const std::string &weighting,
                         const std::string &space) {
      Case c{"hanging nodes " + quadrature + " " + weighting + " " + space,
             degree,
             "smoothed",
             quadrature};
      c.hanging_nodes = c.hanging_slave = true;
      c.weighting                       = weighting;
      c.space                           = space;
      if (dim == 3 && quadrature == "Gauss")
        c.friction = "none"; // not available on these slave surfaces
      c.order = quadrature == "segments" ? (dim == 2 ? 8 : 7) : 0;
      test_case<dim>(c);
    };
    for (const std::string weighting : {"standard", "dual"})
      test(1, "segments", weighting, "displacement trace");
    test(2, "segments", "dual", "vertices");
    if (dim == 2)
      test(2, "segments", "dual", "displacement trace");
    test(1, "nodal", "standard", "displacement trace");
    test(2, "nodal", "standard", "displacement trace");
    test(2, "Gauss", "standard", "vertices");
  }



  /// Triangles and tetrahedra.
  template <int dim>
  void
  test_simplices()
  {
    for (const unsigned int degree : {1, 2})
      {
        const auto test = [degree](const std::string &normals,
                                   const std::string &quadrature) {
          Case c{normals + " " + quadrature, degree, normals, quadrature};
          c.space     = dim == 3 && degree == 2 ? "vertices" : "automatic";
          c.order     = quadrature == "segments" ? (dim == 2 ? 8 : 7) : 3;
          c.weighting = "dual";
          c.simplices = true;
          test_case<dim>(c);
        };
        if (dim == 2 || degree == 1)
          test("smoothed", "nodal");
        test("facet", "Gauss");
        test("smoothed", "Gauss");
        test("smoothed", "segments");
      }
  }



  /// Triangles and tetrahedra against quadrilaterals and hexahedra.
  template <int dim>
  void
  test_mixed_cells()
  {
    for (const bool simplices : {true, false})
      for (const unsigned int degree : {1, 2})
        {
          const auto test = [&](const std::string &quadrature,
                                const bool         corners = false) {
            Case c{quadrature, degree, "smoothed", quadrature};
            c.space     = degree == 2 ? "vertices" : "displacement trace";
            c.order     = quadrature == "segments" ? (dim == 2 ? 8 : 7) : 3;
            c.weighting = "dual";
            c.simplices = simplices;
            c.mixed     = true;
            c.corners   = corners;
            if (corners)
              c.name += " around corners";
            test_case<dim>(c);
          };
          if (degree == 1)
            test("nodal");
          test("Gauss");
          test("segments");
          if (degree == 1)
            test("segments", true);
        }
  }



  /// Slave surfaces with edges of 90 degrees, where the normal is the master's.
  template <int dim>
  void
  test_corners()
  {
    for (const unsigned int degree : {1, 2})
      {
        Case c{"segments around corners", degree, "smoothed", "segments"};
        c.space     = degree == 2 ? "vertices" : "displacement trace";
        c.weighting = "dual";
        c.order     = dim == 2 ? 8 : 7;
        c.corners   = true;
        if (dim == 2 || degree == 1)
          test_case<dim>(c);
        // a threshold that changes scales the rows of held slips, too, which
        // the tangent leaves out: they are zero in the end
        c.symmetric = true;
        c.friction  = "Tresca";
        c.name += " at a symmetry plane";
        if (dim == 3 && degree == 1)
          test_case<dim>(c);
      }
  }



  /// Pairs that cannot part.
  template <int dim>
  void
  test_bilateral()
  {
    for (const std::string law : {"tied", "no separation"})
      for (const unsigned int degree : {1, 2})
        if (dim == 2 || degree == 1)
          {
            Case c{law, degree, "smoothed", "segments", "none"};
            c.weighting = "dual";
            c.law       = law;
            test_case<dim>(c);
          }
  }



  /// Sections of bodies of revolution: areas grow with the radius, slave and
  /// master have their own.
  void
  test_axisymmetry()
  {
    const auto test = [](Case c) {
      c.axisymmetric = true;
      c.name += ", axisymmetric";
      if (c.quadrature == "segments")
        {
          c.order     = 8;
          c.weighting = "dual";
        }
      test_case<2>(c);
    };
    for (const unsigned int degree : {1, 2})
      {
        test({"nodal", degree, "smoothed"});
        test({"Gauss", degree, "facet", "Gauss"});
        test({"segments", degree, "smoothed", "segments"});
      }
    Case c{"P2-P1 segments", 2, "smoothed", "segments"};
    c.space = "vertices";
    test(c);
    c           = {"segments", 2, "smoothed", "segments"};
    c.simplices = true;
    c.space     = "automatic";
    test(c);
    c         = {"segments around corners", 1, "smoothed", "segments"};
    c.corners = true;
    test(c);
    c     = {"tied", 1, "smoothed", "segments", "none"};
    c.law = "tied";
    test(c);
  }



  template <int dim>
  void
  test_all()
  {
    for (const unsigned int degree : {1, 2})
      for (const std::string normals : {"facet", "smoothed"})
        {
          test_case<dim>({normals + " nodal", degree, normals});
          if (dim == 2 || degree == 1)
            test_case<dim>({normals + " Gauss", degree, normals, "Gauss"});
        }
    if (dim == 2)
      {
        test_case<dim>(
          {"plain threshold", 1, "facet", "Gauss", "Coulomb", "plain"});
        test_case<dim>({"Tresca", 1, "facet", "nodal", "Tresca"});
        test_case<dim>({"frictionless", 1, "facet", "nodal", "none"});
      }
    test_case<dim>(
      {"vertices", 2, "facet", "Gauss", "Coulomb", "augmented", "vertices"});
    for (const unsigned int degree : {1, 2})
      if (dim == 2 || degree == 1)
        {
          Case c{"hanging nodes", degree, "smoothed", "Gauss"};
          c.hanging_nodes = true;
          test_case<dim>(c);
          c.name        = "hanging nodes on a held master";
          c.held_master = true;
          test_case<dim>(c);
        }
    test_segments<dim>();
    test_hanging_nodes<dim>();
    Case c{"held master", 1};
    c.held_master = true;
    test_case<dim>(c);
  }
} // namespace



int
main(int argc, char **argv)
{
  Utilities::MPI::MPI_InitFinalize mpi(argc, argv, 1);
  test_all<2>();
  test_all<3>();
  test_simplices<2>();
  test_simplices<3>();
  test_bilateral<2>();
  test_corners<2>();
  test_corners<3>();
  test_bilateral<3>();
  test_axisymmetry();
  test_mixed_cells<2>();
  test_mixed_cells<3>();
}
