#include "surface/test_meshes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

namespace meshknit {
namespace {

constexpr double kTurn = 6.283185307179586;

MeshArrays to_arrays(const std::vector<std::array<double, 3>>& vertices,
                     const std::vector<std::array<int, 3>>& faces) {
  MeshArrays arrays;
  arrays.vertices.resize(static_cast<Eigen::Index>(vertices.size()), 3);
  arrays.faces.resize(static_cast<Eigen::Index>(faces.size()), 3);
  for (std::size_t v = 0; v < vertices.size(); ++v)
    for (int k = 0; k < 3; ++k)
      arrays.vertices(static_cast<Eigen::Index>(v), k) = vertices[v][k];
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k) arrays.faces(static_cast<Eigen::Index>(f), k) = faces[f][k];
  return arrays;
}

}  // namespace

double Jitter::next() {
  state_ = state_ * 1664525u + 1013904223u;
  return static_cast<double>(state_ >> 8) / 8388608.0 - 1.0;
}

MeshArrays tube(const TubeShape& shape) {
  Jitter jitter(7);
  std::vector<std::array<double, 3>> vertices;
  for (int ring = 0; ring <= shape.along; ++ring)
    for (int i = 0; i < shape.around; ++i) {
      const bool inner = ring > 0 && ring < shape.along;
      const double step = inner ? shape.jitter : 0.0;
      const double angle = kTurn * (i + step * jitter.next()) / shape.around;
      const double z = shape.length * (ring + step * jitter.next()) / shape.along;
      const double radius = shape.radius(z);
      vertices.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
    }
  std::vector<std::array<int, 3>> faces;
  for (int ring = 0; ring < shape.along; ++ring)
    for (int i = 0; i < shape.around; ++i) {
      const int a = ring * shape.around + i, b = ring * shape.around + (i + 1) % shape.around;
      faces.push_back({a, b, b + shape.around});
      faces.push_back({a, b + shape.around, a + shape.around});
    }
  return to_arrays(vertices, faces);
}

MeshArrays cut_torus() {
  TubeShape shape;
  MeshArrays arrays = tube(shape);
  for (Eigen::Index v = 0; v < arrays.vertices.rows(); ++v) {
    const double a = kTurn * static_cast<double>(v % shape.around) / shape.around;
    const double b = kTurn * static_cast<double>(v / shape.around) / shape.along;
    const double radius = 60.0 + 20.0 * std::cos(b);
    arrays.vertices.row(v) << radius * std::cos(a), radius * std::sin(a), 20.0 * std::sin(b);
  }
  return arrays;
}

MeshArrays closed_torus() {
  MeshArrays arrays = cut_torus();
  const int rim = static_cast<int>(arrays.vertices.rows()) - TubeShape().around;
  for (Eigen::Index i = 0; i < arrays.faces.size(); ++i)
    if (arrays.faces.data()[i] >= rim) arrays.faces.data()[i] -= rim;
  return arrays;
}

MeshArrays without_quads(const MeshArrays& arrays, const std::vector<int>& quads) {
  MeshArrays result{arrays.vertices, arrays.faces};
  Eigen::Index kept = 0;
  for (Eigen::Index f = 0; f < arrays.faces.rows(); ++f)
    if (std::find(quads.begin(), quads.end(), static_cast<int>(f / 2)) == quads.end())
      result.faces.row(kept++) = arrays.faces.row(f);
  result.faces.conservativeResize(kept, 3);
  return result;
}

MeshArrays grid(int w, int h, double cell, const std::function<bool(int, int)>& hole) {
  std::vector<std::array<double, 3>> vertices;
  for (int row = 0; row <= h; ++row)
    for (int column = 0; column <= w; ++column)
      vertices.push_back({cell * column, cell * row, 0.0});
  std::vector<std::array<int, 3>> faces;
  for (int row = 0; row < h; ++row)
    for (int column = 0; column < w; ++column) {
      if (hole(column, row)) continue;
      const int a = row * (w + 1) + column, c = a + w + 1;
      faces.push_back({a, a + 1, c + 1});
      faces.push_back({a, c + 1, c});
    }
  return to_arrays(vertices, faces);
}

MeshArrays side_by_side(const MeshArrays& a, const MeshArrays& b,
                        const Eigen::Vector3d& shift) {
  MeshArrays both;
  both.vertices.resize(a.vertices.rows() + b.vertices.rows(), 3);
  both.vertices << a.vertices, b.vertices.rowwise() + shift.transpose();
  both.faces.resize(a.faces.rows() + b.faces.rows(), 3);
  both.faces << a.faces, b.faces.array() + static_cast<int>(a.vertices.rows());
  return both;
}

MeshArrays triangle_soup(const MeshArrays& arrays) {
  MeshArrays soup;
  soup.vertices.resize(3 * arrays.faces.rows(), 3);
  soup.faces.resize(arrays.faces.rows(), 3);
  for (Eigen::Index f = 0; f < arrays.faces.rows(); ++f)
    for (int k = 0; k < 3; ++k) {
      soup.vertices.row(3 * f + k) = arrays.vertices.row(arrays.faces(f, k));
      soup.faces(f, k) = static_cast<int>(3 * f) + k;
    }
  return soup;
}

MeshArrays ball(double radius, int times) {
  std::vector<Eigen::Vector3d> points{{1, 0, 0},  {-1, 0, 0}, {0, 1, 0},
                                      {0, -1, 0}, {0, 0, 1},  {0, 0, -1}};
  std::vector<std::array<int, 3>> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                                        {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int pass = 0; pass < times; ++pass) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [entry, is_new] =
          middles.insert({std::minmax(a, b), static_cast<int>(points.size())});
      if (is_new) points.push_back((points[a] + points[b]).normalized());
      return entry->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& [a, b, c] : faces) {
      const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      for (const auto& face :
           {std::array<int, 3>{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}})
        finer.push_back(face);
    }
    faces = std::move(finer);
  }
  MeshArrays arrays{VertexArray(points.size(), 3), FaceArray(faces.size(), 3)};
  for (std::size_t v = 0; v < points.size(); ++v)
    arrays.vertices.row(static_cast<Eigen::Index>(v)) = radius * points[v];
  for (std::size_t f = 0; f < faces.size(); ++f)
    for (int k = 0; k < 3; ++k) arrays.faces(static_cast<Eigen::Index>(f), k) = faces[f][k];
  return arrays;
}

MeshArrays box(const Eigen::Vector3d& size) {
  MeshArrays arrays{VertexArray(8, 3), FaceArray(12, 3)};
  for (int v = 0; v < 8; ++v)
    arrays.vertices.row(v) << (v & 1) * size.x(), (v >> 1 & 1) * size.y(), (v >> 2) * size.z();
  arrays.faces << 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 6, 7, 2, 7, 3, 0, 4,
      6, 0, 6, 2, 1, 3, 7, 1, 7, 5;
  return arrays;
}

TriangleMesh half_edges(const MeshArrays& arrays) {
  TriangleMesh mesh;
  for (Eigen::Index v = 0; v < arrays.vertices.rows(); ++v)
    mesh.add_vertex({arrays.vertices(v, 0), arrays.vertices(v, 1), arrays.vertices(v, 2)});
  for (Eigen::Index f = 0; f < arrays.faces.rows(); ++f)
    mesh.add_face(OpenMesh::VertexHandle(arrays.faces(f, 0)),
                  OpenMesh::VertexHandle(arrays.faces(f, 1)),
                  OpenMesh::VertexHandle(arrays.faces(f, 2)));
  return mesh;
}

}  // namespace meshknit
