#pragma once

#include <string>

#include "meshknit/core/problem.h"
#include "meshknit/surface/openings.h"

namespace meshknit {

/// An opening as people know it: what to call it in a sentence (without an article), and where
/// it is on the input.
struct OpeningName {
  std::string text;
  ProblemElements elements;
  bool by_faces = false;  ///< marked faces, not a place with a radius
};

OpeningName name_of(const OpeningMark& mark);
/// Requires: `faces` are rows of the input, at least one; `at` lies on one of them.
OpeningName name_of_faces(const std::vector<int>& faces, const Eigen::Vector3d& at);

// What cut_openings says to people: one function a code.

Problem opening_radius(const OpeningName& name);
Problem opening_off_surface(const OpeningName& name, double distance);
/// `radius` is one that would do, 0 for marked faces.
Problem opening_too_small(const OpeningName& name, double rim, double shortest, double radius);
Problem opening_too_large(const OpeningName& name, double rim, double shortest);
Problem opening_swallows_part(const OpeningName& name);
Problem opening_over_boundary(const OpeningName& name);
Problem opening_not_a_disc(const OpeningName& name, int rims);
Problem openings_overlap(const OpeningName& one, const OpeningName& other);
Problem openings_touch(const OpeningName& one, const OpeningName& other);
Problem part_left_out(const OpeningName& name);

}  // namespace meshknit
