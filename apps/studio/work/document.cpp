#include "document.hpp"

#include "../refusals.hpp"
#include "attachments.hpp"

#include <planish/schema/fail_at.hpp>

#include <fmt/format.h>

namespace planish::studio {
namespace {

/// The report of the piece that is looked at.
Result<const job::Report*> shown_piece(const job::Made& made, const Asked& asked) {
  auto piece = job::piece_of(made, asked.request.piece);
  if (!piece) return tl::unexpected(job::at_pointer(piece.error(), kOptions));
  return piece;
}

// Drafts are seen for a moment, shaded smoothly: 0.15 mm, 10° will do.
const FacetOptions kOfDrafts{0.15, Angle::degrees(10.0)};

FacetOptions facet_options(const Asked& asked, job::Effort effort) {
  FacetOptions options = effort == job::Effort::draft ? kOfDrafts : FacetOptions{};
  if (asked.chord) options.chord = *asked.chord;
  options.extruded = asked.request.extruded;
  return options;
}

void add_flange_names(Shape& shape, const job::Made& made) {
  const auto names = made.flange_names();
  for (std::size_t i = 0; i < names.size() && i < shape.parts.size(); ++i)
    if (shape.parts[i]["kind"] == "flange") shape.parts[i]["plate"] = names[i];
}

}  // namespace

Document::Document(const job::Catalogue& catalogue, const job::Maker& maker, std::string name,
                   std::filesystem::path attachments, std::unique_ptr<job::Work> work)
    : catalogue_(&catalogue),
      maker_(&maker),
      name_(std::move(name)),
      attachments_(std::move(attachments)),
      work_(std::move(work)) {}

Result<Document> Document::open(const job::Catalogue& catalogue, const std::string& name,
                                const std::string& content, std::filesystem::path attachments,
                                const Progress& progress) {
  const auto maker = catalogue.maker_for(name, content);
  if (!maker) return pass_on(maker);
  if (auto plain = check_names(**maker, content, name); !plain) return pass_on(plain);
  auto work = (*maker)->open({name, content, std::nullopt}, progress);
  if (!work) return pass_on(work);
  return Document(catalogue, **maker, name, std::move(attachments), std::move(*work));
}

job::Request Document::request_of(const Asked& asked, job::Effort effort) const {
  job::Request request = asked.request;
  request.input = name_;
  request.effort = effort;
  if (request.body.empty()) request.body = std::string("1");
  return request;
}

Result<void> Document::take_spec(const Asked& asked) {
  if (maker_->format.empty()) return {};
  if (asked.spec.empty()) return schema::fail_at(refuse::no_spec, "/spec");
  if (auto there = check_attachments(*maker_, asked.spec, name_, attachments_); !there)
    return there;
  return work_->edit({name_, asked.spec, attachments_});
}

Result<Document::MadePointer> Document::make(const Asked& asked, job::Effort effort,
                                             const Progress& progress) {
  const bool whole = effort == job::Effort::full;
  if (whole && last_ && last_->first == asked.key) return last_->second;
  if (auto taken = take_spec(asked); !taken) return pass_on(taken);
  auto made = job::shown(work_->make(request_of(asked, effort), progress));
  if (!made) return tl::unexpected(job::at_pointer(made.error(), kOptions));
  MadePointer shared(std::move(*made));
  if (whole) last_ = {asked.key, shared};
  return shared;
}

Result<Shape> Document::shape(const Asked& asked, job::Effort effort, const Progress& progress) {
  const auto made = make(asked, effort, progress);
  if (!made) return pass_on(made);
  const auto piece = shown_piece(**made, asked);
  if (!piece) return pass_on(piece);
  Shape shape;
  shape.report = (*made)->json();
  shape.handles = (*made)->handles();
  add_sheet(shape, **piece, facet_options(asked, effort));
  add_flange_names(shape, **made);
  if ((*made)->report().refusal)
    if (const auto solid = (*made)->refused_solid()) add_space(shape, *solid);
  return shape;
}

Result<job::WrittenArtifact> Document::file(const Asked& asked, const std::string& name,
                                            const Progress& progress) {
  const job::Artifact* artifact = catalogue_->artifact(*maker_, name);
  if (!artifact) return fail(refuse::no_such_file, {{"format", name}}, name);
  const auto made = make(asked, job::Effort::full, progress);
  if (!made) return pass_on(made);
  if ((*made)->report().refusal && artifact->role != job::Role::report)
    return tl::unexpected(*(*made)->report().refusal);
  const auto piece = shown_piece(**made, asked);
  if (!piece) return pass_on(piece);
  auto bytes = artifact->write(**made, asked.request.piece, request_of(asked, job::Effort::full));
  if (!bytes) return pass_on(bytes);
  return job::WrittenArtifact{artifact, name_, std::move(*bytes)};
}

Result<job::BendOrder*> Document::order_of(const Asked& asked, const Progress& progress) {
  const std::string key = asked.key + "\n" + asked.brake;
  if (ordered_ && ordered_->key == key) return &ordered_->order;
  auto bending = job::read_bending(asked.brake, kBrake, asked.request.bending);
  if (!bending) return pass_on(bending);
  auto made = make(asked, job::Effort::full, progress);
  if (!made) return pass_on(made);
  const auto piece = shown_piece(**made, asked);
  if (!piece) return pass_on(piece);
  auto order = job::BendOrder::make(**piece, std::move(*bending));
  if (!order) return pass_on(order);
  ordered_.emplace(Ordered{key, std::move(*made), std::move(*order)});
  return &ordered_->order;
}

Result<std::string> Document::plan(const Asked& asked, const Progress& progress) {
  const auto order = order_of(asked, progress);
  if (!order) return pass_on(order);
  if (asked.order.empty()) return (*order)->plan(progress);
  return (*order)->check(asked.order, progress);
}

}  // namespace planish::studio
