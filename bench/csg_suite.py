#!/usr/bin/env python3
"""Random solids there and back: model, evenly spread samples, reconstruction, check.

    bench/csg_suite.py ARRIS OUT.csv [--seeds 200] [--first 1] [--jobs 1] [--models-only] [--keep DIR]

For each seed: arris model csg; arris sample --mode blue with as many samples as the model says are
dense enough (four spacings across its thinnest part); arris reconstruct; arris check; arris compare for
the F1 of sharp edges within 0.1 % of the diagonal (none if there are no sharp edges). One line of
OUT.csv per seed, written as soon as it is known: a run that was interrupted goes on where it was,
and seeds that are in the file already are not done again. Prints a summary of the file at the end;
fails if a model or a result is not closed, manifold and free of intersections.
"""
import argparse
import concurrent.futures
import csv
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time

COLUMNS = ["seed", "recipe", "triangles", "components", "euler", "volume", "area", "wall", "gap",
           "detail", "clearance", "neck", "samples", "outcome", "result_triangles", "result_components", "result_euler",
           "result_volume", "edge_f1", "model_seconds", "reconstruct_seconds"]
# A reconstruction of this many points takes seconds.
TIME_LIMIT = 600


def run(command):
    return subprocess.run(command, capture_output=True, text=True, timeout=TIME_LIMIT)


def last_line(text):
    return (text.strip().splitlines() or ["no message"])[0]


def do_seed(arris, seed, directory, models_only):
    """The row of one seed. outcome: certified, or what failed first."""
    row = {"seed": seed}
    truth, cloud, result = (os.path.join(directory, f"{seed}.{part}.ply")
                            for part in ("truth", "cloud", "result"))
    start = time.monotonic()
    made = run([arris, "model", "csg", "--seed", str(seed), "-o", truth, "--json"])
    row["model_seconds"] = f"{time.monotonic() - start:.2f}"
    if made.returncode != 0:
        return row | {"outcome": "model: " + last_line(made.stderr)}
    known = json.loads(made.stdout)
    row |= {key: known[key] for key in COLUMNS if key in known and key != "seed"}
    row["samples"] = known["dense_samples"]
    checked = run([arris, "check", truth, "--json"])
    if checked.returncode != 0:
        return row | {"outcome": "model: " + last_line(checked.stderr)}
    if models_only:
        return row | {"outcome": "certified"}

    sampled = run([arris, "sample", truth, "-n", str(row["samples"]), "--mode", "blue", "-o", cloud])
    if sampled.returncode != 0:
        return row | {"outcome": "sample: " + last_line(sampled.stderr)}
    start = time.monotonic()
    rebuilt = run([arris, "reconstruct", cloud, "-o", result, "--quiet", "--threads", "1"])
    row["reconstruct_seconds"] = f"{time.monotonic() - start:.2f}"
    if rebuilt.returncode != 0:
        return row | {"outcome": "reconstruct: " + last_line(rebuilt.stderr)}
    checked = run([arris, "check", result, "--json"])
    if checked.returncode != 0:
        return row | {"outcome": "result: " + last_line(checked.stderr)}
    found = json.loads(checked.stdout)
    for key in ("triangles", "components", "euler", "volume"):
        row["result_" + key] = found[key]
    compared = run([arris, "compare", result, truth, "--json", "--samples", "20000", "--threads", "1"])
    if compared.returncode != 0:
        return row | {"outcome": "compare: " + last_line(compared.stderr)}
    row["edge_f1"] = json.loads(compared.stdout)["edges"]["at_0.001"]["f1"]
    return row | {"outcome": "certified"}


def right_topology(row):
    return (row["components"], row["euler"]) == (row["result_components"], row["result_euler"])


def summarize(rows):
    certified = [row for row in rows if row["outcome"] == "certified"]
    print(f"{len(rows)} seeds, {len(certified)} certified")
    for row in rows:
        if row["outcome"] != "certified":
            print(f"  seed {row['seed']}: {row['outcome']}")
    rebuilt = [row for row in certified if row["result_euler"] != ""]
    wrong = [row for row in rebuilt if not right_topology(row)]
    if rebuilt:
        share = 100 * (len(rebuilt) - len(wrong)) / len(rebuilt)
        print(f"right components and Euler characteristic: {len(rebuilt) - len(wrong)} "
              f"of {len(rebuilt)} ({share:.1f} %)")
    for row in wrong:
        print(f"  seed {row['seed']}: components {row['components']} -> {row['result_components']}, "
              f"Euler {row['euler']} -> {row['result_euler']}; {row['recipe']}")
    edge_f1 = [float(row["edge_f1"]) for row in rebuilt if row["edge_f1"] not in ("", None)]
    if edge_f1:
        print(f"sharp-edge F1 at 0.1 %: median {statistics.median(edge_f1):.3f} "
              f"of {len(edge_f1)} with sharp edges")
    return len(certified) == len(rows)


def do_all(arguments, seeds, scratch):
    """Yields the rows as they are known."""
    def do_one(seed):
        with tempfile.TemporaryDirectory(dir=scratch) as directory:
            return do_seed(arguments.arris, seed, arguments.keep or directory,
                           arguments.models_only)

    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for done in concurrent.futures.as_completed([pool.submit(do_one, s) for s in seeds]):
            yield done.result()


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("arris")
    parser.add_argument("out")
    parser.add_argument("--seeds", type=int, default=200)
    parser.add_argument("--first", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1, help="seeds at a time")
    parser.add_argument("--models-only", action="store_true")
    parser.add_argument("--keep", help="keep models, clouds and results in this directory")
    arguments = parser.parse_args()

    done = set()
    if os.path.exists(arguments.out):
        with open(arguments.out, newline="") as file:
            done = {int(row["seed"]) for row in csv.DictReader(file)}
    with open(arguments.out, "a", newline="") as file, tempfile.TemporaryDirectory() as scratch:
        writer = csv.DictWriter(file, COLUMNS, restval="")
        if file.tell() == 0:
            writer.writeheader()
        if arguments.keep:
            os.makedirs(arguments.keep, exist_ok=True)
        seeds = range(arguments.first, arguments.first + arguments.seeds)
        for row in do_all(arguments, [s for s in seeds if s not in done], scratch):
            writer.writerow(row)
            file.flush()
    with open(arguments.out, newline="") as file:
        return 0 if summarize(list(csv.DictReader(file))) else 1


if __name__ == "__main__":
    sys.exit(main())
