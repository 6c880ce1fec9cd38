#include "meshknit/remesh/sampling.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "meshknit/remesh/linking.h"

namespace meshknit {
namespace {

// How far along the active cycle from a node its image is looked for, mm.
constexpr double look_aside = 3.0;

}  // namespace

std::vector<NodeImage> images_on_next(const ActiveCycle& active, int source,
                                      const NextCycle& next) {
  const double length = active.cycle.length();
  std::vector<std::pair<double, int>> feet;  // place on the active cycle, crossing
  for (int i = 0; i < next.cycle.size(); ++i)
    if (next.source[i] == source) feet.push_back({next.foot[i], i});
  std::sort(feet.begin(), feet.end());
  const int n = static_cast<int>(feet.size());
  std::vector<NodeImage> images;
  for (const ActiveNode& node : active.nodes) {
    NodeImage image;
    double nearest = std::numeric_limits<double>::infinity();
    const auto offer = [&](int k) {
      const auto& [foot, crossing] = feet[k];
      const double off = around(foot, node.place, length), gap = next.gap[crossing];
      if (off * off + gap * gap < nearest) {
        nearest = off * off + gap * gap;
        image.off = std::abs(off);
        const double step = next.cycle.arc[crossing + 1] - next.cycle.arc[crossing];
        image.place = next.cycle.arc[crossing] + std::clamp(off, -step, step);
      }
      return std::abs(off);
    };
    const auto after =
        std::lower_bound(feet.begin(), feet.end(), std::make_pair(node.place, -1));
    const int begin = static_cast<int>(after - feet.begin());
    // A far strand of the active cycle may have a foot that fits, too: what is nearest counts.
    for (int k = 0; k < n && offer((begin + k) % n) < look_aside; ++k) continue;
    for (int k = 1; k <= n && offer((begin - k + n) % n) < look_aside; ++k) continue;
    images.push_back(image);
  }
  return images;
}

std::vector<double> sample_next_row(const ActiveCycle& active, const NextCycle& next,
                                    const std::vector<NodeImage>& images, double stitch_width,
                                    int fewest, int unit) {
  constexpr double turn = 6.28318530717958647692;
  std::vector<char> single;
  for (const ActiveNode& node : active.nodes) single.push_back(node.single);
  const auto [least, most] = linkable_counts(single);
  const double length = next.cycle.length();
  const int wanted = unit * static_cast<int>(std::lround(length / (unit * stitch_width)));
  const int count = std::clamp(wanted, std::min(std::max(fewest, least), most), most);
  const double spacing = length / count;
  double x = 0.0, y = 0.0;
  for (const NodeImage& image : images) {
    x += std::cos(turn * image.place / spacing);
    y += std::sin(turn * image.place / spacing);
  }
  const double phase = std::atan2(y, x) / turn * spacing;
  std::vector<double> places(count);
  for (int j = 0; j < count; ++j) places[j] = forward(0.0, phase + j * spacing, length);
  return places;
}

}  // namespace meshknit
