#include "bend_order_json.hpp"
#include "bending.hpp"
#include "option_tables.hpp"
#include "plan_report.hpp"
#include "refusals.hpp"

#include <planish/job/bend_order.hpp>
#include <planish/job/run.hpp>
#include <planish/schema/fail_at.hpp>
#include <planish/schema/json_reading.hpp>

#include <fmt/format.h>

// Orders of strokes for the studio: the cheapest one, or one that a person has put together. Both
// are made stroke by stroke by the same checker, which keeps what it found, so moving a stroke
// costs only what changed (math.md#bend-order). An order's fault is at its row in the request.

namespace planish::job {
using namespace schema;
namespace {

constexpr int kMostStrokes = 10'000;  // of an order that is read

/// Of the press brake the options that requests have; they say nothing of the sheet.
const Maker& brake_options() {
  static const Maker maker = [] {
    Maker all{.name = "bend"};
    for (const Option& option : bending_options())
      if (option.name != "check_bending" && option.name != "first")
        all.options.push_back({option.name, option.otherwise});
    return all;
  }();
  return maker;
}

const Schema& order_schema() {
  static const Schema stroke = object(
      {required("bends", list(text()).said("pressed together")),
       optional("press_line", whole(1).said("which one of a bend with several")),
       optional("flattening", flag().said("closes a hem that was bent before"))});
  static const Schema schema = object({required("order", list(stroke))});
  return schema;
}

Result<std::vector<OrderedStroke>> parse_order(const std::string& json, const Report& report) {
  JsonReading reading("{\"order\": " + json + "}", "request", "", order_schema());
  if (reading.error()) return tl::unexpected(*reading.error());
  std::vector<OrderedStroke> order;
  for (const JsonPlace& row : JsonPlace(reading)["order"].items()) {
    const auto names = mapped(row["bends"].items(),
                              [&](const JsonPlace& name) { return name.text(); });
    auto bends = bends_named(report, names);
    if (!bends) {
      Error error = std::move(bends.error());
      error.code = code::invalid_input;
      error.where = row.pointer();
      error.places.push_back(place::pointer(row.pointer()));
      return fail(std::move(error));
    }
    OrderedStroke stroke{std::move(*bends)};
    if (row["press_line"].given()) stroke.press_line = row["press_line"].whole() - 1;
    stroke.flattening = row["flattening"].given() && row["flattening"].yes();
    order.push_back(std::move(stroke));
  }
  if (order.size() > kMostStrokes)
    return fail_at(refuse::long_order, "/order", {{"count", order.size()}, {"most", kMostStrokes}});
  return order;
}

}  // namespace

Result<Bending> read_bending(const std::string& json, const std::string& pointer,
                             const Bending& otherwise) {
  const auto values = read_options(json, brake_options(), OptionFiles::content, pointer);
  if (!values) return pass_on(values);
  Request request;
  request.bending = otherwise;
  if (auto entered = values->enter(request); !entered)
    return tl::unexpected(at_pointer(entered.error(), pointer));
  return std::move(request.bending);
}

struct BendOrder::State {
  const Report& report;
  Bending bending;
  const BrakeTools& tools() const { return tools_of(bending); }
  std::optional<OrderChecker> checker = {};

  /// Orders are checked with large bends formed as in the plan.
  Result<void> form_as(const Plan& plan) {
    if (plan.large.empty() || bending.plan.large_radii) return {};
    bending.plan.large = plan.large;
    auto made = OrderChecker::make(report.sheet, report.layout, tools(), bending.plan);
    if (!made) return pass_on(made);
    checker = std::move(*made);
    return {};
  }
};

BendOrder::BendOrder(std::unique_ptr<State> state) : state_(std::move(state)) {}
BendOrder::BendOrder(BendOrder&&) noexcept = default;
BendOrder& BendOrder::operator=(BendOrder&&) noexcept = default;
BendOrder::~BendOrder() = default;

Result<BendOrder> BendOrder::make(const Report& report, Bending bending) {
  if (report.refusal) return tl::unexpected(*report.refusal);
  auto state = std::make_unique<State>(State{report, std::move(bending)});
  auto begin = bends_named(report, state->bending.begin_with);
  if (!begin) return pass_on(begin);
  state->bending.plan.begin_with = std::move(*begin);
  auto checker = OrderChecker::make(report.sheet, report.layout, state->tools(),
                                    state->bending.plan);
  if (!checker) return pass_on(checker);
  state->checker = std::move(*checker);
  return BendOrder(std::move(state));
}

Result<std::string> BendOrder::plan(const Progress& progress) {
  const Report& report = state_->report;
  progress.at("ordering the bends", 0.1);
  auto plan = plan_bending(report.sheet, report.layout, state_->tools(), state_->bending.plan,
                           progress);
  if (!plan) return pass_on(plan);
  if (auto formed = state_->form_as(*plan); !formed) return pass_on(formed);
  auto order = mapped(plan->strokes, [&](const Stroke& stroke) { return ordered(stroke); });
  if (order.empty())
    for (const BendId bend : state_->bending.plan.begin_with)
      order.push_back({{bend}});
  const auto checked = state_->checker->check(order, progress);
  if (!checked) return pass_on(checked);
  Json json = planned_order_json(*plan, state_->bending, report);
  add_order(json, *checked, report, state_->tools());
  return text_of(json);
}

Result<std::string> BendOrder::check(const std::string& order, const Progress& progress) {
  const auto strokes = parse_order(order, state_->report);
  if (!strokes) return pass_on(strokes);
  const auto checked = state_->checker->check(*strokes, progress);
  if (!checked) return pass_on(checked);
  Json json = checked_order_json(*checked);
  add_order(json, *checked, state_->report, state_->tools());
  return text_of(json);
}

}  // namespace planish::job
