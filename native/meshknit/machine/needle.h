#pragma once

#include <string>
#include <tuple>

namespace meshknit {

enum class Bed { front, back };

inline Bed opposite(Bed bed) { return bed == Bed::front ? Bed::back : Bed::front; }

/// A needle as knitout names it: f12, b-3, and with `slider` fs4, bs4.
struct Needle {
  Bed bed = Bed::front;
  int index = 0;
  bool slider = false;

  friend bool operator==(const Needle& a, const Needle& b) {
    return a.bed == b.bed && a.index == b.index && a.slider == b.slider;
  }
  friend bool operator!=(const Needle& a, const Needle& b) { return !(a == b); }
  friend bool operator<(const Needle& a, const Needle& b) {
    return std::tie(a.bed, a.index, a.slider) < std::tie(b.bed, b.index, b.slider);
  }
};

inline std::string to_string(const Needle& needle) {
  return std::string(needle.bed == Bed::front ? "f" : "b") + (needle.slider ? "s" : "") +
         std::to_string(needle.index);
}

/// Half gauge: every second needle holds a loop, so that each loop has an empty needle opposite and
/// beside it (knitout primer, section 3). A place is a needle in tube coordinates.
///
///     back    b(2n)   b(2n+1)      parked front loop n    hook of back place n
///     front   f(2n)   f(2n+1)      hook of front place n  parked back loop n
///
/// `parked`: the loop belongs to the *other* bed and waits opposite its own hook. So place
/// {front, n, parked} is on the front bed and holds a loop of the back.
struct Place {
  Bed bed = Bed::front;
  int n = 0;
  bool parked = false;

  friend bool operator==(const Place& a, const Place& b) {
    return a.bed == b.bed && a.n == b.n && a.parked == b.parked;
  }
  friend bool operator!=(const Place& a, const Place& b) { return !(a == b); }
  friend bool operator<(const Place& a, const Place& b) {
    return std::tie(a.bed, a.n, a.parked) < std::tie(b.bed, b.n, b.parked);
  }
};

/// The real needle of a half-gauge place.
inline Needle half_gauge_needle(const Place& place) {
  const bool odd = (place.bed == Bed::back) != place.parked;
  return {place.bed, 2 * place.n + (odd ? 1 : 0), false};
}

/// The racking at which needles of opposite beds face each other: at rack R, b meets f = b + R.
inline int racking_between(const Needle& a, const Needle& b) {
  return a.bed == Bed::front ? a.index - b.index : b.index - a.index;
}

}  // namespace meshknit
