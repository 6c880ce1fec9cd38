#pragma once

#include <string>
#include <utility>
#include <vector>

#include "meshknit/knit_graph/knit_graph_checks.h"
#include "meshknit/remesh/remesh.h"

namespace meshknit {

/// Gauges for a surface of this area (mm^2): the default stitch, scaled so that graphs get about so
/// many nodes.
std::vector<RemeshOptions> gauges_for(double area, const std::vector<double>& nodes);

/// How well the edges of several graphs together have the wanted lengths.
class TotalFit {
 public:
  void add(const KnitGraphStats& stats);
  /// One line; nothing if there were no edges.
  void print(const char* of_what) const;

 private:
  struct Kind {
    double edges = 0.0, within_10 = 0.0, within_20 = 0.0;
    void add(const LengthError& error);
  };
  Kind rows_, columns_;
};

/// Seconds on a clock that only goes forward.
double seconds();

/// The most memory that the process has used since forget_peak(), MB; since its start where the
/// system (Linux) cannot forget.
double peak_mb();
void forget_peak();

/// How time grows with size: least squares of log(seconds) over log(size).
double growth_exponent(const std::vector<std::pair<double, double>>& size_and_seconds);

/// Runs a benchmark's body; what it throws is printed. Returns the exit status.
int run_benchmark(int argc, char** argv, void (*body)(int argc, char** argv));

}  // namespace meshknit
