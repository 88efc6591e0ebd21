"""Ground truth and clouds, made by `arris model` and `arris sample`, kept in a folder."""
import json
import os
import threading
from dataclasses import dataclass

from harness import process

PAPER_MODELS = ("two_cubes", "two_spheres", "perforated_cube", "tangled_cubes", "male_symbol",
                "female_symbol", "dodecahedron", "icosahedron", "buckyball", "brilliant_diamond",
                "power_wheel", "tear_drop", "dumb_bell", "bolt")
MORE_MODELS = ("cube", "sphere", "cylinder", "cone", "torus", "thin_plate", "wedge", "l_bracket",
               "drilled_bracket", "nested_shells", "steps", "octahedron", "hexagonal_prism")
# What is done to a model; noise is a share of the diagonal of its bounding box.
VARIANTS = {
    "feature": "--mode feature",
    "blue": "--mode blue",
    "uniform": "--mode uniform",
    "graded": "--mode graded",
    "hole": "--mode blue --missing 2",
    "scan": "--mode scan --noise 0.05%",
    "blue_noise025": "--mode blue --noise 0.25%",
    "blue_noise050": "--mode blue --noise 0.5%",
    "blue_outl5": "--mode blue --outliers 5%",
}
FEWEST_SAMPLES, MOST_SAMPLES = 4000, 40000


@dataclass(frozen=True)
class Case:
    model: str  # a name of `arris model`, or csg:SEED
    variant: str
    seed: int
    samples: int = 0  # 0: dense enough for the model

    @property
    def name(self):
        size = f"_{self.samples}" if self.samples else ""
        return f"{self.model.replace(':', '')}__{self.variant}{size}__{self.seed}"


class MissingTruth(Exception):
    """A model or cloud could not be made; the text says why."""


class Truth:
    def __init__(self, arris, folder):
        self.arris, self.folder = arris, folder
        self.making = threading.RLock()  # one thread makes, others wait for it
        os.makedirs(folder, exist_ok=True)

    def _run(self, *arguments):
        outcome = process.run([self.arris, *arguments])
        if not outcome.ok:
            raise MissingTruth(f"arris {arguments[0]}: {outcome.reason}")
        return outcome.output

    def model(self, name):
        """The mesh of the model, and what `arris model --json` says of it."""
        mesh = os.path.join(self.folder, name.replace(":", "") + ".ply")
        facts = mesh[:-4] + ".json"
        with self.making:
            if not (os.path.exists(mesh) and os.path.exists(facts)):
                plain, _, seed = name.partition(":")
                text = self._run("model", plain, *(["--seed", seed] if seed else []), "--unit",
                                 "-o", mesh, "--json")
                with open(facts, "w", encoding="utf-8") as file:
                    file.write(text)
        with open(facts, encoding="utf-8") as file:
            return mesh, json.load(file)

    def cloud(self, case):
        """The points of a case, as a path, and how many samples were asked for."""
        mesh, facts = self.model(case.model)
        samples = case.samples or min(max(FEWEST_SAMPLES, int(facts["dense_samples"] or 0)),
                                      MOST_SAMPLES)
        points = os.path.join(self.folder, case.name + ".ply")
        with self.making:
            if not os.path.exists(points):
                self._run("sample", mesh, "-n", str(samples), *VARIANTS[case.variant].split(),
                          "--seed", str(case.seed), "-o", points, "--quiet")
        return points, samples


class SharedTruth(Truth):
    """Meshes and clouds that lie in a folder already: gt/MODEL.ply, clouds/MODEL__VARIANT.ply."""

    def __init__(self, folder):
        self.folder = folder

    def model(self, name):
        mesh = os.path.join(self.folder, "gt", name + ".ply")
        if not os.path.exists(mesh):
            raise MissingTruth(f"{mesh} is not there")
        return mesh, {}

    def cloud(self, case):
        points = os.path.join(self.folder, "clouds", f"{case.model}__{case.variant}.ply")
        if not os.path.exists(points):
            raise MissingTruth(f"{points} is not there")
        return points, 0

    def cases(self):
        names = sorted(n[:-4] for n in os.listdir(os.path.join(self.folder, "clouds"))
                       if n.endswith(".ply"))
        return [Case(*name.split("__", 1), 1) for name in names]
