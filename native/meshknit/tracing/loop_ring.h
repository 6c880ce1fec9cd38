#pragma once

#include <vector>

namespace meshknit {

/// The loops that hang on the machine, tube by tube, each tube as a ring in anticlockwise
/// order. A loop is a number that the ring gives out, from 0 and never again.
///
/// Keeps who hangs beside whom while rows are only partly knit, which the graph alone does not
/// say: beside the end of a short row there may be a loop of any row (paper, section 3.3: "any
/// underlying node").
/// Requires: all arguments are loops that hang (were added and not taken off).
class LoopRing {
 public:
  /// A new ring with one loop.
  int add_alone();
  /// A new loop, anticlockwise beside `loop`.
  int add_after(int loop);
  /// The loop is knit through; its neighbours close up.
  void take_off(int loop);
  /// Takes these loops out of their rings and makes them one ring, in this order: tubes part or
  /// meet.
  void join(const std::vector<int>& loops);

  int next(int loop) const { return next_[loop]; }  ///< anticlockwise neighbour
  int previous(int loop) const { return previous_[loop]; }
  bool hangs(int loop) const { return next_[loop] >= 0; }

 private:
  void unlink(int loop);

  std::vector<int> next_, previous_;
};

}  // namespace meshknit
