"""The speed suite: time and memory of every stage over sizes, against CGAL's Delaunay
tetrahedralization of the same points in the same run, and of the peers."""
import json
import os
import tempfile

from harness import process

KEY = ("points", "method", "version", "stage")
COLUMNS = (*KEY, "status", "reason", "seconds", "peak_mb", "cgal_delaunay_s", "triangles")
WHOLE = "all"  # the stage that stands for the whole run, and ends its rows


class Suite:
    def __init__(self, program, methods, sizes, peer_sizes, table, limits):
        """`program` is scaling_bench; `methods` are the peers, run on sizes of `peer_sizes`."""
        self.program, self.methods, self.sizes = program, methods, sizes
        self.peer_sizes, self.table, self.limits = peer_sizes, table, limits

    def run(self, version, say):
        for size in self.sizes:
            if not self.table.is_finished(size, "arris", version, WHOLE):
                for row in self.arris(size, version):
                    self.table.add(row)
                say(f"speed: arris, {size} points, {row['status']} {row['reason']} "
                    f"{row.get('seconds') or 0:.1f} s")
        for size in self.peer_sizes:
            todo = [m for m in self.methods
                    if not self.table.is_finished(size, m.name, m.version, WHOLE)]
            if todo:
                self.peers(size, todo, say)

    def arris(self, size, version):
        outcome = process.run([self.program, str(size)], self.limits)
        common = {"points": size, "method": "arris", "version": version,
                  "status": outcome.status, "reason": outcome.reason}
        if not outcome.ok:
            return [{**common, "stage": WHOLE, "seconds": outcome.seconds,
                     "peak_mb": outcome.memory / 2**20}]
        report = json.loads(outcome.output)
        stages = report["stages"]
        rows = [{**common, "stage": s["name"], "seconds": s["seconds"],
                 "peak_mb": s["peak_memory"] / 2**20} for s in stages]
        return rows + [{**common, "stage": WHOLE, "seconds": sum(s["seconds"] for s in stages),
                        "peak_mb": max(s["peak_memory"] for s in stages) / 2**20,
                        "cgal_delaunay_s": report["cgal_delaunay_seconds"],
                        "triangles": report["triangles"]}]

    def peers(self, size, methods, say):
        with tempfile.TemporaryDirectory(prefix="arris-bench-") as folder:
            points, mesh = os.path.join(folder, "points.ply"), os.path.join(folder, "mesh.ply")
            made = process.run([self.program, str(size), "--write", points], self.limits)
            if not made.ok:
                say(f"speed: no cloud of {size} points: {made.reason}")
                return
            for method in methods:
                outcome = process.run(method.to_mesh(points, mesh), self.limits, folder)
                row = self.table.add({
                    "points": size, "method": method.name, "version": method.version,
                    "stage": WHOLE, "status": outcome.status, "reason": outcome.reason,
                    "seconds": outcome.seconds, "peak_mb": outcome.memory / 2**20})
                say(f"speed: {method.name}, {size} points, {row['status']} {row['reason']} "
                    f"{row['seconds']} s")
