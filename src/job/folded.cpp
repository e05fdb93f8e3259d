#include "folded.hpp"

#include "refusals.hpp"
#include "sentences.hpp"

#include <planish/brep/step.hpp>

#include <fmt/format.h>

#include <cmath>

// The folded solid of a designed sheet. The certificate compares the pattern with its volume, as
// the kernel measures it, so a sheet without a solid has none and says so. A STEP text is read back
// before it is given out, because the kernel may write a solid that it cannot read.

namespace planish::job {
namespace {

Finding unmeasured(const Error& error) {
  return finding_of("folded_solid", say::folded_unmade, error);
}

}  // namespace

std::optional<Error> fold(Report& report, Sheet& sheet, const Sheet& to_fold, Result<Body>& solid,
                          const Progress& progress) {
  progress.at("folding it", 0.3);
  auto folded = folded_body(to_fold, report.body);
  if (progress.should_stop()) return error_of(refuse::cancelled, {});
  if (folded) {
    sheet.volume = folded->volume();
    solid = std::move(folded);
  } else {
    leave_unfolded(report, folded.error(), solid);
    sheet.volume.reset();
  }
  return std::nullopt;
}

void leave_unfolded(Report& report, const Error& why, Result<Body>& solid) {
  report.findings.push_back(unmeasured(why));
  solid = tl::unexpected(why);
}

Result<std::string> checked_step(const Result<Body>& solid) {
  if (!solid) return pass_on(solid);
  auto text = step_text(*solid);
  if (!text) return text;
  const auto read = read_step_text(*text, solid->name());
  if (!read) return pass_on(read);
  constexpr double kSame = 1e-4;  // of the volume: texts round, what is lost is more
  const double written = read->bodies.front().volume();
  if (std::abs(written - solid->volume()) <= kSame * solid->volume()) return text;
  return fail(refuse::step_is_wrong,
              {{"solid", solid->volume(), unit::mm3}, {"written", written, unit::mm3}},
              solid->name());
}

Error placed(Error error, const std::string& name) {
  if (error.where.empty() || error.where.front() == '/') error.where = name + error.where;
  return error;
}

std::string place_name(const std::string& input) { return input == "-" ? "standard input" : input; }

}  // namespace planish::job
