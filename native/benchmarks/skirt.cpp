#include "skirt.h"

#include <cmath>

#include "mesh_files.h"
#include "meshknit/core/error.h"
#include "meshknit/surface/edge_path.h"
#include "meshknit/time_field/time_field.h"

namespace meshknit {
namespace {

constexpr double pi = 3.14159265358979323846;

Workpiece timed(std::string name, const VertexArray& vertices, const FaceArray& faces,
                const Eigen::Vector3d& start, const Eigen::Vector3d& end) {
  Workpiece piece{std::move(name), make_surface(vertices, faces), {}};
  if (has_errors(piece.surface.problems)) throw NotKnittable(piece.surface.problems);
  const auto boundary = [&](const Eigen::Vector3d& near) {
    return piece.surface.boundaries[nearest_boundary(piece.surface, near)].vertices;
  };
  piece.time =
      solve_time_field(piece.surface, {{boundary(start), -1.0}, {boundary(end), 1.0}}).time;
  return piece;
}

}  // namespace

Workpiece skirt() {
  constexpr int around = 96, along = 48;
  constexpr double height = 900.0;
  VertexArray vertices((along + 1) * around, 3);
  for (int r = 0; r <= along; ++r) {
    const double u = static_cast<double>(r) / along;  // 0 at the hem, 1 at the waist
    const double hem = (1.0 - u) * (1.0 - u);
    for (int i = 0; i < around; ++i) {
      const double angle = 2.0 * pi * i / around;
      // Seven folds, and a hem that hangs 40 mm lower at the back.
      const double radius = 127.0 + 78.0 * hem + 14.0 * hem * std::cos(7.0 * angle);
      vertices.row(r * around + i) << radius * std::cos(angle), 0.85 * radius * std::sin(angle),
          height * u - 40.0 * hem * std::cos(angle);
    }
  }
  FaceArray faces(2 * along * around, 3);
  int face = 0;
  for (int r = 0; r < along; ++r)
    for (int i = 0; i < around; ++i) {
      const int a = r * around + i, b = r * around + (i + 1) % around;
      faces.row(face++) << a, b, b + around;
      faces.row(face++) << a, b + around, a + around;
    }
  return timed("skirt", vertices, faces, vertices.row(0).transpose(),
               vertices.row(along * around).transpose());
}

Workpiece workpiece_of(int argc, char** argv) {
  if (argc == 1) return skirt();
  if (argc != 9)
    throw InvalidInput("arguments: file.obj scale start-x start-y start-z end-x end-y end-z");
  const double scale = std::stod(argv[2]);
  const auto point = [&](int first) -> Eigen::Vector3d {
    return scale * Eigen::Vector3d(std::stod(argv[first]), std::stod(argv[first + 1]),
                                   std::stod(argv[first + 2]));
  };
  const MeshArrays arrays = read_mesh_file(argv[1], scale);
  return timed(argv[1], arrays.vertices, arrays.faces, point(3), point(6));
}

}  // namespace meshknit
