#include "meshknit/surface/surface_problems.h"

#include <algorithm>

#include "meshknit/surface/wording.h"

namespace meshknit {
namespace {

Problem error(const std::string& code, const std::string& message, const std::string& remedy) {
  return {code, Severity::error, message, remedy, {}};
}

Problem note(const std::string& code, const std::string& message, const std::string& remedy) {
  return {code, Severity::note, message, remedy, {}};
}

}  // namespace

Problem empty_mesh() {
  return error("empty-mesh", "The mesh has no faces to knit.",
               "Choose an object with faces; check that modifiers and openings leave some.");
}

Problem not_finite_vertices(const std::vector<int>& vertices) {
  Problem problem = error(
      "not-finite",
      counted(vertices.size(), "vertex has a coordinate that is",
              "vertices have coordinates that are") +
          " not a number.",
      "Delete these vertices, or apply the modifier that makes them and move them by hand.");
  problem.elements.vertices = vertices;
  return problem;
}

Problem unused_vertices(const std::vector<int>& vertices) {
  Problem problem =
      note("unused-vertices",
           counted(vertices.size(), "vertex belongs", "vertices belong") + " to no face and " +
               (vertices.size() == 1 ? "was" : "were") + " left out.",
           "Nothing needs to be done; Mesh > Clean Up > Delete Loose removes them.");
  problem.elements.vertices = vertices;
  return problem;
}

Problem collapsed_faces(std::vector<int> faces) {
  std::sort(faces.begin(), faces.end());
  Problem problem =
      note("zero-area-face",
           counted(faces.size(), "face has", "faces have") + " two corners in one place and " +
               (faces.size() == 1 ? "was" : "were") + " left out.",
           "Nothing needs to be done; Mesh > Merge > By Distance removes them.");
  problem.elements.faces = std::move(faces);
  return problem;
}

Problem repeated_faces(std::vector<int> faces) {
  std::sort(faces.begin(), faces.end());
  Problem problem = note("repeated-face",
                         counted(faces.size(), "face covers", "faces cover") +
                             " the same three vertices as another one and " +
                             (faces.size() == 1 ? "was" : "were") + " left out.",
                         "Nothing needs to be done; delete the faces that lie on others.");
  problem.elements.faces = std::move(faces);
  return problem;
}

Problem doubled_vertices(const std::vector<int>& removed) {
  Problem problem = note(
      "doubled-vertices",
      counted(removed.size(), "vertex lies", "vertices lie") +
          " on another one along a seam; the seam was joined.",
      "Nothing needs to be done if the seam is meant to be closed; Mesh > Merge > By Distance "
      "joins it for good. To keep it open, move its two sides apart.");
  problem.elements.vertices = removed;
  return problem;
}

Problem zero_area_face(const VertexArray& vertices, const FaceList& faces,
                       const std::vector<int>& flat) {
  const Eigen::Vector3d at = vertices.row(faces.corners[flat.front()][0]);
  Problem problem = error(
      "zero-area-face",
      counted(flat.size(), "face has", "faces have") +
          " no area: the corners lie on one line (the first near " + place_text(at) + ").",
      "Use Mesh > Clean Up > Degenerate Dissolve, or Mesh > Merge > By Distance.");
  for (const int f : flat) problem.elements.faces.push_back(faces.source[f]);
  return problem;
}

Problem nonmanifold_edge(const std::vector<std::array<int, 2>>& edges) {
  Problem problem =
      error("nonmanifold-edge",
            counted(edges.size(), "edge has", "edges have") +
                " more than two faces; cloth has one layer on each side of an edge.",
            "Delete the extra faces (inner walls, fins), or separate them with "
            "Mesh > Split > Faces by Edges and move them apart.");
  problem.elements.edges = edges;
  return problem;
}

Problem nonmanifold_vertex(const std::vector<int>& vertices) {
  Problem problem =
      error("nonmanifold-vertex",
            counted(vertices.size(), "vertex joins", "vertices join") +
                " parts of the surface that touch in this point only.",
            "Separate the parts with Mesh > Split > Faces & Edges by Vertices and move them "
            "apart, or widen the point to a neck of faces.");
  problem.elements.vertices = vertices;
  return problem;
}

Problem not_orientable(const std::vector<std::array<int, 2>>& edges) {
  Problem problem =
      error("not-orientable",
            "The surface has no inside and outside: going round it once turns it over, like a "
            "Moebius band.",
            "Cut the surface open across the band, or rebuild it without the twist. "
            "The selected edges show where the sides meet.");
  problem.elements.edges = edges;
  return problem;
}

Problem flipped_faces(const std::vector<int>& faces) {
  Problem problem =
      note("flipped-faces",
           counted(faces.size(), "face was", "faces were") +
               " turned over to agree with the faces beside.",
           "Nothing needs to be done; Mesh > Normals > Recalculate Outside mends it for good.");
  problem.elements.faces = faces;
  return problem;
}

Problem several_components(const FaceList& faces, const std::vector<int>& piece, int pieces) {
  std::vector<int> size(static_cast<std::size_t>(pieces), 0);
  for (const int p : piece) ++size[p];
  const int largest =
      static_cast<int>(std::max_element(size.begin(), size.end()) - size.begin());
  Problem problem = error(
      "several-components",
      "The mesh has " + std::to_string(pieces) +
          " separate pieces; one piece can be knit at a time (all but the largest are "
          "selected).",
      "Delete the extra pieces, join them to the largest by faces, or separate the object with "
      "Mesh > Separate > By Loose Parts and knit each.");
  for (std::size_t f = 0; f < piece.size(); ++f)
    if (piece[f] != largest) problem.elements.faces.push_back(faces.source[f]);
  return problem;
}

Problem too_few_boundaries(const Surface& surface) {
  const bool closed = surface.boundaries.empty();
  Problem problem = error(
      "too-few-boundaries",
      closed ? "The surface is closed; knitting needs an opening to start at and one to end at."
             : "The surface has one opening only; knitting needs one to start at and one to "
               "end at.",
      closed ? "Mark two openings (a start and an end), or delete some faces in two places."
             : "Mark another opening, or delete some faces where the knitting should start or "
               "end.");
  if (!closed) {
    problem.elements.boundaries = {0};
    for (const int v : surface.boundaries[0].vertices)
      problem.elements.vertices.push_back(surface.source_vertex[v]);
  }
  return problem;
}

Problem short_boundary(const Surface& surface, int boundary, double shortest) {
  const BoundaryLoop& loop = surface.boundaries[boundary];
  const auto& mesh = surface.mesh;
  Problem problem = error(
      "short-boundary",
      "The opening near " + place_text(mesh.point(OpenMesh::VertexHandle(loop.vertices[0]))) +
          " is " + millimetres(loop.length) + " round; the shortest row that can be knit is " +
          millimetres(shortest) + ".",
      "Widen the opening, close it if it is a gap in the mesh (Mesh > Clean Up > Fill Holes), "
      "or "
      "make the object larger.");
  problem.elements.boundaries = {boundary};
  for (const int v : loop.vertices)
    problem.elements.vertices.push_back(surface.source_vertex[v]);
  return problem;
}

}  // namespace meshknit
