"""The quality suite: models x variants x seeds x methods, each result held against the truth."""
import concurrent.futures
import os
import tempfile
from dataclasses import dataclass, field

from harness import metrics, pictures, process
from harness.table import Table
from harness.truth import MissingTruth

KEY = ("case", "method", "version")
COLUMNS = (*KEY, "model", "variant", "seed", "points", "status", "reason", "seconds", "peak_mb",
           *metrics.COLUMNS)
PICTURE_SEED = 1
POINT_SIZE = ("--points", "--point-size", "1.6")


@dataclass
class Suite:
    arris: str
    truth: object
    methods: list
    cases: list
    table: Table
    pictures: object
    limits: process.Limits
    peer_seeds: int = 1  # peers run on the first so many seeds
    skipped: list = field(default_factory=list)  # (case, reason): no truth or cloud

    def tasks(self):
        """Pairs of case and method that have no row yet."""
        return [(case, method) for case in self.cases for method in self.methods
                if (method.ours or case.seed <= self.peer_seeds)
                and not self.table.is_finished(case.name, method.name, method.version)]

    def run(self, jobs, say):
        tasks = self.tasks()
        say(f"quality: {len(tasks)} runs to do, {len(self.table.rows)} rows are there")
        with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
            futures = [pool.submit(self.one, *task) for task in tasks]
            try:
                for done, future in enumerate(concurrent.futures.as_completed(futures), 1):
                    row = future.result()
                    if row:
                        row = self.table.add(row)
                        say(f"quality {done}/{len(tasks)}: {row['case']} {row['method']} "
                            f"{row['status']} {row['reason']}")
            except BaseException:
                pool.shutdown(wait=False, cancel_futures=True)
                process.kill_all()
                raise

    def one(self, case, method):
        """The row of one result. A failure of the method, or of its mesh, is a row too."""
        try:
            truth, _ = self.truth.model(case.model)
            points, _ = self.truth.cloud(case)
        except MissingTruth as error:
            self.skipped.append((case.name, str(error)))
            return None
        row = {"case": case.name, "method": method.name, "version": method.version,
               "model": case.model, "variant": case.variant, "seed": case.seed,
               "points": count_points(points)}
        self.pictures.remove((case.name, method.name))  # of an older version
        with tempfile.TemporaryDirectory(prefix="arris-bench-") as folder:
            mesh = os.path.join(folder, "mesh.ply")
            outcome = process.run(method.to_mesh(points, mesh), self.limits, folder)
            row.update(status=outcome.status, reason=outcome.reason, seconds=outcome.seconds,
                       peak_mb=outcome.memory / 2**20)
            if outcome.ok:
                drawn = case.seed == PICTURE_SEED
                error = (case.name, "error")
                options = (self.pictures.error_options(error)
                           if drawn and method.name == "arris" else ())
                figures, reason = metrics.measure(self.arris, mesh, truth, options)
                row.update(figures)
                if reason:
                    row.update(status="failed", reason=reason)
                elif drawn:
                    self.draw(case, method, points, mesh, truth)
        return row

    def draw(self, case, method, points, mesh, truth):
        """The result, and of arris also the cloud, the truth and the error map."""
        draw = self.pictures.draw
        draw((case.name, method.name), [mesh])
        if method.name == "arris":
            draw((case.name, "input"), [points], options=POINT_SIZE)
            draw((case.name, "truth"), [truth])
            self.pictures.shrink((case.name, "error"))


def count_points(path):
    """The number of vertices in the header of a PLY file."""
    with open(path, "rb") as file:
        for line in file:
            if line.startswith(b"element vertex "):
                return int(line.split()[2])
            if line.startswith(b"end_header"):
                break
    return 0
