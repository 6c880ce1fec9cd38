#include <pybind11/stl.h>

#include "convert.h"
#include "meshknit/pipeline/pipeline.h"

namespace meshknit {
namespace {

py::dict schedule_report(const Schedule& s) {
  py::dict report, cost;
  cost["alignment"] = s.cost.alignment;
  cost["roll"] = s.cost.roll;
  cost["shift"] = s.cost.shift;
  report["segments"] = s.segments;
  report["connections"] = s.connections;
  report["cost"] = cost;
  report["optimal"] = s.optimal();
  report["optimal_order"] = s.optimal_order;
  report["optimal_moves"] = s.optimal_moves;
  return report;
}

py::dict program_report(const ProgramCost& c) {
  py::dict report;
  report["operations"] = c.operations;
  report["passes"] = c.passes;
  report["transfers"] = c.transfers;
  report["max_racking"] = c.max_racking;
  report["carriers"] = c.carriers;
  report["needles"] = std::vector<int>{c.lowest_needle, c.highest_needle};
  report["estimated_minutes"] = c.estimated_minutes;
  return report;
}

py::dict check_report(const VerifyReport& v) {
  py::dict report;
  report["ok"] = v.ok;
  report["loops"] = v.loops;
  report["edges"] = v.edges;
  report["errors"] = v.errors;
  report["warnings"] = v.warnings;
  return report;
}

}  // namespace

void bind_machine(py::module_& m) {
  py::class_<MachineProfile>(
      m, "MachineProfile", py::module_local(),
      "A machine's limits, as data. Lengths in needles, times in seconds.")
      .def(py::init<>())
      .def(py::init<const MachineProfile&>())
      .def_readwrite("name", &MachineProfile::name)
      .def_readwrite("machine_header", &MachineProfile::machine_header)
      .def_readwrite("gauge", &MachineProfile::gauge)
      .def_readwrite("needles", &MachineProfile::needles)
      .def_readwrite("carriers", &MachineProfile::carriers)
      .def_readwrite("waste_carrier", &MachineProfile::waste_carrier)
      .def_readwrite("draw_carrier", &MachineProfile::draw_carrier)
      .def_readwrite("yarn_carrier", &MachineProfile::yarn_carrier)
      .def_readwrite("has_inserting_hook", &MachineProfile::has_inserting_hook)
      .def_readwrite("has_sliders", &MachineProfile::has_sliders)
      .def_readwrite("first_stitch_leftward", &MachineProfile::first_stitch_leftward)
      .def_readwrite("max_racking", &MachineProfile::max_racking)
      .def_readwrite("liked_racking", &MachineProfile::liked_racking)
      .def_readwrite("quarter_pitch", &MachineProfile::quarter_pitch)
      .def_readwrite("max_stack", &MachineProfile::max_stack)
      .def_readwrite("max_stretch", &MachineProfile::max_stretch)
      .def_readwrite("max_float", &MachineProfile::max_float)
      .def_readwrite("waste_rounds", &MachineProfile::waste_rounds)
      .def_readwrite("take_down_rounds", &MachineProfile::take_down_rounds)
      .def_readwrite("take_down_width", &MachineProfile::take_down_width)
      .def_readwrite("tucks_beside_knits", &MachineProfile::tucks_beside_knits)
      .def_readwrite("transfers_in_halves", &MachineProfile::transfers_in_halves)
      .def_readwrite("takes_kcode", &MachineProfile::takes_kcode)
      .def_readwrite("first_settings", &MachineProfile::first_settings)
      .def_readwrite("seconds_per_turn", &MachineProfile::seconds_per_turn)
      .def_readwrite("needles_per_second", &MachineProfile::needles_per_second);
  m.def("machine_profile_names", &machine_profile_names);
  m.def("machine_profile", &machine_profile, py::arg("name"));

  py::class_<Schedule>(m, "Schedule", py::module_local(), "Needles for every stitch.")
      .def_property_readonly("report", &schedule_report, "The report's `schedule` entry.");
  m.def(
      "schedule",
      [](const StitchTrace& trace, const MachineProfile& profile, RunContext* run) {
        py::gil_scoped_release release;
        return std::make_unique<Schedule>(build_schedule(trace, profile, run));
      },
      py::arg("trace"), py::arg("profile"), py::arg("run") = nullptr);

  py::class_<CheckedKnitout>(
      m, "Knitout", py::module_local(),
      "A machine file that the simulated machine has knitted and found equal to the trace.")
      .def_readonly("text", &CheckedKnitout::text)
      .def_readonly("kcode", &CheckedKnitout::kcode,
                    "The same program as a .kc file; empty for machines that take none.")
      .def_readonly("sheet", &CheckedKnitout::sheet, "What to know at the machine, as text.")
      .def_property_readonly(
          "problems", [](const CheckedKnitout& k) { return to_python(k.check.problems); })
      .def_property_readonly(
          "check", [](const CheckedKnitout& k) { return check_report(k.check); },
          "The report's `check` entry.")
      .def_property_readonly(
          "program", [](const CheckedKnitout& k) { return program_report(k.cost); },
          "The report's `program` entry.");
  m.def(
      "knitout",
      [](const StitchTrace& trace, const Schedule& schedule, const MachineProfile& profile,
         RunContext* run, const CheckedGraph* graph) {
        py::gil_scoped_release release;
        return std::make_unique<CheckedKnitout>(
            build_knitout(trace, schedule, profile, run,
                          graph != nullptr ? graph->seams : std::vector<Seam>()));
      },
      py::arg("trace"), py::arg("schedule"), py::arg("profile"), py::arg("run") = nullptr,
      py::arg("graph") = nullptr, "With the traced graph, the sheet tells of its seams.");
  m.def(
      "check_knitout",
      [](const std::string& text, const MachineProfile& profile, const StitchTrace& trace) {
        VerifyReport report;
        {
          py::gil_scoped_release release;
          report = verify_knitout(text, profile, trace);
        }
        py::dict result = check_report(report);
        result["problems"] = to_python(report.problems);
        return result;
      },
      py::arg("text"), py::arg("profile"), py::arg("trace"),
      "The independent check of any machine file against a trace.");
}

}  // namespace meshknit
