"""Small random contact problems. problem(seed) is the same on every machine.

Each family is a function of a random generator and the dimension that returns
a case as nested dictionaries, in the words of the .prm. All are meant to have a
quasi-static solution: whatever may lose contact is held by prescribed
displacements or by springs, no load can tip a block over, and laws that yield
under strong compression are not used where corners dig in. Lengths are near 1,
moduli near 1 to 1000.
"""
import random

MATERIALS = ("St Venant-Kirchhoff", "neo-Hookean", "neo-Hookean", "Hencky", "linear elastic")
# Their cells can be squeezed to nothing by a finite pressure.
WEAK_IN_COMPRESSION = ("St Venant-Kirchhoff", "linear elastic")


class Case:
    """Bodies, materials, conditions and pairs of one problem."""

    def __init__(self, rng, dim, digs_in=False):
        self.rng = rng
        self.dim = dim
        self.digs_in = digs_in
        self.degree = rng.choice((1, 1, 1, 2)) if dim == 2 else 1
        self.bodies, self.materials, self.conditions, self.pairs = {}, {}, {}, {}
        self.end_time, self.initial_step, self.requested_times = 1.0, 0.1, []

    # ------------------------------------------------------------ ingredients
    def material(self, name, modulus, law=None):
        law = law or self.rng.choice(MATERIALS)
        if self.digs_in and law in WEAK_IN_COMPRESSION:
            law = "neo-Hookean"
        self.materials[name] = {"Law": law, "Young's modulus": modulus,
                                "Poisson's ratio": self.rng.choice((0.0, 0.2, 0.3, 0.4))}

    def plastic_material(self, name, modulus):
        self.materials[name] = {"Law": "Simo-Miehe plasticity", "Young's modulus": modulus, "Poisson's ratio": 0.3,
                                "Yield stress": modulus / self.rng.choice((50, 200)), "Hardening": "linear",
                                "Hardening modulus": modulus / 10}

    def block(self, name, lower, upper, cells, **more):
        """lower, upper, cells are for 3D; y is up."""
        keep = (0, 1) if self.dim == 2 else (0, 1, 2)
        corners = [", ".join(number(p[i]) for i in keep) for p in (lower, upper)]
        self.bodies[name] = {"Generator": "subdivided_hyper_rectangle",
                             "Arguments": f"{', '.join(str(cells[i]) for i in keep)} : {corners[0]} : {corners[1]} : true",
                             **more}
        if "Rigid" not in more:
            self.bodies[name].setdefault("Material", name)

    def move(self, name, body, boundary, x, y):
        """Prescribed displacement; z is held in 3D."""
        self.conditions[name] = {"Body": body, "Boundary": boundary, "Value": "; ".join((x, y, "0")[: self.dim])}

    def hold(self, body, boundary=2):
        self.move(f"{body} is held", body, boundary, "0", "0")

    def spring(self, body, boundary, stiffness):
        self.conditions[f"spring of {body}"] = {"Body": body, "Boundary": boundary, "Type": "spring", "Stiffness": stiffness}

    def contact(self, slave, slave_boundary, master, master_boundary, **more):
        mu = self.rng.choice((0.0, 0.1, 0.3, 0.5, 0.8))
        pair = {"Slave body": slave, "Slave boundary": slave_boundary, "Master body": master,
                "Master boundary": master_boundary, "Normals": self.rng.choice(("facet", "smoothed"))}
        if mu > 0:
            pair.update({"Friction": "Coulomb", "Friction coefficient": mu})
        if self.degree == 2:
            pair.update({"Quadrature": "Gauss", "Multiplier space": "vertices"})
        else:
            pair["Quadrature"] = self.rng.choice(("nodal", "nodal", "Gauss", "Simpson"))
        self.pairs[f"{slave} on {master}"] = {**pair, **more}

    # ----------------------------------------------------------------- the .prm
    def prm(self, title):
        case = {
            "Title": title,
            "Dimension": self.dim,
            "Degree": self.degree,
            "Bodies": self.bodies,
            "Materials": self.materials,
            "Boundary conditions": self.conditions,
            "Contact": self.pairs,
            "Load stepping": {"End time": self.end_time, "Initial step": self.initial_step,
                              "Minimum step": self.initial_step / 16},
            "Output": {"Verbosity": "results", "Every n steps": 1000},
        }
        if self.requested_times:
            case["Load stepping"]["Requested times"] = ", ".join(map(number, self.requested_times))
        return "\n".join(lines(case)) + "\n"


def number(value):
    return f"{value:.6g}"


def lines(section, indent=""):
    for name, value in section.items():
        if isinstance(value, dict):
            yield f"{indent}subsection {name}"
            yield from lines(value, indent + "  ")
            yield f"{indent}end"
        else:
            yield f"{indent}set {name} = {number(value) if isinstance(value, float) else value}"


def uniform(rng, low, high):
    return round(rng.uniform(low, high), 4)


def sizes(case):
    """Cells per unit length of the upper and the lower body: not matching."""
    rng = case.rng
    return (rng.randint(3, 7), rng.randint(3, 7)) if case.dim == 2 else (rng.randint(2, 4), rng.randint(2, 4))


def two_blocks(case, overlap=0.0, width=None, length=None):
    """An upper block (slave or master) on a longer lower one, the lower one held."""
    rng = case.rng
    width = width or uniform(rng, 0.6, 1.2)
    length = length or uniform(rng, 1.6, 2.4)
    start = uniform(rng, 0.1, 0.4)
    n_upper, n_lower = sizes(case)
    case.block("lower", (0, 0, 0), (length, 0.6, 1), (round(length * n_lower), max(2, round(0.6 * n_lower)), n_lower))
    case.block("upper", (start, 0.6 - overlap, 0.1), (start + width, 1.2 - overlap, 0.9),
               (max(2, round(width * n_upper)), max(2, round(0.6 * n_upper)), max(2, round(0.8 * n_upper))))
    case.material("lower", 10.0)
    case.material("upper", 10.0 * 10 ** rng.choice((-1, 0, 0.5, 1, 2)))
    case.hold("lower")
    return start, width, length


# ------------------------------------------------------------------- families
def press_and_drag(case):
    """A block is pressed on another and dragged along it."""
    start, width, length = two_blocks(case, overlap=case.rng.choice((0.0, 0.0, -0.01, 0.01)))
    down, way = uniform(case.rng, 0.02, 0.06), uniform(case.rng, 0.1, length - start - width)
    case.move("hand", "upper", 3, f"if(t < 0.3, 0, {number(way)}*(t - 0.3)/0.7)", f"-{number(down)}*min(t/0.3, 1)")
    case.requested_times = [0.3]
    case.contact("upper", 2, "lower", 3)


def drop_off(case):
    """A block is dragged over the edge of the other one and beyond it."""
    rng = case.rng
    start, width, length = two_blocks(case, length=1.5, width=uniform(rng, 0.6, 0.9))
    down = uniform(rng, 0.02, 0.05)
    way = length - start - rng.choice((0.7, 0.5, 0.2, -0.2)) * width
    case.move("hand", "upper", 3, f"if(t < 0.2, 0, {number(way)}*(t - 0.2)/0.8)", f"-{number(down)}*min(t/0.2, 1)")
    case.requested_times = [0.2]
    case.initial_step = 0.05
    if rng.random() < 0.7:
        case.contact("lower", 3, "upper", 2)
    else:
        case.contact("upper", 2, "lower", 3)


def sharp_corner(case):
    """The corner of a tilted block is pressed into a block and dragged."""
    rng = case.rng
    two_blocks(case, width=0.7)
    angle = uniform(rng, 5, 40)
    case.bodies["upper"].update({"Rotation angle": angle, "Rotation centre": "0.6, 0.6" + (", 0.5" if case.dim == 3 else "")})
    lift = number(0.3)
    case.bodies["upper"]["Translation"] = "0.2, " + lift + (", 0" if case.dim == 3 else "")
    down = 0.3 + uniform(rng, 0.02, 0.06)
    way = uniform(rng, 0, 0.2)
    case.materials["upper"]["Young's modulus"] = 100.0
    # the lowest corner is at the rotation centre's height or below: it comes down from above
    case.move("hand", "upper", 3, f"if(t < 0.6, 0, {number(way)}*(t - 0.6)/0.4)",
              f"-{number(down)}*min(t/0.6, 1)")
    case.requested_times = [0.6]
    case.initial_step = 0.05
    case.contact("lower", 3, "upper", "0, 1, 2", **{"Search distance": 0.6})


def cylinder(case):
    """A half ring is pressed into a block and drawn along it."""
    rng = case.rng
    radius, thick = 0.3, uniform(rng, 0.08, 0.25)
    length, n = 2.0, rng.randint(4, 7) if case.dim == 2 else 3
    case.block("lower", (0, 0, 0), (length, 0.5, 0.4), (round(length * n), max(2, round(0.5 * n)), 2))
    around, across = rng.randint(10, 18) if case.dim == 2 else 10, rng.randint(1, 3)
    ring = f"{number(radius - thick)} : {number(radius)} : 180 : 360 : {across} : {around}"
    case.bodies["ring"] = {"Generator": "annular_sector", "Arguments": ring + (" : 0.4 : 2" if case.dim == 3 else ""),
                           "Translation": f"0.5, {number(0.5 + radius)}" + (", 0" if case.dim == 3 else ""), "Material": "ring"}
    case.material("lower", 1.0)
    case.material("ring", 10.0 ** rng.choice((0, 1, 2)))
    case.hold("lower")
    down, way = uniform(rng, 0.04, 0.12), uniform(rng, 0.2, 0.9)
    case.move("hand", "ring", "2, 3", f"if(t < 0.4, 0, {number(way)}*(t - 0.4)/0.6)", f"-{number(down)}*min(t/0.4, 1)")
    case.requested_times = [0.4]
    case.initial_step = 0.05
    if rng.random() < 0.5:
        case.contact("ring", 1, "lower", 3)
    else:
        case.contact("lower", 3, "ring", 1)


def loss_and_regain(case):
    """Down, up until contact is lost, sideways, and down again."""
    rng = case.rng
    start, width, length = two_blocks(case)
    down, up, way = uniform(rng, 0.02, 0.05), uniform(rng, 0.02, 0.1), uniform(rng, 0.05, 0.3)
    case.move("hand", "upper", 3, f"{number(way)}*min(max(t - 0.5, 0)/0.2, 1)",
              f"if(t < 0.25, -{number(down)}*t/0.25, if(t < 0.5, -{number(down)} + {number(down + up)}*(t - 0.25)/0.25, "
              f"if(t < 0.7, {number(up)}, {number(up)} - {number(down + up)}*(t - 0.7)/0.3)))")
    case.requested_times = [0.25, 0.5, 0.7]
    case.contact("upper", 2, "lower", 3)


def initial_overlap(case):
    """The bodies overlap at the start and push each other apart."""
    rng = case.rng
    start, width, length = two_blocks(case, overlap=uniform(rng, 0.005, 0.05))
    case.move("hand", "upper", 3, f"{number(uniform(rng, 0, 0.1))}*t", "0")
    case.initial_step = rng.choice((0.2, 1.0))
    case.contact("upper", 2, "lower", 3)


def held_by_springs(case):
    """A block on soft springs is pressed and pushed by tractions, below or beyond the cone."""
    rng = case.rng
    start, width, length = two_blocks(case)
    softness = min(1.0, case.materials["upper"]["Young's modulus"] / 10.0)
    pressure, push = softness * uniform(rng, 0.05, 0.3), uniform(rng, 0.1, 1.0)
    # Without friction the springs stop the block, 0.6 high, before pressure and
    # push together act beyond the end of the lower one, with 0.15 to spare. Near
    # that end the surface slopes, and up to a tenth of the pressure pushes, too.
    longest_way = length - start - 0.5 * width - 0.6 * 0.3 * push - 0.15
    case.spring("upper", 3, max(0.05, (0.3 * push + 0.1) * pressure / longest_way))
    case.conditions["weight"] = {"Body": "upper", "Boundary": 3, "Type": "pressure",
                                 "Value": f"{number(pressure)}*min(t/0.5, 1)"}
    case.conditions["push"] = {"Body": "upper", "Boundary": 3, "Type": "traction",
                               "Value": "; ".join((f"{number(0.3 * push * pressure)}*max(t - 0.5, 0)/0.5", "0", "0")[: case.dim])}
    case.requested_times = [0.5]
    case.contact("upper", 2, "lower", 3)


def pile(case):
    """Three bodies on top of each other, with different meshes, pressed and sheared."""
    rng = case.rng
    n = [rng.randint(3, 6) if case.dim == 2 else rng.randint(2, 3) for _ in range(3)]
    for i, name in enumerate(("lower", "middle", "upper")):
        inset = 0.1 * i
        case.block(name, (inset, 0.4 * i, inset), (1.4 - inset, 0.4 * (i + 1), 1 - inset),
                   (n[i] + 1, max(2, n[i] // 2), max(2, n[i] - 1)))
        case.material(name, 10.0 * 10 ** rng.choice((-1, 0, 1)))
    case.hold("lower")
    case.spring("middle", 0, 0.02)
    case.move("hand", "upper", 3, f"{number(uniform(rng, 0, 0.1))}*max(t - 0.4, 0)/0.6", f"-{number(uniform(rng, 0.02, 0.06))}*min(t/0.4, 1)")
    case.requested_times = [0.4]
    case.contact("middle", 2, "lower", 3)
    case.contact("upper", 2, "middle", 3)


def tilt(case):
    """A block is pressed down and then rotated until it lifts off on one side."""
    rng = case.rng
    start, width, length = two_blocks(case)
    centre = [start + 0.5 * width, 1.2, 0.5][: case.dim]
    down, angle = uniform(rng, 0.02, 0.05), uniform(rng, 1, 6)
    case.conditions["hand"] = {"Body": "upper", "Boundary": 3, "Type": "rigid motion",
                               "Translation": "; ".join(("0", f"-{number(down)}*min(t/0.3, 1)", "0")[: case.dim]),
                               "Rotation angle": f"{number(angle)}*max(t - 0.3, 0)/0.7",
                               "Rotation centre": ", ".join(map(number, centre))}
    case.requested_times = [0.3]
    case.contact("upper", 2, "lower", 3)


def rigid_waves(case):
    """A soft block is pressed on a rigid base with waves or teeth and dragged over it."""
    rng = case.rng
    n = rng.randint(4, 8) if case.dim == 2 else 3
    height, waves = uniform(rng, 0.02, 0.06), rng.randint(2, 4)
    shape = rng.choice(("sin(3.14159*{0}*x)", "abs(sin(3.14159*{0}*x))")).format(waves)
    case.block("base", (-0.5, -0.3, -0.2), (2.5, 0, 1.2), (rng.randint(24, 40), 1, 2), Rigid="true",
               Coordinates=f"x; y + if(y > -0.1, {number(height)}*({shape}), 0)" + ("; z" if case.dim == 3 else ""))
    case.block("upper", (0.2, height, 0.1), (1.2, 0.5 + height, 0.9), (n + 1, max(2, n // 2), max(2, n - 1)))
    case.material("upper", 10.0)
    down, way = uniform(rng, 0.02, 0.06), uniform(rng, 0.0, 0.4)
    case.move("hand", "upper", 3, f"{number(way)}*max(t - 0.4, 0)/0.6", f"-{number(down + 0.3 * height)}*min(t/0.4, 1)")
    case.requested_times = [0.4]
    case.initial_step = 0.05
    case.contact("upper", 2, "base", 3)


def plastic_dent(case):
    """A stiff narrow block leaves a dent in a plastic one and is lifted again."""
    rng = case.rng
    two_blocks(case, width=uniform(rng, 0.3, 0.6))
    case.plastic_material("lower", 100.0)
    case.material("upper", 2000.0, "neo-Hookean")
    down = uniform(rng, 0.01, 0.04)
    case.move("hand", "upper", 3, "0", f"-{number(down)}*if(t < 0.7, t/0.7, 1 - (t - 0.7)/0.3*1.5)")
    case.requested_times = [0.7]
    if rng.random() < 0.5:
        case.contact("lower", 3, "upper", 2)
    else:
        case.contact("upper", 2, "lower", 3)


DIG_IN = (drop_off, sharp_corner, cylinder, rigid_waves)
FAMILIES = (press_and_drag, drop_off, sharp_corner, cylinder, loss_and_regain, initial_overlap, held_by_springs, pile, tilt,
            rigid_waves, plastic_dent)


def problem(seed):
    """Title and .prm of a problem. Every family comes in turn, every fourth problem is in 3D."""
    rng = random.Random(seed)
    family = FAMILIES[seed % len(FAMILIES)]
    case = Case(rng, 3 if (seed // len(FAMILIES)) % 4 == 3 else 2, family in DIG_IN)
    family(case)
    return family.__name__, case.dim, case.prm(f"{family.__name__}, seed {seed}")
