#ifndef stickslip_simulation_case_parameters_h
#define stickslip_simulation_case_parameters_h

#include <stickslip/adaptivity/adaptation_parameters.h>

#include <stickslip/base/amplitude.h>
#include <stickslip/base/parameter_file.h>

#include <stickslip/contact/cycling/status_cycle_treatment.h>
#include <stickslip/contact/point/automatic_contact.h>
#include <stickslip/contact/point/contact_parameters.h>

#include <stickslip/linear_solvers/linear_solver.h>

#include <stickslip/mesh/body_parameters.h>
#include <stickslip/mesh/mesh_parameters.h>
#include <stickslip/mesh/refinement_parameters.h>

#include <stickslip/output/output_parameters.h>

#include <stickslip/problem/automatic_pairs.h>
#include <stickslip/problem/verification.h>

#include <stickslip/simulation/checkpoint_description.h>
#include <stickslip/simulation/reference_checks.h>

#include <stickslip/solid/boundary_condition_parameters.h>
#include <stickslip/solid/material_parameters.h>

#include <stickslip/strategy/load_stepping.h>
#include <stickslip/strategy/solution_strategy.h>

#include <deal.II/base/parameter_handler.h>

#include <string>
#include <vector>

namespace stickslip
{
  /// A whole case as the .prm describes it.
  struct CaseParameters
  {
    std::string  title;
    unsigned int dimension    = 2;
    bool         axisymmetric = false;
    unsigned int degree       = 1;

    MeshParameters                         mesh;
    NamedList<BodyParameters>              bodies;
    NamedList<RefinementParameters>        refinement;
    AdaptationParameters                   adaptation;
    NamedList<MaterialParameters>          materials;
    NamedList<AmplitudeParameters>         amplitudes;
    NamedList<BoundaryConditionParameters> boundary_conditions;
    AutomaticContact                       automatic_contact;
    NamedList<ContactPairParameters>       contact_pairs;
    AlgorithmParameters                    algorithm;
    CyclingParameters                      cycling;
    VerificationParameters                 acceptance;
    LoadSteppingParameters                 load_stepping;
    LinearSolverParameters                 linear_solver;
    OutputParameters                       output;
    NamedList<ReferenceCheckParameters>    checks;

    /// Parameters of materials and contact pairs ("Materials/soft/Law") and
    /// their values: what a state depends on beside the mesh.
    ParameterValues physics;

    /// All values as a parameter file; for the record of a run.
    std::string record;

    CaseParameters() = default;

    // ParameterHandler keeps references to the members.
    CaseParameters(const CaseParameters &) = delete;

    /// Reads and checks a case, with the files of its materials. @p prm, empty
    /// before, then has all its parameters. Collective. Throws UserError, the
    /// same on all ranks.
    void
    read(const ParameterFile &file,
         ParameterHandler    &prm,
         const MPI_Comm       communicator);

    /// Everything that can be set, with placeholder names such as `<body>`.
    static void
    declare_all(CaseParameters &parameters, ParameterHandler &prm);

    /// Adds the pairs that the file does not name, and returns them. The
    /// ParameterHandler of read() must not be set afterwards. Collective.
    template <int dim>
    AutomaticPairs
    add_automatic_pairs(const Mesh<dim> &mesh);

    /// Reads the files of the amplitudes. Collective. Throws UserError.
    Amplitudes
    make_amplitudes(const MPI_Comm communicator) const;

    /// The rules of section `Refinement` with the surfaces that they name.
    std::vector<RefinementRequest>
    refinement_requests() const;

    /// What the distribution of the cells may weigh.
    std::vector<NamedSurface>
    slave_surfaces() const;

  private:
    /// Throws UserError that blames @p path if there is no such pair.
    const ContactPairParameters &
    pair_called(const std::string &name, const std::string &path) const;

    void
    add_parameters(ParameterHandler &prm);

    void
    check() const;
  };
} // namespace stickslip

#endif
