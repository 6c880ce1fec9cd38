// Every example and every model at hand on every machine, in stitches of half, once and twice the default size: what the file
// costs, or why there is none.

#include <cstdio>
#include <optional>

#include "meshknit/core/error.h"
#include "meshknit/pipeline/pipeline.h"
#include "models.h"
#include "shapes.h"
#include "table.h"

namespace {

using namespace meshknit;

void knit(const std::string& name, const ExampleShape& drawn, double size,
          const MachineProfile& machine) {
  std::printf("%-18s %4.1f %-16s ", name.c_str(), size, machine.name.c_str());
  try {
    const double begun = seconds();
    const RemeshOptions options = gauge(size);
    const TimedShape shape = timed(opened(drawn, options.stitch_width), options.stitch_width);
    const CheckedGraph graph = build_knit_graph(shape.surface, shape.time, options);
    const StitchTrace trace = build_trace(graph.graph, machine);
    const Schedule schedule = build_schedule(trace, machine);
    const CheckedKnitout file = build_knitout(trace, schedule, machine);
    std::printf("%8zu %6d %6d %9d %4.0f %5d %7.0f %7.2f %4d\n", trace.stitches.size(),
                file.cost.passes, file.kcode_sweeps, file.cost.transfers, file.cost.max_racking,
                trace.yarns, file.cost.estimated_minutes, seconds() - begun,
                file.check.warnings);
  } catch (const NotKnittable& refused) {
    const Problem& reason = refused.problems().front();
    std::printf("%s: %s %s\n", reason.code.c_str(), reason.message.c_str(),
                reason.remedy.c_str());
  }
}

void knit_everywhere(const std::string& name, const ExampleShape& drawn) {
  for (const std::string& machine : machine_profile_names())
    for (const double size : {0.5, 1.0, 2.0}) knit(name, drawn, size, machine_profile(machine));
}

void measure(int argc, char** argv) {
  std::printf(
      "shape             size machine          stitches passes sweeps transfers rack yarns "
      "minutes "
      "seconds warn\n");
  const auto wanted = [&](const std::string& name) { return argc < 2 || name == argv[1]; };
  for (const std::string& name : example_shape_names())
    if (wanted(name)) knit_everywhere(name, example_shape(name));
  for (const std::string& name : model_names())
    if (const auto found = wanted(name) ? model(name) : std::nullopt)
      knit_everywhere(name, *found);
}

}  // namespace

int main(int argc, char** argv) { return run_benchmark(argc, argv, measure); }
