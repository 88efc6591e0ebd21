"""The paper suite: table 1 and figures 6 to 10 of Shi, Wan, Tai and Wang (SSVM 2011), with arris.

Clouds have samples on corners and edges, as the paper's pictures show them. Models are made after
the figures; the paper gives sizes for four of them only.
"""
import json
import os
import tempfile

from harness import metrics, process
from harness.pictures import LARGE_VIEW
from harness.quality import POINT_SIZE, count_points
from harness.truth import Case, MissingTruth

KEY = ("example", "setting", "version")
RUN_COLUMNS = ("points", "mesh_s", "tetrahedra", "cuts", "cuts_s", "rounds", "swap_s")
COLUMNS = (*KEY, "status", "reason", *RUN_COLUMNS, "seconds", "peak_mb", *metrics.COLUMNS)
LIMITS = process.Limits(seconds=600)

# Table 1, on a Pentium 4 of 3.2 GHz: the columns of RUN_COLUMNS.
TABLE_1 = {
    "two_cubes": (2472, 24.1, 175851, 3, 0.33, 5, 5.57),
    "two_spheres": (2653, 34.2, 218119, 3, 0.42, 4, 0.31),
    "female_symbol": (4530, 41.8, 307968, 3, 0.63, 7, 11.57),
    "bolt": (2357, 34.9, 223346, 3, 0.41, 6, 2.57),
}
FIGURES = {
    "Figure 7: the unions of geometries": ("two_cubes", "two_spheres"),
    "Figure 8: a perforated cube, two tangling ones, male and female symbol":
        ("perforated_cube", "tangled_cubes", "male_symbol", "female_symbol"),
    "Figure 9: dodecahedron, icosahedron, buckyball and brilliant cut diamond":
        ("dodecahedron", "icosahedron", "buckyball", "brilliant_diamond"),
    "Figure 10: power wheel, tear drop, dumb bell and bolt":
        ("power_wheel", "tear_drop", "dumb_bell", "bolt"),
}
SETTINGS = {"paper": ("--method", "paper"), "default": ()}
# Figure 6: what λ weighs, from total variation to what arris does.
FIGURE_6_EXAMPLE = "two_cubes"
FIGURE_6 = {
    "area": ("total variation: λ weighs area",
             ("--method", "paper", "--curvature", "area", "--free-samples")),
    "distance": ("λ = 0: distance alone", ("--method", "paper", "--lambda", "0", "--free-samples")),
    "cotangent": ("the paper's curvature", ("--method", "paper", "--free-samples")),
    "polyhedral": ("polyhedral curvature",
                   ("--method", "paper", "--curvature", "polyhedral", "--free-samples")),
    "area_kept": ("area, and no sample may leave the surface",
                  ("--method", "paper", "--curvature", "area")),
    "kept": ("the paper's curvature, and no sample may leave: --method paper",
             ("--method", "paper")),
}
FEWEST_SAMPLES = 4000  # where the paper gives no size


def case_of(example):
    size = TABLE_1[example][0] if example in TABLE_1 else 0
    return Case(example, "feature", 1, size)


def run_figures(report):
    """The columns of table 1 from the report of arris."""
    seconds = {"mesh": 0, "cuts": 0, "swap": 0}
    for stage in report["stages"]:
        name = stage["name"]
        if name in ("delaunay", "seeds", "background"):
            seconds["mesh"] += stage["seconds"]
        elif name.startswith("cut"):
            seconds["cuts"] += stage["seconds"]
        elif name == "swap":
            seconds["swap"] += stage["seconds"]
    return {"mesh_s": seconds["mesh"], "tetrahedra": report["tetrahedra"],
            "cuts": len(report["cut_energy"]), "cuts_s": seconds["cuts"],
            "rounds": max(0, len(report["swap_energy"]) - 1), "swap_s": seconds["swap"]}


class Suite:
    def __init__(self, arris, version, truth, table, pictures, examples):
        self.arris, self.version, self.truth = arris, version, truth
        self.table, self.pictures, self.examples = table, pictures, examples
        self.skipped = []

    def tasks(self):
        settings = [(e, s, o) for e in self.examples for s, o in SETTINGS.items()]
        if FIGURE_6_EXAMPLE in self.examples:
            settings += [(FIGURE_6_EXAMPLE, s, o) for s, (_, o) in FIGURE_6.items()]
        return [t for t in settings if not self.table.is_finished(t[0], t[1], self.version)]

    def run(self, say):
        """One at a time: Table 1 has times."""
        tasks = self.tasks()
        say(f"paper: {len(tasks)} runs to do, {len(self.table.rows)} rows are there")
        for done, (example, setting, options) in enumerate(tasks, 1):
            try:
                row = self.table.add(self.one(example, setting, options))
            except MissingTruth as error:
                self.skipped.append((example, str(error)))
                continue
            say(f"paper {done}/{len(tasks)}: {example} {setting} {row['status']} {row['reason']}")

    def one(self, example, setting, options):
        truth, _ = self.truth.model(example)
        points, _ = self.truth.cloud(case_of(example))
        row = {"example": example, "setting": setting, "version": self.version,
               "points": count_points(points)}
        with tempfile.TemporaryDirectory(prefix="arris-bench-") as folder:
            mesh, report = os.path.join(folder, "mesh.ply"), os.path.join(folder, "report.json")
            outcome = process.run([self.arris, "reconstruct", points, "-o", mesh, "--report",
                                   report, "--quiet", "--threads", "1", *options], LIMITS)
            row.update(status=outcome.status, reason=outcome.reason, seconds=outcome.seconds,
                       peak_mb=outcome.memory / 2**20)
            if not outcome.ok:
                return row
            with open(report, encoding="utf-8") as file:
                row.update(run_figures(json.load(file)))
            figures, reason = metrics.measure(self.arris, mesh, truth)
            row.update(figures)
            if reason:
                row.update(status="failed", reason=reason)
            draw = self.pictures.draw
            draw(("paper", f"{example}-{setting}"), [mesh], LARGE_VIEW)
            draw(("paper", f"{example}-input"), [points], LARGE_VIEW, POINT_SIZE)
        return row
