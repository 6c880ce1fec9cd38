#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include "convert.h"
#include "meshknit/suggest/suggest.h"

namespace meshknit {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;
using Ints = py::array_t<int, py::array::c_style | py::array::forcecast>;

py::dict to_python(const FieldCost& cost) {
  py::dict result;
  result["total"] = cost.total();
  result["stitches"] = cost.stitches;
  result["shaping"] = cost.shaping;
  result["short_rows"] = cost.short_rows;
  result["flat"] = cost.flat;
  result["splits"] = cost.splits;
  result["merges"] = cost.merges;
  result["starts"] = cost.starts;
  result["ends"] = cost.ends;
  result["tangled"] = cost.tangled;
  result["needles"] = cost.needles;
  result["can_hang"] = cost.can_hang;
  result["fits"] = cost.fits;
  return result;
}

py::dict to_python(const Suggestion& suggestion) {
  py::dict result;
  put_marks(suggestion.openings, suggestion.times, result);
  result["summary"] = suggestion.summary;
  result["cost"] = to_python(suggestion.cost);
  return result;
}

}  // namespace

void bind_suggest(py::module_& m) {
  m.def(
      "suggest_marks",
      [](const Doubles& vertices, const Ints& faces, double stitch_width, double stitch_height,
         int needles, int count, RunContext* context) {
        const VertexArray v = to_vertices(vertices, "vertices");
        const FaceArray f = to_faces(faces, "faces");
        std::vector<Suggestion> found;
        {
          py::gil_scoped_release release;
          found = suggest_marks(v, f, {stitch_width, stitch_height, needles}, count, context);
        }
        py::list result;
        for (const Suggestion& suggestion : found) result.append(to_python(suggestion));
        return result;
      },
      py::arg("vertices"), py::arg("faces"), py::arg("stitch_width") = CostGauge().stitch_width,
      py::arg("stitch_height") = CostGauge().stitch_height,
      py::arg("needles") = CostGauge().needles, py::arg("count") = 3,
      py::arg("context") = nullptr,
      "Set-ups for a mesh (mm), best first: openings [{at, radius}], times [{time, opening | "
      "boundary_near}], a summary for people, and the cost. Throws NotKnittable, InvalidInput, "
      "Cancelled.");
  m.def(
      "judge_field",
      [](const Surface& surface, const Doubles& time, double stitch_width, double stitch_height,
         int needles, RunContext* context) {
        const std::vector<double> field = from_input_order(surface, time);
        FieldCost cost;
        {
          py::gil_scoped_release release;
          cost = cost_of_field(surface, field, {stitch_width, stitch_height, needles}, context);
        }
        py::dict result = to_python(cost);
        py::list saddles;
        for (const SaddlePlace& place : cost.saddles) {
          py::dict entry;
          entry["at"] = place.at;
          entry["time"] = place.time;
          entry["below"] = place.below;
          entry["above"] = place.above;
          saddles.append(entry);
        }
        result["saddles"] = saddles;
        result["slowness"] = to_array(cost.slowness);
        result["slowness_faces"] = to_array(surface.source_face);
        return result;
      },
      py::arg("surface"), py::arg("time"), py::arg("stitch_width") = CostGauge().stitch_width,
      py::arg("stitch_height") = CostGauge().stitch_height,
      py::arg("needles") = CostGauge().needles, py::arg("context") = nullptr,
      "What a field (one time a row of the surface) makes of its surface before any row is "
      "knit: "
      "the numbers of a suggestion's cost, its saddles [{at (mm), time, below, above}], and "
      "how "
      "much slower time steps in each face than in its row; `slowness_faces` are the rows of "
      "the "
      "input's faces.");
}

}  // namespace meshknit
