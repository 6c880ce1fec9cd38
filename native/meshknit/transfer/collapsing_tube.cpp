#include "meshknit/transfer/collapsing_tube.h"

namespace meshknit {

void append_move(CollapsingTube& state, HangingRun& run, const Stop& to) {
  const Stop from = run.stop();
  const auto append = [&](int beyond) {
    state.plan.transfers.push_back({{from.bed(), from.place + beyond, from.parked},
                                    {to.bed(), to.place + beyond, to.parked}});
  };
  append(0);
  for (const int beyond : run.beyond) append(beyond);
  run.go_to(to);
}

}  // namespace meshknit
