"""What `arris compare --json` says of a pair of meshes, as columns of a table."""
import json

from harness import process

LIMITS = process.Limits(seconds=300)
SAMPLES = 30000  # on each surface

# Column of the table: where the figure stands in the JSON. Lengths are shares of the diagonal,
# angles in degrees.
FIGURES = {
    "chamfer": "chamfer",
    "hausdorff": "hausdorff",
    "f_loose": "fscore_0.005/f1",
    "f_strict": "fscore_0.001/f1",
    "normal_there": "result_to_truth/normal_error_deg",
    "normal_back": "truth_to_result/normal_error_deg",
    "edge_loose": "edges/at_0.005/f1",
    "edge_strict": "edges/at_0.001/f1",
    "corner_recall": "edges/corners/recall",
    "ndc_edge": "ndc/ef1",
    "volume_iou": "volume_iou",
    "components": "result/components",
    "truth_components": "truth/components",
    "euler": "result/euler",
    "truth_euler": "truth/euler",
    "closed": "result/closed",
    "manifold": "result/manifold",
    "intersections": "result/self_intersections",
    "vertices": "result/vertices",
    "triangles": "result/triangles",
}
COLUMNS = (*FIGURES, "normal_error", "same_topology", "sound")


def look_up(report, path):
    for part in path.split("/"):
        if not isinstance(report, dict) or part not in report:
            raise KeyError(f"arris compare reports no {path}")
        report = report[part]
    return report


def figures_of(report):
    row = {column: look_up(report, path) for column, path in FIGURES.items()}
    errors = (row["normal_there"], row["normal_back"])
    row["normal_error"] = None if None in errors else sum(errors) / 2
    # Degenerate triangles do not count here: components and Euler characteristic do not see them.
    row["same_topology"] = bool(row["closed"] and row["manifold"]
                                and row["components"] == row["truth_components"]
                                and row["euler"] == row["truth_euler"])
    # What a user can rely on: a solid without faults of its surface.
    row["sound"] = bool(row["closed"] and row["manifold"] and row["intersections"] == 0)
    return row


def measure(arris, mesh, truth, options=()):
    """The figures, and why there are none (empty if there are). `options` are those of the
    command, for a picture of the errors."""
    outcome = process.run([arris, "compare", mesh, truth, "--json", "--quiet", "--samples",
                           str(SAMPLES), "--threads", "1", *options], LIMITS)
    if not outcome.ok:
        return {}, f"compare: {outcome.reason}"
    return figures_of(json.loads(outcome.output)), ""
