#include "random_body.h"

#include <algorithm>
#include <cmath>

namespace meshknit {
namespace {

using Eigen::Vector3d;

constexpr double pi = 3.14159265358979323846;
constexpr int most_limbs = 8;  // beside the trunk

Vector3d turned(const Vector3d& v, const Vector3d& axis, double angle) {
  return v * std::cos(angle) + axis.cross(v) * std::sin(angle) +
         axis * axis.dot(v) * (1.0 - std::cos(angle));
}

class Growth {
 public:
  explicit Growth(Lots& lots) : lots_(lots) {}

  RandomBody grow() {
    // The trunk leaves its rim straight; the piece below the rim is cut off.
    const Tip root{Vector3d::Zero(), Vector3d::UnitZ(), Vector3d::UnitX(), 1.0};
    body_.rims.push_back({root.at, -Vector3d::UnitZ()});
    limbs_left_ = static_cast<int>(lots_.between(2.0, most_limbs + 1.0));
    const Tip end = grow_limb(root, lots_.between(3.0, 6.5), root.radius);
    end_or_branch(end, 0);
    body_.blobs.rounding = 0.45 * body_.thinnest;
    return body_;
  }

 private:
  // The end of a limb: where it goes, and across which side its branches lie.
  struct Tip {
    Vector3d at, ahead, side;
    double radius;
  };

  Tip grow_limb(Tip tip, double length, double radius) {
    constexpr int pieces = 4;
    const Vector3d axis = turned(tip.side, tip.ahead, lots_.between(0.0, 2.0 * pi));
    const double bend = lots_.chance(0.6) ? lots_.between(-0.9, 0.9) : 0.0;
    const double taper = lots_.between(0.8, 1.1);
    Limb limb = {{tip.at - 0.5 * radius * tip.ahead, radius}};
    for (int i = 1; i <= pieces; ++i) {
      tip.ahead = turned(tip.ahead, axis, bend / pieces);
      tip.at += length / pieces * tip.ahead;
      tip.radius = radius * (1.0 + (taper - 1.0) * i / pieces) * lots_.between(0.93, 1.07);
      limb.push_back({tip.at, tip.radius});
    }
    tip.side = (tip.side - tip.side.dot(tip.ahead) * tip.ahead).normalized();
    for (const LimbStop& stop : limb) body_.thinnest = std::min(body_.thinnest, stop.radius);
    body_.blobs.limbs.push_back(limb);
    if (lots_.chance(0.35)) add_bump(limb);
    if (length > 5.0 * radius && body_.handles < 2 && lots_.chance(0.3)) add_handle(limb);
    return tip;
  }

  void end_or_branch(const Tip& tip, int depth) {
    const double branches[] = {0.92, 0.45, 0.25};
    if (depth < 3 && limbs_left_ >= 2 && lots_.chance(branches[depth])) {
      branch(tip, depth);
    } else if (body_.rims.size() < 2 || lots_.chance(0.88)) {
      // The round end beyond the cut is as long as the limb is thick.
      body_.rims.push_back({tip.at, tip.ahead});
    }
  }

  void branch(Tip tip, int depth) {
    const double kind = lots_.between(0.0, 1.0);
    const int ways = std::min(kind < 0.6 ? 2 : kind < 0.87 ? 3 : 4, limbs_left_);
    limbs_left_ -= ways;
    const double widest[] = {0.0, 0.0, 0.75, 1.2, 1.6},
                 thickness[] = {0.0, 0.0, 0.72, 0.6, 0.55};
    const double spread = widest[ways] * lots_.between(0.85, 1.2);
    tip.side = turned(tip.side, tip.ahead, lots_.between(0.0, 2.0 * pi));
    const Vector3d axis = tip.ahead.cross(tip.side);
    for (int i = 0; i < ways; ++i) {
      const double angle = spread * (2.0 * i / (ways - 1) - 1.0) + lots_.between(-0.08, 0.08);
      Tip limb = tip;
      limb.ahead = turned(tip.ahead, axis, angle);
      limb.side = turned(tip.side, axis, angle);
      const double radius = tip.radius * thickness[ways] * lots_.between(0.85, 1.15);
      end_or_branch(
          grow_limb(limb, 1.6 * tip.radius + lots_.between(2.5, 5.0) * radius, radius),
          depth + 1);
    }
  }

  void add_bump(const Limb& limb) {
    const std::size_t i = lots_.chance(0.5) ? 2 : 3;
    const double radius = limb[i].radius * lots_.between(0.45, 0.7);
    const Vector3d ahead = (limb[i].at - limb[i - 1].at).normalized();
    const Vector3d out = turned(ahead.unitOrthogonal(), ahead, lots_.between(0.0, 2.0 * pi));
    body_.blobs.ellipsoids.push_back(
        {limb[i].at + limb[i].radius * lots_.between(0.6, 0.9) * out,
         radius * Vector3d(lots_.between(0.8, 1.2), lots_.between(0.8, 1.2), 1.0)});
  }

  // Leaves a limb near its beginning and returns near its end, far enough out for a hole.
  void add_handle(const Limb& limb) {
    const double radius = limb[2].radius * lots_.between(0.42, 0.6);
    const Vector3d from = 0.5 * (limb[0].at + limb[1].at);
    const Vector3d to = 0.5 * (limb[3].at + limb[4].at), along = to - from;
    const Vector3d ahead = along.normalized();
    const Vector3d out = turned(ahead.unitOrthogonal(), ahead, lots_.between(0.0, 2.0 * pi));
    const double reach = limb[2].radius * lots_.between(1.7, 2.2) + 2.0 * radius;
    constexpr int pieces = 8;
    Limb handle;
    for (int i = 0; i <= pieces; ++i) {
      const double angle = pi * i / pieces;
      handle.push_back(
          {from + 0.5 * (1.0 - std::cos(angle)) * along + reach * std::sin(angle) * out,
           radius});
    }
    body_.thinnest = std::min(body_.thinnest, radius);
    body_.blobs.limbs.push_back(handle);
    ++body_.handles;
  }

  Lots& lots_;
  RandomBody body_;
  int limbs_left_ = 0;
};

}  // namespace

double Lots::between(double low, double high) {
  state_ ^= state_ << 13;
  state_ ^= state_ >> 7;
  state_ ^= state_ << 17;
  return low + (high - low) * static_cast<double>(state_ >> 32) / 4294967296.0;
}

RandomBody random_body(Lots& lots) { return Growth(lots).grow(); }

}  // namespace meshknit
