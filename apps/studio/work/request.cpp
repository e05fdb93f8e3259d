#include "request.hpp"

#include "../refusals.hpp"
#include "json_text.hpp"

#include <planish/schema/fail_at.hpp>

#include <fmt/format.h>

namespace planish::studio {
namespace {

Result<void> read_options(const Json& options, const job::Maker& maker, job::Request& request) {
  const auto values = job::read_options(json_text(options), maker, job::OptionFiles::content,
                                        kOptions);
  if (!values) return pass_on(values);
  if (auto entered = values->enter(request); !entered)
    return tl::unexpected(job::at_pointer(entered.error(), kOptions));
  return {};
}

/// The options without those of the DXF, which change how a pattern is written and not what is
/// made.
Json of_geometry(const Json& options, const job::Maker& maker) {
  Json kept = options;
  for (const job::OptionUse& use : maker.options)
    if (use.entry().group == job::OptionGroup::dxf) kept.erase(std::string(use.name));
  return kept;
}

// Below, a circle as large as a sheet would have thousands of corners; above, a small hole three.
constexpr double kFinestChord = 1e-5, kCoarsestChord = 10.0;  // mm

Result<double> read_chord(const Json& value) {
  if (!value.is_number())
    return schema::fail_at(refuse::chord_no_number, "/chord", {{"value", json_text(value)}});
  const double chord = value.get<double>();
  if (chord >= kFinestChord && chord <= kCoarsestChord) return chord;
  return schema::fail_at(refuse::chord_out_of_range, "/chord",
                         {{"chord", chord, unit::mm},
                          {"least", kFinestChord, unit::mm},
                          {"most", kCoarsestChord, unit::mm}});
}

}  // namespace

Result<Asked> parse_asked(const std::string& text, const job::Maker& maker) {
  const auto json = parse_json(text, "request");
  if (!json) return pass_on(json);
  if (!json->is_object()) return fail(refuse::request_no_object);
  Asked asked;
  std::string options;
  for (const auto& [key, value] : json->items()) {
    if (key == "spec") {
      if (!value.is_null()) asked.spec = json_text(value);
    } else if (key == "options") {
      if (auto read = read_options(value, maker, asked.request); !read) return pass_on(read);
      options = json_text(of_geometry(value, maker));
    } else if (key == "chord") {
      const auto chord = read_chord(value);
      if (!chord) return pass_on(chord);
      asked.chord = *chord;
    } else if (key == "brake") {
      if (!value.is_null()) asked.brake = json_text(value);
    } else if (key == "order") {
      if (!value.is_null()) asked.order = json_text(value);
    } else {
      return schema::fail_at(refuse::unknown_key, "/" + key);
    }
  }
  asked.key = asked.spec + "\n" + options;
  return asked;
}

}  // namespace planish::studio
