#pragma once

#include <array>
#include <vector>

#include "meshknit/core/problem.h"
#include "meshknit/surface/face_list.h"
#include "meshknit/surface/surface.h"

namespace meshknit {

// What make_surface says to people: one function a code, elements are rows of the input arrays.

Problem empty_mesh();
Problem not_finite_vertices(const std::vector<int>& vertices);
Problem unused_vertices(const std::vector<int>& vertices);
Problem collapsed_faces(std::vector<int> faces);
Problem repeated_faces(std::vector<int> faces);
Problem doubled_vertices(const std::vector<int>& removed);
/// `flat` are indices into the list.
Problem zero_area_face(const VertexArray& vertices, const FaceList& faces,
                       const std::vector<int>& flat);
Problem nonmanifold_edge(const std::vector<std::array<int, 2>>& edges);
Problem nonmanifold_vertex(const std::vector<int>& vertices);
Problem not_orientable(const std::vector<std::array<int, 2>>& edges);
Problem flipped_faces(const std::vector<int>& faces);
/// Names the faces of all pieces but the one with the most faces.
Problem several_components(const FaceList& faces, const std::vector<int>& piece, int pieces);
Problem too_few_boundaries(const Surface& surface);
Problem short_boundary(const Surface& surface, int boundary, double shortest);

}  // namespace meshknit
