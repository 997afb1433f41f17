#include <stickslip/simulation/run_output.h>

namespace stickslip
{
  template <int dim>
  RunOutput<dim>::RunOutput(const CaseParameters &parameters,
                            const Bodies         &bodies,
                            const MPI_Comm       &communicator)
    : parameters(parameters)
    , field_output(parameters.output, bodies, communicator)
    , contact_output(parameters.output, communicator)
    , tool_output(parameters.output, communicator)
    , point_values(parameters.output, bodies, communicator)
    , statistics(parameters.output.directory + "/statistics", communicator)
    , forces(parameters, communicator)
    , tables{&point_values.values_of_steps(),
             &forces.resultants(),
             &forces.reactions(),
             &statistics}
  {}



  template <int dim>
  void
  RunOutput<dim>::locate(const ContactProblem<dim> &problem)
  {
    point_values.locate(problem.layout().mapping, problem.layout().dof_handler);
  }



  template <int dim>
  void
  RunOutput<dim>::resume(const double time)
  {
    field_output.resume(time);
    contact_output.resume(time);
    tool_output.resume(time);
    point_values.resume(time);
    statistics.resume(time);
    forces.resume(time);
  }



  template <int dim>
  void
  RunOutput<dim>::write(const LoadStepping                        &steps,
                        ContactProblem<dim>                       &problem,
                        const std::vector<ContactFaceResult<dim>> &faces,
                        const NamedCellValues                     &cell_values)
  {
    const unsigned int        step         = steps.step_number();
    const double              time         = steps.time();
    const DofLayout<dim>     &layout       = problem.layout();
    const LA::Vector         &displacement = problem.ghosted_displacement();
    const MaterialFields<dim> material =
      material_fields(problem.solid(), displacement);
    if (parameters.output.is_written(step) || steps.finished())
      {
        field_output.write(step,
                           time,
                           layout.mapping,
                           layout.dof_handler,
                           displacement,
                           material,
                           cell_values);
        if (!parameters.contact_pairs.empty())
          contact_output.write(step, time, faces);
        tool_output.write(step,
                          time,
                          problem.contact().contact_pairs(),
                          displacement);
      }
    point_values.write(step, time, displacement, material, faces);
  }

  template class RunOutput<2>;
  template class RunOutput<3>;
} // namespace stickslip
