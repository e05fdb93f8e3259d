#include <planish/base/message.hpp>
#include <planish/batch/part_record.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <iterator>

// What batches and packs need of a report is read from it by JSON pointers, in one table for each
// type of value, so that nothing is stored twice. A record's text is the report itself, with
// folder, files and shapes around it; reading that text gives the same record.

namespace planish::batch {
namespace {

using Json = nlohmann::ordered_json;

/// Where a report says what a member of its record holds.
template <typename T>
struct Said {
  const char* pointer;
  T PartRecord::*member;
};

using SaidText = Said<std::string>;
constexpr std::array kTexts{
    SaidText{"/input", &PartRecord::input},       SaidText{"/body", &PartRecord::body},
    SaidText{"/status", &PartRecord::status},     SaidText{"/units", &PartRecord::units},
    SaidText{"/material", &PartRecord::material}, SaidText{"/colour", &PartRecord::colour},
    SaidText{"/reason/code", &PartRecord::reason}};

using SaidCount = Said<std::optional<int>>;
constexpr std::array kCounts{SaidCount{"/quantity", &PartRecord::quantity},
                             SaidCount{"/flat/openings", &PartRecord::openings},
                             SaidCount{"/sheet/bends", &PartRecord::bends}};

using SaidSize = Said<std::optional<double>>;
constexpr std::array kSizes{SaidSize{"/sheet/thickness", &PartRecord::thickness},
                            SaidSize{"/flat/size/0", &PartRecord::length},
                            SaidSize{"/flat/size/1", &PartRecord::width},
                            SaidSize{"/flat/area", &PartRecord::area},
                            SaidSize{"/flat/cutting/outer", &PartRecord::outer_cutting},
                            SaidSize{"/flat/cutting/inner", &PartRecord::inner_cutting},
                            SaidSize{"/sheet/mass", &PartRecord::mass},
                            SaidSize{"/density", &PartRecord::density},
                            SaidSize{"/sheet/volume", &PartRecord::volume},
                            SaidSize{"/verification/volume_ratio", &PartRecord::volume_ratio}};

/// The value at a pointer; null where there is none.
const Json& at(const Json& json, const char* pointer) {
  static const Json kNothing;
  const Json::json_pointer place(pointer);
  return json.contains(place) ? json[place] : kNothing;
}

std::string text_at(const Json& json, const char* pointer) {
  const Json& said = at(json, pointer);
  return said.is_string() ? said.get<std::string>() : std::string();
}

std::vector<std::string> texts_at(const Json& json, const char* pointer) {
  std::vector<std::string> texts;
  for (const Json& text : at(json, pointer))
    if (text.is_string()) texts.push_back(text.get<std::string>());
  return texts;
}

/// A sentence with its options as on a command line, which is where batches come from.
std::string sentence_at(const Json& reason) {
  const Json& wording = at(reason, "/wording");
  if (!wording.is_array()) return text_at(reason, "/message");
  std::string sentence;
  for (const Json& piece : wording) {
    const std::string option = text_at(piece, "/option");
    sentence += option.empty() ? text_at(piece, "/text") : flag_of(option);
  }
  return sentence;
}

/// One remedy stands alone, several in a list.
std::vector<std::string> remedies_at(const Json& finding) {
  std::vector<std::string> changes;
  for (const Json& remedy : at(finding, "/remedies"))
    changes.push_back(text_at(remedy, "/change"));
  if (changes.empty()) changes.push_back(text_at(finding, "/remedy/change"));
  std::erase(changes, std::string());
  return changes;
}

void enter_report(PartRecord& record, const Json& report) {
  for (const SaidText& text : kTexts)
    record.*text.member = text_at(report, text.pointer);
  for (const SaidCount& count : kCounts)
    if (const Json& said = at(report, count.pointer); said.is_number_integer())
      record.*count.member = said.get<int>();
  for (const SaidSize& size : kSizes)
    if (const Json& said = at(report, size.pointer); said.is_number())
      record.*size.member = said.get<double>();
  for (const Json& found : at(report, "/checks"))
    record.findings.push_back({text_at(found, "/severity"), text_at(found, "/code"),
                               text_at(found, "/message"), remedies_at(found)});
  record.message = sentence_at(at(report, "/reason"));
  record.notes = texts_at(report, "/notes");
  record.written = texts_at(report, "/files");
}

}  // namespace

PartRecord part_record(std::string folder, std::string report, std::vector<std::string> shapes,
                       std::vector<std::string> files) {
  PartRecord record;
  enter_report(record, Json::parse(report));
  record.folder = std::move(folder);
  record.report = std::move(report);
  record.shapes = std::move(shapes);
  record.files = std::move(files);
  return record;
}

std::vector<RecordedFinding> warnings_of(const PartRecord& record) {
  std::vector<RecordedFinding> warnings;
  std::ranges::copy_if(record.findings, std::back_inserter(warnings),
                       [](const RecordedFinding& found) { return found.severity != "info"; });
  return warnings;
}

std::string record_text(const PartRecord& record) {
  return fmt::format(R"({{"folder":{},"files":{},"report":{},"shapes":{}}})",
                     Json(record.folder).dump(), Json(record.files).dump(), record.report,
                     Json(record.shapes).dump());
}

std::optional<std::vector<PartRecord>> part_records(std::string_view text) {
  const Json json = Json::parse(text, nullptr, false);
  if (!json.is_array()) return std::nullopt;
  std::vector<PartRecord> records;
  try {
    for (const Json& one : json) {
      PartRecord& record = records.emplace_back();
      one.at("folder").get_to(record.folder);
      one.at("files").get_to(record.files);
      one.at("shapes").get_to(record.shapes);
      record.report = one.at("report").dump();
      enter_report(record, one.at("report"));
    }
  } catch (const Json::exception&) {
    return std::nullopt;
  }
  return records;
}

}  // namespace planish::batch
