#include "meshknit/remesh/surface_springs.h"

#include <algorithm>

#include "meshknit/core/parallel.h"

namespace meshknit {
namespace {

// Each of a point's springs, about four, pulls by this part of its error a round.
constexpr double step = 0.22;

// Movement that goes on from round to round: corrections travel further in fewer rounds.
constexpr double carried_on = 0.7;

// A point that would move less than this stays where it is, as a fraction of a spring's length.
constexpr double still = 3e-3;

// Cosine of the angle between two points' triangles from which on the way over the surface is measured:
// bent less, it is at most a hundredth longer than the straight one.
constexpr double hardly_bent = 0.95;

// Springs or points that a thread takes at a time: fewer are not worth another thread.
constexpr int batch = 1024;

template <class Work>
void in_batches(Team& team, int count, const Work& work) {
  team.for_each((count + batch - 1) / batch, [&](int number, int) {
    const int end = std::min(count, (number + 1) * batch);
    for (int k = number * batch; k < end; ++k) work(k);
  });
}

}  // namespace

void SurfaceSprings::add(const FacePoint& at) {
  points_.push_back(at);
  corners_.push_back(triangle_corners(mesh_, at.face));
  normals_.push_back(corners_.back().normal.normalized());
}

void SurfaceSprings::shrink(int size) {
  points_.resize(size);
  corners_.resize(size);
  normals_.resize(size);
}

void SurfaceSprings::move(int i, const FacePoint& to) {
  if (to.face != points_[i].face) {
    corners_[i] = triangle_corners(mesh_, to.face);
    normals_[i] = corners_[i].normal.normalized();
  }
  points_[i] = to;
}

bool SurfaceSprings::bends(int a, int b) const {
  return normals_[a].dot(normals_[b]) < hardly_bent;
}

FacePoint SurfaceSprings::between(int a, int b, double part) const {
  if (points_[a].position == points_[b].position) return points_[a];
  const Section way = section(mesh_, points_[a], points_[b]);
  const FacePoint there = walk(mesh_, points_[a], part * way.length * way.from_first);
  return there.face < 0 ? points_[a] : there;
}

double SurfaceSprings::length(int a, int b) const {
  return bends(a, b) ? section_length(mesh_, points_[a], points_[b])
                     : (points_[b].position - points_[a].position).norm();
}

SurfaceSprings::Force SurfaceSprings::force(const Spring& s) const {
  const Eigen::Vector3d ab = points_[s.b].position - points_[s.a].position;
  const double length = ab.norm();
  if (!(length > 0.0)) return {Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  if (bends(s.a, s.b)) {
    const Section way =
        section(mesh_, points_[s.a], points_[s.b], normals_[s.a] + normals_[s.b]);
    const double size = step * (way.length - s.rest);
    return {size * way.from_first, size * way.from_last};
  }
  const Eigen::Vector3d on_a = step * (1.0 - s.rest / length) * ab;
  return {on_a, -on_a};
}

void SurfaceSprings::relax(const std::vector<Spring>& springs, const std::vector<int>& movable,
                           int rounds, const std::function<void(double)>& progress) {
  motion_.resize(points_.size());
  for (const Spring& s : springs) motion_[s.a] = motion_[s.b] = Motion();
  if (springs.empty()) return;
  const Force none{Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()};
  std::vector<Force> forces(springs.size(), none), changes(springs.size(), none);
  std::vector<int> pulling;
  Team team(static_cast<int>(springs.size()) / batch);
  const double least_move = still * springs.front().rest;
  for (int round = 0; round < rounds; ++round) {
    if (progress) progress(static_cast<double>(round) / rounds);
    // Most of a graph soon lies still: its springs pull as before.
    pulling.clear();
    for (std::size_t k = 0; k < springs.size(); ++k)
      if (round == 0 || motion_[springs[k].a].moved || motion_[springs[k].b].moved)
        pulling.push_back(static_cast<int>(k));
    in_batches(team, static_cast<int>(pulling.size()), [&](int i) {
      const int k = pulling[i];
      const Force now = force(springs[k]);
      changes[k] = {now.on_a - forces[k].on_a, now.on_b - forces[k].on_b};
      forces[k] = now;
    });
    // Summed up in one order, so that rounding is always the same.
    for (const int k : pulling) {
      motion_[springs[k].a].force += changes[k].on_a;
      motion_[springs[k].b].force += changes[k].on_b;
    }
    in_batches(team, static_cast<int>(movable.size()),
               [&](int i) { pull(movable[i], least_move); });
  }
}

void SurfaceSprings::pull(int i, double least_move) {
  Motion& m = motion_[i];
  m.pull = carried_on * m.pull + m.force;
  m.moved = false;
  if (m.pull.squaredNorm() < least_move * least_move) return;
  const FacePoint to = walk(mesh_, points_[i], m.pull, corners_[i]);
  if (to.face < 0) return;  // over a rim: the rows there are the boundaries' own
  if (to.face != points_[i].face) normals_[i] = corners_[i].normal.normalized();
  points_[i] = to;
  m.moved = true;
}

}  // namespace meshknit
