#include "table.h"

#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>

namespace meshknit {

std::vector<RemeshOptions> growing_gauges(double area) {
  std::vector<RemeshOptions> gauges;
  for (const double nodes : {2000.0, 5000.0, 20000.0, 80000.0}) {
    RemeshOptions gauge;
    const double scale =
        std::sqrt(area / (nodes * gauge.stitch_width * 2.0 * gauge.stitch_height));
    gauge.stitch_width *= scale;
    gauge.stitch_height *= scale;
    gauges.push_back(gauge);
  }
  return gauges;
}

double seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

double peak_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

double growth_exponent(const std::vector<std::pair<double, double>>& size_and_seconds) {
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& [size, time] : size_and_seconds) {
    const double a = std::log(size), b = std::log(time);
    n += 1.0;
    x += a;
    y += b;
    xx += a * a;
    xy += a * b;
  }
  return (n * xy - x * y) / (n * xx - x * x);
}

int run_benchmark(int argc, char** argv, void (*body)(int argc, char** argv)) {
  try {
    body(argc, argv);
    return 0;
  } catch (const std::exception& e) {
    std::fprintf(stderr, "%s: %s\n", argv[0], e.what());
    return 1;
  }
}

}  // namespace meshknit
