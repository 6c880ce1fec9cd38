#pragma once

#include <string>
#include <vector>

#include "meshknit/core/run_context.h"
#include "meshknit/suggest/field_cost.h"
#include "meshknit/surface/example_shapes.h"
#include "meshknit/surface/openings.h"
#include "meshknit/surface/triangle_mesh.h"

namespace meshknit {

/// A set-up for a mesh: what a marks file would say, and what it is expected to cost.
struct Suggestion {
  std::vector<OpeningMark> openings;
  std::vector<TimeMark> times;  ///< of all boundaries and openings
  FieldCost cost;
  std::string summary;  ///< a line for people: how it is knit and what it costs
};

/// Where to open a mesh and when to knit its rims (what the paper leaves open in its closing
/// discussion): at most `count` set-ups, best first.
///
/// Openings are tried at the mesh's most prominent tips (tips.h), just wide enough to be cast on; which
/// rims come first follows the axes, the two lowest eigenfunctions, and the distance from the
/// furthest tip; times follow from the flow between rims (rim_times.h). Each harmonic field that passes
/// check_time_field is judged by cost_of_field. No clock, no chance: the same mesh gives the same.
/// Throws: NotKnittable with make_surface's problems if the mesh is at fault; "nothing-to-suggest" if
/// no set-up works at this size and gauge; InvalidInput; Cancelled.
/// Ensures: cut_openings and solve_time_field accept every suggestion.
std::vector<Suggestion> suggest_marks(const VertexArray& vertices, const FaceArray& faces,
                                      const CostGauge& gauge = {}, int count = 3,
                                      RunContext* run = nullptr);

}  // namespace meshknit
