#pragma once

#include <string>

namespace meshknit {

/// The Kniterate's settings, which extension operations change (primer, section 3). At first the
/// public backend's defaults.
struct KcodeSettings {
  char stitch = '5', transfer = '3';  ///< sizes
  int speed = 100, roller = 100;
  int added_roller = 0;  ///< for one pass

  /// An extension as it stands in a program. Others than sizes, speed and roller change nothing.
  /// Throws: InvalidInput if the value cannot be read.
  void take(const std::string& text);
};

}  // namespace meshknit
