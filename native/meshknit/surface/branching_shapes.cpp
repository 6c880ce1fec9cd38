#include <cmath>

#include "meshknit/surface/blob_shape.h"
#include "meshknit/surface/example_shapes.h"

namespace meshknit {
namespace {

using Eigen::Vector3d;

constexpr double edge_length = 6.0;  // mm

// A rim and the time when it is knit.
struct TimedRim {
  RimCut cut;
  double time;
};

ExampleShape shape_of(const Blobs& blobs, const std::vector<TimedRim>& rims) {
  ExampleShape shape;
  std::vector<RimCut> cuts;
  for (const TimedRim& rim : rims) cuts.push_back(rim.cut);
  BlobMesh mesh = mesh_of_blobs(blobs, cuts, edge_length);
  shape.vertices = std::move(mesh.vertices);
  shape.faces = std::move(mesh.faces);
  for (const TimedRim& rim : rims) shape.times.push_back({rim.time, rim.cut.at});
  return shape;
}

// Where a limb's last piece ends: a flat rim across it, in the middle of its round end.
RimCut end_of(const Limb& limb) {
  const Vector3d& last = limb.back().at;
  return {last, (last - limb[limb.size() - 2].at).normalized()};
}

// An upright trunk below limbs that lean apart and then rise straight, side by side along x.
ExampleShape branching(const std::vector<double>& limb_x, double limb_radius,
                       double trunk_radius, double trunk_time) {
  constexpr double trunk = 70.0, rise = 45.0, height = 150.0;
  Blobs blobs;
  blobs.rounding = 5.0;
  const Limb stem = {{{0.0, 0.0, trunk}, trunk_radius}, {{0.0, 0.0, 0.0}, trunk_radius}};
  blobs.limbs.push_back(stem);
  std::vector<TimedRim> rims = {{end_of(stem), trunk_time}};
  for (const double x : limb_x) {
    const Limb limb = {{{0.35 * x, 0.0, trunk}, limb_radius},
                       {{x, 0.0, trunk + rise}, limb_radius},
                       {{x, 0.0, height}, limb_radius}};
    blobs.limbs.push_back(limb);
    rims.push_back({end_of(limb), -trunk_time});
  }
  return shape_of(blobs, rims);
}

}  // namespace

ExampleShape two_way_split() { return branching({-30.0, 30.0}, 17.0, 28.0, -1.0); }
ExampleShape three_way_split() { return branching({-52.0, 0.0, 52.0}, 16.0, 32.0, -1.0); }
ExampleShape two_way_merge() { return branching({-30.0, 30.0}, 17.0, 28.0, 1.0); }
ExampleShape three_way_merge() { return branching({-52.0, 0.0, 52.0}, 16.0, 32.0, 1.0); }

ExampleShape trousers() {
  Blobs blobs;
  blobs.rounding = 6.0;
  // Two limbs side by side make a waist that is wider than deep.
  std::vector<TimedRim> rims = {{{{0.0, 0.0, 100.0}, Vector3d::UnitZ()}, -1.0}};
  for (const double side : {-1.0, 1.0}) {
    const Limb leg = {{{side * 17.0, 0.0, 125.0}, 33.0},
                      {{side * 20.0, 0.0, 50.0}, 37.0},
                      {{side * 34.0, 0.0, 0.0}, 30.0},
                      {{side * 40.0, 0.0, -110.0}, 23.0}};
    blobs.limbs.push_back(leg);
    rims.push_back({end_of(leg), 1.0});
  }
  return shape_of(blobs, rims);
}

}  // namespace meshknit
