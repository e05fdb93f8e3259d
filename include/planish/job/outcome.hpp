#pragma once

#include <planish/base/result.hpp>

#include <concepts>
#include <optional>
#include <utility>

namespace planish::job {

/// Why a request gave no pattern. What was understood and refused has a report all the same: it
/// shows how far the work got and what is in the way.
template <typename T>
struct Refused : Error {
  Refused(Error why, std::optional<T> made = {}) : Error(std::move(why)), shown(std::move(made)) {}

  std::optional<T> shown;  ///< reports the refusal; empty: the request failed before
};

/// The refusal that a report holds. Overloaded for everything else that an `Outcome` gives.
template <typename T>
requires requires(const T& report) { report.refusal; }
const std::optional<Error>& refusal_of(const T& report) { return report.refusal; }

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
