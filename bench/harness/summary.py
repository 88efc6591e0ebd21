"""The rows of the suites, condensed: medians, worst cases, counts of what went wrong."""
import statistics

from harness import paper, speed
from harness.grid import Grid, fixed, scaled
from harness.table import number

# Column, heading, format, and whether larger is better. Chamfer and Hausdorff distances in 1/10000
# of the diagonal.
MEASURES = (
    ("chamfer", "Chamfer, e-4", scaled(1e4, 2), False),
    ("hausdorff", "Hausdorff, e-4", scaled(1e4, 0), False),
    ("f_strict", "F 0.1 %", scaled(1, 3), True),
    ("normal_error", "normals, °", scaled(1, 2), False),
    ("edge_strict", "edge F1 0.1 %", scaled(1, 3), True),
    ("edge_loose", "edge F1 0.5 %", scaled(1, 3), True),
    ("volume_iou", "volume IoU", scaled(1, 4), True),
)
FEWEST_FOR_MEDIAN = 1


def current(table, methods):
    """The rows of the versions at hand, by method name."""
    versions = {(m.name, m.version): m for m in methods}
    rows = {m.name: [] for m in methods}
    for row in table.rows.values():
        if (row["method"], row["version"]) in versions:
            rows[row["method"]].append(row)
    return rows


def values(rows, column):
    return [v for v in (number(r[column]) for r in rows) if v is not None]


def median_and_worst(rows, column, text, larger_is_better):
    found = values(rows, column)
    if len(found) < FEWEST_FOR_MEDIAN:
        return "–"
    worst = min(found) if larger_is_better else max(found)
    return f"{text(statistics.median(found))} ({text(worst)})"


def share(rows, column):
    return f"{sum(r[column] == '1' for r in rows)} of {len(rows)}"


def quality_grid(rows_of, methods, variant):
    """Methods x measures on the cases of a variant: median, and the worst in brackets."""
    grid = Grid(["method", "meshes", "sound", "right topology", *(m[1] for m in MEASURES),
                 "seconds"])
    for method in methods:
        rows = [r for r in rows_of[method.name] if r["variant"] == variant]
        if not rows:
            continue
        ok = [r for r in rows if r["status"] == "ok"]
        grid.rows.append([
            method.title, f"{len(ok)} of {len(rows)}", share(rows, "sound"),
            share(rows, "same_topology"),
            *(median_and_worst(ok, *m[:1], m[2], m[3]) for m in MEASURES),
            median_and_worst(ok, "seconds", scaled(1, 1), False)])
    return grid


def failures_grid(rows_of, methods):
    grid = Grid(["method", "case", "status", "reason"])
    for method in methods:
        for r in rows_of[method.name]:
            if r["status"] != "ok":
                grid.rows.append([method.title, r["case"], r["status"], r["reason"]])
    return grid


def case_grid(rows_of, methods, case):
    """One case: its figures for every method that has them."""
    grid = Grid(["method", *(m[1] for m in MEASURES), "components", "Euler", "sound", "seconds"])
    for method in methods:
        for r in rows_of[method.name]:
            if r["case"] != case:
                continue
            if r["status"] != "ok":
                grid.rows.append([method.title, f"{r['status']}: {r['reason']}"] +
                                 [""] * (len(grid.header) - 2))
                continue
            grid.rows.append([
                method.title, *(m[2](number(r[m[0]])) for m in MEASURES),
                f"{r['components']} ({r['truth_components']})", f"{r['euler']} ({r['truth_euler']})",
                "yes" if r["sound"] == "1" else "no", fixed(number(r["seconds"]), 1)])
    return grid


def table_1(table, version):
    grid = Grid(["example", "data set", "mesh generation, s", "tetrahedra", "graph cuts",
                 "cuts, s", "rounds of swaps", "swaps, s"],
                note="The paper's figures in brackets; its machine was a Pentium 4 of 3.2 GHz. Mesh "
                     "generation is both tetrahedralizations, the seeds and the background points.")
    for example, theirs in paper.TABLE_1.items():
        key = (example, "paper", version)
        if key not in table or table[key]["status"] != "ok":
            continue
        ours = [table[key][c] for c in paper.RUN_COLUMNS]
        cells = []
        for column, mine, its in zip(paper.RUN_COLUMNS, ours, theirs):
            text = fixed(float(mine), 2) if column.endswith("_s") else f"{int(mine):,}"
            cells.append(f"{text} ({its:,})")
        grid.rows.append([example.replace("_", " "), *cells])
    return grid


def examples_grid(table, version, examples):
    grid = Grid(["example", "samples", "edge F1 0.1 %, --method paper", "edge F1, default",
                 "normals, °, --method paper", "normals, default", "right topology"],
                note="Edge F1 is 1 where every edge of the truth is there and no other, and 0 where "
                     "the truth has none but the mesh has one, however short.")
    for example in examples:
        rows = [table[(example, s, version)] for s in ("paper", "default")
                if (example, s, version) in table]
        if len(rows) != 2:
            continue
        grid.rows.append([example.replace("_", " "), rows[0]["points"],
                          *(fixed(number(r["edge_strict"]), 3) for r in rows),
                          *(fixed(number(r["normal_error"]), 2) for r in rows),
                          " and ".join("yes" if r["same_topology"] == "1" else "no" for r in rows)])
    return grid


def figure_6(table, version):
    grid = Grid(["what λ = 0.1 weighs", "edge F1 0.1 %", "normals, °", "Chamfer, e-4"],
                note="Two cubes. In all but the last two rows the swaps may take samples off the "
                     "surface, which arris otherwise refuses.")
    for setting, (title, _) in paper.FIGURE_6.items():
        key = (paper.FIGURE_6_EXAMPLE, setting, version)
        if key not in table and setting == "kept":
            key = (paper.FIGURE_6_EXAMPLE, "paper", version)
        if key in table:
            r = table[key]
            grid.rows.append([title, fixed(number(r["edge_strict"]), 3),
                              fixed(number(r["normal_error"]), 2),
                              scaled(1e4, 2)(number(r["chamfer"]))])
    return grid


def speed_rows(table, method, version):
    """points -> stage -> row"""
    sizes = {}
    for row in table.rows.values():
        if row["method"] == method and row["version"] == version and row["status"] == "ok":
            sizes.setdefault(int(row["points"]), {})[row["stage"]] = row
    return {size: rows for size, rows in sorted(sizes.items()) if speed.WHOLE in rows}


def speed_grid(table, version):
    sizes = speed_rows(table, "arris", version)
    stages = list(dict.fromkeys(s for rows in sizes.values() for s in rows if s != speed.WHOLE))
    grid = Grid(["points", *(f"{s}, s" for s in stages), "all, s", "CGAL Delaunay, s", "all / CGAL",
                 "µs a point", "peak, MB", "bytes a point"],
                note="CGAL Delaunay is its sequential tetrahedralization of the same points, alone, "
                     "in the same run. The peak is that of the process.")
    for points, rows in sizes.items():
        whole = rows[speed.WHOLE]
        seconds, cgal = float(whole["seconds"]), float(whole["cgal_delaunay_s"])
        peak = float(whole["peak_mb"])
        grid.rows.append([
            f"{points:,}", *(fixed(number(rows[s]["seconds"]) if s in rows else None, 2)
                             for s in stages),
            fixed(seconds, 2), fixed(cgal, 2), fixed(seconds / cgal, 2),
            fixed(1e6 * seconds / points, 1), fixed(peak, 0), fixed(peak * 2**20 / points, 0)])
    return grid


def stage_memory_grid(table, version):
    sizes = speed_rows(table, "arris", version)
    stages = list(dict.fromkeys(s for rows in sizes.values() for s in rows if s != speed.WHOLE))
    grid = Grid(["points", *stages], note="Peak of the process up to the end of the stage, MB.")
    for points, rows in sizes.items():
        grid.rows.append([f"{points:,}", *(fixed(number(rows[s]["peak_mb"]) if s in rows else None,
                                                 0) for s in stages)])
    return grid


# The tables of each suite with their titles, for a digest.
def paper_digest(suite):
    examples = [e for group in paper.FIGURES.values() for e in group]
    return [("Table 1", table_1(suite.table, suite.version)),
            ("Figure 6", figure_6(suite.table, suite.version)),
            ("Figures 7 to 10", examples_grid(suite.table, suite.version, examples))]


def quality_digest(title, suite, variants):
    rows_of = current(suite.table, suite.methods)
    return [(f"{title}: {v}", quality_grid(rows_of, suite.methods, v)) for v in variants]


def speed_digest(suite, version):
    return [("Time", speed_grid(suite.table, version)),
            ("Memory", stage_memory_grid(suite.table, version))]
