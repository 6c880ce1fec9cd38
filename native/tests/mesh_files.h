#pragma once

#include <string>

#include "surface/test_meshes.h"

namespace meshknit {

/// Vertices, times `scale`, and faces of an .obj or a binary little-endian .ply file whose vertices
/// are floats x, y, z; polygons become fans. Throws: InvalidInput for a file that is none of these
/// or cannot be read.
MeshArrays read_mesh_file(const std::string& path, double scale);

}  // namespace meshknit
