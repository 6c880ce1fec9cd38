// Remeshing of surfaces that nobody drew: how many give a valid graph, and why the others do not.

#include <cstdio>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "meshknit/core/error.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "random_surfaces.h"
#include "table.h"

namespace {

using namespace meshknit;

constexpr double least_valid = 0.995;

struct Tally {
  int valid = 0, invalid = 0, crashed = 0;
  std::map<std::string, std::vector<int>> refused;  // code -> seeds
  double nodes = 0.0, seconds = 0.0, splits = 0.0, merges = 0.0, handles = 0.0;
  TotalFit fit;
};

void add_valid(Tally& tally, const KnitGraph& graph) {
  const KnitGraphStats stats = measure_graph(graph);
  ++tally.valid;
  tally.nodes += stats.nodes;
  tally.splits += stats.splits;
  tally.merges += stats.merges;
  tally.fit.add(stats);
}

void knit(int seed, Tally& tally) {
  try {
    const RandomSurface random = random_surface(static_cast<std::uint32_t>(seed));
    const double begin = seconds();
    const KnitGraph graph = remesh(random.timed.surface, random.timed.time, random.gauge);
    tally.seconds += seconds() - begin;
    tally.handles += random.handles;
    const Problems problems = check_knit_graph(graph).problems;
    if (!has_errors(problems)) return add_valid(tally, graph);
    ++tally.invalid;
    std::printf("seed %d: %s\n", seed, problems.front().message.c_str());
  } catch (const NotKnittable& refusal) {
    tally.refused[refusal.problems().front().code].push_back(seed);
  } catch (const std::exception& broken) {
    ++tally.crashed;
    std::printf("seed %d: %s\n", seed, broken.what());
  }
}

void measure(int argc, char** argv) {
  const int count = argc > 1 ? std::stoi(argv[1]) : 1000;
  const int first = argc > 2 ? std::stoi(argv[2]) : 0;
  Tally tally;
  for (int seed = first; seed < first + count; ++seed) knit(seed, tally);
  std::printf("%d random surfaces: %d valid graphs, %d invalid ones, %d crashes\n", count,
              tally.valid, tally.invalid, tally.crashed);
  for (const auto& [code, seeds] : tally.refused) {
    std::printf("refused, %s: %zu (seeds", code.c_str(), seeds.size());
    for (const int seed : seeds) std::printf(" %d", seed);
    std::printf(")\n");
  }
  std::printf("%.0f nodes, %.0f nodes/s, %.0f splits, %.0f merges, %.0f handles, %.0f MB\n",
              tally.nodes, tally.nodes / tally.seconds, tally.splits, tally.merges,
              tally.handles, peak_mb());
  tally.fit.print("valid graphs");
  if (tally.invalid > 0 || tally.crashed > 0 || tally.valid < least_valid * count)
    throw std::runtime_error("too few valid graphs, or some that break a promise");
}

}  // namespace

int main(int argc, char** argv) { return run_benchmark(argc, argv, measure); }
