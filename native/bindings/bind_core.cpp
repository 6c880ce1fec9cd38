#include "convert.h"
#include "meshknit/core/run_context.h"

namespace meshknit {

void bind_core(py::module_& m) {
  py::class_<RunContext>(
      m, "RunContext", py::module_local(),
      "Progress and cancellation of one run. Any thread may read and cancel.")
      .def(py::init<>())
      .def("cancel", &RunContext::cancel)
      .def("begin_stage", &RunContext::begin_stage, py::arg("begin"), py::arg("end"),
           "Gives the next stage this share of the bar.")
      .def_property_readonly("cancelled", &RunContext::cancelled)
      .def_property_readonly("progress", &RunContext::progress);

  // Attributes of the module keep the types alive; NotKnittable carries its problems.
  static py::exception<InvalidInput> invalid(m, "InvalidInput", PyExc_ValueError);
  static py::exception<NotKnittable> not_knittable(m, "NotKnittable", PyExc_RuntimeError);
  static py::exception<BrokenPromise> broken(m, "BrokenPromise", PyExc_RuntimeError);
  static py::exception<Cancelled> cancelled(m, "Cancelled", PyExc_RuntimeError);
  py::register_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(thrown);
    } catch (const NotKnittable& error) {
      py::object instance =
          py::reinterpret_borrow<py::object>(not_knittable.ptr())(error.what());
      instance.attr("problems") = to_python(error.problems());
      PyErr_SetObject(not_knittable.ptr(), instance.ptr());
    } catch (const InvalidInput& error) {
      invalid(error.what());
    } catch (const BrokenPromise& error) {
      broken(error.what());
    } catch (const Cancelled& error) {
      cancelled(error.what());
    }
  });
}

}  // namespace meshknit
