#include "table.h"

#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <cstdio>
#include <exception>
#include <fstream>

namespace meshknit {

std::vector<RemeshOptions> gauges_for(double area, const std::vector<double>& nodes) {
  std::vector<RemeshOptions> gauges;
  for (const double wanted : nodes) {
    RemeshOptions gauge;
    const double scale =
        std::sqrt(area / (wanted * gauge.stitch_width * 2.0 * gauge.stitch_height));
    gauge.stitch_width *= scale;
    gauge.stitch_height *= scale;
    gauges.push_back(gauge);
  }
  return gauges;
}

void TotalFit::Kind::add(const LengthError& error) {
  edges += error.edges;
  within_10 += error.edges * error.within_10;
  within_20 += error.edges * error.within_20;
}

void TotalFit::add(const KnitGraphStats& stats) {
  rows_.add(stats.row_error);
  columns_.add(stats.column_error);
}

void TotalFit::print(const char* of_what) const {
  if (rows_.edges == 0.0) return;
  std::printf(
      "%s: rows %.2f %% within 10 %%, %.2f %% within 20 %%; columns %.2f %%, %.2f %%\n",
      of_what, 100.0 * rows_.within_10 / rows_.edges, 100.0 * rows_.within_20 / rows_.edges,
      100.0 * columns_.within_10 / columns_.edges, 100.0 * columns_.within_20 / columns_.edges);
}

double seconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double>(now).count();
}

double peak_mb() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;)
    if (double kilobytes = 0.0; word == "VmHWM:" && status >> kilobytes)
      return kilobytes / 1024.0;
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;
}

void forget_peak() {
  // "5" resets the high-water mark (proc(5)).
  std::ofstream("/proc/self/clear_refs") << 5;
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
