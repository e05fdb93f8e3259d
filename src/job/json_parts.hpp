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

/// NaN and infinity, which JSON cannot express, become null.
Json number_json(double value);
Json number_json(const std::optional<double>& value);
Json point_json(const Vec2& p, const Units& units);
Json space_point_json(const Vec3& p, const Units& units);
/// formats.md#reason, its places in `units`; null without an error.
Json reason_json(const std::optional<Error>& error, const Units& units);
/// A whole report as defined in formats.md#report.
Json report_value(const UnfoldReport& report);

/// Whether a report lists its bends one by one.
enum class BendList { shown, left_out };

/// Keys that a command adds to those that every bend has.
using BendDetails = std::function<void(Json& bend, const FlatBend& flat)>;
/// The first keys of every report, then those from "units" to the end; a command may put its own
/// between them.
Json begun_report(const Report& report, std::string_view command);
void finish_report(Json& json, const Report& report, BendList bends = BendList::shown,
                   const BendDetails& details = {});
/// Text of a document, indented by two spaces, ending with a line break. Bytes that are not UTF-8
/// (in names from files) become U+FFFD.
std::string text_of(const Json& document);

}  // namespace planish::job
