#include "surface/exact_point_distances.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_shortest_path.h>

#include <Eigen/LU>
#include <algorithm>

namespace meshknit {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using ShortestPath =
    CGAL::Surface_mesh_shortest_path<CGAL::Surface_mesh_shortest_path_traits<Kernel, CgalMesh>>;

constexpr double off_edges = 1e-3;

ShortestPath::Face_location locate(const CgalMesh& mesh, const SurfacePoint& place) {
  const CgalMesh::Face_index face(static_cast<CgalMesh::size_type>(place.face));
  const auto half = mesh.halfedge(face);
  Eigen::Matrix3d corners;
  int k = 0;
  for (const auto v : {mesh.source(half), mesh.target(half), mesh.target(mesh.next(half))}) {
    const auto& p = mesh.point(v);
    corners.col(k++) = Eigen::Vector3d(p.x(), p.y(), p.z());
  }
  const Eigen::Vector3d middle = corners.rowwise().mean();
  const Eigen::Vector3d at = place.position + off_edges * (middle - place.position);
  // Weights from areas, which also hold for a plane through the origin.
  const auto area = [&](int i, int j) -> Eigen::Vector3d {
    return (corners.col(i) - at).cross(corners.col(j) - at);
  };
  const Eigen::Vector3d normal =
      (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0));
  const double whole = normal.squaredNorm();
  const double a = std::max(0.0, area(1, 2).dot(normal) / whole);
  const double b = std::max(0.0, area(2, 0).dot(normal) / whole);
  return {face, {a, b, 1.0 - a - b}};
}

}  // namespace

std::vector<double> exact_distances_from(const MeshArrays& arrays, const SurfacePoint& source,
                                         const std::vector<SurfacePoint>& places) {
  CgalMesh mesh;
  for (Eigen::Index v = 0; v < arrays.vertices.rows(); ++v)
    mesh.add_vertex({arrays.vertices(v, 0), arrays.vertices(v, 1), arrays.vertices(v, 2)});
  for (Eigen::Index f = 0; f < arrays.faces.rows(); ++f) {
    const auto corner = [&](int k) {
      return CgalMesh::Vertex_index(static_cast<CgalMesh::size_type>(arrays.faces(f, k)));
    };
    mesh.add_face(corner(0), corner(1), corner(2));
  }
  ShortestPath paths(mesh);
  const auto from = locate(mesh, source);
  paths.add_source_point(from.first, from.second);
  std::vector<double> distances;
  for (const SurfacePoint& place : places) {
    const auto to = locate(mesh, place);
    distances.push_back(paths.shortest_distance_to_source_points(to.first, to.second).first);
  }
  return distances;
}

}  // namespace meshknit
