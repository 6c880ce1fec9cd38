#include "meshknit/remesh/sampling.h"

#include <algorithm>
#include <cmath>

#include "meshknit/remesh/linking.h"

namespace meshknit {

std::vector<double> images_on_next(const ActiveCycle& active, const NextCycle& next) {
  const double length = active.cycle.length();
  const int n = next.cycle.size(), nodes = static_cast<int>(active.nodes.size());
  std::vector<double> images(nodes, 0.0);
  std::vector<double> nearest(nodes, 2.0 * length);
  // Every piece of the next cycle is the image of the stretch between its ends' feet.
  std::vector<std::pair<double, int>> by_place(nodes);
  for (int i = 0; i < nodes; ++i) by_place[i] = {active.nodes[i].place, i};
  std::sort(by_place.begin(), by_place.end());
  const auto offer = [&](int node, double off, double image) {
    if (off < nearest[node]) {
      nearest[node] = off;
      images[node] = image;
    }
  };
  for (int i = 0; i < n; ++i) {
    const double a = next.foot[i], span = around(a, next.foot[(i + 1) % n], length);
    const double step = next.cycle.arc[i + 1] - next.cycle.arc[i];
    const auto first =
        std::lower_bound(by_place.begin(), by_place.end(), std::make_pair(a, -1));
    const int begin = static_cast<int>(first - by_place.begin());
    for (int k = 0; k < nodes; ++k) {
      const auto& [place, node] = by_place[(begin + k) % nodes];
      const double ahead = forward(a, place, length);
      if (span <= 0.0 || ahead > span) {
        offer(node, ahead, next.cycle.arc[i]);
        break;
      }
      offer(node, 0.0, next.cycle.arc[i] + step * ahead / span);
    }
  }
  return images;
}

std::vector<double> sample_next_row(const ActiveCycle& active, const NextCycle& next,
                                    const std::vector<double>& images, double stitch_width,
                                    int fewest) {
  constexpr double turn = 6.28318530717958647692;
  std::vector<char> single;
  for (const ActiveNode& node : active.nodes) single.push_back(node.single);
  const auto [least, most] = linkable_counts(single);
  const double length = next.cycle.length();
  const int count = std::clamp(static_cast<int>(std::lround(length / stitch_width)),
                               std::min(std::max(fewest, least), most), most);
  const double spacing = length / count;
  double x = 0.0, y = 0.0;
  for (const double image : images) {
    x += std::cos(turn * image / spacing);
    y += std::sin(turn * image / spacing);
  }
  const double phase = std::atan2(y, x) / turn * spacing;
  std::vector<double> places(count);
  for (int j = 0; j < count; ++j) places[j] = forward(0.0, phase + j * spacing, length);
  return places;
}

}  // namespace meshknit
