// The independent check alone, on long programs without transfers: one tube, and a tube that parts
// into three, which are knit in turn.

#include <cstdio>

#include "graphs.h"
#include "meshknit/tracing/trace.h"
#include "meshknit/verify/verify_knitout.h"
#include "table.h"
#include "verify/in_place_knitter.h"

namespace {

using namespace meshknit;
using Front = GraphDrawing::Front;

std::vector<Needle> joined(const std::vector<std::vector<Needle>>& parts) {
  std::vector<Needle> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

void measure_program(const char* name, const KnitGraph& graph,
                     const std::vector<Needle>& needles) {
  const StitchTrace trace = trace_knit_graph(graph);
  const std::vector<std::string> lines = knit_in_place(trace, {needles});
  std::string text;
  for (const std::string& line : lines) text += line + "\n";
  const double begin = seconds();
  const VerifyReport report = verify_knitout(text, machine_profile("shima_swg091n2"), trace);
  const double taken = seconds() - begin;
  std::printf("%-12s %9zu lines %6.2f s %6.2f s a million %s\n", name, lines.size(), taken,
              taken * 1e6 / static_cast<double>(lines.size()), report.ok ? "ok" : "REFUSED");
}

// Three tubes of 2 * half loops each, `rows` rows before they part and after.
KnitGraph three_tubes(int half, int rows) {
  GraphDrawing drawing;
  Front trunk = drawing.cast_on(6 * half);
  for (int row = 1; row < rows; ++row) trunk = drawing.closed_row(trunk, links(6 * half));
  const auto part = [&](int from, int to) {
    return Front(trunk.begin() + from * half, trunk.begin() + to * half);
  };
  Front left = part(0, 2), right = part(3, 5), middle = part(2, 3);
  const Front rest = part(5, 6);
  middle.insert(middle.end(), rest.begin(), rest.end());
  for (int row = 0; row < rows; ++row) {
    left = drawing.closed_row(left, links(2 * half));
    right = drawing.closed_row(right, links(2 * half));
    middle = drawing.closed_row(middle, links(2 * half));
  }
  return drawing.graph();
}

void measure(int, char**) {
  measure_program("one tube", plain_tube(100, 5000),
                  joined({front_places(10, 50), back_places(10, 50)}));
  const int half = 16;
  measure_program("three tubes", three_tubes(half, 2600),
                  joined({back_places(10, half), front_places(10, half),
                          front_places(10 + half, half), front_places(10 + 2 * half, half),
                          back_places(10 + 2 * half, half), back_places(10 + half, half)}));
}

}  // namespace

int main(int argc, char** argv) { return run_benchmark(argc, argv, measure); }
