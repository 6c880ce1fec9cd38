#include "meshknit/surface/opening_problems.h"

#include <cmath>

#include "meshknit/surface/wording.h"

namespace meshknit {
namespace {

Problem error(const std::string& code, const std::string& message, const std::string& remedy,
              const OpeningName& name) {
  return {code, Severity::error, message, remedy, name.elements};
}

void add_elements(const ProblemElements& more, ProblemElements& elements) {
  elements.vertices.insert(elements.vertices.end(), more.vertices.begin(), more.vertices.end());
  elements.faces.insert(elements.faces.end(), more.faces.begin(), more.faces.end());
}

double tenth_up(double length) { return std::ceil(10.0 * length) / 10.0; }

}  // namespace

OpeningName name_of(const OpeningMark& mark) {
  OpeningName name;
  name.text = "opening at " + place_text(mark.at) + " with radius " + millimetres(mark.radius);
  return name;
}

OpeningName name_of_faces(const std::vector<int>& faces, const Eigen::Vector3d& at) {
  OpeningName name;
  name.text = "opening of " + counted(faces.size(), "marked face", "marked faces") + " near " +
              place_text(at);
  name.elements.faces = faces;
  name.by_faces = true;
  return name;
}

Problem opening_radius(const OpeningName& name) {
  return error("opening-radius", "The " + name.text + " has no size that can be cut.",
               "Give it a place and a radius in millimetres, above 0.", name);
}

Problem opening_off_surface(const OpeningName& name, double distance) {
  return error(
      "opening-off-surface",
      "The " + name.text + " is " + millimetres(distance) + " away from the surface.",
      "Put it on the surface; check the units of the place and the scale of the object.", name);
}

Problem opening_too_small(const OpeningName& name, double rim, double shortest, double radius) {
  return error("opening-too-small",
               "The " + name.text + " is " + millimetres(rim) +
                   " round; the shortest row that can be knit is " + millimetres(shortest) +
                   ".",
               name.by_faces
                   ? "Mark more faces round it, make the stitches smaller or the object larger."
                   : "Make its radius at least " + millimetres(tenth_up(radius)) +
                         ", or make the stitches smaller or the object larger.",
               name);
}

Problem opening_too_large(const OpeningName& name, double rim, double shortest) {
  return error("opening-too-large",
               "The " + name.text + " reaches so far round the object that its rim is only " +
                   millimetres(rim) + " long; the shortest row that can be knit is " +
                   millimetres(shortest) + ".",
               "Make its radius smaller.", name);
}

Problem opening_swallows_part(const OpeningName& name) {
  return error(
      "opening-swallows-part", "The " + name.text + " takes away a whole piece of the object.",
      name.by_faces ? "Leave some faces unmarked: those are knit." : "Make its radius smaller.",
      name);
}

Problem opening_over_boundary(const OpeningName& name) {
  return error(
      "opening-over-boundary", "The " + name.text + " reaches over the edge of the surface.",
      "Make its radius smaller or move it away from the edge. Where the surface is open "
      "already, give that boundary a time instead.",
      name);
}

Problem opening_not_a_disc(const OpeningName& name, int rims) {
  const std::string what =
      rims > 1 ? "The " + name.text + " would have " + std::to_string(rims) +
                     " rims: it wraps round the object or round a bump."
               : "The " + name.text +
                     " meets itself or the edge of the surface, as round a limb or a handle.";
  return error("opening-not-a-disc", what,
               name.by_faces ? "Mark a patch that is filled and has one rim."
                             : "Make its radius smaller, or put it nearer to the tip.",
               name);
}

Problem openings_overlap(const OpeningName& one, const OpeningName& other) {
  Problem problem =
      error("openings-overlap", "The " + one.text + " and the " + other.text + " overlap.",
            "Make them smaller, move them apart, or make one of the two.", one);
  add_elements(other.elements, problem.elements);
  return problem;
}

Problem openings_touch(const OpeningName& one, const OpeningName& other) {
  Problem problem =
      error("openings-touch", "The " + one.text + " and the " + other.text + " touch.",
            one.by_faces && other.by_faces
                ? "Leave faces between them unmarked, or mark the faces between them, with the "
                  "same number, so that they become one."
                : "Make them smaller, or move them apart.",
            one);
  add_elements(other.elements, problem.elements);
  return problem;
}

Problem part_left_out(const OpeningName& name) {
  Problem problem = {
      "part-left-out", Severity::note,
      "The " + name.text + " is a whole piece of the object and was left out.",
      "Nothing needs to be done if this piece is not to be knit; unmark its faces "
      "if it is.",
      name.elements};
  return problem;
}

}  // namespace meshknit
