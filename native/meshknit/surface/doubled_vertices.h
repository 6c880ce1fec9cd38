#pragma once

#include <vector>

#include "meshknit/surface/face_list.h"

namespace meshknit {

/// For every vertex the one that it is joined with (the lowest of each group; itself if none),
/// so that surfaces whose seams were exported with doubled vertices become whole.
///
/// Only whole edges are joined: two open edges, and only two, whose ends lie within `tolerance`
/// (mm) of each other. So sheets that touch in a point stay apart, and no edge gets a third
/// face. Two rims of the same piece that coincide all the way round stay open: somebody cut
/// there to have a start and an end.
std::vector<int> join_doubled_vertices(const VertexArray& vertices, const FaceList& faces,
                                       double tolerance);

}  // namespace meshknit
