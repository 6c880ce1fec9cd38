// Remeshing at growing sizes: speed, growth, fit of the stitches.

#include <cstdio>

#include "meshknit/knit_graph/knit_graph_checks.h"
#include "skirt.h"
#include "table.h"

namespace {

using namespace meshknit;

void measure(int argc, char** argv) {
  const Workpiece piece = workpiece_of(argc, argv);
  std::printf("%s: %.0f vertices, %.0f cm2\n", piece.name.c_str(),
              static_cast<double>(piece.surface.mesh.n_vertices()), piece.surface.area / 100.0);
  std::printf(
      "   nodes  seconds  nodes/s  row10  row20  col10  col20  rows short   inc   dec     "
      "MB\n");
  std::vector<std::pair<double, double>> growth;
  for (const RemeshOptions& gauge : growing_gauges(piece.surface.area)) {
    const double begin = seconds();
    const KnitGraph graph = remesh(piece.surface, piece.time, gauge);
    const double taken = seconds() - begin;
    const KnitGraphStats stats = measure_graph(graph);
    std::vector<int> up(graph.nodes.size(), 0), down(graph.nodes.size(), 0);
    int increases = 0, decreases = 0;
    for (const auto& column : graph.columns) {
      increases += ++up[column[0]] == 2;
      decreases += ++down[column[1]] == 2;
    }
    std::printf("%8d %8.2f %8.0f %6.1f %6.1f %6.1f %6.1f %5d %5d %5d %5d %6.0f\n", stats.nodes,
                taken, stats.nodes / taken, 100.0 * stats.row_error.within_10,
                100.0 * stats.row_error.within_20, 100.0 * stats.column_error.within_10,
                100.0 * stats.column_error.within_20, stats.rows, stats.short_rows, increases,
                decreases, peak_mb());
    growth.push_back({stats.nodes, taken});
  }
  std::printf("seconds grow as nodes ^ %.3f\n", growth_exponent(growth));
}

}  // namespace

int main(int argc, char** argv) { return run_benchmark(argc, argv, measure); }
