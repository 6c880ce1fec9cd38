#include <pybind11/stl.h>

#include "convert.h"
#include "meshknit/pipeline/pipeline.h"

namespace meshknit {
namespace {

using Doubles = py::array_t<double, py::array::c_style | py::array::forcecast>;

py::dict to_python(const LengthError& error) {
  py::dict result;
  result["mean"] = error.mean;
  result["p95"] = error.p95;
  result["within_10"] = error.within_10;
  result["within_20"] = error.within_20;
  py::list bounds;
  for (int k = 0; k + 1 < histogram_bins; ++k) bounds.append(histogram_bound(k));
  py::dict histogram;
  histogram["bounds"] = bounds;
  histogram["counts"] = error.histogram;
  result["histogram"] = histogram;
  return result;
}

py::dict graph_report(const CheckedGraph& g) {
  py::dict report, properties;
  report["nodes"] = g.stats.nodes;
  report["rows"] = g.stats.rows;
  report["short_rows"] = g.stats.short_rows;
  report["splits"] = g.stats.splits;
  report["merges"] = g.stats.merges;
  report["increases"] = g.stats.increases;
  report["decreases"] = g.stats.decreases;
  report["short_row_ends"] = g.stats.short_row_ends;
  report["irregular"] = g.stats.irregular;
  report["row_error"] = to_python(g.stats.row_error);
  report["column_error"] = to_python(g.stats.column_error);
  for (std::size_t k = 0; k < g.check.violations.size(); ++k)
    properties[py::str(std::to_string(k + 1))] = g.check.violations[k];
  report["properties"] = properties;
  return report;
}

py::array_t<double> node_table(const KnitGraph& g) {
  std::vector<double> values;
  for (const KnitNode& n : g.nodes) {
    values.insert(values.end(), n.position.data(), n.position.data() + 3);
    values.push_back(n.time);
  }
  return to_table(values, 4);
}

py::list rows_to_python(const KnitGraph& g) {
  py::list rows;
  for (const KnitRow& row : g.rows) {
    py::dict entry;
    entry["nodes"] = row.nodes;
    entry["closed"] = row.closed;
    rows.append(entry);
  }
  return rows;
}

py::array_t<int> column_table(const KnitGraph& g) {
  std::vector<int> values;
  for (const auto& c : g.columns) values.insert(values.end(), c.begin(), c.end());
  return to_table(values, 2);
}

// Row edges as node pairs, and whether each belongs to a short row: ready for drawing.
py::tuple row_edges(const KnitGraph& g) {
  std::vector<int> pairs;
  std::vector<char> of_short_row;
  for (const KnitRow& row : g.rows) {
    const std::size_t n = row.nodes.size();
    for (std::size_t i = 0; i + 1 < n + row.closed; ++i) {
      pairs.push_back(row.nodes[i]);
      pairs.push_back(row.nodes[(i + 1) % n]);
      of_short_row.push_back(!row.closed);
    }
  }
  return py::make_tuple(to_table(pairs, 2), to_array(of_short_row).attr("astype")("bool"));
}

// The report's `seams` entry.
py::list seams_to_python(const CheckedGraph& g) {
  py::list seams;
  for (const Seam& seam : g.seams) {
    const auto& rows = g.graph.rows;
    py::dict entry;
    entry["rows"] = std::vector<int>{seam.row_below, seam.row_above};
    entry["stitches"] = std::vector<std::size_t>{rows[seam.row_below].nodes.size(),
                                                 rows[seam.row_above].nodes.size()};
    entry["at"] = std::vector<double>(seam.middle.data(), seam.middle.data() + 3);
    entry["columns"] = seam.columns;
    seams.append(entry);
  }
  return seams;
}

py::list stitches_to_python(const StitchTrace& trace) {
  py::list result;
  for (const Stitch& s : trace.stitches) {
    py::dict entry;
    entry["yarn"] = s.yarn;
    entry["kind"] = name_of(s.kind);
    entry["direction"] = s.direction == Direction::clockwise ? "clockwise" : "anticlockwise";
    entry["node"] = s.node;
    entry["parents"] = s.parents;
    entry["children"] = s.children;
    result.append(entry);
  }
  return result;
}

int count_tucks(const StitchTrace& trace) {
  int tucks = 0;
  for (const Stitch& s : trace.stitches) tucks += s.kind == StitchKind::tuck;
  return tucks;
}

}  // namespace

void bind_graph(py::module_& m) {
  py::class_<CheckedGraph>(m, "KnitGraph", py::module_local(),
                           "A knit graph that has passed the checks of Properties 1-6.")
      .def_property_readonly("stitch_width",
                             [](const CheckedGraph& g) { return g.graph.stitch_width; })
      .def_property_readonly("stitch_height",
                             [](const CheckedGraph& g) { return g.graph.stitch_height; })
      .def_property_readonly(
          "nodes", [](const CheckedGraph& g) { return node_table(g.graph); },
          "(n, 4): x, y, z in mm and time.")
      .def_property_readonly("rows",
                             [](const CheckedGraph& g) { return rows_to_python(g.graph); })
      .def_property_readonly("columns",
                             [](const CheckedGraph& g) { return column_table(g.graph); })
      .def_property_readonly("row_lengths",
                             [](const CheckedGraph& g) { return g.graph.row_lengths; })
      .def_property_readonly(
          "column_lengths",
          [](const CheckedGraph& g) { return to_array(g.graph.column_lengths); })
      .def_property_readonly(
          "row_edges", [](const CheckedGraph& g) { return row_edges(g.graph); },
          "(node pairs, whether each lies on a short row).")
      .def_property_readonly("problems",
                             [](const CheckedGraph& g) { return to_python(g.check.problems); })
      .def_property_readonly("report", &graph_report, "The report's `graph` entry.")
      .def_property_readonly("seams", &seams_to_python, "The report's `seams` entry.");

  py::class_<FirstRows>(
      m, "FirstRows", py::module_local(),
      "The rows that are knit so far, for one who looks on while a graph is made "
      "in another thread.")
      .def(py::init<>())
      .def(
          "take",
          [](FirstRows& first_rows) -> std::unique_ptr<CheckedGraph> {
            std::optional<KnitGraph> rows = first_rows.take();
            if (!rows) return nullptr;
            auto graph = std::make_unique<CheckedGraph>();
            graph->graph = std::move(*rows);
            return graph;
          },
          "A graph of the rows since the last call, without lengths or report, or None; asks "
          "for the "
          "next.");

  m.def(
      "build_knit_graph",
      [](const Surface& surface, const Doubles& time, double stitch_width, double stitch_height,
         bool relax, RunContext* run, FirstRows* first_rows) {
        const std::vector<double> field = from_input_order(surface, time);
        py::gil_scoped_release release;
        return std::make_unique<CheckedGraph>(build_knit_graph(
            surface, field, {stitch_width, stitch_height, relax}, run, first_rows));
      },
      py::arg("surface"), py::arg("time"),
      py::arg("stitch_width") = RemeshOptions().stitch_width,
      py::arg("stitch_height") = RemeshOptions().stitch_height,
      py::arg("relax") = RemeshOptions().relax, py::arg("run") = nullptr,
      py::arg("first_rows") = nullptr);

  m.def(
      "cut_seams",
      [](const CheckedGraph& graph) {
        py::gil_scoped_release release;
        return std::make_unique<CheckedGraph>(cut_seams(graph));
      },
      py::arg("graph"), "The graph cut along the seams that it needs to be knittable, if any.");

  py::class_<StitchTrace>(m, "StitchTrace", py::module_local(),
                          "Traced stitches in construction order.")
      .def("__len__", [](const StitchTrace& t) { return t.stitches.size(); })
      .def_property_readonly("stitches", &stitches_to_python, "As in the stitches file.")
      .def_property_readonly("nodes",
                             [](const StitchTrace& t) {
                               std::vector<int> nodes;
                               for (const Stitch& s : t.stitches) nodes.push_back(s.node);
                               return to_array(nodes);
                             })
      .def_property_readonly(
          "report",
          [](const StitchTrace& t) {
            py::dict report;
            report["stitches"] = t.stitches.size();
            report["yarns"] = t.yarns;
            report["tucks"] = count_tucks(t);
            report["courses"] = t.courses;
            return report;
          },
          "The report's `trace` entry.");
  m.def(
      "trace",
      [](const CheckedGraph& graph, const MachineProfile& profile, RunContext* run) {
        py::gil_scoped_release release;
        return std::make_unique<StitchTrace>(build_trace(graph.graph, profile, run));
      },
      py::arg("graph"), py::arg("profile"), py::arg("run") = nullptr);
}

}  // namespace meshknit
