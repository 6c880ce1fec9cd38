#include "meshknit/suggest/opening_radius.h"

#include <algorithm>
#include <limits>

#include "meshknit/surface/point_distance.h"

namespace meshknit {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double enough_stitches = 12.0, fewest_stitches = 8.0;
constexpr double most_of_area = 0.125;

struct Rim {
  double length = 0.0, area_inside = 0.0;
};

Rim rim_at(const TriangleMesh& mesh, const std::vector<double>& distance, double radius) {
  Rim rim;
  for (const auto f : mesh.faces()) {
    Eigen::Vector3d corner[3];
    double d[3];
    int k = 0;
    for (const auto v : mesh.fv_range(f)) {
      corner[k] = mesh.point(v);
      d[k++] = distance[v.idx()];
    }
    const double low = std::min({d[0], d[1], d[2]}), high = std::max({d[0], d[1], d[2]});
    if (low >= radius) continue;
    if (high <= radius) {
      rim.area_inside += mesh.calc_face_area(f);
      continue;
    }
    rim.area_inside += mesh.calc_face_area(f) * (radius - low) / (high - low);
    Eigen::Vector3d end[2];
    int ends = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if ((d[i] < radius) == (d[j] < radius) || ends == 2) continue;
      const double t = (radius - d[i]) / (d[j] - d[i]);
      end[ends++] = corner[i] + t * (corner[j] - corner[i]);
    }
    if (ends == 2) rim.length += (end[1] - end[0]).norm();
  }
  return rim;
}

}  // namespace

std::vector<double> distance_to(const TriangleMesh& mesh, int vertex) {
  const TriangleMesh::VertexHandle at(vertex);
  return distance_from(mesh, {(*mesh.cvf_iter(at)).idx(), mesh.point(at)}, infinity);
}

int furthest_vertex(const TriangleMesh& mesh, const std::vector<int>& from) {
  std::vector<double> nearest(mesh.n_vertices(), infinity);
  for (const int v : from) {
    const std::vector<double> distance = distance_to(mesh, v);
    for (std::size_t w = 0; w < nearest.size(); ++w)
      nearest[w] = std::min(nearest[w], distance[w]);
  }
  return static_cast<int>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
}

double radius_for_opening(const TriangleMesh& mesh, int vertex, double most,
                          double stitch_width, double area) {
  const double flat = enough_stitches * stitch_width / 6.28318530717958647692;
  const double furthest = std::min(most, 6.0 * flat);
  const std::vector<double> distance = distance_to(mesh, vertex);
  double best = 0.0, longest = fewest_stitches * stitch_width;
  for (double radius = flat; radius <= furthest; radius *= 1.12) {
    const Rim rim = rim_at(mesh, distance, radius);
    if (rim.area_inside > most_of_area * area) break;
    if (rim.length < longest) continue;
    best = radius;
    longest = rim.length;
    if (longest >= enough_stitches * stitch_width) break;
  }
  return best;
}

}  // namespace meshknit
