#include "schedule/tube_knitter.h"

#include "graphs.h"

namespace meshknit {

TubeKnitter::TubeKnitter(int loops) : at_(loops - 1) {
  trace_.yarns = 1;
  for (int i = 0; i < loops; ++i) ring_.push_back({LoopName{add(StitchKind::start), 0}});
}

int TubeKnitter::ahead() const {
  return (at_ + (direction_ == Direction::anticlockwise ? 1 : loops() - 1)) % loops();
}

int TubeKnitter::add(StitchKind kind) {
  Stitch stitch;
  stitch.kind = kind;
  stitch.direction = direction_;
  stitch.node = static_cast<int>(trace_.stitches.size());
  trace_.stitches.push_back(stitch);
  return stitch.node;
}

void TubeKnitter::give_parents(int stitch, const LoopStack& stack) {
  for (const LoopName& loop : stack) {
    trace_.stitches[stitch].parents.push_back(loop.stitch);
    std::vector<int>& children = trace_.stitches[loop.stitch].children;
    // The second loop may be knit before the first one.
    if (trace_.stitches[loop.stitch].kind == StitchKind::increase) {
      children.resize(2, -1);
      children[loop.which] = stitch;
    } else {
      children.push_back(stitch);
    }
  }
}

TubeKnitter& TubeKnitter::knit(int stitches) {
  for (int i = 0; i < stitches; ++i) {
    at_ = ahead();
    const int stitch = add(StitchKind::knit);
    give_parents(stitch, ring_[at_]);
    ring_[at_] = {LoopName{stitch, 0}};
  }
  return *this;
}

TubeKnitter& TubeKnitter::increase() {
  at_ = ahead();
  const int stitch = add(StitchKind::increase);
  give_parents(stitch, ring_[at_]);
  const bool forward = direction_ == Direction::anticlockwise;
  ring_[at_] = {LoopName{stitch, forward ? 0 : 1}};
  ring_.insert(ring_.begin() + at_ + 1, LoopStack{LoopName{stitch, forward ? 1 : 0}});
  at_ += forward ? 1 : 0;
  return *this;
}

size_t TubeKnitter::height_ahead(int stacks) const {
  const int step = direction_ == Direction::anticlockwise ? 1 : loops() - 1;
  size_t height = 0;
  for (int i = 1; i <= stacks; ++i) height += ring_[(at_ + i * step) % loops()].size();
  return height;
}

TubeKnitter& TubeKnitter::decrease() {
  at_ = ahead();
  const int first = at_, second = ahead();
  const int stitch = add(StitchKind::decrease);
  give_parents(stitch, ring_[first]);
  give_parents(stitch, ring_[second]);
  ring_[first] = {LoopName{stitch, 0}};
  ring_.erase(ring_.begin() + second);
  at_ = second < first ? first - 1 : first;
  return *this;
}

TubeKnitter& TubeKnitter::round() { return knit(loops()); }

TubeKnitter& TubeKnitter::turn() {
  const int next = ahead();
  const int tuck = add(StitchKind::tuck);
  trace_.stitches[tuck].node = trace_.stitches[ring_[next].front().stitch].node;
  ring_[next].push_back({tuck, 0});
  at_ = next;  // the next stitch goes back over the one before the tuck
  direction_ =
      direction_ == Direction::anticlockwise ? Direction::clockwise : Direction::anticlockwise;
  return *this;
}

StitchTrace TubeKnitter::end() {
  const size_t before = trace_.stitches.size();
  round();
  for (size_t s = before; s < trace_.stitches.size(); ++s)
    trace_.stitches[s].kind = StitchKind::end;
  return trace_;
}

StitchTrace knit_random_tube(std::uint32_t seed, int loops, int rounds, int rarity) {
  Dice dice(seed);
  TubeKnitter tube(loops);
  for (int r = 0; r < rounds; ++r) {
    for (int left = tube.loops(); left > 0;) {
      const int choice = dice.roll(4 * rarity);
      if (choice < 2 && left >= 1) {
        tube.increase();
        left -= 1;
      } else if (choice < 4 && left >= 2 && tube.loops() > 6 && tube.height_ahead(2) <= 3) {
        tube.decrease();
        left -= 2;
      } else {
        tube.knit();
        left -= 1;
      }
    }
    if (dice.roll(3) > 0 || tube.loops() < 6) continue;
    // A short row: there and back, sometimes with a decrease on the way there and an increase
    // on the way back.
    int length = 2 + dice.roll(tube.loops() - 4);
    if (tube.height_ahead(1) > 2) continue;
    tube.turn();
    if (length >= 4 && tube.loops() > 8 && dice.roll(2) == 0) {
      tube.knit().decrease().knit(length - 3);
      --length;
    } else {
      tube.knit(length);
    }
    // A needle does not hold more than three loops.
    while (tube.height_ahead(1) > 2) {
      tube.knit();
      ++length;
    }
    tube.turn();
    if (length >= 4 && dice.roll(2) == 0)
      tube.knit().increase().knit(length - 2);
    else
      tube.knit(length);
  }
  return tube.end();
}

StitchTrace knit_one_sided_cone(int loops, int least) {
  TubeKnitter tube(loops);
  while (tube.loops() > least) tube.decrease().knit(tube.loops() - 1);
  return tube.end();
}

StitchTrace knit_plain_tube(int loops, int rounds) {
  TubeKnitter tube(loops);
  for (int r = 2; r < rounds; ++r) tube.round();
  return tube.end();
}

}  // namespace meshknit
