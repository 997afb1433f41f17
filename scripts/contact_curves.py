"""Slave surfaces of 2D bodies as curves: the faces in their order, open or closed."""
import numpy as np
import vtk
from vtk.util.numpy_support import vtk_to_numpy


class Curve:
    """
    A connected part of the slave surface of one pair: rows of points in their order
    (a face has points of its own, so that its ends may differ from its neighbours').
    """

    def __init__(self, pair, lines, positions, is_closed):
        self.pair = pair
        self.lines = lines  # (n, 2) numbers of points, each line in the sense of the curve
        self.is_closed = is_closed
        ends = positions[lines]
        lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
        stops = np.cumsum(lengths)
        self.arc_length = np.column_stack([stops - lengths, stops])

        # an open curve that goes along an axis is drawn over that axis
        steps = ends[:, 1] - ends[:, 0]
        axis = int(np.argmax(np.abs(steps.sum(axis=0))))
        signs = np.sign(steps[:, axis])
        self.axis = axis if not is_closed and (signs == signs[0]).all() and signs[0] != 0 else None

    def abscissa(self, current_positions):
        """(n, 2): of both ends of each line."""
        return self.arc_length if self.axis is None else current_positions[self.lines, self.axis]

    @property
    def abscissa_name(self):
        if self.axis is None:
            return "arc length, undeformed, from the dot" + (" (closed line)" if self.is_closed else "")
        return "xyz"[self.axis] + ", deformed"


def _merged_nodes(positions, lines):
    """Number of the node at each point: points of two faces at one place are one node."""
    tolerance = 1e-6 * max(np.ptp(positions, axis=0).max(), 1e-300)
    shortest = np.linalg.norm(positions[lines[:, 1]] - positions[lines[:, 0]], axis=1).min()
    tolerance = min(tolerance, 0.1 * shortest) if shortest > 0 else tolerance
    locator, merged = vtk.vtkPointLocator(), vtk.vtkPoints()
    locator.SetTolerance(tolerance)
    low, high = positions.min(axis=0) - tolerance, positions.max(axis=0) + tolerance
    locator.InitPointInsertion(merged, np.column_stack([low, high]).ravel())
    nodes, number = np.empty(len(positions), int), vtk.reference(0)
    for i, position in enumerate(positions):
        locator.InsertUniquePoint(position, number)
        nodes[i] = number.get()
    return nodes


def _walk(first, neighbours, unused):
    """Lines from a node on, [(line, is_reversed)]; uses them up."""
    chain, node = [], first
    while True:
        following = next(((line, other) for line, other in neighbours[node] if line in unused), None)
        if following is None:
            return chain, node
        line, other = following
        unused.discard(line)
        chain.append((line, other))
        node = other


def contact_curves(grid, weight):
    """
    The curves of a contact grid in its reference positions. `weight` at the points
    (the pressure, summed over the steps): a closed curve is cut open far from its centre.
    """
    positions = vtk_to_numpy(grid.GetPoints().GetData()).astype(float)
    all_lines = vtk_to_numpy(grid.GetCells().GetConnectivityArray()).reshape(-1, 2)
    pair_array = grid.GetPointData().GetArray("pair")
    pairs = np.rint(vtk_to_numpy(pair_array)).astype(int) if pair_array is not None else np.zeros(len(positions), int)

    curves = []
    for pair in np.unique(pairs):
        lines = all_lines[pairs[all_lines[:, 0]] == pair]
        if len(lines) == 0:
            continue
        node_of = _merged_nodes(positions, lines)
        neighbours = {}
        for i, (a, b) in enumerate(node_of[lines]):
            neighbours.setdefault(a, []).append((i, b))
            neighbours.setdefault(b, []).append((i, a))
        unused = set(range(len(lines)))
        ends = [node for node, around in neighbours.items() if len(around) == 1]
        while unused:
            start = next((node for node in ends if neighbours[node][0][0] in unused), None)
            is_closed = start is None
            if is_closed:
                start = _far_from_contact(positions, lines, node_of, sorted(unused), weight)
            chain, _ = _walk(start, neighbours, unused)
            oriented = [lines[i] if node_of[lines[i][1]] == other else lines[i][::-1] for i, other in chain]
            curves.append(Curve(int(pair), np.array(oriented), positions, is_closed))
    return curves


def _far_from_contact(positions, lines, node_of, candidates, weight):
    points = np.unique(lines[candidates])
    total = weight[points].sum()
    centre = (weight[points, None] * positions[points]).sum(axis=0) / total if total > 0 else positions[points].mean(axis=0)
    distance = np.linalg.norm(positions[points] - centre, axis=1)
    # all points of a circle with contact everywhere are as far: the lowest number of them
    return node_of[points[np.flatnonzero(distance >= distance.max() * (1 - 1e-6))[0]]]
