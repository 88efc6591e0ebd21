"""The surface reconstructions of MeshLab, as peers in the benchmark: one method, one process.

    pymeshlab_peers.py METHOD POINTS.ply MESH.ply    METHOD: screened_poisson rimls ball_pivoting
    pymeshlab_peers.py --version

bench/harness/methods.py states the settings for the page.
"""
import sys

import pymeshlab

NORMAL_NEIGHBOURS = 16
POISSON_DEPTH = 9
RIMLS_RESOLUTION = 200  # cells along the longest side; MeshLab's default


def normals(meshes):
    meshes.compute_normal_for_point_clouds(k=NORMAL_NEIGHBOURS)


def screened_poisson(meshes):
    normals(meshes)
    meshes.generate_surface_reconstruction_screened_poisson(
        depth=POISSON_DEPTH, preclean=True, threads=1)


def rimls(meshes):
    normals(meshes)
    meshes.generate_marching_cubes_rimls(resolution=RIMLS_RESOLUTION)
    # Where the surface meets a corner of the grid there are several vertices at one place.
    meshes.meshing_remove_duplicate_vertices()
    meshes.meshing_remove_null_faces()
    meshes.meshing_remove_unreferenced_vertices()


def ball_pivoting(meshes):
    normals(meshes)
    meshes.generate_surface_reconstruction_ball_pivoting()  # it chooses the radius


METHODS = {f.__name__: f for f in (screened_poisson, rimls, ball_pivoting)}


def main(arguments):
    if arguments == ["--version"]:
        from importlib.metadata import version
        print(version("pymeshlab"))
        return 0
    if len(arguments) != 3 or arguments[0] not in METHODS:
        print(__doc__, file=sys.stderr)
        return 2
    meshes = pymeshlab.MeshSet()
    meshes.load_new_mesh(arguments[1])
    try:
        METHODS[arguments[0]](meshes)
    except pymeshlab.PyMeshLabException as error:
        print(f"pymeshlab_peers: {error}", file=sys.stderr)
        return 1
    if meshes.current_mesh().face_number() == 0:
        print("pymeshlab_peers: no faces", file=sys.stderr)
        return 1
    meshes.save_current_mesh(arguments[2], save_vertex_quality=False, save_vertex_normal=False,
                             save_vertex_color=False, save_face_quality=False)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
