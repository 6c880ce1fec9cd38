// From the surface to the verified file at growing sizes: seconds a stage, passes, transfers.

#include <cstdio>

#include "meshknit/pipeline/pipeline.h"
#include "skirt.h"
#include "table.h"

namespace {

using namespace meshknit;

void measure(int argc, char** argv) {
  const Workpiece piece = workpiece_of(argc, argv);
  // A bed that is wide enough at every gauge: speed is what is measured, not a machine.
  MachineProfile machine = machine_profile("shima_swg091n2");
  machine.needles = 4000;
  std::printf(
      "%s\n   nodes    graph    trace schedule  knitout    total   passes transfers     MB\n",
      piece.name.c_str());
  std::vector<std::pair<double, double>> growth;
  for (const RemeshOptions& gauge : gauges_for(piece.surface.area, {2e3, 5e3, 2e4, 8e4})) {
    const double t0 = seconds();
    const CheckedGraph graph = build_knit_graph(piece.surface, piece.time, gauge);
    const double t1 = seconds();
    const StitchTrace trace = build_trace(graph.graph, machine);
    const double t2 = seconds();
    const Schedule schedule = build_schedule(trace, machine);
    const double t3 = seconds();
    const CheckedKnitout knitout = build_knitout(trace, schedule, machine);
    const double t4 = seconds();
    std::printf("%8d %8.2f %8.2f %8.2f %8.2f %8.2f %8d %9d %6.0f\n", graph.stats.nodes, t1 - t0,
                t2 - t1, t3 - t2, t4 - t3, t4 - t0, knitout.cost.passes, knitout.cost.transfers,
                peak_mb());
    growth.push_back({graph.stats.nodes, t4 - t0});
  }
  std::printf("seconds grow as nodes ^ %.3f\n", growth_exponent(growth));
}

}  // namespace

int main(int argc, char** argv) { return run_benchmark(argc, argv, measure); }
