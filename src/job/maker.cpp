#include "folded.hpp"
#include "refusals.hpp"

#include <planish/base/text.hpp>
#include <planish/brep/step_archive.hpp>
#include <planish/job/artifact.hpp>
#include <planish/job/maker.hpp>
#include <planish/schema/fail_at.hpp>
#include <planish/schema/json_depth.hpp>
#include <planish/schema/json_parts.hpp>
#include <planish/schema/text_file.hpp>

#include <fmt/format.h>

#include <algorithm>

// The catalogue: which maker reads a file, and which artifacts it can write. A file that is not
// JSON is STEP; JSON is known by its `format`, else by the key that marks it. So no surface names a
// maker (decisions/0007-makers-and-artifacts-are-tables.md).

namespace planish::job {
using namespace schema;
namespace {

tl::unexpected<Error> not_made(const char* what) {
  return fail(refuse::not_made, {{"what", what}});
}

bool looks_like_json(std::string_view content) {
  content = without_byte_order_mark(content);
  const std::size_t first = content.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && (content[first] == '{' || content[first] == '[');
}

template <typename Text>
std::string listed(const std::vector<Maker>& makers, const Text& text) {
  std::string all;
  for (const Maker& maker : makers) {
    if (maker.format.empty()) continue;
    all += (all.empty() ? "" : ", ") + text(maker);
  }
  return all;
}

}  // namespace

Result<std::string> Made::folded_solid(int) const { return not_made("A folded solid"); }
Result<Mesh> Made::folded_mesh() const { return not_made("A folded mesh"); }
Result<Mesh> Made::mould_mesh() const { return not_made("A mould"); }

Result<const Report*> piece_of(const Made& made, int piece) {
  if (piece < made.pieces()) return &made.piece(piece);
  if (made.report().refusal) return &made.report();
  return fail(refuse::no_such_piece, {{"piece", piece}, {"last", made.pieces() - 1}}, "piece");
}

Result<void> Work::edit(const InputFile&) { return fail_at(refuse::not_edited, "/spec"); }

Result<InputFile> read_input_file(const std::filesystem::path& file, const std::string& kind) {
  auto content = is_in_archive(file) ? read_in_archive(file) : read_text(file, kind);
  if (!content) return pass_on(content);
  return InputFile{place_name(file.string()), std::move(*content),
                   file == "-" ? std::filesystem::path() : file.parent_path()};
}

Result<std::unique_ptr<Work>> open_input(const Maker& maker, const Request& request,
                                         const Progress& progress) {
  const auto input = read_input_file(request.input, maker.input_kind());
  if (!input) return pass_on(input);
  if (progress.should_stop()) return fail(refuse::cancelled);
  return maker.open(*input, progress);
}

bool Maker::makes(Source source) const {
  return source == Source::report || std::ranges::find(sources, source) != sources.end();
}

bool Maker::takes(std::string_view option) const {
  return std::ranges::any_of(options, [&](const OptionUse& use) { return use.name == option; });
}

std::string Maker::input_kind() const { return fmt::format("{} file", input); }

std::string Maker::schema_name() const { return std::string(format.substr(format.rfind('/') + 1)); }

const Maker* Catalogue::maker(std::string_view name) const {
  const auto found = std::ranges::find(makers, name, &Maker::name);
  return found == makers.end() ? nullptr : &*found;
}

const Task* Catalogue::task(std::string_view name) const {
  const bool of_maker = maker(name) != nullptr;
  const auto found = std::ranges::find_if(tasks, [&](const Task& one) {
    return of_maker ? one.reader == Reader::named : !name.empty() && one.name == name;
  });
  return found == tasks.end() ? nullptr : &*found;
}

Result<const Maker*> Catalogue::maker_for(const std::string& name,
                                          const std::string& content) const {
  const bool json = looks_like_json(content);
  if (const auto byte = json ? too_deep_at(content) : std::nullopt)
    return fail(too_deep(content, *byte, name, name + ":"));
  Json document;
  try {
    if (json) document = Json::parse(content);
  } catch (const Json::parse_error& mistake) {
    return fail(not_json(content, mistake.byte, name, name + ":"));
  } catch (const Json::exception& mistake) {
    return fail(refuse::no_json, {{"file", name}}, name);
  }
  const bool told = document.is_object() && document.contains("format") &&
                    document["format"].is_string();
  const std::string format = told ? document["format"].get<std::string>() : "";
  for (const Maker& maker : makers) {
    if (maker.format.empty() ? !json
        : told               ? maker.format == format
                             : document.is_object() && document.contains(maker.mark))
      return &maker;
  }
  if (told)
    return fail(refuse::unknown_format,
                {{"file", name},
                 {"format", shortened(format)},
                 {"known", listed(makers, [](const Maker& m) { return std::string(m.format); })},
                 {"field", place::pointer("/format")}},
                name + "/format");
  return fail(
      refuse::no_known_file,
      {{"file", name}, {"known", listed(makers, [](const Maker& m) { return m.input_kind(); })}},
      name);
}

std::vector<const Artifact*> Catalogue::written_by(const Maker& maker) const {
  std::vector<const Artifact*> all;
  for (const Artifact& artifact : artifacts)
    if (maker.makes(artifact.source)) all.push_back(&artifact);
  return all;
}

std::vector<const Artifact*> Catalogue::written_by(const Maker& maker, Role role) const {
  std::vector<const Artifact*> all = written_by(maker);
  all.erase(std::remove_if(all.begin(), all.end(),
                           [&](const Artifact* artifact) { return artifact->role != role; }),
            all.end());
  return all;
}

const Artifact* Catalogue::artifact(const Maker& maker, std::string_view name) const {
  const auto all = written_by(maker);
  for (const Artifact* artifact : all)
    if (artifact->name == name) return artifact;
  for (const Artifact* artifact : all)
    if (artifact->suffix == fmt::format(".{}", name)) return artifact;
  return nullptr;
}

const Catalogue& built_in() {
  static const Catalogue all{makers(), artifacts(), tasks()};
  return all;
}

}  // namespace planish::job
