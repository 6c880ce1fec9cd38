#pragma once

#include <cstdint>
#include <vector>

#include "meshknit/surface/blob_shape.h"

namespace meshknit {

/// Lots that are drawn alike on every machine (Marsaglia's xorshift).
class Lots {
 public:
  explicit Lots(std::uint32_t seed) : state_(0x9E3779B97F4A7C15u * (seed + 1ull)) {}
  double between(double low, double high);
  bool chance(double probability) { return between(0.0, 1.0) < probability; }

 private:
  std::uint64_t state_;
};

/// A tree of limbs before anyone knows how it is knit. The trunk's radius is about 1.
struct RandomBody {
  Blobs blobs;
  std::vector<RimCut> rims;  ///< first the trunk's
  int handles = 0;
  double thinnest = 1.0;  ///< smallest radius of a limb
};

/// Parts may run into each other; that shows in the genus and the rims of its mesh.
RandomBody random_body(Lots& lots);

}  // namespace meshknit
