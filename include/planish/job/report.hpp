#pragma once

#include <planish/base/result.hpp>
#include <planish/brake/plan.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/job/request.hpp>
#include <planish/sheet/certificate.hpp>

#include <concepts>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planish::job {

struct SheetSummary {
  double thickness = 0.0, thickness_spread = 0.0, volume = 0.0;
  int flanges = 0, bends = 0;
  std::optional<double> k_factor;  ///< of all bends, or of the rule if there are none; empty if
                                   ///< they differ
  std::string k_source;            ///< likewise; "mixed" if they differ
};

enum class Status { ok, warning, refused };
/// "ok", "warning", "refused".
std::string_view status_name(Status status);

/// The pattern that fits the tools of a plan, where these leave other inside radii than the drawn
/// ones. The folded part has its flanges where they are drawn. With `Bending::as_made` it is the
/// report's own.
struct MadeFlat {
  struct Row {
    BendId bend;
    double drawn = 0.0, made = 0.0;  ///< inside radii, mm
    double change = 0.0;             ///< of the developed length, mm; above 0: longer
  };
  FlatPattern flat;
  Vec2 size = Vec2::Zero();  ///< as `Report::size`
  std::vector<Row> bends;
};

/// What every command reports about a flat pattern. A refused report, which an `Outcome` only shows
/// beside its error, has no pattern; `summary` (if its thickness > 0) and `flat` (if its outer
/// contour is not empty) then hold what was known. Lengths are mm; `units` is for the reports.
struct Report {
  std::string input;
  std::string body;      ///< name of the part: of the body in its file, or of its input file
  std::string material;  ///< "S235", as it was chosen, or its file says; empty: neither
  std::string colour;    ///< "#rrggbb" as its file says; empty: it does not say
  std::optional<double> density;  ///< kg/dm³, likewise, of that material
  int quantity = 1;               ///< pieces: in its file, or wanted
  std::optional<Error> refusal;   ///< empty in what an `Outcome` holds
  SheetSummary summary;
  Sheet sheet;  ///< the faces and bends that `flat` refers to; no faces if it was not known
  FlatPattern flat;
  Layout layout;              ///< how the faces of `sheet` lie in `flat`, before slits are cut
  FlattenOptions laid;        ///< how that was laid
  std::vector<Loop> reliefs;  ///< outlines of what was cut out of `flat` beyond its faces
  Vec2 size = Vec2::Zero();   ///< smallest enclosing rectangle, longer side first, mm
  Certificate certificate;
  std::vector<Finding> findings;
  std::vector<std::string> notes;
  std::optional<double> mass;             ///< kg, when the density is known
  std::optional<Plan> plan;               ///< of the strokes that bend it, if that was asked for
  std::optional<MadeFlat> as_made = {};   ///< if the plan makes other radii than the drawn ones;
                                          ///< with `Bending::as_made` `flat` is this one
  std::optional<Error> not_as_made = {};  ///< why there is none
  std::string_view task = {};             ///< that reports it, "bend"; empty: that of the maker
  std::vector<std::string> files;         ///< written, named as the writer names them
  LengthUnit units = LengthUnit::mm;
  double read_seconds = 0.0, unfold_seconds = 0.0;
  bool has_warnings() const;
  Status status() const;
};

/// Why a request gave no pattern. What was understood and refused has a report all the same: it
/// shows how far the work got and what is in the way.
template <typename T>
struct Refused : Error {
  Refused(Error why, std::optional<T> made = {}) : Error(std::move(why)), shown(std::move(made)) {}

  std::optional<T> shown;  ///< reports the refusal; empty: the request failed before
};

/// The refusal that a report holds. Overloaded for everything else that an `Outcome` gives.
inline const std::optional<Error>& refusal_of(const Report& report) { return report.refusal; }

/// What came of a request: a report with a pattern, or the reason why there is none. A report with
/// a refusal becomes an error that shows it, so a value never has one. Not to be dropped.
template <typename T>
class [[nodiscard]] Outcome : public tl::expected<T, Refused<T>> {
  using Expected = tl::expected<T, Refused<T>>;

 public:
  template <std::convertible_to<T> Made>
  Outcome(Made&& made) : Expected(judged(std::forward<Made>(made))) {}
  template <std::convertible_to<Refused<T>> Why>
  Outcome(tl::unexpected<Why> why) : Expected(std::move(why)) {}

 private:
  static Expected judged(T made) {
    std::optional<Error> refusal = refusal_of(made);
    if (!refusal) return Expected(std::move(made));
    return tl::unexpected(Refused<T>(std::move(*refusal), std::move(made)));
  }
};

/// The report to write, refused or not. Errors: those of a request that has none.
template <typename T>
Result<T> shown(Outcome<T> outcome) {
  if (outcome) return std::move(*outcome);
  if (outcome.error().shown) return std::move(*outcome.error().shown);
  return tl::unexpected<Error>(std::move(outcome.error()));
}

}  // namespace planish::job
