#!/usr/bin/env python3
"""Measures arris against ground truth, the paper and its peers, and writes one page.

    bench/benchmark.py                  minutes: a few models, the peers that are installed
    bench/benchmark.py --full           hours: everything; stop and start it again at will
    bench/benchmark.py --quick          under two minutes, no peers: that the benchmark runs
    bench/benchmark.py --page           no new runs: the page from the rows that are there

Rows go to OUT/*.csv as they are finished; a row that is there is not run again unless the program
or the settings behind it have changed. OUT/index.html needs nothing beside it; OUT/summary.md has its
tables alone.
"""
import argparse
import os
import platform
import signal
import subprocess
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
from harness import methods, page, paper, process, quality, speed, summary, truth  # noqa: E402
from harness.pictures import Pictures  # noqa: E402
from harness.table import Table  # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))
SOME_MODELS = ("two_cubes", "bolt", "l_bracket", "torus")
SOME_VARIANTS = ("blue", "scan", "blue_noise050")


def csg(count):
    return tuple(f"csg:{seed}" for seed in range(1, count + 1))


# What each size of the benchmark covers.
PRESETS = {
    "quick": {"models": ("two_cubes", "torus"), "variants": ("blue",), "seeds": 1,
              "peer_seeds": 0, "examples": ("two_cubes",), "sizes": (10_000,), "peer_sizes": ()},
    "some": {"models": (*SOME_MODELS, *csg(1)), "variants": SOME_VARIANTS, "seeds": 1,
             "peer_seeds": 1, "examples": truth.PAPER_MODELS,
             "sizes": (10_000, 100_000, 1_000_000), "peer_sizes": (10_000,)},
    "full": {"models": (*truth.PAPER_MODELS, *truth.MORE_MODELS, *csg(20)),
             "variants": tuple(truth.VARIANTS), "seeds": 3, "peer_seeds": 1,
             "examples": truth.PAPER_MODELS,
             "sizes": (10_000, 100_000, 1_000_000, 10_000_000),
             "peer_sizes": (10_000, 100_000, 1_000_000)},
}
BYTES_A_POINT = 2400  # the forecast of arris; sizes that need more than there is are left out


def parse(arguments):
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    preset = parser.add_mutually_exclusive_group()
    preset.add_argument("--quick", dest="preset", action="store_const", const="quick")
    preset.add_argument("--full", dest="preset", action="store_const", const="full")
    parser.set_defaults(preset="some")
    parser.add_argument("--build", default="build", help="the build directory (build)")
    parser.add_argument("--out", default=os.path.join(HERE, "results"),
                        help="where rows, pictures and the page go (bench/results)")
    parser.add_argument("--suites", default="paper,quality,speed")
    parser.add_argument("--models", help="of the quality suite; csg:SEED is a random solid")
    parser.add_argument("--variants", help=", ".join(truth.VARIANTS))
    parser.add_argument("--seeds", type=int, help="clouds a model and variant")
    parser.add_argument("--methods", help="only these (as in the tables' column `method`)")
    parser.add_argument("--no-peers", action="store_true")
    parser.add_argument("--sizes", help="points of the speed suite, separated by commas or spaces")
    parser.add_argument("--jobs", type=int, default=os.cpu_count(),
                        help="runs of the quality suite at a time (one a processor)")
    parser.add_argument("--seconds", type=float, default=120, help="limit of a run (120)")
    parser.add_argument("--memory", type=float, default=4, help="limit of a run, GiB (4)")
    parser.add_argument("--data", help="a folder with gt/MODEL.ply and clouds/MODEL__VARIANT.ply: "
                                       "one more quality suite")
    parser.add_argument("--retry", action="store_true",
                        help="run again what failed, for instance for the limit of time")
    parser.add_argument("--page", action="store_true", help="run nothing, write the page")
    return parser.parse_args(arguments)


def split(text, default):
    return tuple(text.replace(",", " ").split()) if text else default


def memory_bytes():
    return os.sysconf("SC_PAGE_SIZE") * os.sysconf("SC_PHYS_PAGES")


def machine():
    name = platform.processor() or platform.machine()
    try:
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            name = next((line.partition(":")[2].strip() for line in file
                         if line.startswith("model name")), name)
    except OSError:
        pass
    return f"{os.cpu_count()} x {name}, {memory_bytes() / 2**30:.0f} GiB"


class Benchmark:
    def __init__(self, options):
        self.options, self.preset = options, PRESETS[options.preset]
        options.build, options.out = map(os.path.abspath, (options.build, options.out))
        self.arris = os.path.join(options.build, "arris")
        self.ours = methods.arris_methods(self.arris)
        self.peers, self.missing = [], []
        if not options.no_peers and self.preset["peer_seeds"]:
            self.peers, self.missing = methods.find_peers(options.build)
        self.limits = process.Limits(options.seconds, int(options.memory * process.GIB))
        self.truth = truth.Truth(self.arris, os.path.join(options.build, "bench-data"))
        self.suites = set(split(options.suites, ()))

    @property
    def version(self):
        return self.ours[0].version

    def chosen(self, found):
        names = split(self.options.methods, ())
        return [m for m in found if not names or m.name in names]

    def pictures(self, name):
        return Pictures(self.arris, os.path.join(self.options.out, "pictures", name))

    def table(self, name, module):
        return Table(os.path.join(self.options.out, f"{name}.csv"), module.KEY, module.COLUMNS,
                     self.options.retry)

    def paper_suite(self):
        return paper.Suite(self.arris, self.version, self.truth, self.table("paper", paper),
                           self.pictures("paper"), self.preset["examples"])

    def quality_suite(self, name, source, cases, variants):
        cases = [c for c in cases if c.variant in variants]
        return quality.Suite(self.arris, source, self.chosen(self.ours + self.peers), cases,
                             self.table(name, quality), self.pictures(name), self.limits,
                             self.preset["peer_seeds"])

    def quality_suites(self):
        """Title, suite and variants."""
        variants = split(self.options.variants, self.preset["variants"])
        seeds = range(1, (self.options.seeds or self.preset["seeds"]) + 1)
        models = split(self.options.models, self.preset["models"])
        cases = [truth.Case(m, v, s) for m in models for v in variants for s in seeds]
        yield "Quality", self.quality_suite("quality", self.truth, cases, variants), variants
        if self.options.data:
            source = truth.SharedTruth(os.path.abspath(self.options.data))
            cases = [c for c in source.cases() if not self.options.models or c.model in models]
            name = os.path.basename(source.folder)
            yield (f"Quality on {name}",
                   self.quality_suite(f"quality-{name}", source, cases, variants), variants)

    def speed_suite(self):
        sizes = [int(s) for s in split(self.options.sizes, self.preset["sizes"])]
        fit = [s for s in sizes if s * BYTES_A_POINT < memory_bytes()]
        for size in sorted(set(sizes) - set(fit)):
            say(f"speed: {size} points do not fit into the memory of this machine")
        peer_sizes = [s for s in self.preset["peer_sizes"] if s in fit]
        seconds = max(self.options.seconds, 1800 if self.options.preset == "full" else 300)
        limits = process.Limits(seconds, memory_bytes())
        program = os.path.join(self.options.build, "scaling_bench")
        return speed.Suite(program, self.chosen(self.peers), fit, peer_sizes,
                           self.table("speed", speed), limits)

    def heading(self):
        revision = subprocess.run(["git", "describe", "--always", "--dirty"], cwd=HERE, text=True,
                                  capture_output=True, check=False).stdout.strip()
        return page.heading({
            "arris": f"{self.version} {revision}".strip(), "machine": machine(),
            "peers found": ", ".join(sorted({f"{m.name.split('_')[0]} {m.version}"
                                             for m in self.peers})) or "none",
            "peers not found": ", ".join(self.missing) or "none"})

    def failures(self, *tables):
        """Rows of the arris at hand that are no sound mesh."""
        return [row for table in tables for row in table.rows.values()
                if row["version"] == self.version
                and (row["status"] != "ok" or row.get("sound", "1") != "1")]

    def run(self):
        """Runs what is to do and writes the page. Returns the failures of arris."""
        tables = []
        running = not self.options.page
        digest = []  # the tables alone
        sections = [self.heading(), page.methods_section(self.ours + self.peers, self.missing)]
        if "paper" in self.suites:
            suite = self.paper_suite()
            tables.append(suite.table)
            if running:
                suite.run(say)
            sections.append(page.paper_section(suite, suite.pictures))
            digest += summary.paper_digest(suite)
        if "quality" in self.suites:
            for title, suite, variants in self.quality_suites():
                tables.append(suite.table)
                if running:
                    suite.run(self.options.jobs, say)
                sections.append(page.quality_section(title, suite, variants, suite.pictures))
                digest += summary.quality_digest(title, suite, variants)
        if "speed" in self.suites:
            suite = self.speed_suite()
            tables.append(suite.table)
            if running:
                suite.run(self.version, say)
            sections.append(page.speed_section(suite, self.version, machine()))
            digest += summary.speed_digest(suite, self.version)
        path = os.path.join(self.options.out, "index.html")
        os.makedirs(self.options.out, exist_ok=True)
        page.write(path, sections)
        with open(os.path.join(self.options.out, "summary.md"), "w", encoding="utf-8") as file:
            file.writelines(f"## {title}\n\n{grid.markdown()}\n" for title, grid in digest
                            if grid.rows)
        say(f"page: {path}, {os.path.getsize(path) / 1e6:.1f} MB")
        return self.failures(*tables)


def say(text):
    print(text, file=sys.stderr, flush=True)


def main():
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    os.environ.setdefault("OMP_NUM_THREADS", "1")  # of the peers; arris is told on its command line
    options = parse(sys.argv[1:])
    try:
        failures = Benchmark(options).run()
        for row in failures:
            say("arris failed: " + ", ".join(f"{k} {v}" for k, v in list(row.items())[:10] if v))
    except KeyboardInterrupt:
        say("benchmark: interrupted; the same command goes on from here")
        return 130
    # A measurement may have failures in it; a check that the benchmark runs may not.
    return 1 if failures and options.preset == "quick" else 0


if __name__ == "__main__":
    sys.exit(main())
