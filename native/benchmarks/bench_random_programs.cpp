// Surfaces that nobody drew, all the way: mesh -> checked machine file. How many arrive, why the
// others do not, and which took longest at which stage.

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "meshknit/core/error.h"
#include "meshknit/pipeline/pipeline.h"
#include "random_surfaces.h"
#include "table.h"

namespace {

using namespace meshknit;

constexpr double most_seconds = 10.0;

// Of the processor: what else the machine does is not the surface's fault.
double own_seconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

constexpr const char* stages[] = {"graph", "trace", "schedule", "knitout"};

struct Slowest {
  int seed = -1;
  double seconds = 0.0;
  void add(int s, double t) {
    if (t <= seconds) return;
    seed = s;
    seconds = t;
  }
};

struct Tally {
  int knitted = 0, crashed = 0;
  int seams = 0;                                    // that were needed
  std::map<std::string, std::vector<int>> refused;  // "stage: code" -> seeds
  double stitches = 0.0, passes = 0.0, transfers = 0.0;
  double seconds[4] = {};
  Slowest slowest[4], whole;
};

void knit(int seed, Tally& tally) {
  const RandomSurface random = random_surface(static_cast<std::uint32_t>(seed));
  const MachineProfile machine = machine_profile("shima_swg091n2");
  const double begin = own_seconds();
  double last = begin;
  int stage = 0;
  const auto lap = [&] {
    const double now = own_seconds();
    tally.seconds[stage] += now - last;
    tally.slowest[stage].add(seed, now - last);
    last = now;
  };
  const auto next = [&] {
    lap();
    ++stage;
  };
  try {
    const CheckedGraph graph =
        cut_seams(build_knit_graph(random.timed.surface, random.timed.time, random.gauge));
    tally.seams += static_cast<int>(graph.seams.size());
    next();
    const StitchTrace trace = build_trace(graph.graph, machine);
    next();
    const Schedule schedule = build_schedule(trace, machine);
    next();
    const CheckedKnitout knitout =
        build_knitout(trace, schedule, machine, nullptr, graph.seams);
    ++tally.knitted;
    tally.stitches += static_cast<double>(trace.stitches.size());
    tally.passes += knitout.cost.passes;
    tally.transfers += knitout.cost.transfers;
  } catch (const NotKnittable& refusal) {
    tally.refused[std::string(stages[stage]) + ": " + refusal.problems().front().code]
        .push_back(seed);
  } catch (const std::exception& broken) {
    ++tally.crashed;
    std::printf("seed %d, %s: %s\n", seed, stages[stage], broken.what());
  }
  lap();
  tally.whole.add(seed, last - begin);
}

void measure(int argc, char** argv) {
  const int count = argc > 1 ? std::stoi(argv[1]) : 500;
  const int first = argc > 2 ? std::stoi(argv[2]) : 0;
  Tally tally;
  for (int seed = first; seed < first + count; ++seed) knit(seed, tally);
  std::printf("%d random surfaces: %d checked files, %d seams, %d crashes\n", count,
              tally.knitted, tally.seams, tally.crashed);
  for (const auto& [why, seeds] : tally.refused) {
    std::printf("refused, %s: %zu (seeds", why.c_str(), seeds.size());
    for (const int seed : seeds) std::printf(" %d", seed);
    std::printf(")\n");
  }
  std::printf("%.0f stitches, %.0f passes, %.0f transfers, %.0f MB\n", tally.stitches,
              tally.passes, tally.transfers, peak_mb());
  std::printf("stage       all, s  slowest, s    seed\n");
  for (int s = 0; s < 4; ++s)
    std::printf("%-9s %8.2f %11.2f %7d\n", stages[s], tally.seconds[s],
                tally.slowest[s].seconds, tally.slowest[s].seed);
  std::printf("%-9s %20.2f %7d\n", "together", tally.whole.seconds, tally.whole.seed);
  if (tally.crashed > 0 || tally.whole.seconds > most_seconds)
    throw std::runtime_error("a surface broke a promise or took too long");
}

}  // namespace

int main(int argc, char** argv) { return run_benchmark(argc, argv, measure); }
