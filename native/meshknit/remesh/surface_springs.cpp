#include "meshknit/remesh/surface_springs.h"

#include "meshknit/remesh/walk.h"

namespace meshknit {
namespace {

// Each of a point's springs, about four, pulls by this part of its error a round.
constexpr double step = 0.22;

// Movement that goes on from round to round: corrections travel further in fewer rounds.
constexpr double carried_on = 0.7;

// A point that would move less than this stays where it is, mm.
constexpr double still = 2e-3;

// Cosine of the angle between two points' triangles from which on the way over the surface is measured:
// bent less, it is at most a hundredth longer than the straight one.
constexpr double hardly_bent = 0.95;

Eigen::Vector3d normal_of(const TriangleMesh& mesh, int face) {
  return mesh.calc_face_normal(TriangleMesh::FaceHandle(face));
}

}  // namespace

void SurfaceSprings::add(const FacePoint& at) {
  points_.push_back(at);
  normals_.push_back(normal_of(mesh_, at.face));
}

void SurfaceSprings::shrink(int size) {
  points_.resize(size);
  normals_.resize(size);
}

void SurfaceSprings::move(int i, const FacePoint& to) {
  if (to.face != points_[i].face) normals_[i] = normal_of(mesh_, to.face);
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

void SurfaceSprings::relax(const std::vector<Spring>& springs, const std::vector<int>& movable,
                           int rounds, const std::function<void(double)>& progress) {
  pull_.resize(points_.size());
  for (const Spring& s : springs)
    for (const int i : {s.a, s.b}) pull_[i].setZero();
  for (int round = 0; round < rounds; ++round) {
    if (progress) progress(static_cast<double>(round) / rounds);
    for (const int i : movable) pull_[i] *= carried_on;
    for (const Spring& s : springs) {
      const Eigen::Vector3d ab = points_[s.b].position - points_[s.a].position;
      const double length = ab.norm();
      if (!(length > 0.0)) continue;
      if (bends(s.a, s.b)) {
        const Section way = section(mesh_, points_[s.a], points_[s.b]);
        const double force = step * (way.length - s.rest);
        pull_[s.a] += force * way.from_first;
        pull_[s.b] += force * way.from_last;
      } else {
        const Eigen::Vector3d force = step * (1.0 - s.rest / length) * ab;
        pull_[s.a] += force;
        pull_[s.b] -= force;
      }
    }
    for (const int i : movable) {
      if (pull_[i].squaredNorm() < still * still) continue;
      const FacePoint moved = walk(mesh_, points_[i], pull_[i]);
      if (moved.face >= 0)
        move(i, moved);  // over a rim: the rows there are the boundaries' own
    }
  }
}

}  // namespace meshknit
