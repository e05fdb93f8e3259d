#include "call.hpp"

#include <planish/job/reason.hpp>

namespace planish::python {

namespace py = pybind11;

void raise(const Error& error) {
  const py::object made = py::module_::import("planish._errors")
                              .attr("error_of")(std::string(code_name(error.code)), error.message,
                                                error.where, exit_status(error.code),
                                                job::reason_text(error));
  PyErr_SetObject(reinterpret_cast<PyObject*>(Py_TYPE(made.ptr())), made.ptr());
  throw py::error_already_set();
}

Call::Call(py::object listener) : listener_(std::move(listener)), asked_(Clock::now()) {}

Progress Call::progress() {
  Progress progress;
  progress.cancelled = [this] { return should_stop(); };
  if (!listener_.is_none())
    progress.report = [this](std::string_view stage, double share) { tell(stage, share); };
  return progress;
}

template <typename Called>
void Call::into_python(Called call) {
  const py::gil_scoped_acquire held;
  try {
    call();
  } catch (py::error_already_set& raised) {
    if (!raised_) raised_.emplace(std::move(raised));
    stopped_ = true;
  }
}

void Call::tell(std::string_view stage, double share) {
  const std::unique_lock calling(calling_, std::try_to_lock);
  const auto now = Clock::now();
  if (!calling || stopped_ || (stage == stage_ && now - told_ < kBetween)) return;
  stage_ = stage;
  told_ = now;
  into_python([&] {
    const py::object go_on = listener_(std::string(stage), share);
    if (go_on.is(py::bool_(false))) stopped_ = true;
  });
}

bool Call::should_stop() {
  if (stopped_) return true;
  const std::unique_lock calling(calling_, std::try_to_lock);
  const auto now = Clock::now();
  if (!calling || now - asked_ < kBetween) return stopped_;
  asked_ = now;
  into_python([] {
    if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  });
  return stopped_;
}

void Call::finish() {
  if (!raised_) return;
  py::error_already_set raised = std::move(*raised_);
  raised_.reset();
  throw raised;
}

}  // namespace planish::python
