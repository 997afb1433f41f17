// Shared by tests: the mesh and the discrete problem of a case.

#ifndef stickslip_tests_case_problem_h
#define stickslip_tests_case_problem_h

#include <stickslip/base/parameter_file.h>

#include <stickslip/problem/contact_problem.h>

#include <stickslip/simulation/case_parameters.h>

#include <stickslip/solid/periodic_conditions.h>

#include <string>

namespace
{
  using namespace stickslip;

  struct TextParameters : CaseParameters
  {
    explicit TextParameters(const std::string &prm_text)
    {
      ParameterHandler prm;
      read(ParameterFile::from_string(prm_text, "test"), prm, MPI_COMM_WORLD);
    }
  };



  /// What a .prm describes, without time stepping and output. Collective.
  template <int dim>
  struct CaseProblem
  {
    explicit CaseProblem(const std::string &prm_text)
      : parameters(prm_text)
      , mesh(build_mesh<dim>(parameters.mesh,
                             parameters.bodies,
                             periodic_requests(parameters.boundary_conditions,
                                               dim),
                             MPI_COMM_WORLD))
      , problem(mesh,
                parameters.degree,
                parameters.materials,
                parameters.boundary_conditions,
                parameters.contact_pairs,
                false)
    {}

    const TextParameters parameters;
    Mesh<dim>            mesh;
    ContactProblem<dim>  problem;
  };
} // namespace

#endif
