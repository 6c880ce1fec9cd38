// Remeshing over shapes and gauges, and at growing sizes: speed, fit of the stitches, violations.

#include <cstdio>
#include <numeric>
#include <optional>

#include "meshknit/core/error.h"
#include "meshknit/knit_graph/knit_graph_checks.h"
#include "models.h"
#include "shapes.h"
#include "skirt.h"
#include "table.h"

namespace {

using namespace meshknit;

constexpr double gauges[] = {0.6, 0.8, 1.0, 1.4, 2.0};

void print_head() {
  std::printf(
      "%-17s gauge   nodes  field  graph nodes/s  row10  row20  col10  col20 irregular  rows "
      "short splits merges viol     MB\n",
      "shape");
}

// One line of a table. Returns the seconds that the graph took, or nothing for a refusal, of which the
// line says why.
std::optional<double> print_line(const std::string& name, double times, double field_seconds,
                                 const Surface& surface, const std::vector<double>& time,
                                 const RemeshOptions& options, KnitGraphStats& stats) {
  std::printf("%-17s %5.2f ", name.c_str(), times);
  forget_peak();
  const double begin = seconds();
  try {
    const KnitGraph graph = remesh(surface, time, options);
    const double taken = seconds() - begin;
    stats = measure_graph(graph);
    const KnitGraphCheck check = check_knit_graph(graph);
    std::printf("%7d %6.2f %6.2f %7.0f %6.1f %6.1f %6.1f %6.1f %9d %5d %5d %6d %6d %4d %6.0f\n",
                stats.nodes, field_seconds, taken, stats.nodes / taken,
                100.0 * stats.row_error.within_10, 100.0 * stats.row_error.within_20,
                100.0 * stats.column_error.within_10, 100.0 * stats.column_error.within_20,
                stats.irregular, stats.rows, stats.short_rows, stats.splits, stats.merges,
                std::accumulate(check.violations.begin(), check.violations.end(), 0),
                peak_mb());
    return taken;
  } catch (const NotKnittable& refusal) {
    std::printf("%s: %s\n", refusal.problems().front().code.c_str(), refusal.what());
    return std::nullopt;
  }
}

void print_shape(const std::string& name, const ExampleShape& shape, TotalFit& at_default) {
  for (const double times : gauges) {
    const RemeshOptions options = gauge(times);
    const double begin = seconds();
    std::optional<TimedShape> ready;
    try {
      ready = timed(opened(shape, options.stitch_width), options.stitch_width);
    } catch (const NotKnittable& refusal) {
      std::printf("%-17s %5.2f %s: %s\n", name.c_str(), times,
                  refusal.problems().front().code.c_str(), refusal.what());
      continue;
    }
    KnitGraphStats stats;
    if (print_line(name, times, seconds() - begin, ready->surface, ready->time, options,
                   stats) &&
        times == 1.0)
      at_default.add(stats);
  }
}

void print_shapes() {
  print_head();
  TotalFit examples;
  for (const std::string& name : example_shape_names())
    print_shape(name, example_shape(name), examples);
  TotalFit models;
  for (const std::string& name : model_names())
    if (const std::optional<ExampleShape> shape = model(name))
      print_shape(name, *shape, models);
  examples.print("examples at gauge 1");
  models.print("models at gauge 1");
}

void print_growth(const Workpiece& piece) {
  std::printf("%s at growing sizes: %.0f vertices, %.0f cm2\n", piece.name.c_str(),
              static_cast<double>(piece.surface.mesh.n_vertices()), piece.surface.area / 100.0);
  print_head();
  std::vector<std::pair<double, double>> growth;
  for (const RemeshOptions& options :
       gauges_for(piece.surface.area, {2e3, 5e3, 1e4, 2e4, 5e4, 1e5, 2e5})) {
    KnitGraphStats stats;
    const double times = options.stitch_width / RemeshOptions().stitch_width;
    if (const auto taken =
            print_line(piece.name, times, 0.0, piece.surface, piece.time, options, stats))
      growth.push_back({stats.nodes, *taken});
  }
  std::printf("seconds grow as nodes ^ %.3f\n\n", growth_exponent(growth));
}

void measure(int argc, char** argv) {
  print_growth(workpiece_of(argc, argv));
  if (argc == 1) print_shapes();
}

}  // namespace

int main(int argc, char** argv) { return run_benchmark(argc, argv, measure); }
