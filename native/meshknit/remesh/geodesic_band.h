#pragma once

#include <Eigen/Core>
#include <limits>
#include <vector>

#include "meshknit/remesh/front.h"
#include "meshknit/remesh/knit_limits.h"

namespace meshknit {

/// Geodesic distance from active cycles over the open surface, out to a limit. Exact on the mesh up
/// to rounding: straight rays are unfolded over the triangles from every piece of the cycle and
/// from its corners, and again from vertices with more than a full turn round them (windows,
/// after Mitchell, Mount and Papadimitriou 1987). Work is proportional to the band.
class GeodesicBand {
 public:
  GeodesicBand(const PeelState& state, const KnitLimits& limits);

  /// Measures from `cycles` to every open vertex within `limit` mm, and a bit beyond: as far as
  /// may be knit, and to the neighbours of what may be.
  void measure(const std::vector<const Cycle*>& cycles, double limit);

  /// Open vertices that were reached, in the order of their numbers.
  const std::vector<int>& reached() const { return reached_; }
  /// Distance in mm; infinite if not reached by the last measure().
  double distance(int vertex) const { return distance_[vertex]; }
  /// Which of the cycles is nearest, and where on it (distance along it, mm) the nearest point is.
  int nearest_cycle(int vertex) const { return nearest_[vertex]; }
  double foot(int vertex) const { return foot_[vertex]; }
  /// The cycle that crosses this edge, -1 if none does, and where on it that is.
  int cycle_across(int edge) const { return cycle_of_edge_[edge]; }
  double place_across(int edge) const { return place_on_edge_[edge]; }

 private:
  // Rays from a point, or parallel ones from a straight piece of the cycle, in a triangle's
  // plane.
  struct Source {
    bool strip;
    Eigen::Vector2d point;  // the point, or any point of the piece
    Eigen::Vector2d ray;    // unit direction of a strip
    double before;          // distance travelled before the source
    double foot;            // place of `point` on the cycle
    int cycle;
  };
  // Rays that enter the triangle of a half edge, which lies on the x axis from 0, between two
  // places on it.
  struct Window {
    int halfedge;
    double begin, end;
    Source source;
  };
  // Two half planes that bound rays: left of the ray through `low`, right of the one through
  // `high`.
  struct Bounds {
    Eigen::Vector2d low, low_ray, high, high_ray;
  };
  struct Event {
    double distance;
    int what;  // a window, or -1 - vertex for a vertex that passes rays on
    bool operator>(const Event& o) const {
      return distance != o.distance ? distance > o.distance : what > o.what;
    }
  };

  void launch_piece(const Cycle& cycle, int number, int piece);
  void launch_corner(const Cycle& cycle, int number, int corner);
  void launch_vertex(int vertex);
  void propagate(const Window& window);
  void emit(int inner, const Eigen::Vector2d& from, const Eigen::Vector2d& to,
            const Bounds* bounds, const Source& source);
  void improve(int vertex, double distance, double foot, int cycle);
  void push(const Event& event);
  bool open_range(int halfedge, double& begin, double& end) const;
  const Eigen::Vector2d& apex(int halfedge) const { return apex_[halfedge]; }
  Eigen::Vector2d find_apex(int halfedge) const;

  const PeelState& state_;
  const KnitLimits& limits_;
  std::vector<double> distance_, foot_;
  std::vector<int> nearest_;
  std::vector<int> cycle_of_edge_;
  std::vector<double> place_on_edge_;
  std::vector<int> crossed_;           // edges of the cycles
  std::vector<Eigen::Vector2d> apex_;  // per half edge: the third corner, in its frame
  std::vector<char> bends_;            // vertices with more than a full turn round them
  std::vector<int> reached_;
  std::vector<Window> windows_;
  std::vector<std::vector<Event>> steps_;  // by distance, out to the limit
  int step_ = 0;                           // the one that is being passed on
  double limit_ = 0.0;
};

}  // namespace meshknit
