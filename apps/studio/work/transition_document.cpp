#include "document.hpp"
#include "made_files.hpp"
#include "profile_points.hpp"
#include "remembered.hpp"

#include <planish/io/mesh_writers.hpp>
#include <planish/job/transition.hpp>

#include <fmt/format.h>

namespace planish::studio {
namespace {

using job::TransitionReport;

Json handles_of(const TransitionSpec& spec, const Transition& transition) {
  Json json;
  for (const PlacedProfile* profile : {&spec.from, &spec.to})
    json["profiles"].push_back(
        {{"points", points_json(profile_points(*profile, transition.mesh))}});
  return json;
}

class TransitionDocument : public Document {
 public:
  explicit TransitionDocument(std::string name) : name_(std::move(name)) {}

  std::string_view kind() const override { return "transition"; }

  Result<Shape> shape(const Asked& asked, job::Effort effort, const Progress& progress) override {
    auto report = report_of(asked, effort, progress);
    if (!report) return tl::unexpected(report.error());
    const auto piece = piece_of(*report, asked);
    if (!piece) return tl::unexpected(piece.error());
    // Nobody reads them while he drags, and they are half of what would be sent.
    if (effort == job::Effort::draft) report->transition.true_lengths.clear();
    Shape shape;
    shape.report = report_json(*report);
    shape.handles = handles_of(report->spec, report->transition);
    add_sheet(shape, **piece, effort);
    return shape;
  }

  Result<MadeFile> file(const Asked& asked, const std::string& format,
                        const Progress& progress) override {
    const auto report = report_of(asked, job::Effort::full, progress);
    if (!report) return tl::unexpected(report.error());
    if (format == "json") return MadeFile{kJsonType, report_json(*report)};
    const auto piece = piece_of(*report, asked);
    if (!piece) return tl::unexpected(piece.error());
    if (auto common = common_file(**piece, asked, format)) return std::move(*common);
    if (auto whole = not_refused(*report); !whole) return tl::unexpected(whole.error());
    if (format == "stl")
      return MadeFile{kStlType, stl_binary(report->transition.mesh, report->body)};
    if (format == "step") return as_file(report->pieces[asked.piece].solid, kStepType);
    return tl::unexpected(no_such_format(format));
  }

 private:
  Result<TransitionReport> report_of(const Asked& asked, job::Effort effort,
                                     const Progress& progress) {
    const auto make = [&]() -> Result<TransitionReport> {
      if (auto given = has_spec(asked); !given) return tl::unexpected(given.error());
      const auto file = job::parse_transition(asked.spec, name_);
      if (!file) return tl::unexpected(file.error());
      if (asked.k && !std::holds_alternative<ConstantK>(*asked.k))
        return fail(ErrorCode::bad_option,
                    "transitions have no inside radius, so their K is a number", "/options/k");
      return job::transition_between(*file, make_request(asked, name_, effort), progress);
    };
    return effort == job::Effort::draft ? make() : last_.get(asked.key, make);
  }

  /// The report of the piece that is looked at; the whole where refusal left none.
  static Result<const job::Report*> piece_of(const TransitionReport& report, const Asked& asked) {
    const std::size_t count = report.pieces.size();
    if (static_cast<std::size_t>(asked.piece) < count) return &report.pieces[asked.piece];
    if (report.refusal) return &report;
    return fail(ErrorCode::bad_option,
                fmt::format("there is no piece {}; the last is {}", asked.piece, count - 1),
                "/options/piece");
  }

  std::string name_;
  Remembered<TransitionReport> last_;
};

}  // namespace

Result<std::unique_ptr<Document>> open_transition(const std::string& name,
                                                  const std::string& json) {
  if (const auto file = job::parse_transition(json, name); !file)
    return tl::unexpected(file.error());
  return std::make_unique<TransitionDocument>(name);
}

}  // namespace planish::studio
