"""Further random problems, with numbers of their own: gaps that close, thin parts, several bodies, tools under force.

As in problems.py a family is a function that fills a case. A case also knows
what statics says about it: the loads on each body, what its springs take, when
a gap closes, so that checks.py can tell a wrong result from a right one. Each
problem draws its numbers from a generator of its own.
"""
import math
import random

from problems import Case, lines, number, uniform

FIRST = 200
ELASTIC = ("St Venant-Kirchhoff", "neo-Hookean", "neo-Hookean", "Hencky", "hyperelastic", "linear elastic")
# For what corners dig into, and for what bends far.
ROBUST = ("neo-Hookean", "neo-Hookean", "Hencky")
PLASTIC = ("Simo-Miehe plasticity", "Hencky plasticity")


class Ramp:
    """From zero at START to VALUE at END, constant before and after: an expression and a function of t."""

    def __init__(self, value, start=0.0, end=1.0):
        self.value, self.start, self.end = value, start, end

    def __str__(self):
        if self.value == 0:
            return "0"
        return f"({number(self.value)})*min(max(t - {number(self.start)}, 0)/{number(self.end - self.start)}, 1)"

    def __call__(self, t):
        return self.value * min(max(t - self.start, 0.0) / (self.end - self.start), 1.0)


ZERO = Ramp(0.0)


class StaticCase(Case):
    """A case with its statics."""

    def __init__(self, rng, dim, automatic):
        super().__init__(rng, dim)
        self.automatic = automatic
        self.friction = rng.choice((0.0, 0.0, 0.1, 0.3, 0.5, 0.8))
        self.rule = rng.choice(("segments", "segments", "nodal", "Gauss", "default"))
        self.points = {}
        self.boxes = {}  # lower and upper corner and cells of the blocks
        self.loads = []  # (body, one Ramp per direction): dead loads
        self.point_springs = []  # (body, stiffness per direction, [(point, area)]): springs on a boundary
        self.tool_springs = []  # (body, condition, stiffness per direction)
        self.closed_forms = []  # (name, function of the tables at a step, tolerance): what has to be zero
        self.touching = []  # (body, other body, time of the first contact): before no force, afterwards some
        self.width = 1.0  # in z

    # ------------------------------------------------------------ ingredients
    def material(self, name, modulus, law=None):
        law = law or self.rng.choice(ELASTIC)
        nu = self.rng.choice((0.0, 0.2, 0.3, 0.4))
        if law == "hyperelastic":
            self.materials[name] = {"Law": law, "C10": modulus / (4 * (1 + nu)), "Poisson's ratio": nu}
        else:
            self.materials[name] = {"Law": law, "Young's modulus": modulus, "Poisson's ratio": nu}

    def plastic_or_elastic(self, name, modulus, laws=ROBUST):
        if self.rng.random() < 0.4:
            self.plastic_material(name, modulus)
            self.materials[name].update({"Law": self.rng.choice(PLASTIC), "Yield stress": modulus / 50})
        else:
            self.material(name, modulus, self.rng.choice(laws))

    def block(self, name, lower, upper, cells, **more):
        super().block(name, lower, upper, cells, **more)
        self.boxes[name] = (lower, upper, cells)

    def vector(self, x, y, z=0):
        """One entry per dimension, as the .prm has it."""
        return "; ".join(str(entry) for entry in (x, y, z)[: self.dim])

    def area(self, body, boundary):
        """Of a side of a block; in 2D per unit of thickness."""
        lower, upper, _ = self.boxes[body]
        return math.prod(upper[i] - lower[i] for i in range(self.dim) if i != boundary // 2)

    def volume(self, body):
        lower, upper, _ = self.boxes[body]
        return math.prod(upper[i] - lower[i] for i in range(self.dim))

    def pressure(self, body, boundary, ramp):
        """On the top of a block, dead."""
        self.conditions[f"pressure on {body}"] = {"Body": body, "Boundary": boundary, "Type": "pressure", "Value": str(ramp)}
        self.loads.append((body, [ZERO, Ramp(-ramp.value * self.area(body, boundary), ramp.start, ramp.end), ZERO]))

    def push(self, body, boundary, ramp):
        """Along x."""
        self.conditions[f"push of {body}"] = {"Body": body, "Boundary": boundary, "Type": "traction", "Value": self.vector(ramp, 0)}
        self.loads.append((body, [Ramp(ramp.value * self.area(body, boundary), ramp.start, ramp.end), ZERO, ZERO]))

    def weight(self, body, ramp):
        """Per volume, down."""
        self.conditions[f"weight of {body}"] = {"Body": body, "Type": "body force",
                                                "Value": self.vector(0, Ramp(-ramp.value, ramp.start, ramp.end))}
        self.loads.append((body, [ZERO, Ramp(-ramp.value * self.volume(body), ramp.start, ramp.end), ZERO]))

    def spring(self, body, boundary, stiffness, direction=None):
        """On a side of a block, with points at all nodes, whose displacements give its force exactly."""
        name = f"spring of {body} {boundary}"
        self.conditions[name] = {"Body": body, "Boundary": boundary, "Type": "spring", "Stiffness": stiffness}
        if direction:
            self.conditions[name]["Direction"] = direction
        lower, upper, cells = self.boxes[body]
        axes = []
        for i in range(self.dim):
            if i == boundary // 2:
                axes.append([((lower, upper)[boundary % 2][i], 1.0)])
                continue
            n = cells[i] * self.degree
            h = (upper[i] - lower[i]) / n
            if self.degree == 1:
                weights = [h / 2 if j in (0, n) else h for j in range(n + 1)]
            else:
                weights = [h / 3 * (1 if j in (0, n) else 4 if j % 2 else 2) for j in range(n + 1)]
            axes.append([(lower[i] + j * h, weight) for j, weight in enumerate(weights)])
        nodes = [((), 1.0)]
        for axis in axes:
            nodes = [(position + (x,), weight * w) for position, weight in nodes for x, w in axis]
        named = []
        for position, weight in nodes:
            point = f"p{len(self.points)}"
            self.points[point] = {"Body": body, "Position": ", ".join(f"{x:.12g}" for x in position)}
            named.append((point, weight))
        along = [stiffness if direction in (None, axis) else 0.0 for axis in "xyz"]
        self.point_springs.append((body, along, named))

    def tool(self, body, centre, translation, rotation, force=None, torque=None, stiffness=None, rotation_stiffness=None, **more):
        """A rigid body with free components; forces are Ramps."""
        condition = {"Body": body, "Type": "rigid motion", "Translation": self.vector(*translation),
                     "Rotation angle": rotation, "Rotation centre": ", ".join(number(x) for x in centre[: self.dim])}
        if force:
            condition["Force"] = self.vector(*force)
            self.loads.append((body, list(force)))
        if torque:
            condition["Torque"] = torque
        if stiffness:
            condition["Translation stiffness"] = self.vector(*map(number, stiffness))
            self.tool_springs.append((body, f"{body} under force", stiffness))
        if rotation_stiffness:
            condition["Rotation stiffness"] = rotation_stiffness
        self.conditions[f"{body} under force"] = {**condition, **more}

    def contact(self, slave, slave_boundary, master, master_boundary, **more):
        if self.automatic:
            self.pairs = {"Automatic": "true", "Automatic friction coefficient": self.friction}
            return
        pair = {"Slave body": slave, "Slave boundary": slave_boundary, "Master body": master, "Master boundary": master_boundary}
        if self.friction > 0:
            pair.update({"Friction": "Coulomb", "Friction coefficient": self.friction})
        if self.rule != "default":
            pair["Quadrature"] = self.rule
        if self.degree == 2 and self.rule in ("nodal", "Gauss"):
            pair.update({"Quadrature": "Gauss", "Multiplier space": "vertices"})
        self.pairs[f"{slave} on {master}"] = {**pair, **more}

    def must_touch(self, body, other, time):
        self.touching.append((body, other, time))

    # ----------------------------------------------------------------- the .prm
    def prm(self, title):
        self.conditions = {name: {"Body": condition["Body"], **condition} for name, condition in self.conditions.items()}
        text = super().prm(title).rstrip("\n").split("\n")
        more = ["  set Contact points = true"]
        if self.points:
            more += lines({"Points": self.points}, "  ")
        return "\n".join(text[:-1] + more + text[-1:]) + "\n"


def cells_of(case, lower, upper, per_length):
    return tuple(max(1, round(per_length * (b - a))) for a, b in zip(lower, upper))


def box(case, name, lower, upper, per_length, **more):
    case.block(name, lower, upper, cells_of(case, lower, upper, per_length), **more)


def fineness(case):
    return case.rng.randint(4, 8) if case.dim == 2 else case.rng.randint(3, 4)


def depth(case, inset):
    """z of a body: in 3D upper ones are narrower."""
    return (inset, case.width - inset)


def two_bodies_apart(case, gap):
    """A block above a longer one that is held, a gap between them."""
    rng = case.rng
    start, width = uniform(rng, 0.2, 0.4), uniform(rng, 0.5, 0.9)
    box(case, "lower", (0, 0, 0), (1.8, 0.5, 1), fineness(case))
    box(case, "upper", (start, 0.5 + gap, 0.2), (start + width, 1.0 + gap, 0.8), fineness(case))
    case.plastic_or_elastic("lower", 10.0)
    case.material("upper", 10.0 * 10 ** rng.choice((0, 0.5, 1, 2)), rng.choice(ROBUST))
    case.hold("lower")
    case.contact("upper", 2, "lower", 3, **{"Search distance": 1.0})
    return start, width


# -------------------------------------------------------- gaps that close
def gap_and_drag(case):
    """A block comes down over a gap of some steps, is pressed on and dragged."""
    rng = case.rng
    gap, press = uniform(rng, 0.03, 0.15), uniform(rng, 0.02, 0.05)
    start, width = two_bodies_apart(case, gap)
    case.move("hand", "upper", 3, str(Ramp(uniform(rng, 0.05, 1.5 - start - width), 0.5, 1)), str(Ramp(-(gap + press), 0, 0.5)))
    case.requested_times = [0.5]
    case.must_touch("upper", "lower", 0.5 * gap / (gap + press))


def gaps_of_three(case):
    """A block comes down on posts of different heights; the last one it does not reach."""
    rng = case.rng
    gaps = [uniform(rng, 0.01, 0.03), uniform(rng, 0.05, 0.08), 0.15]
    down = uniform(rng, 0.09, 0.11)
    order = rng.sample(range(3), 3)
    box(case, "beam", (0, 0.5, 0), (2.2, 0.9, 0.6), fineness(case))
    case.material("beam", 50.0, rng.choice(ROBUST))
    case.move("hand", "beam", 3, str(Ramp(uniform(rng, 0, 0.05), 0.6, 1)), str(Ramp(-down, 0, 0.6)))
    for i, which in enumerate(order):
        left = 0.1 + 0.75 * i
        box(case, f"post {i}", (left, -0.2, 0), (left + 0.5, 0.5 - gaps[which], 0.6), fineness(case))
        case.plastic_or_elastic(f"post {i}", 10.0)
        case.hold(f"post {i}")
        case.contact(f"post {i}", 3, "beam", 2, **{"Search distance": 1.0})
        case.must_touch("beam", f"post {i}", 0.6 * gaps[which] / down if gaps[which] < down else math.inf)
    case.requested_times = [0.6]


def gap_under_pressure(case):
    """A block on springs is pushed over a gap by pressure; springs and contact share it."""
    rng = case.rng
    gap, closes = uniform(rng, 0.03, 0.15), uniform(rng, 0.15, 0.35)
    pressure = uniform(rng, 0.15, 0.35)
    two_bodies_apart(case, gap)
    # Pressure and springs act on the same side: the block moves as a whole until it touches.
    case.pressure("upper", 3, Ramp(pressure, 0, 0.6))
    case.spring("upper", 3, round(pressure * closes / 0.6 / gap, 6))
    case.push("upper", 3, Ramp(0.2 * pressure * uniform(rng, 0.2, 1.0), 0.6, 1))
    case.requested_times = [0.6]
    case.must_touch("upper", "lower", closes)


# -------------------------------------------------------------- thin parts
def strip(case, name, start, end, bottom, thickness, cells=(12, 20)):
    """One or two cells over the thickness."""
    rng = case.rng
    n = rng.randint(*cells) if case.dim == 2 else cells[0]
    case.block(name, (start, bottom, 0), (end, bottom + thickness, 0.3), (n, rng.randint(1, 2) if case.dim == 2 else 1, 2))
    case.material(name, 1000.0, rng.choice(("St Venant-Kirchhoff", "neo-Hookean", "Hencky", "hyperelastic")))


def clamped_strip(case):
    """A thin strip, clamped at one end, is bent by a pressure until its tip lies on a block."""
    rng = case.rng
    case.degree = 2 if case.dim == 2 and rng.random() < 0.6 else 1
    length, thickness, gap = 1.5, uniform(rng, 0.05, 0.1), uniform(rng, 0.02, 0.06)
    strip(case, "strip", 0, length, 0, thickness)
    nu = case.materials["strip"]["Poisson's ratio"]
    bending = 1000.0 / (1 - nu ** 2) * thickness ** 3 / 12
    free_deflection = gap * uniform(rng, 2.5, 4)
    pressure = 8 * bending * free_deflection / length ** 4
    case.pressure("strip", 3, Ramp(round(pressure, 8)))
    case.move("clamp", "strip", 0, "0", "0")
    box(case, "support", (1.1, -0.4 - gap, -0.1), (1.8, -gap, 0.4), fineness(case))
    case.material("support", 10.0 ** rng.choice((1, 2, 3)), rng.choice(ROBUST))
    case.hold("support")
    case.contact("strip", 2, "support", 3, **{"Search distance": 0.5})
    if case.degree == 2:
        # Bernoulli's beam, before it touches.
        case.points["tip"] = {"Body": "strip", "Position": f"{number(length)}, 0"}
        case.closed_forms.append(("deflection of a beam", lambda row: row["tip_y"] / (-free_deflection * row["time"]) - 1
                                  if row["time"] * free_deflection < 0.9 * gap else 0.0, 0.05))
        case.must_touch("strip", "support", gap / free_deflection)


def bending_on_supports(case):
    """A thin strip on two round rigid supports is bent by a round tool."""
    rng = case.rng
    case.degree = rng.choice((1, 2)) if case.dim == 2 else 1
    thickness, gap = uniform(rng, 0.05, 0.12), rng.choice((0.0, 0.02))
    # Cells smaller than the radius of what they bend around.
    strip(case, "strip", 0, 2, 0, thickness, (24, 36))
    for side in (0, 1):
        case.spring("strip", side, 0.02)
    n = 16
    along = " : 0.4 : 2" if case.dim == 3 else ""
    back = ", -0.05" if case.dim == 3 else ""
    for name, x in (("left", uniform(rng, 0.25, 0.4)), ("right", uniform(rng, 1.6, 1.75))):
        case.bodies[name] = {"Generator": "annular_sector", "Arguments": f"0.1 : 0.2 : 0 : 180 : 1 : {n}{along}",
                             "Translation": f"{number(x)}, -0.2{back}", "Rigid": "true"}
        case.contact("strip", 2, name, 1, **{"Search distance": 0.5})
    case.bodies["tool"] = {"Generator": "annular_sector", "Arguments": f"0.1 : 0.2 : 180 : 360 : 1 : {n}{along}",
                           "Translation": f"1, {number(thickness + gap + 0.2)}{back}", "Rigid": "true"}
    case.contact("strip", 3, "tool", 1, **{"Search distance": 0.5})
    down = uniform(rng, 0.05, 0.12)
    case.conditions["hand"] = {"Body": "tool", "Type": "rigid motion", "Translation": case.vector(0, Ramp(-(gap + down)))}
    if gap > 0:
        case.must_touch("strip", "tool", gap / (gap + down))


def thin_arch(case):
    """A thin half ring on its feet is pressed down by a plate, which may slide sideways then."""
    rng = case.rng
    case.degree = rng.choice((1, 2)) if case.dim == 2 else 1
    radius, thickness, gap = 0.5, uniform(rng, 0.03, 0.08), uniform(rng, 0.0, 0.03)
    across, around = rng.randint(1, 2) if case.dim == 2 else 1, 2 * rng.randint(10, 16) if case.dim == 2 else 16
    ring = f"{number(radius - thickness)} : {number(radius)} : 0 : 180 : {across} : {around}"
    case.bodies["arch"] = {"Generator": "annular_sector", "Arguments": ring + (" : 0.3 : 2" if case.dim == 3 else ""), "Material": "arch"}
    case.material("arch", 1000.0, rng.choice(("St Venant-Kirchhoff", "neo-Hookean", "Hencky")))
    case.move("feet", "arch", "2, 3", "0", "0")
    box(case, "plate", (-0.8, radius + gap, -0.1), (0.8, radius + gap + 0.2, 0.4), fineness(case))
    case.material("plate", 100.0, rng.choice(ROBUST))
    down = uniform(rng, 0.05, 0.15)
    case.move("hand", "plate", 3, str(Ramp(uniform(rng, 0, 0.1), 0.6, 1)), str(Ramp(-(gap + down), 0, 0.6)))
    case.requested_times = [0.6]
    case.initial_step = 0.05
    case.contact("arch", 1, "plate", 2, **{"Search distance": 0.5})
    if gap > 0:
        case.must_touch("arch", "plate", 0.6 * gap / (gap + down))


def leaf_spring(case):
    """Three thin strips on each other, clamped at one end, the longest one pressed down at its tip."""
    rng = case.rng
    case.degree = 1
    thickness, gap = uniform(rng, 0.04, 0.08), rng.choice((0.0, 0.0, 0.005))
    lengths = (1.5, uniform(rng, 1.0, 1.2), uniform(rng, 0.5, 0.8))
    for i, length in enumerate(lengths):
        strip(case, f"leaf {i}", 0, length, -i * (thickness + gap), thickness)
        case.move(f"clamp {i}", f"leaf {i}", 0, "0", "0")
    case.move("hand", "leaf 0", 1, "free", str(Ramp(-uniform(rng, 0.05, 0.2))))
    if case.dim == 3:
        case.conditions["hand"]["Value"] = f"free; {case.conditions['hand']['Value'].split('; ')[1]}; free"
    for i in (1, 2):
        case.contact(f"leaf {i}", 3, f"leaf {i - 1}", 2, **{"Search distance": 0.3, "Excluded boundaries": 0})


# ---------------------------------------------------------- several bodies
def tower(case):
    """Four or five blocks, heavy, on a base that moves; each interface carries what is above it."""
    rng = case.rng
    n = rng.randint(4, 5)
    height, density = 0.3, uniform(rng, 0.05, 0.2)
    for i in range(n):
        inset = 0.07 * i
        box(case, f"block {i}", (inset, height * i, inset), (1.2 - inset, height * (i + 1), 1.2 - inset), fineness(case))
        case.material(f"block {i}", 10.0 * 10 ** rng.choice((0, 0.5, 1)))
        if i > 0:
            case.weight(f"block {i}", Ramp(density, 0, 0.5))
            case.spring(f"block {i}", 0, 0.05, "x")
            if case.dim == 3:
                case.spring(f"block {i}", 4, 0.05, "z")
            case.contact(f"block {i}", 2, f"block {i - 1}", 3)
    case.move("table", "block 0", 2, str(Ramp(uniform(rng, 0.02, 0.08), 0.5, 1)), "0")
    case.requested_times = [0.5]


def chain(case):
    """Blocks in a row with gaps between them; the hand at the end closes them one after the other."""
    rng = case.rng
    n = rng.randint(3, 5)
    x, gaps = 0.0, []
    for i in range(n):
        inset = 0.06 * (i % 2)
        box(case, f"block {i}", (x, inset, inset), (x + 0.5, 0.6 - inset, 0.6 - inset), fineness(case))
        case.material(f"block {i}", 10.0 * 10 ** rng.choice((0, 0.5, 1)))
        if 0 < i < n - 1:
            case.spring(f"block {i}", 2, 0.1)
        if i > 0:
            case.contact(f"block {i}", 0, f"block {i - 1}", 1, **{"Search distance": 0.3})
        gaps.append(uniform(rng, 0.005, 0.03))
        x += 0.5 + gaps[-1]
    case.hold("block 0", 0)
    way = sum(gaps[:-1]) + uniform(rng, 0.02, 0.05)
    case.move("hand", f"block {n - 1}", 1, str(Ramp(-way, 0, 0.8)), str(Ramp(uniform(rng, 0, 0.02), 0.8, 1)))
    case.requested_times = [0.8]
    case.must_touch(f"block {n - 1}", f"block {n - 2}", 0.8 * gaps[n - 2] / way)


def between_two(case):
    """A heavy body between two jaws, which friction holds, or not quite: then springs do."""
    rng = case.rng
    press = uniform(rng, 0.01, 0.03)
    for i, name in enumerate(("left", "middle", "right")):
        inset = 0.1 * (i == 1)
        box(case, name, (0.6 * i, inset, inset), (0.6 * (i + 1), 0.8 - inset, 0.8 - inset), fineness(case))
        case.material(name, 10.0, rng.choice(ROBUST))
    case.hold("left", 0)
    case.move("hand", "right", 1, str(Ramp(-press, 0, 0.4)), "0")
    force = 10.0 * press / 1.8 * case.area("middle", 0)
    heavy = 2 * max(case.friction, 0.1) * force * uniform(rng, 0.3, 1.5)
    case.weight("middle", Ramp(round(heavy / case.volume("middle"), 6), 0.4, 1))
    case.spring("middle", 2, round(heavy / 0.1 / case.area("middle", 2), 6))
    case.requested_times = [0.4]
    case.contact("middle", 0, "left", 1)
    case.contact("middle", 1, "right", 0)


def wedge(case):
    """A wedge is driven between two blocks."""
    rng = case.rng
    slope, gap = round(math.tan(math.radians(uniform(rng, 8, 25))), 4), rng.choice((0.0, 0.01, 0.02))
    z = "; z" if case.dim == 3 else ""
    box(case, "left", (0, 0, 0), (0.6, 0.6, 0.8), fineness(case), Coordinates=f"x*(1 - {slope}*y/0.6); y{z}")
    box(case, "right", (1.4, 0, 0), (2.0, 0.6, 0.8), fineness(case), Coordinates=f"2 - (2 - x)*(1 - {slope}*y/0.6); y{z}")
    box(case, "wedge", (0.6, 0.1, 0.1), (1.4, 0.9, 0.7), fineness(case), Coordinates=f"1 + (x - 1)*(1 + {slope}*y/0.4); y{z}",
        Translation=f"0, {number(gap)}" + (", 0" if case.dim == 3 else ""))
    for name, boundary in (("left", 0), ("right", 1)):
        case.plastic_or_elastic(name, 10.0)
        case.hold(name, boundary)
    case.material("wedge", 10.0 * 10 ** rng.choice((0, 0.5, 1)), rng.choice(ROBUST))
    case.move("hand", "wedge", 3, "0", str(Ramp(-(gap + uniform(rng, 0.03, 0.08)))))
    case.contact("wedge", 0, "left", 1, **{"Search distance": 0.3})
    case.contact("wedge", 1, "right", 0, **{"Search distance": 0.3})
    case.initial_step = 0.05


# -------------------------------------------------------- tools under force
def punch_under_force(case):
    """A rigid block, free to sink and to tilt, is pressed on a block by a force beside its middle, and pulled."""
    rng = case.rng
    width, force = uniform(rng, 0.5, 0.8), uniform(rng, 0.1, 0.25)
    left = uniform(rng, 0.3, 0.6)
    box(case, "block", (0, 0, 0), (1.6, 0.6, 1), fineness(case))
    box(case, "punch", (left, 0.6, 0.2), (left + width, 0.9, 0.8), 3, Rigid="true")
    case.plastic_or_elastic("block", 10.0)
    case.hold("block")
    force *= width * (0.6 if case.dim == 3 else 1)
    pull = 0.4 * force * case.friction * uniform(rng, 0, 1)
    centre = (left + width * uniform(rng, 0.4, 0.6), 0.9, 0.5)
    case.tool("punch", centre, ("free", "free", "0"), "free" if case.dim == 2 else "0; 0; free",
              force=(Ramp(pull, 0.5, 1), Ramp(-force, 0, 0.5), ZERO), stiffness=(0.02, 0, 0), rotation_stiffness="0.01" if case.dim == 2 else "0; 0; 0.01")
    case.requested_times = [0.5]
    case.contact("block", 3, "punch", 2)


def lever(case):
    """A rigid lever on a hinge with a spring is turned by a torque and falls on a block."""
    rng = case.rng
    torque, stiffness = uniform(rng, 0.4, 1.2), uniform(rng, 0.8, 1.5)
    angle = uniform(rng, 5, 15)  # degrees down to the top of the block
    top = -2.0 * math.sin(math.radians(angle)) - 0.1
    box(case, "block", (1.2, top - 0.6, 0), (2.0, top, 0.6), fineness(case))
    box(case, "lever", (0, -0.1, -0.1), (2.4, 0.1, 0.7), 4 if case.dim == 2 else 2, Rigid="true")
    case.plastic_or_elastic("block", 10.0)
    case.hold("block")
    case.tool("lever", (0, 0, 0.3), ("0", "0", "0"), "free", torque=str(Ramp(-torque)), rotation_stiffness=stiffness)
    case.contact("block", "0, 1, 3", "lever", 2, **{"Search distance": 1.0})
    # Its hinge is the origin: spring and contact carry the torque.
    case.closed_forms.append(("moment about the hinge", lambda row: (
        math.radians(row["lever under force.rotation_z"]) * stiffness + row.moment_on("block", "z")) / torque + row["time"],
        # The moment is that of the slave points; friction acts on the master at their gaps from there.
        1e-5 + 0.01 * case.friction))


def machine(case):
    """A rigid machine on feet, its weight beside the middle, is pulled sideways; friction or a spring holds it."""
    rng = case.rng
    n = rng.randint(2, 3) if case.dim == 2 else 2
    weight = uniform(rng, 0.03, 0.1)
    for i in range(n):
        left = 0.1 + 1.4 * i / (n - 1)
        box(case, f"foot {i}", (left, 0, 0), (left + 0.4, 0.3, 0.6), fineness(case) + 2)
        case.material(f"foot {i}", 2.0, rng.choice(ROBUST))
        case.hold(f"foot {i}")
        case.contact(f"foot {i}", 3, "machine", 2)
    box(case, "machine", (0, 0.3, -0.1), (2, 0.8, 0.7), 3, Rigid="true")
    free = ("free", "free", "free")
    force = (Ramp(weight * 0.4 * uniform(rng, 0, 0.8) * case.friction, 0.5, 1), Ramp(-weight, 0, 0.5), ZERO)
    centre = (uniform(rng, 0.8, 1.2), 0.5, 0.3)
    if case.dim == 2:
        case.tool("machine", centre, free, "free", force=force, stiffness=(0.05, 0, 0))
    else:
        case.tool("machine", centre, free, "free; free; free", force=force, stiffness=(0.05, 0, 0.05), rotation_stiffness="0; 0.05; 0")
    case.requested_times = [0.5]


def tool_on_spring(case):
    """A rigid tool on a spring is pushed over a gap by a force, pressed on and moved along."""
    rng = case.rng
    gap, force = uniform(rng, 0.03, 0.2), uniform(rng, 0.1, 0.3)
    closes = uniform(rng, 0.1, 0.3)
    stiffness = round(force * closes / 0.5 / gap, 6)
    left = 0.3
    box(case, "block", (0, 0, 0), (1.8, 0.5, 0.8), fineness(case) + 1)
    case.plastic_or_elastic("block", 10.0)
    case.hold("block")
    round_tool = rng.random() < 0.5
    if round_tool:
        tail = " : 1 : 2" if case.dim == 3 else ""
        case.bodies["tool"] = {"Generator": "annular_sector", "Arguments": f"0.2 : 0.4 : 180 : 360 : 1 : {24 if case.dim == 2 else 12}{tail}",
                               "Translation": f"0.6, {number(0.9 + gap)}" + (", -0.1" if case.dim == 3 else ""), "Rigid": "true"}
    else:
        box(case, "tool", (left, 0.5 + gap, 0.1), (left + 0.6, 0.8 + gap, 0.7), 3, Rigid="true")
    case.tool("tool", (0.6, 0.9 + gap, 0.4), (Ramp(uniform(rng, 0.05, 0.4), 0.5, 1), "free", "0"), "0",
              force=(ZERO, Ramp(-force, 0, 0.5), ZERO), stiffness=(0, stiffness, 0))
    case.requested_times = [0.5]
    case.initial_step = 0.05
    case.contact("block", 3, "tool", 1 if round_tool else 2, **{"Search distance": 1.0})
    case.closed_forms.append(("spring before it touches", lambda row: row["tool under force.displacement_y"] / gap + row["time"] / closes
                              if row["time"] < closes - 1e-9 else 0.0, 1e-5))
    case.must_touch("block", "tool", closes)


KINDS = {
    "gaps": (gap_and_drag, gaps_of_three, gap_under_pressure),
    "thin parts": (clamped_strip, bending_on_supports, thin_arch, leaf_spring),
    "several bodies": (tower, chain, between_two, wedge),
    "tools under force": (punch_under_force, lever, machine, tool_on_spring),
}
FAMILIES = tuple(family for kind in KINDS.values() for family in kind)
NUMBER = 4 * len(FAMILIES)


def case_of(seed):
    """Family and case: families take turns, and each has one of its four problems in 3D and one or two with automatic contact."""
    turn, position = divmod(seed - FIRST, len(FAMILIES))
    family = FAMILIES[position]
    case = StaticCase(random.Random(f"stress {seed}"), 3 if (turn + position) % 4 == 3 else 2, (2 * position + turn) % 3 == 0)
    family(case)
    return family, case


def problem(seed):
    """Title, dimension and .prm of a problem."""
    family, case = case_of(seed)
    return family.__name__, case.dim, case.prm(f"{family.__name__}, seed {seed}")
