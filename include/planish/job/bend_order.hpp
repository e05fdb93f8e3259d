#pragma once

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/job/report.hpp>
#include <planish/job/request.hpp>

#include <memory>
#include <string>

namespace planish::job {

/// Options of the press brake alone, as a JSON object with the keys of `Request`: tools (by their
/// content), metal, springback, clearance, shortfall, opening, weights, fix, search_time. What is
/// left out is that of `otherwise`, such as what a shop says. Errors: those of `read_options` and
/// of the values; `where` is `pointer` with the option.
Result<Bending> read_bending(const std::string& json, const std::string& pointer,
                             const Bending& otherwise = {});

/// The order in which a sheet is bent, to be looked at and changed. Answers are JSON texts
/// (studio-api.md#plan). What was found out for one order is used for the next.
class BendOrder {
 public:
  /// `report` must outlive this. Errors: the refusal of a report without a pattern, those of
  /// `plan_bending`.
  static Result<BendOrder> make(const Report& report, Bending bending);
  BendOrder(BendOrder&&) noexcept;
  BendOrder& operator=(BendOrder&&) noexcept;
  ~BendOrder();

  /// The cheapest order; if there is none, one with as many strokes as can be made first. Errors:
  /// `cancelled`, `bad_option`.
  Result<std::string> plan(const Progress& progress);
  /// An order given as a JSON list. Errors: `invalid_input` for anything else (`where` is "/order"
  /// with the JSON pointer in it), those of `OrderChecker::check`.
  Result<std::string> check(const std::string& order, const Progress& progress);

 private:
  struct State;
  explicit BendOrder(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace planish::job
