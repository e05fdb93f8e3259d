#pragma once

#include <planish/base/result.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <string>
#include <string_view>

namespace planish {

/// A flat pattern as one line of JSON, to be kept: `dxf_text` and `svg_text` of what is read back
/// give the same bytes, since every number is written so that it reads back as the same double. An
/// internal store: what it holds may change with the program's version. What refers to the sheet
/// (`Contour::origins`, `FlatBend::bend`, `FlatPattern::root` and its placement) is left out. Bytes
/// that are not UTF-8 are replaced. Requires a pattern that passes `check`.
std::string flat_json(const FlatPattern& pattern);

/// The pattern again. Error: `invalid_input` for text that `flat_json` of this version has not
/// written: cut off, changed anywhere, or of another version.
Result<FlatPattern> read_flat_json(std::string_view text);

}  // namespace planish
