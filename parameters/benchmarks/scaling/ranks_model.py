"""What 1 to 64 ranks do, in counts that do not depend on time, and a model that makes times of them.

The counts are of whole runs (one load step of the mixed state), by rank and Krylov iteration.
"""
import math

# (ranks, cells to the edge of the upper cube): as many unknowns on each rank, and the same problem on all
WEAK = ((1, 6), (4, 10), (16, 16), (64, 26))
STRONG = ((1, 26), (4, 26), (16, 26), (64, 26))

# A node of two EPYC 7742 and HDR InfiniBand, all 128 cores at work: what one of them has.
MACHINE = {
    "latency": 2e-6,           # of a message to another node, the time in MPI included [s]
    "network": 25e9 / 128,     # [byte/s]
    "memory": 380e9 / 128,     # [byte/s]
}
# What a Krylov iteration reads by unknown: the tangent (1.0 kB), triangles and coarse levels of a cycle
# (three times 0.2), vectors of GMRES (0.3); see doc/scaling.md, section 2.
BYTES_PER_UNKNOWN = 1.9e3


def row(record, traffic):
    ranks, krylov = record["ranks"], record["linear_iterations"]
    return {
        "unknowns": record["dofs"], "ranks": ranks, "Newton": record["newton_iterations"], "Krylov": krylov,
        "messages": sum(traffic.messages) / ranks / krylov, "most messages": max(traffic.messages) / krylov,
        "kB": sum(traffic.bytes) / 1024 / ranks / krylov, "most kB": max(traffic.bytes) / 1024 / krylov,
        "collectives": max(traffic.collectives) / krylov,
    }


def seconds(unknowns, ranks, counts):
    """Of a Krylov iteration on MACHINE, with the counts of a rank: (work, messages, collective operations)."""
    work = unknowns / ranks * BYTES_PER_UNKNOWN / MACHINE["memory"]
    messages = counts["messages"] * MACHINE["latency"] + counts["kB"] * 1024 / MACHINE["network"]
    return work, messages, counts["collectives"] * 2 * math.log2(max(2, ranks)) * MACHINE["latency"]


def extrapolated(counts, unknowns_per_rank):
    """Counts of a rank with a part of another size: as many messages, which grow with the surface of the part."""
    surface = (unknowns_per_rank * counts["ranks"] / counts["unknowns"]) ** (2 / 3)
    return {**counts, "kB": counts["kB"] * surface}


def print_rows(title, rows):
    print(f"\n{title}\n  " + "  ".join(rows[0]))
    for values in rows:
        print("  " + "  ".join(f"{value:{len(name)}.{0 if float(value).is_integer() else 1}f}" for name, value in values.items()))


def run(benchmark, counted):
    """`counted`(state, cells, ranks) makes a run."""
    tables = {}
    for title, sizes in (("as many unknowns on each rank", WEAK), ("the same problem", STRONG)):
        results = [counted("mixed", n, ranks) for ranks, n in (sizes[:3] if benchmark.quick else sizes)]
        tables[title] = [row(*result) for result in results if result]
    for title, rows in tables.items():
        if not rows:
            continue
        print_rows(title, rows)
        benchmark.write_csv(f"by_ranks_{'weak' if 'each' in title else 'strong'}.csv", tuple(rows[0]), [tuple(r.values()) for r in rows])
        iterations = [r["Krylov"] / r["Newton"] for r in rows]
        if "same" in title:
            benchmark.check(f"{title}: Krylov iterations by Newton iteration, most ranks / one", iterations[-1] / iterations[0], 1.15, 0.0, "below")
            newton = [r["Newton"] for r in rows]
            benchmark.check(f"{title}: Newton iterations, most - least", max(newton) - min(newton), 1, 0.0, "below")
    last = next((rows[-1] for rows in reversed(tables.values()) if rows), None)
    if last and last["ranks"] > 1:
        rows = []
        for unknowns in (1e6, 1e7, 1e8):
            for ranks in (64, 256, 1024, 4096, 10000):
                if 2e3 <= unknowns / ranks <= 2e5:
                    parts = seconds(unknowns, ranks, extrapolated(last, unknowns / ranks))
                    rows.append({"unknowns": unknowns, "ranks": ranks, "work [ms]": 1e3 * parts[0], "messages [ms]": 1e3 * parts[1],
                                 "collectives [ms]": 1e3 * parts[2], "efficiency [%]": 100 * parts[0] / sum(parts)})
        print_rows("a Krylov iteration by the model", rows)
        benchmark.write_csv("model.csv", tuple(rows[0]), [tuple(r.values()) for r in rows])
    benchmark.finish()
