#pragma once

#include "units.hpp"

#include <planish/base/result.hpp>
#include <planish/geometry/frame.hpp>
#include <planish/job/unfold.hpp>

#include <nlohmann/json.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>

namespace planish::job {

/// Keys stay in the order in which they are written here, so equal reports are equal bytes.
using Json = nlohmann::ordered_json;

/// What JSON cannot say (NaN, infinity) is null.
Json number_json(double value);
Json number_json(const std::optional<double>& value);
Json point_json(const Vec2& p, const Units& units);
Json space_point_json(const Vec3& p, const Units& units);
/// formats.md#reason; null for none.
Json reason_json(const std::optional<Error>& error);
/// A whole report as formats.md#report has it.
Json report_value(const UnfoldReport& report);

/// Whether a report lists its bends one by one.
enum class BendList { shown, left_out };

/// What a command says of a bend beyond what all say.
using BendDetails = std::function<void(Json& bend, const FlatBend& flat)>;
/// The keys at the beginning of every report, then those from "units" to the end; between them a
/// command may put its own.
Json begun_report(const Report& report, std::string_view command);
void finish_report(Json& json, const Report& report, BendList bends = BendList::shown,
                   const BendDetails& details = {});
/// Text of a document, two spaces deep, ending with a line break. Bytes that are not UTF-8 (names
/// in files can be anything) become U+FFFD.
std::string text_of(const Json& document);

}  // namespace planish::job
