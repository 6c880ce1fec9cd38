#include "meshknit/surface/blob_shape.h"

#include "meshknit/surface/even_triangles.h"

namespace meshknit {
namespace {

TriangleMesh to_mesh(const BlobMesh& arrays) {
  TriangleMesh mesh;
  std::vector<OpenMesh::VertexHandle> corner;
  for (Eigen::Index v = 0; v < arrays.vertices.rows(); ++v)
    corner.push_back(mesh.add_vertex(arrays.vertices.row(v).transpose()));
  for (Eigen::Index f = 0; f < arrays.faces.rows(); ++f)
    mesh.add_face(corner[arrays.faces(f, 0)], corner[arrays.faces(f, 1)],
                  corner[arrays.faces(f, 2)]);
  return mesh;
}

BlobMesh to_arrays(const TriangleMesh& mesh) {
  BlobMesh arrays;
  arrays.vertices.resize(static_cast<Eigen::Index>(mesh.n_vertices()), 3);
  for (const auto v : mesh.vertices()) arrays.vertices.row(v.idx()) = mesh.point(v).transpose();
  arrays.faces.resize(static_cast<Eigen::Index>(mesh.n_faces()), 3);
  for (const auto f : mesh.faces()) {
    int k = 0;
    for (const auto v : f.vertices()) arrays.faces(f.idx(), k++) = v.idx();
  }
  return arrays;
}

}  // namespace

BlobMesh mesh_of_blobs(const Blobs& blobs, const std::vector<RimCut>& cuts,
                       double edge_length) {
  BlobMesh arrays = march_tetrahedra(blobs, edge_length);
  std::vector<int> rim = cut_rims(arrays, cuts);
  TriangleMesh mesh = to_mesh(arrays);
  const SmoothSurface surface{
      [&](const Eigen::Vector3d& point, int number) {
        if (number < 0) return onto_surface(blobs, point);
        const RimCut& cut = cuts[number];
        const Eigen::Vector3d in_plane = point - cut.outward.dot(point - cut.at) * cut.outward;
        return onto_surface(blobs, in_plane, cut.outward);
      },
      [&](const Eigen::Vector3d& point) {
        return distance_outside(blobs, point).gradient.normalized().eval();
      }};
  even_triangles(mesh, rim, surface, edge_length);
  return to_arrays(mesh);
}

RimCut end_of(const Limb& limb) {
  const Eigen::Vector3d& last = limb.back().at;
  return {last, (last - limb[limb.size() - 2].at).normalized()};
}

ExampleShape shape_of_blobs(const Blobs& blobs, const std::vector<TimedRim>& rims,
                            double edge_length) {
  ExampleShape shape;
  std::vector<RimCut> cuts;
  for (const TimedRim& rim : rims) {
    cuts.push_back(rim.cut);
    shape.times.push_back({rim.time, rim.cut.at});
  }
  BlobMesh mesh = mesh_of_blobs(blobs, cuts, edge_length);
  shape.vertices = std::move(mesh.vertices);
  shape.faces = std::move(mesh.faces);
  return shape;
}

}  // namespace meshknit
