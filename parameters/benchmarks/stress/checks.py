"""What is wrong with the results of a finished problem: statics, contact law, energy, closed forms.

violations(case, result) yields a line per violation. It reads the tables of the
run only, and knows the loads from the case (StaticCase in more_problems.py).
"""
import math

# Of forces, over the largest one of the run. GNM solves to 1e-8 of loads or reactions; loops of fixed
# points end where their last change is 1e-6, and may leave a residual of 1e-3 with nothing frozen.
FORCE_TOLERANCE, LOOP_TOLERANCE = 1e-5, 1e-3
# Of overlaps over the size of a cell, of pressures and tractions over the largest pressure. The nodal
# rule satisfies the contact law at each point, the others in the mean of a face.
POINT_TOLERANCE, WEAK_TOLERANCE, MEAN_TOLERANCE = 1e-5, 0.25, 0.05
# Works are sums over the steps (trapezoidal rule).
WORK_TOLERANCE = 0.02
AXES = "xyz"


class Row:
    """All tables at the end of one step: row["hand.force_x"]."""

    def __init__(self, values, pairs):
        self.values, self.pairs = values, pairs

    def __getitem__(self, name):
        return self.values[name]

    def force_on(self, body, axis, other=None):
        """Of contact, with all other bodies or with one."""
        return sum(self.share(pair, body, other) * self.values[f"{pair}.force_{axis}"] for pair in self.pairs)

    def moment_on(self, body, axis):
        """Of contact, about the origin."""
        return sum(self.share(pair, body, None) * self.values[f"{pair}.moment_{axis}"] for pair in self.pairs)

    def share(self, pair, body, other):
        """1 if the body is the slave of the pair, -1 if it is the master."""
        slave, master = self.pairs[pair]
        if other is not None and {slave, master} != {body, other}:
            return 0
        return (slave == body) - (master == body)


def rows_of(case, result):
    tables = {name: result.table(name) for name in ("statistics.csv", "resultants.csv", "reactions.csv", "points.csv")
              if (result.directory / name).exists()}
    names = {column.split(".")[0] for column in tables.get("resultants.csv", {}) if "." in column}
    # The names that the program finds for pairs have no spaces.
    pairs = {f"{slave} on {master}".replace(" ", "_" if case.automatic else " "): (slave, master)
             for slave in case.bodies for master in case.bodies}
    pairs = {name: bodies for name, bodies in pairs.items() if name in names}
    assert len(pairs) == len(names), f"pairs of unknown bodies among {names}"
    for step in range(len(tables["statistics.csv"]["time"])):
        yield Row({name: column[step] for table in tables.values() for name, column in table.items()}, pairs)


def unbalanced(case, row, body, axis):
    """Sum of all forces on a body, and the largest of them."""
    i = AXES.index(axis)
    forces = [row.force_on(body, axis)]
    forces += [load[i](row["time"]) for name, load in case.loads if name == body]
    for name, condition in case.conditions.items():
        # A tool under force is driven by its force; what its other components exert is a reaction.
        if condition["Body"] == body and f"{name}.force_{axis}" in row.values:
            if "free" in condition.get("Translation", "").split("; ")[i:i + 1]:
                continue
            forces.append(row[f"{name}.force_{axis}"])
    for name, stiffness, points in case.point_springs:
        if name == body:
            forces.append(-stiffness[i] * sum(area * row[f"{point}_{axis}"] for point, area in points))
    for name, condition, stiffness in case.tool_springs:
        if name == body:
            forces.append(-stiffness[i] * row[f"{condition}.displacement_{axis}"])
    return sum(forces), max(map(abs, forces))


def is_held_in_place(case, body):
    """A rigid body without a condition: whatever holds it is in no table."""
    return "Rigid" in case.bodies[body] and not any(c["Body"] == body for c in case.conditions.values())


def violations_of_statics(case, rows):
    axes = AXES[:case.dim]
    balances = [(row, body, axis, *unbalanced(case, row, body, axis)) for row in rows
                for body in case.bodies if not is_held_in_place(case, body) for axis in axes]
    largest = max(balance[4] for balance in balances)
    for row, body, axis, force, _ in balances:
        if not abs(force) <= (FORCE_TOLERANCE if row["algorithm"] == "GNM" else LOOP_TOLERANCE) * largest:
            yield (f"t = {row['time']:.4g}: the forces on '{body}' along {axis} add up to {force:.3g}; "
                   f"the largest of the run is {largest:.3g}")
            break
    for body, other, time in case.touching:
        for row in rows:
            force = math.hypot(*(row.force_on(body, axis, other) for axis in axes))
            if row["time"] < time - 1e-9 and force > FORCE_TOLERANCE * largest:
                yield f"t = {row['time']:.4g}: '{body}' and '{other}' are apart, the force between them is {force:.3g}"
                break
        # Half a step later they press.
        last = math.hypot(*(rows[-1].force_on(body, axis, other) for axis in axes))
        if rows[-1]["time"] > time and not last > FORCE_TOLERANCE * largest:
            yield f"'{body}' and '{other}' should press on each other at the end"
    for name, function, tolerance in case.closed_forms:
        errors = [function(row) for row in rows]
        if not max(map(abs, errors)) <= tolerance:
            yield f"{name}: off by {max(errors, key=abs):.3g}"
    if not all(math.isfinite(value) for row in rows for value in row.values.values() if isinstance(value, float)):
        yield "not all results are finite"


def violations_of_contact(case, rows, result, rule):
    nodal = not case.automatic and rule == "nodal" and case.degree == 1
    tolerance = POINT_TOLERANCE if nodal else WEAK_TOLERANCE
    for row in rows:
        for pair in row.pairs:
            normal, friction = (math.hypot(*(row[f"{pair}.{part}_force_{axis}"] for axis in AXES[:case.dim])) for part in ("normal", "friction"))
            # On a curved surface normal forces cancel in part; the points say more (below).
            if case.friction == 0 and friction > FORCE_TOLERANCE * max(normal, 1e-12):
                yield f"t = {row['time']:.4g}: friction {friction:.3g} in '{pair}', which has none"
                return
    tables = sorted(result.directory.glob("contact_points-*.csv"))
    if not tables:
        yield "no table of contact points"
        return
    points = result.table(tables[-1].name)
    number = len(points["pressure"])
    largest = max(max(map(abs, points["pressure"])), 1e-300)
    size = max(points["reference_weight"]) ** (1 / (case.dim - 1))
    for k in range(number):
        if points["status"][k] in (0, 5):
            continue
        gap, pressure = points["gap"][k], points["pressure"][k]
        traction = math.hypot(*(points[f"tangential_traction_{axis}"][k] for axis in AXES[:case.dim]))
        if not gap >= -tolerance * size:
            yield f"a point overlaps by {-gap:.3g}, with cells of {size:.3g}"
            return
        if not pressure >= -tolerance * largest:
            yield f"a point pulls with {-pressure:.3g}; the largest pressure is {largest:.3g}"
            return
        if not traction <= case.friction * max(pressure, 0) + tolerance * max(case.friction, FORCE_TOLERANCE) * largest:
            yield f"a traction of {traction:.3g} is beyond the cone of a pressure of {pressure:.3g}"
            return
    closed = [k for k in range(number) if points["status"][k] in (2, 3, 4)]
    area = sum(points["reference_weight"][k] for k in closed)
    overlap = sum(points["reference_weight"][k] * max(-points["gap"][k], 0) for k in closed)
    if not overlap <= MEAN_TOLERANCE * size * area:
        yield f"closed points overlap by {overlap / area:.3g} in the mean, with cells of {size:.3g}"


def violations_of_energy(rows):
    """Stored energy is what the loads have done less what friction has dissipated; it cannot be negative."""
    scale = max(max(abs(row["external_work"]), row["friction_work"]) for row in rows)
    dissipated = 0.0
    for row in rows:
        if not row["friction_work"] >= dissipated - 1e-6 * scale:
            yield f"t = {row['time']:.4g}: friction gives back work"
            return
        dissipated = row["friction_work"]
        if not row["external_work"] >= dissipated - WORK_TOLERANCE * scale:
            yield f"t = {row['time']:.4g}: the loads' work {row['external_work']:.3g} is less than friction dissipates, {dissipated:.3g}"
            return


def violations(case, result, rule=None):
    """RULE: the contact rule of all pairs, if it is another one than the case's."""
    rows = list(rows_of(case, result))
    yield from violations_of_statics(case, rows)
    yield from violations_of_contact(case, rows, result, rule or case.rule)
    yield from violations_of_energy(rows)
