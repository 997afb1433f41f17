"""Runs the input of kratos_input.py in the current directory; writes results.json.

To be run by a Python that has Kratos.
"""
import json
import resource

import KratosMultiphysics as kratos
import KratosMultiphysics.ContactStructuralMechanicsApplication as contact
from KratosMultiphysics.StructuralMechanicsApplication.structural_mechanics_analysis import StructuralMechanicsAnalysis


class Analysis(StructuralMechanicsAnalysis):
    def __init__(self, model, parameters):
        super().__init__(model, parameters)
        self.converged = True
        self.newton_iterations = 0

    def RunSolutionLoop(self):
        """Kratos goes on after a step that has not converged; this is to be known."""
        while self.KeepAdvancingSolutionLoop():
            self.time = self._AdvanceTime()
            self.InitializeSolutionStep()
            self._GetSolver().Predict()
            self.converged = self._GetSolver().SolveSolutionStep() and self.converged
            self.newton_iterations += self.model["Structure"].ProcessInfo[kratos.NL_ITERATION_NUMBER]
            self.FinalizeSolutionStep()
            self.OutputSolutionStep()


with open("ProjectParameters.json") as file:
    parameters = kratos.Parameters(file.read())
model = kratos.Model()
analysis = Analysis(model, parameters)
analysis.Run()

pressure = {node: node.GetValue(contact.AUGMENTED_NORMAL_CONTACT_PRESSURE) for node in model["Structure.flat"].Nodes}
closed = {node: -p for node, p in pressure.items() if node.Is(kratos.ACTIVE)}
origin = min(pressure, key=lambda node: node.X0**2 + node.Y0**2 + node.Z0**2)
largest = max(closed, key=closed.get)
results = {
    "converged": analysis.converged,
    "newton_iterations": analysis.newton_iterations,
    "force": sum(node.GetSolutionStepValue(kratos.REACTION_Z) for node in model["Structure.bottom"].Nodes),
    "pressure_at_origin": closed.get(origin, 0.0),
    "largest_pressure": closed[largest],
    "largest_at": [largest.X0, largest.Y0],
    "closed_nodes": len(closed),
    "peak_mebibytes": resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024,
}
with open("results.json", "w") as file:
    json.dump(results, file, indent=2)
    file.write("\n")
