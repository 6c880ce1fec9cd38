// What must be moved to knit whole objects: passes and transfers of our plans and of
// collapse-shift-expand alone, as published (with sliders) and in half gauge, where it needs fewer
// passes; seconds to plan, and which part of the way from mesh to file each stage takes. Knits the examples by name and the models if they are there.

#include <cstdio>
#include <string>
#include <vector>

#include "meshknit/core/error.h"
#include "meshknit/emit/step_transfers.h"
#include "meshknit/pipeline/pipeline.h"
#include "models.h"
#include "shapes.h"
#include "table.h"
#include "transfer/textbook_planner.h"

namespace {

using namespace meshknit;

struct Moves {
  int passes = 0, slider_passes = 0;
  std::size_t transfers = 0;
  void add(const TransferPlan& plan) {
    passes += count_passes(plan);
    slider_passes += count_slider_passes(plan);
    transfers += plan.transfers.size();
  }
  void add(const Moves& other) {
    passes += other.passes;
    slider_passes += other.slider_passes;
    transfers += other.transfers;
  }
};

struct Compared {
  int problems = 0, stuck = 0;
  Moves ours, textbook;
  double seconds = 0.0;
};

Compared compare(const StitchTrace& trace, const Schedule& schedule,
                 const MachineProfile& machine) {
  Compared compared;
  TransferPlanner planner;
  for (const ScheduleStep& step : schedule.steps) {
    const TransferProblem problem =
        step_transfer_problem(step, transfer_direction(trace, step), machine);
    if (problem.loops.empty()) continue;
    ++compared.problems;
    const double begin = seconds();
    const TransferPlan plan = planner.plan(problem);
    compared.seconds += seconds() - begin;
    const TextbookPlan alone = collapse_shift_expand_alone(problem);
    compared.stuck += alone.arrived ? 0 : 1;
    if (!alone.arrived) continue;
    compared.ours.add(plan);
    compared.textbook.add(alone.plan);
  }
  return compared;
}

double ratio(double part, double whole) { return whole > 0.0 ? part / whole : 0.0; }

void print_line(const std::string& name, const Compared& compared) {
  std::printf("%-16s %6d %7d %7d %5.2f %7d %5.2f %8zu %8zu %5.2f %8.2f", name.c_str(),
              compared.problems, compared.ours.passes, compared.textbook.slider_passes,
              ratio(compared.ours.passes, compared.textbook.slider_passes),
              compared.textbook.passes, ratio(compared.ours.passes, compared.textbook.passes),
              compared.ours.transfers, compared.textbook.transfers,
              ratio(static_cast<double>(compared.ours.transfers),
                    static_cast<double>(compared.textbook.transfers)),
              compared.seconds);
}

void knit(const std::string& name, const ExampleShape& shape, Compared& all) {
  const MachineProfile machine = machine_profile("shima_swg091n2");
  try {
    const TimedShape piece = timed(opened(shape));
    const double t0 = seconds();
    const CheckedGraph graph = build_knit_graph(piece.surface, piece.time, {});
    const double t1 = seconds();
    const StitchTrace trace = build_trace(graph.graph, machine);
    const double t2 = seconds();
    const Schedule schedule = build_schedule(trace, machine);
    const double t3 = seconds();
    const CheckedKnitout knitout = build_knitout(trace, schedule, machine);
    const double t4 = seconds();
    const Compared compared = compare(trace, schedule, machine);
    print_line(name, compared);
    const double percent = 100.0 / (t4 - t0);
    std::printf(" %8zu %7d %6.2f %5.0f %5.0f %5.0f %5.0f\n", trace.stitches.size(),
                knitout.cost.passes, t4 - t0, percent * (t1 - t0), percent * (t2 - t1),
                percent * (t3 - t2), percent * (t4 - t3));
    all.problems += compared.problems;
    all.stuck += compared.stuck;
    all.seconds += compared.seconds;
    all.ours.add(compared.ours);
    all.textbook.add(compared.textbook);
  } catch (const NotKnittable& refusal) {
    std::printf("%-16s refused: %s\n", name.c_str(), refusal.problems().front().code.c_str());
  }
}

void measure(int, char**) {
  std::printf(
      "                  passes: ours, textbook's with sliders, in half gauge; "
      "transfers                  whole program              %% of the seconds\n"
      "object            moves    ours sliders ratio    half ratio     ours    textb ratio  "
      "plan, s stitches  passes      s graph trace sched knito\n");
  Compared all;
  for (const std::string& name : example_shape_names()) knit(name, example_shape(name), all);
  for (const std::string& name : model_names())
    if (const std::optional<ExampleShape> shape = model(name)) knit(name, *shape, all);
  print_line("all", all);
  std::printf("\n%d moves left out: the textbook does not arrive\n", all.stuck);
}

}  // namespace

int main(int argc, char** argv) { return run_benchmark(argc, argv, measure); }
