#include "call.hpp"
#include "part.hpp"

#include <planish/job/info.hpp>
#include <planish/job/reason.hpp>
#include <planish/job/schemas.hpp>

#include <nlohmann/json.hpp>
#include <pybind11/stl.h>

#include <set>
#include <string_view>

// The part of the package `planish` that is in C++. What Python sees of it is in the package's
// Python files, which give it names, types and descriptions.

namespace planish::python {
namespace {

namespace py = pybind11;
using Json = nlohmann::ordered_json;

template <typename T>
T value_of(Result<T> result) {
  if (!result) raise(result.error());
  return std::move(*result);
}

/// Runs `work` without the GIL.
template <typename Work>
auto apart(Work work) {
  auto result = [&] {
    const py::gil_scoped_release released;
    return work();
  }();
  return value_of(std::move(result));
}

Json option_json(const job::Option& option, std::string_view otherwise) {
  constexpr const char* kKinds[] = {"flag", "number", "whole", "word",
                                    "face", "name",   "file",  "by_bend"};
  return {{"name", option.name},
          {"kind", kKinds[static_cast<int>(option.kind)]},
          {"group", job::heading(option.group)},
          {"description", option.description},
          {"otherwise", otherwise},
          {"words", option.words}};
}

/// Makers and their options, of which the package's functions are made; all options; and by task
/// the names of its own, whatever the input.
std::string catalogue() {
  Json json;
  for (const job::Option& option : job::options())
    json["options"].push_back(option_json(option, option.otherwise));
  for (const job::Maker& maker : job::makers()) {
    Json options = Json::array();
    for (const job::Option& option : job::options()) {
      if (!maker.takes(option.name)) continue;
      std::string_view otherwise = option.otherwise;
      for (const job::OptionUse& use : maker.options)
        if (use.name == option.name && !use.otherwise.empty()) otherwise = use.otherwise;
      options.push_back(option_json(option, otherwise));
    }
    json["makers"].push_back({{"name", maker.name},
                              {"description", maker.description},
                              {"input", maker.input_kind()},
                              {"options", std::move(options)}});
  }
  for (const job::Task& task : job::tasks()) {
    std::set<std::string_view> names;
    if (task.reader == job::Reader::by_format)
      for (const job::Maker& maker : job::makers())
        for (const job::OptionUse& use : task.taking(&maker).options)
          names.insert(use.name);
    if (!task.name.empty()) json["tasks"][std::string(task.name)] = names;
  }
  return json.dump();
}

/// `content`: the bytes of the input, or None if they are in the request or in a file.
std::shared_ptr<Part> make(const std::string& request, const std::optional<py::bytes>& content,
                           py::object listener) {
  Call call(std::move(listener));
  const auto bytes = content ? std::optional(std::string(*content)) : std::nullopt;
  return std::make_shared<Part>(call.run(
      [&](const Progress& progress) { return job::shown(job::make(request, progress, bytes)); }));
}

std::string info(const std::string& file, const std::string& body, bool sheets,
                 py::object listener) {
  Call call(std::move(listener));
  const job::InfoRequest request{.input = file, .body = body, .recognize = sheets};
  return job::info_json(
      call.run([&](const Progress& progress) { return job::info(request, progress); }));
}

py::list views_of(const std::vector<Rows>& all, const py::object& owner) {
  py::list views;
  for (const Rows& rows : all)
    views.append(view_of(rows, owner));
  return views;
}

/// The arrays of a piece, which keep the part alive.
py::dict flat_arrays(const py::object& self, int piece, double chord) {
  auto& part = self.cast<Part&>();
  const FlatRows* rows = nullptr;
  {
    const py::gil_scoped_release released;
    rows = &part.flat(piece, chord);
  }
  py::dict arrays;
  arrays["outline"] = view_of(rows->outline, self);
  arrays["openings"] = views_of(rows->openings, self);
  arrays["slits"] = views_of(rows->slits, self);
  arrays["features"] = views_of(rows->features, self);
  arrays["feature_of"] = rows->feature_of;
  arrays["bends"] = views_of(rows->bends, self);
  return arrays;
}

template <typename T, typename Row>
py::array mesh_view(const std::vector<Row>& rows, const py::object& owner) {
  static_assert(sizeof(Row) == 3 * sizeof(T));
  py::array_t<T> view({static_cast<py::ssize_t>(rows.size()), py::ssize_t{3}},
                      rows.empty() ? nullptr : reinterpret_cast<const T*>(rows.data()), owner);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

py::list files_of(std::vector<job::WrittenArtifact> files) {
  py::list list;
  for (const job::WrittenArtifact& file : files)
    list.append(py::make_tuple(file.name, py::bytes(file.bytes)));
  return list;
}

py::object refusal_of(const Part& part) {
  const auto refusal = part.refusal();
  if (!refusal) return py::none();
  return py::make_tuple(std::string(code_name(refusal->code)), refusal->message, refusal->where,
                        exit_status(refusal->code), job::reason_text(*refusal));
}

}  // namespace

PYBIND11_MODULE(_planish, module) {
  // pybind11 looks NumPy up once, under a lock that it keeps while Python lets other threads run:
  // two threads that come first would wait for each other for ever.
  (void)py::dtype::of<double>();
  (void)py::dtype::of<int>();
  module.attr("version") = PLANISH_VERSION;
  module.def("catalogue", catalogue);
  module.def("schema_names", [] { return job::schema_names(); });
  module.def("schema", [](const std::string& name) { return job::schema_text(name); });
  module.def("make", make, py::arg("request"), py::arg("content"), py::arg("listener"));
  module.def("info", info, py::arg("file"), py::arg("body"), py::arg("sheets"),
             py::arg("listener"));

  py::class_<Part, std::shared_ptr<Part>>(module, "Part")
      .def_property_readonly("maker", &Part::maker)
      .def_property_readonly("status", &Part::status)
      .def_property_readonly("pieces", &Part::pieces)
      .def_property_readonly("refusal", refusal_of)
      .def("report", &Part::report)
      .def("has_pattern", &Part::has_pattern)
      .def("flat", flat_arrays, py::arg("piece"), py::arg("chord"))
      .def("exact", &Part::exact, py::arg("piece"))
      .def("mesh", [](Part& part) { return PartMesh(apart([&] { return part.mesh(); })); })
      .def(
          "write",
          [](Part& part, const std::string& artifact, const std::string& options) {
            return files_of(apart([&] { return part.write(artifact, options); }));
          },
          py::arg("artifact"), py::arg("options"))
      .def(
          "bend_pages",
          [](Part& part, bool svg) {
            return py::bytes(apart([&] { return part.bend_pages(svg); }));
          },
          py::arg("svg"))
      .def("flats_as_made",
           [](Part& part) {
             return mapped(apart([&] { return part.flats_as_made(); }),
                           [](const std::string& dxf) { return py::bytes(dxf); });
           })
      .def("artifacts", [](const Part& part) { return part.artifacts(job::built_in()); });

  py::class_<PartMesh>(module, "Mesh")
      .def_property_readonly("points",
                             [](const py::object& self) {
                               const auto& mesh = self.cast<const PartMesh&>().mesh();
                               return mesh_view<double>(mesh.points, self);
                             })
      .def_property_readonly("triangles", [](const py::object& self) {
        const auto& mesh = self.cast<const PartMesh&>().mesh();
        return mesh_view<int>(mesh.triangles, self);
      });
}

}  // namespace planish::python
