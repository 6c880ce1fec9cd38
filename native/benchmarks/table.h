#pragma once

#include <string>
#include <utility>
#include <vector>

#include "meshknit/remesh/remesh.h"

namespace meshknit {

/// Gauges for a surface of this area (mm^2): the default stitch, scaled so that graphs get
/// about 2,000, 5,000, 20,000 and 80,000 nodes.
std::vector<RemeshOptions> growing_gauges(double area);

/// Seconds on a clock that only goes forward.
double seconds();

/// The most memory that the process has used so far, MB.
double peak_mb();

/// How time grows with size: least squares of log(seconds) over log(size).
double growth_exponent(const std::vector<std::pair<double, double>>& size_and_seconds);

/// Runs a benchmark's body; what it throws is printed. Returns the exit status.
int run_benchmark(int argc, char** argv, void (*body)(int argc, char** argv));

}  // namespace meshknit
