#include "made_files.hpp"

#include <planish/job/outputs.hpp>

#include <fmt/format.h>

namespace planish::studio {
namespace {

Result<MadeFile> pattern_file(const job::Report& report, const Asked& asked,
                              job::OutputFormat format, const SvgOptions& svg) {
  if (auto whole = not_refused(report); !whole) return tl::unexpected(whole.error());
  DxfOptions dxf = asked.dxf;
  dxf.units = report.units;
  const char* type = format == job::OutputFormat::dxf   ? kDxfType
                     : format == job::OutputFormat::svg ? kSvgType
                                                        : kStepType;
  return as_file(job::composed(report, format, dxf, svg), type);
}

}  // namespace

std::optional<Result<MadeFile>> common_file(const job::Report& report, const Asked& asked,
                                            const std::string& format, const SvgOptions& svg) {
  if (format == "dxf") return pattern_file(report, asked, job::OutputFormat::dxf, svg);
  if (format == "svg") return pattern_file(report, asked, job::OutputFormat::svg, svg);
  if (format == "flat.step") return pattern_file(report, asked, job::OutputFormat::step, svg);
  return std::nullopt;
}

Result<MadeFile> as_file(Result<std::string> text, const char* type) {
  if (!text) return tl::unexpected(text.error());
  return MadeFile{type, std::move(*text)};
}

Result<void> not_refused(const job::Report& report) {
  if (report.refusal) return tl::unexpected(*report.refusal);
  return {};
}

Error no_such_format(const std::string& format) {
  return {ErrorCode::bad_option,
          fmt::format("files of the format \"{}\" are not made of this kind of document", format),
          format};
}

Result<void> has_spec(const Asked& asked) {
  if (asked.spec.empty())
    return fail(ErrorCode::bad_option,
                "the request holds no spec, which this kind of document needs", "/spec");
  return {};
}

}  // namespace planish::studio
