"""The surface reconstructions of Open3D, as peers in the benchmark: one method, one process.

    open3d_peers.py METHOD POINTS.ply MESH.ply    METHOD: poisson ball_pivoting alpha_shape
    open3d_peers.py --version

Lengths are in units of the average distance to the six nearest neighbours, the measure that CGAL
calls the average spacing. bench/harness/methods.py states the settings for the page.
"""
import sys

import numpy
import open3d

NORMAL_NEIGHBOURS = 30  # as in Open3D's tutorial
POISSON_DEPTH = 9
BALL_RADII = (0.75, 1.5, 3)  # in units of spacing
ALPHA = 1.5  # in units of spacing


def spacing(cloud):
    tree = open3d.geometry.KDTreeFlann(cloud)
    squared = [tree.search_knn_vector_3d(p, 7)[2] for p in cloud.points]
    return float(numpy.mean([numpy.sqrt(numpy.asarray(s)[1:]).mean() for s in squared]))


def with_normals(cloud):
    cloud.estimate_normals(open3d.geometry.KDTreeSearchParamKNN(NORMAL_NEIGHBOURS))
    cloud.orient_normals_consistent_tangent_plane(NORMAL_NEIGHBOURS)
    return cloud


def poisson(cloud):
    mesh, _ = open3d.geometry.TriangleMesh.create_from_point_cloud_poisson(
        with_normals(cloud), depth=POISSON_DEPTH, n_threads=1)
    return mesh


def ball_pivoting(cloud):
    radii = open3d.utility.DoubleVector([r * spacing(cloud) for r in BALL_RADII])
    return open3d.geometry.TriangleMesh.create_from_point_cloud_ball_pivoting(
        with_normals(cloud), radii)


def alpha_shape(cloud):
    return open3d.geometry.TriangleMesh.create_from_point_cloud_alpha_shape(
        cloud, ALPHA * spacing(cloud))


METHODS = {f.__name__: f for f in (poisson, ball_pivoting, alpha_shape)}


def main(arguments):
    if arguments == ["--version"]:
        print(open3d.__version__)
        return 0
    if len(arguments) != 3 or arguments[0] not in METHODS:
        print(__doc__, file=sys.stderr)
        return 2
    open3d.utility.set_verbosity_level(open3d.utility.VerbosityLevel.Error)
    cloud = open3d.io.read_point_cloud(arguments[1])
    mesh = METHODS[arguments[0]](cloud)
    if len(mesh.triangles) == 0:
        print("open3d_peers: no faces", file=sys.stderr)
        return 1
    mesh.triangle_normals = mesh.vertex_normals = open3d.utility.Vector3dVector()
    return 0 if open3d.io.write_triangle_mesh(arguments[2], mesh) else 1


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
