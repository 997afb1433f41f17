"""stickslip from Python: start runs, read results.

    import stickslip

    results = stickslip.run("case.prm", {"Mesh/Global refinements": 1}, ranks=2)
    results.resultants["base.force_y"]         # numpy array, a value per step
    results.statistics.pandas()                # if pandas is installed
    results.bodies.steps[-1].pyvista()         # if pyvista is installed; meshio(), vtk()

    stickslip.Results("results")               # of a run that has been made before

A thin layer over the program's files, which doc/results.md describes.
"""
from .convergence_log import Attempt, ConvergenceLog
from .errors import ParameterFileError, ResultsError, RunError, StickslipError
from .fields import FieldSeries, FieldStep, GridArrays
from .parameters import Parameters
from .results import Results
from .running import find_program, run
from .tables import Table

__all__ = ["Attempt", "ConvergenceLog", "FieldSeries", "FieldStep", "GridArrays", "ParameterFileError", "Parameters", "Results",
           "ResultsError", "RunError", "StickslipError", "Table", "find_program", "run"]
