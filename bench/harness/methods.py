"""What is compared: arris and its peers, each a command from points to a mesh, with the settings
that the page states."""
import hashlib
import os
import sys
from dataclasses import dataclass

from harness import process

PEERS = os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "peers")
VERSION_LIMITS = process.Limits(seconds=60)


@dataclass(frozen=True)
class Method:
    name: str  # in tables and files
    title: str  # on the page
    settings: str
    command: tuple  # with {points} and {mesh} to fill in
    version: str = ""  # of the program and of what drives it; part of the key of a result
    ours: bool = False

    def to_mesh(self, points, mesh):
        return [part.format(points=points, mesh=mesh) for part in self.command]


CGAL_METHODS = (
    ("poisson", "CGAL Poisson",
     "normals by jet fitting over 18 neighbours, oriented by a minimum spanning tree over 18, "
     "points that it leaves unoriented dropped; poisson_surface_reconstruction_delaunay with the "
     "average spacing (6 neighbours) and a mesh of 20 degrees, radius 2, distance 0.1 spacings; the "
     "default radius of 30 gives a thousand triangles for 4000 points"),
    ("advancing_front", "CGAL advancing front", "defaults: radius ratio bound 5, beta 0.52"),
    ("scale_space", "CGAL scale space",
     "four smoothings with the jet smoother, advancing front mesher with edges of at most 5 average "
     "spacings; the vertices are the input points"),
    ("alpha_wrap", "CGAL alpha wrap",
     "alpha 4 average spacings, offset 0.05; with an alpha of 3 it enters the solid between random "
     "samples"),
)
OPEN3D_METHODS = (
    ("poisson", "Open3D Poisson",
     "normals over 30 neighbours, oriented by consistent tangent planes over 30; depth 9, nothing "
     "trimmed"),
    ("ball_pivoting", "Open3D ball pivoting",
     "the same normals; radii 0.75, 1.5 and 3 average spacings"),
    ("alpha_shape", "Open3D alpha shape",
     "alpha 6 average spacings: of 1.5, 3, 6, 12 and 24 the best on two cubes. It returns the "
     "boundary of small tetrahedra, so flat faces need a large alpha and concave edges a small one"),
)
PYMESHLAB_METHODS = (
    ("screened_poisson", "MeshLab screened Poisson",
     "normals over 16 neighbours, propagated; depth 9, pre-clean, other values default"),
    ("rimls", "MeshLab RIMLS", "the same normals; marching cubes with 200 cells, other values "
     "default; duplicate vertices and null faces of the marching cubes removed"),
    ("ball_pivoting", "MeshLab ball pivoting", "the same normals; radius chosen by MeshLab"),
)


def fingerprint(path):
    with open(path, "rb") as file:
        return hashlib.sha256(file.read()).hexdigest()[:8]


def program_version(command):
    """The output of `command --version`, or None if it cannot be run."""
    outcome = process.run([*command, "--version"], VERSION_LIMITS)
    return outcome.output.strip() if outcome.ok else None


def arris_methods(arris):
    version = program_version([arris])
    if version is None:
        raise SystemExit(f"benchmark: {arris} cannot be run: build it first, with make")
    version = f"{version.removeprefix('arris ')}-{fingerprint(arris)}"
    run = (arris, "reconstruct", "{points}", "-o", "{mesh}", "--quiet", "--threads", "1",
           "--report", "{mesh}.json")
    return [
        Method("arris", "arris", "defaults", run, version, True),
        Method("arris_paper", "arris --method paper", "the setting of the paper",
               (*run, "--method", "paper"), version, True),
    ]


def find_peers(build):
    """All peers that scripts/install-peers.sh has installed, and the names of missing families."""
    python = os.path.join(build, "peers", "bin", "python")
    cgal = os.path.join(build, "cgal_peers")
    families = (
        ("cgal", [cgal], CGAL_METHODS),
        ("open3d", [python, os.path.join(PEERS, "open3d_peers.py")], OPEN3D_METHODS),
        ("meshlab", [python, os.path.join(PEERS, "pymeshlab_peers.py")], PYMESHLAB_METHODS),
    )
    found, missing = [], []
    for family, command, methods in families:
        version = program_version(command)
        if not version:
            missing.append(family)
            continue
        version = f"{version}-{fingerprint(command[-1])}"
        found += [Method(f"{family}_{name}", title, settings,
                         (*command, name, "{points}", "{mesh}"), version)
                  for name, title, settings in methods]
    if missing:
        print(f"benchmark: peers not found: {', '.join(missing)} (scripts/install-peers.sh)",
              file=sys.stderr)
    return found, missing
