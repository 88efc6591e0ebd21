// Files in and out. The format follows the extension, in any letter case.
#pragma once

#include <string>

#include "arris/context.h"
#include "arris/error.h"
#include "arris/features.h"
#include "arris/types.h"

namespace arris {

// Reads points from .ply (ascii, binary little and big endian), .xyz .txt .csv .pts .asc, .off or
// .obj (vertices). Positions are doubles, other scalar vertex properties become attributes, list
// properties and faces are left behind (see PointCloud::warnings). Coordinates may be non-finite
// here; reconstruct decides. Errors: unreadable, unsupported, bad_points (no points at all),
// out_of_memory (the header declares more than memory_limit), cancelled.
Result<PointCloud> read_points(const std::string& path, const Context& context = {});

// Reads a polygon mesh from .ply .off .obj .stl, polygons cut into fans. Identical STL corners are
// joined. Scalar properties of the faces of a .ply become face attributes if all are triangles.
// Errors as read_points.
Result<Mesh> read_mesh(const std::string& path, const Context& context = {});

// Writes .ply (binary, little endian), .obj, .off or .stl, to a temporary file beside `path` that
// is renamed at the end: on failure `path` is as it was. Coordinates are written so that reading
// gives the same doubles back; .stl is binary when every coordinate is a float32 value and ascii
// with the shortest exact digits otherwise. Attributes of vertices and faces go into .ply, each in
// its type; .obj takes red, green and blue if they are u8, and the i32 face attribute "patch" as
// groups (patch_0, patch_1, ...), for which the faces are put in order; .off and .stl take none.
// Errors: usage (an index or the length of an attribute does not fit the mesh), unsupported,
// unwritable, cancelled.
Result<void> write_mesh(const std::string& path, const Mesh& mesh, const Context& context = {});

// Writes .msh (Gmsh 2.2 ascii) or .vtk (legacy ascii). Errors as write_mesh.
Result<void> write_tetrahedra(const std::string& path, const TetVolume& volume,
                              const Context& context = {});

// Writes the curves and corners of a network found on `mesh`: .ply (vertices and an element edge
// with the curve, its mean angle and kind), .obj (a group and a polyline `l` per curve, a point `p`
// per corner) or .json (with angles, kinds and positions). Errors as write_mesh.
Result<void> write_features(const std::string& path, const Mesh& mesh,
                            const FeatureNetwork& network, const Context& context = {});

// Writes text, by the same temporary-and-rename. Errors as write_mesh.
Result<void> write_text(const std::string& path, const std::string& text);

}  // namespace arris
