#include "meshknit/surface/openings.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

#include "meshknit/core/error.h"
#include "meshknit/surface/boundary_loops.h"
#include "meshknit/surface/opening_regions.h"

namespace meshknit {
namespace {

using Edge = std::pair<int, int>;

// What is left when the labelled faces are taken out of a mesh.
class Remainder {
 public:
  explicit Remainder(const OpeningRegions& cut) : cut_(cut), row_(cut.mesh.n_vertices(), -1) {}

  void fill(CutSurface& result) {
    number_vertices(result);
    const TriangleMesh& mesh = cut_.mesh;
    result.vertices.resize(static_cast<Eigen::Index>(result.source_vertex.size()), 3);
    for (const auto v : mesh.vertices())
      if (row_[v.idx()] >= 0) result.vertices.row(row_[v.idx()]) = mesh.point(v);
    std::vector<int> corners;
    result.source_face.clear();
    for (const auto f : mesh.faces()) {
      if (!kept(f.idx())) continue;
      auto half = mesh.halfedge_handle(f);
      for (int k = 0; k < 3; ++k, half = mesh.next_halfedge_handle(half))
        corners.push_back(row_[mesh.from_vertex_handle(half).idx()]);
      result.source_face.push_back(cut_.surface.source_face[cut_.origin[f.idx()].face]);
    }
    result.faces = Eigen::Map<const FaceArray>(
        corners.data(), static_cast<Eigen::Index>(result.source_face.size()), 3);
  }

  // Edges of the result along openings, in the direction of their faces.
  std::map<Edge, int> rim_edges() const {
    const TriangleMesh& mesh = cut_.mesh;
    std::map<Edge, int> found;
    for (const auto half : mesh.halfedges()) {
      const auto back = mesh.opposite_halfedge_handle(half);
      if (mesh.is_boundary(half) || mesh.is_boundary(back)) continue;
      const int beyond = mesh.face_handle(back).idx();
      if (kept(mesh.face_handle(half).idx()) && !kept(beyond))
        found[{row_[mesh.from_vertex_handle(half).idx()],
               row_[mesh.to_vertex_handle(half).idx()]}] = cut_.origin[beyond].opening;
    }
    return found;
  }

 private:
  bool kept(int face) const { return cut_.origin[face].opening < 0; }

  void number_vertices(CutSurface& result) {
    const Surface& surface = cut_.surface;
    std::vector<char> used(row_.size(), 0);
    for (const auto f : cut_.mesh.faces())
      if (kept(f.idx()))
        for (const auto v : cut_.mesh.fv_range(f)) used[v.idx()] = 1;
    result.source_vertex.clear();
    for (std::size_t v = 0; v < used.size(); ++v) {
      if (!used[v]) continue;
      row_[v] = static_cast<int>(result.source_vertex.size());
      result.source_vertex.push_back(v < surface.source_vertex.size() ? surface.source_vertex[v]
                                                                      : -1);
    }
    for (std::size_t r = 0; r < surface.vertex_of_source.size(); ++r) {
      const int v = surface.vertex_of_source[r];
      result.vertex_of_source[r] = v < 0 ? -1 : row_[v];
    }
  }

  const OpeningRegions& cut_;
  std::vector<int> row_;  // vertex of the mesh -> row of the result
};

TriangleMesh half_edges(const CutSurface& cut) {
  TriangleMesh mesh;
  for (Eigen::Index v = 0; v < cut.vertices.rows(); ++v)
    mesh.add_vertex(Eigen::Vector3d(cut.vertices.row(v)));
  for (Eigen::Index f = 0; f < cut.faces.rows(); ++f) {
    const auto corner = [&](int k) { return OpenMesh::VertexHandle(cut.faces(f, k)); };
    if (!mesh.add_face(corner(0), corner(1), corner(2)).is_valid())
      throw BrokenPromise("cut_openings: what is left is no manifold");
  }
  return mesh;
}

std::vector<int> openings_beside(const BoundaryLoop& loop, const std::map<Edge, int>& edges) {
  std::vector<int> found;
  const std::size_t n = loop.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto edge = edges.find({loop.vertices[i], loop.vertices[(i + 1) % n]});
    if (edge != edges.end()) found.push_back(edge->second);
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

void judge_rim(const OpeningRegions::Region& region, int rims, double shortest,
               Problems& problems) {
  const double rim = region.opening.rim_length;
  if (rims == 0)
    problems.push_back(part_left_out(region.name));
  else if (rims > 1)
    problems.push_back(opening_not_a_disc(region.name, rims));
  else if (rim < shortest && region.length_before > rim)
    // Past the widest place a larger radius makes the rim shorter still.
    problems.push_back(opening_too_large(region.name, rim, shortest));
  else if (rim < shortest)
    problems.push_back(
        opening_too_small(region.name, rim, shortest, 1.02 * region.radius * shortest / rim));
}

void find_rims(const Remainder& remainder, double shortest, OpeningRegions& regions,
               CutSurface& cut) {
  std::vector<int> itself(cut.source_vertex.size());
  std::iota(itself.begin(), itself.end(), 0);
  const std::map<Edge, int> edges = remainder.rim_edges();
  std::vector<int> rims(regions.regions.size(), 0);
  for (const BoundaryLoop& loop : boundary_loops(half_edges(cut), itself))
    for (const int o : openings_beside(loop, edges)) {
      ++rims[o];
      regions.regions[o].opening.rim = loop.vertices;
      regions.regions[o].opening.rim_length = loop.length;
    }
  for (std::size_t o = 0; o < rims.size(); ++o) {
    judge_rim(regions.regions[o], rims[o], shortest, regions.problems);
    if (rims[o] == 1) cut.openings.push_back(regions.regions[o].opening);
  }
}

CutSurface uncut(const VertexArray& vertices, const FaceArray& faces, Problems problems) {
  CutSurface result;
  result.vertices = vertices;
  result.faces = faces;
  result.source_vertex.resize(static_cast<std::size_t>(vertices.rows()));
  result.source_face.resize(static_cast<std::size_t>(faces.rows()));
  std::iota(result.source_vertex.begin(), result.source_vertex.end(), 0);
  std::iota(result.source_face.begin(), result.source_face.end(), 0);
  result.vertex_of_source = result.source_vertex;
  result.problems = std::move(problems);
  return result;
}

// The surface's problems without those that openings change: they are judged on what is left.
Problems lasting(const Problems& problems) {
  Problems kept;
  for (const Problem& p : problems)
    if (p.code != "several-components" && p.code != "too-few-boundaries" &&
        p.code != "short-boundary")
      kept.push_back(p);
  return kept;
}

}  // namespace

CutSurface cut_openings(const VertexArray& vertices, const FaceArray& faces,
                        const std::vector<int>& face_marks,
                        const std::vector<OpeningMark>& marks, const SurfaceOptions& options) {
  if (!face_marks.empty() && static_cast<Eigen::Index>(face_marks.size()) != faces.rows())
    throw InvalidInput("cut_openings: there must be one face mark a face, or none");
  const Surface surface = make_surface(vertices, faces, options);
  CutSurface result = uncut(vertices, faces, lasting(surface.problems));
  if (has_errors(result.problems)) return result;

  const double shortest = options.fewest_stitches * options.stitch_width;
  OpeningRegions regions(surface);
  for (const OpeningMark& mark : marks) regions.cut_mark(mark, shortest);
  if (!face_marks.empty()) regions.leave_out(face_marks);
  regions.check_touching();
  if (!has_errors(regions.problems)) {
    Remainder remainder(regions);
    remainder.fill(result);
    find_rims(remainder, shortest, regions, result);
  }
  Problems problems = lasting(surface.problems);
  problems.insert(problems.end(), regions.problems.begin(), regions.problems.end());
  if (has_errors(problems)) return uncut(vertices, faces, std::move(problems));
  result.problems = std::move(problems);
  return result;
}

}  // namespace meshknit
