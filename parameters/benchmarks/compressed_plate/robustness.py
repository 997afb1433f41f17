"""The plate as a user meets it: default line search, cycle treatment and fallback sequence; any r_n and r_t, any units, any friction."""

# Plain numbers, r_n [N/mm^3] and r_t [1/mm]: 1e2 .. 1e15 Pa/m and 1 .. 1e8 1/m.
R_N = [1e-7 * 10 ** (2.6 * i) for i in range(6)]
R_T = [1e-3 * 10 ** (1.6 * i) for i in range(6)]
POINTS = {"A": 0.0, "B": 1.25, "C": 5.0, "D": 7.5, "E": 11.25}


def iterations(result, column="newton_iterations"):
    return int(result.total("statistics.csv", column))


def is_right(result, displacements, known, tolerance=1e-5):
    return result.converged and all(abs(a / b - 1) < tolerance for a, b in zip(displacements(result), known))


def compare_plain_numbers(benchmark, run_all, displacements, known):
    """36 pairs of plain numbers: right, failed, or converged to something else."""
    scale = "Contact/base/Regularization/"
    names = ("GNM", "automatic") if benchmark.quick else ("GNM", "PNM", "FPM", "automatic")
    step = 2 if benchmark.quick else 1
    print("\nPlain numbers with cycle treatment: Newton iterations, r_n downwards, r_t to the right")
    rows = []
    for name in names:
        results = run_all({
            f"pairs/{name}_{i}_{j}": {"Algorithm/Name": name, scale + "Scale": "plain", scale + "r_n": f"{R_N[i]:.6g}",
                                      scale + "r_t": f"{R_T[j]:.6g}"}
            for i in range(0, 6, step) for j in range(0, 6, step)})
        right = {label: is_right(result, displacements, known) for label, result in results.items()}
        for i in range(0, 6, step):
            cells = []
            for j in range(0, 6, step):
                label = f"pairs/{name}_{i}_{j}"
                count = sum(iterations(results[label], c) for c in ("newton_iterations", "failed_newton_iterations")) if right[label] else -1
                rows.append((name, R_N[i], R_T[j], int(right[label]), int(results[label].converged), count))
                cells.append(f"{count:6d}")
            print(f"  {name:10} {R_N[i]:8.1e} " + "".join(cells))
        wrong = sum(result.converged and not right[label] for label, result in results.items())
        needed = len(results) if name == "automatic" else round(len(results) * 34 / 36)
        benchmark.check(f"{name}: pairs that are right, of {len(results)}", sum(right.values()), needed, 0.0, "above")
        benchmark.check(f"{name}: pairs that are wrong", wrong, 0, 0.0, "absolute")
    benchmark.write_csv("pairs.csv", ("algorithm", "r_n", "r_t", "right", "converged", "newton_iterations"), rows)


def in_units(length):
    """The plate with lengths multiplied by a number."""
    L = length
    overrides = {
        "Bodies/plate/Arguments": f"0 |1| {1.25 * L} |3| {5 * L} |2| {7.5 * L} |3| {11.25 * L} |23| {40 * L} : 0 |10| {40 * L}",
        "Bodies/base/Arguments": f"1, 1 : {-10 * L}, {-10 * L} : {50 * L}, 0 : true",
        "Boundary conditions/corner/Where": f"x > {39.999 * L} && y < {1e-6 * L}",
        "Contact/base/Excluded points": f"{40 * L}, 0",
    }
    return {**overrides, **{f"Output/Points/{name}/Position": f"{x * L}, 0" for name, x in POINTS.items()}}


def compare_scales(benchmark, run_all, displacements, known):
    """automatic with default scales: any modulus and unit of length in the same iterations, friction, meshes."""
    name = {"Algorithm/Name": "automatic"}
    moduli = {f"scales/E_{modulus:g}": {**name, "Materials/steel/Young's modulus": modulus,
                                        "Boundary conditions/top/Value": f"{50 / 1.3e5 * modulus}*t",
                                        "Boundary conditions/left/Value": f"{150 / 1.3e5 * modulus}*t"}
              for modulus in (1e-3, 1.0, 1e8, 1e12)}
    lengths = {f"scales/length_{length:g}": {**name, **in_units(length)} for length in (1e-3, 1e3)}
    results = run_all({"scales/as_it_is": name, **moduli, **lengths})
    expected = iterations(results["scales/as_it_is"])
    for label, result in results.items():
        factor = float(label.rsplit("_", 1)[1]) if "length" in label else 1.0
        benchmark.check_true(f"{label}: the same answer",
                             is_right(result, lambda r: [x / factor for x in displacements(r)], known))
        benchmark.check(f"{label}: Newton iterations", iterations(result), expected, 0.0, "absolute")

    meshes = ((8, 4), (16, 5), (32, 10), (64, 20)) if benchmark.quick else ((8, 4), (16, 5), (32, 10), (64, 20), (128, 40), (256, 80))
    others = run_all({
        **{f"scales/mu_{mu:g}": {**name, "Contact/base/Friction coefficient": mu} for mu in (0.05, 0.2, 0.5, 0.8, 1.2, 1.6, 2.0)},
        **{f"scales/mesh_{nx}x{ny}": {**name, "Bodies/plate/Arguments": f"0 |{nx}| 40 : 0 |{ny}| 40"} for nx, ny in meshes}})
    for label, result in others.items():
        benchmark.check_true(f"{label}: converged in one load step", result.converged)
        if result.converged:
            benchmark.report(f"{label}: Newton iterations", iterations(result), expected)
