#include "meshknit/transfer/pass.h"

#include <cstdlib>

namespace meshknit {

int shift_of(const Pass& pass) {
  // Front place n is needle 2n and back place m is 2m+1, so between hooks f(2n) meets b(2m+1)
  // at the odd racking 2(n-m)-1; between a hook and a parking needle both numbers have one
  // parity and the racking is 2(n-m).
  const int leftward = (changes_side(pass) ? pass.racking + 1 : pass.racking) / 2;
  return pass.from == Bed::front ? -leftward : leftward;
}

int racking_travel(const Passes& passes) {
  int travel = 0, racking = 0;
  for (const Pass& pass : passes) {
    travel += std::abs(pass.racking - racking);
    racking = pass.racking;
  }
  return travel + std::abs(racking);
}

}  // namespace meshknit
