#include "part.hpp"

#include "refusals.hpp"

#include <planish/io/flat_json.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/bend_plan_pages.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace planish::python {
namespace {

namespace py = pybind11;

/// The points of curves, one after the other, each shared point once.
Rows polyline(const std::vector<Vec2>& points, double scale, bool closed) {
  Rows rows;
  rows.numbers.reserve(2 * points.size() + 2);
  for (const Vec2& p : points)
    rows.numbers.insert(rows.numbers.end(), {scale * p.x(), scale * p.y()});
  if (closed && !points.empty())
    rows.numbers.insert(rows.numbers.end(),
                        {scale * points.front().x(), scale * points.front().y()});
  return rows;
}

FlatRows rows_of(const FlatPattern& flat, double scale, double chord) {
  FlatRows rows;
  const auto closed = [&](const Loop& loop) { return polyline(sampled(loop, chord), scale, true); };
  rows.outline = closed(flat.outer.loop);
  for (const Contour& opening : flat.openings)
    rows.openings.push_back(closed(opening.loop));
  for (const Curve2& slit : flat.slits)
    rows.slits.push_back(polyline(sampled(slit, chord), scale, false));
  for (std::size_t i = 0; i < flat.features.size(); ++i)
    for (const Loop& outline : flat.features[i].outlines) {
      rows.features.push_back(closed(outline));
      rows.feature_of.push_back(static_cast<int>(i));
    }
  for (const FlatBend& bend : flat.bends) {
    Rows& lines = rows.bends.emplace_back();
    lines.columns = 4;
    for (const Segment& line : bend.lines)
      lines.numbers.insert(lines.numbers.end(), {scale * line.a.x(), scale * line.a.y(),
                                                 scale * line.b.x(), scale * line.b.y()});
  }
  return rows;
}

}  // namespace

py::array view_of(const Rows& rows, const py::object& owner) {
  const auto count = static_cast<py::ssize_t>(rows.numbers.size()) / rows.columns;
  py::array_t<double> view({count, rows.columns}, rows.numbers.data(), owner);
  view.attr("setflags")(py::arg("write") = false);
  return view;
}

std::string Part::status() const {
  return std::string(job::status_name(made_.made->report().status()));
}

std::optional<Error> Part::refusal() const { return refusal_of(made_); }

std::string Part::report() const { return made_.made->json(); }

bool Part::has_pattern(int piece) const {
  return !made_.made->piece(piece).flat.outer.loop.empty();
}

const FlatRows& Part::flat(int piece, double chord) {
  const std::lock_guard working(working_);
  auto& rows = flat_[{piece, chord}];
  const job::Report& report = made_.made->piece(piece);
  if (!rows)
    rows = std::make_unique<FlatRows>(
        rows_of(report.flat, 1.0 / millimetres_in(report.units), chord));
  return *rows;
}

std::string Part::exact(int piece) const { return flat_json(made_.made->piece(piece).flat); }

Result<Mesh> Part::mesh() {
  const std::lock_guard working(working_);
  return made_.made->folded_mesh();
}

Result<std::vector<job::WrittenArtifact>> Part::write(const std::string& name,
                                                      const std::string& options) {
  const std::lock_guard working(working_);
  const job::Artifact* artifact = job::built_in().artifact(*made_.maker, name);
  if (!artifact)
    return fail(refuse::not_written_by,
                {{"maker", made_.maker->name},
                 {"format", name},
                 {"known", fmt::format("{}", fmt::join(artifacts(job::built_in()), ", "))}},
                "format");
  job::Request request = made_.request;
  const auto values = job::read_options(options, *made_.maker, job::OptionFiles::path_or_content,
                                        "");
  if (!values) return pass_on(values);
  if (auto entered = values->enter(request); !entered) return pass_on(entered);
  return job::write(*artifact, *made_.made, request, made_.made->report().body);
}

Result<std::string> Part::bend_pages(bool svg) {
  const std::lock_guard working(working_);
  const auto pages = job::bend_plan_pages(*made_.made, made_.request.bending);
  if (svg) return pages_svg(pages);
  return pages_pdf(pages, made_.made->report().body + ", bend plan");
}

Result<std::vector<std::string>> Part::flats_as_made() {
  const std::lock_guard working(working_);
  std::vector<std::string> drawings;
  for (int piece = 0; piece < pieces(); ++piece) {
    auto dxf = job::dxf_as_made(made_.made->piece(piece), made_.request);
    if (!dxf) return tl::unexpected(std::move(dxf.error()));
    drawings.push_back(std::move(*dxf));
  }
  return drawings;
}

std::vector<std::string> Part::artifacts(const job::Catalogue& catalogue) const {
  return mapped(catalogue.written_by(*made_.maker),
                [&](const job::Artifact* artifact) { return std::string(artifact->name); });
}

}  // namespace planish::python
