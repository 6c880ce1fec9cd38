#pragma once

#include <vector>

#include "meshknit/surface/opening_problems.h"
#include "meshknit/surface/refine_near.h"

namespace meshknit {

/// A surface on the way to being cut: its mesh, split where rims run, with the faces of each
/// opening labelled. The surface is whole until the end, so distances know nothing of openings.
struct OpeningRegions {
  explicit OpeningRegions(const Surface& surface);

  /// Labels the faces within a mark, or says in `problems` why it cannot be an opening.
  /// `shortest` mm is the shortest rim; here only hopelessly small ones are refused.
  void cut_mark(const OpeningMark& mark, double shortest);
  /// Labels each island of marked faces. `face_marks` has a number per row of the input's faces.
  void leave_out(const std::vector<int>& face_marks);
  /// Whether openings touch each other or themselves, once all are labelled.
  void check_touching();

  /// Of an opening: what it is, what it is called, and for a mark the length of the line at
  /// nine tenths of its radius.
  struct Region {
    Opening opening;
    OpeningName name;
    double radius = 0.0;
    double length_before = 0.0;
  };

  const Surface& surface;
  TriangleMesh mesh;  ///< its first vertices are those of the surface
  std::vector<FaceOrigin> origin;
  std::vector<Region> regions;
  Problems problems;

 private:
  void label_disc(const std::vector<int>& faces);
};

}  // namespace meshknit
