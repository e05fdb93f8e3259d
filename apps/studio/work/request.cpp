#include "request.hpp"

#include "json_text.hpp"

#include <fmt/format.h>

namespace planish::studio {
namespace {

tl::unexpected<Error> mistake(const std::string& message, const std::string& where) {
  return fail(code::invalid_input, message, where);
}

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
Json of_geometry(const Json& options) {
  Json kept = Json::object();
  for (const auto& [name, value] : options.items())
    if (job::option(name).group != "DXF") kept[name] = value;
  return kept;
}

// Below, a circle as large as a sheet would have thousands of corners; above, a small hole three.
constexpr double kFinestChord = 1e-5, kCoarsestChord = 10.0;  // mm

Result<double> read_chord(const Json& value) {
  if (!value.is_number())
    return mistake(fmt::format("the chord is {}; it must be a number", json_text(value)), "/chord");
  const double chord = value.get<double>();
  if (chord >= kFinestChord && chord <= kCoarsestChord) return chord;
  return mistake(fmt::format("the chord is {} mm; it must be from {} to {} mm", chord, kFinestChord,
                             kCoarsestChord),
                 "/chord");
}

}  // namespace

Result<Asked> parse_asked(const std::string& text, const job::Maker& maker) {
  const auto json = parse_json(text, "request");
  if (!json) return pass_on(json);
  if (!json->is_object()) return mistake("the request must be an object", "");
  Asked asked;
  std::string options;
  for (const auto& [key, value] : json->items()) {
    if (key == "spec") {
      if (!value.is_null()) asked.spec = json_text(value);
    } else if (key == "options") {
      if (auto read = read_options(value, maker, asked.request); !read) return pass_on(read);
      options = json_text(of_geometry(value));
    } else if (key == "chord") {
      const auto chord = read_chord(value);
      if (!chord) return pass_on(chord);
      asked.chord = *chord;
    } else if (key == "brake") {
      if (!value.is_null()) asked.brake = json_text(value);
    } else if (key == "order") {
      if (!value.is_null()) asked.order = json_text(value);
    } else {
      return mistake(fmt::format("a request has no key \"{}\"", key), "/" + key);
    }
  }
  asked.key = asked.spec + "\n" + options;
  return asked;
}

}  // namespace planish::studio
