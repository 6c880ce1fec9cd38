#include <gtest/gtest.h>

#include "meshknit/emit/step_transfers.h"
#include "meshknit/pipeline/pipeline.h"
#include "models.h"
#include "shapes.h"
#include "transfer/textbook_planner.h"

namespace meshknit {
namespace {

struct Moves {
  int passes = 0;
  std::size_t transfers = 0;
};

// Everything that must be moved to knit these shapes, planned by us and by the textbook.
struct Compared {
  Moves ours, textbook;

  void add(const ExampleShape& shape) {
    const MachineProfile machine = machine_profile("shima_swg091n2");
    const TimedShape piece = timed(opened(shape));
    const StitchTrace trace =
        build_trace(build_knit_graph(piece.surface, piece.time, {}).graph, machine);
    const Schedule schedule = build_schedule(trace, machine);
    TransferPlanner planner;
    for (const ScheduleStep& step : schedule.steps) {
      const TransferProblem problem =
          step_transfer_problem(step, transfer_direction(trace, step), machine);
      if (problem.loops.empty()) continue;
      const TextbookPlan alone = collapse_shift_expand_alone(problem);
      if (!alone.arrived) continue;
      const TransferPlan plan = planner.plan(problem);
      ours.passes += count_passes(plan);
      ours.transfers += plan.transfers.size();
      textbook.passes += count_slider_passes(alone.plan);
      textbook.transfers += alone.plan.transfers.size();
    }
  }

  void expect_half() const {
    EXPECT_GT(ours.passes, 0);
    EXPECT_LE(2 * ours.passes, textbook.passes);
    EXPECT_LE(2 * ours.transfers, textbook.transfers);
  }
};

TEST(PlannedPasses, AreHalfOfThoseOfTheTextbook) {
  Compared compared;
  for (const char* name : {"sock", "mitten", "teddy"}) compared.add(example_shape(name));
  compared.expect_half();
}

TEST(PlannedPasses, AreHalfOnOtherPeoplesModels) {
  Compared compared;
  for (const std::string& name : model_names()) {
    const std::optional<ExampleShape> shape = model(name);
    if (!shape) GTEST_SKIP() << why_no_models();
    compared.add(*shape);
  }
  compared.expect_half();
}

}  // namespace
}  // namespace meshknit
