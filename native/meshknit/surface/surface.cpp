#include "meshknit/surface/surface.h"

#include "meshknit/core/error.h"
#include "meshknit/surface/boundary_loops.h"
#include "meshknit/surface/face_list.h"
#include "meshknit/surface/mend_faces.h"
#include "meshknit/surface/orientation.h"
#include "meshknit/surface/surface_problems.h"

namespace meshknit {
namespace {

std::vector<int> sources(const FaceList& faces, const std::vector<int>& list) {
  std::vector<int> result;
  for (const int f : list) result.push_back(faces.source[f]);
  return result;
}

// Whether the faces make a manifold; turns them to agree.
bool check_manifold(FaceList& faces, Surface& surface) {
  const std::vector<FaceSide> sides = sorted_sides(faces);
  std::vector<std::array<int, 2>> crowded;
  for_each_edge(sides, [&](auto first, auto last) {
    if (last - first > 2) crowded.push_back({first->a, first->b});
  });
  if (!crowded.empty()) {
    surface.problems.push_back(nonmanifold_edge(crowded));
    return false;
  }
  const std::vector<int> pinched = pinched_vertices(faces, sides);
  if (!pinched.empty()) surface.problems.push_back(nonmanifold_vertex(pinched));

  const Orientation orientation = orient_faces(faces, sides);
  surface.components = orientation.pieces;
  if (!orientation.contradictions.empty())
    surface.problems.push_back(not_orientable(orientation.contradictions));
  else if (!orientation.flipped.empty())
    surface.problems.push_back(flipped_faces(sources(faces, orientation.flipped)));
  if (orientation.pieces > 1)
    surface.problems.push_back(
        several_components(faces, orientation.piece, orientation.pieces));
  return pinched.empty() && orientation.contradictions.empty();
}

void build_mesh(const VertexArray& vertices, const FaceList& faces,
                const std::vector<int>& representative, Surface& surface) {
  std::vector<bool> used(static_cast<std::size_t>(vertices.rows()), false);
  for (const auto& corners : faces.corners)
    for (const int v : corners) used[v] = true;
  surface.vertex_of_source.assign(used.size(), -1);
  surface.mesh.reserve(used.size(), 3 * faces.corners.size() / 2 + used.size(),
                       faces.corners.size());
  for (std::size_t v = 0; v < used.size(); ++v) {
    if (!used[v]) continue;
    const auto row = static_cast<Eigen::Index>(v);
    surface.vertex_of_source[v] =
        surface.mesh.add_vertex({vertices(row, 0), vertices(row, 1), vertices(row, 2)}).idx();
    surface.source_vertex.push_back(static_cast<int>(v));
  }
  for (std::size_t v = 0; v < used.size(); ++v)
    surface.vertex_of_source[v] = surface.vertex_of_source[representative[v]];
  for (const auto& corners : faces.corners) {
    const auto vertex = [&](int k) {
      return OpenMesh::VertexHandle(surface.vertex_of_source[corners[k]]);
    };
    if (!surface.mesh.add_face(vertex(0), vertex(1), vertex(2)).is_valid())
      throw BrokenPromise("make_surface: a face of a checked manifold could not be added");
  }
  surface.source_face = faces.source;
}

void measure(Surface& surface) {
  const TriangleMesh& mesh = surface.mesh;
  for (const auto f : mesh.faces()) surface.area += mesh.calc_face_area(f);
  surface.boundaries = boundary_loops(mesh, surface.source_vertex);
  // Euler: V - E + F = 2 c - 2 g - b.
  const int characteristic = static_cast<int>(mesh.n_vertices()) -
                             static_cast<int>(mesh.n_edges()) +
                             static_cast<int>(mesh.n_faces());
  const int boundaries = static_cast<int>(surface.boundaries.size());
  surface.genus = (2 * surface.components - boundaries - characteristic) / 2;
}

}  // namespace

Surface make_surface(const VertexArray& vertices, const FaceArray& faces,
                     const SurfaceOptions& options) {
  Surface surface;
  MendedFaces mended = mend_faces(vertices, list_faces(vertices, faces));
  surface.problems = std::move(mended.problems);
  if (mended.faces.corners.empty() || has_errors(surface.problems)) return surface;

  const std::vector<int> flat = zero_area_faces(vertices, mended.faces);
  if (!flat.empty()) surface.problems.push_back(zero_area_face(vertices, mended.faces, flat));
  const bool manifold = check_manifold(mended.faces, surface);
  if (!manifold || !flat.empty()) return surface;

  build_mesh(vertices, mended.faces, mended.representative, surface);
  measure(surface);
  if (surface.components == 1 && surface.boundaries.size() < 2)
    surface.problems.push_back(too_few_boundaries(surface));
  const double shortest = options.fewest_stitches * options.stitch_width;
  for (std::size_t b = 0; b < surface.boundaries.size(); ++b)
    if (surface.boundaries[b].length < shortest)
      surface.problems.push_back(short_boundary(surface, static_cast<int>(b), shortest));
  return surface;
}

}  // namespace meshknit
