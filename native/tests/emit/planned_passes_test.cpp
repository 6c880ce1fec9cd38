#include <gtest/gtest.h>

#include "meshknit/emit/step_transfers.h"
#include "meshknit/pipeline/pipeline.h"
#include "models.h"
#include "shapes.h"
#include "transfer/textbook_planner.h"

namespace meshknit {
namespace {

struct Moves {
  double passes = 0.0, transfers = 0.0;
  void add(const TransferPlan& plan) {
    passes += count_passes(plan);
    transfers += static_cast<double>(plan.transfers.size());
  }
};

// Everything that must be moved to knit this shape, planned by us and by the textbook.
void expect_fewer_than_the_textbook(const ExampleShape& shape, const std::string& name) {
  const MachineProfile machine = machine_profile("shima_swg091n2");
  const TimedShape piece = timed(opened(shape));
  const StitchTrace trace =
      build_trace(build_knit_graph(piece.surface, piece.time, {}).graph, machine);
  const Schedule schedule = build_schedule(trace, machine);
  TransferPlanner planner;
  Moves ours, textbook;
  for (const ScheduleStep& step : schedule.steps) {
    const TransferProblem problem =
        step_transfer_problem(step, transfer_direction(trace, step), machine);
    if (problem.loops.empty()) continue;
    const TextbookPlan alone = collapse_shift_expand_alone(problem);
    if (!alone.arrived) continue;
    ours.add(planner.plan(problem));
    textbook.add(alone.plan);
  }
  // A gap or a decrease takes the textbook four passes, and no plan fewer than two.
  EXPECT_LE(ours.passes, 0.75 * textbook.passes) << name;
  EXPECT_LE(ours.transfers, 0.5 * textbook.transfers) << name;
}

TEST(PlannedPasses, AreFewerThanThoseOfTheTextbook) {
  for (const char* name : {"sock", "mitten", "teddy"})
    expect_fewer_than_the_textbook(example_shape(name), name);
}

TEST(PlannedPasses, AreFewerOnOtherPeoplesModels) {
  for (const char* name : {"glove", "spot_two", "bob"})
    if (const std::optional<ExampleShape> shape = model(name))
      expect_fewer_than_the_textbook(*shape, name);
}

}  // namespace
}  // namespace meshknit
