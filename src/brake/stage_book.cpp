#include "stage_book.hpp"

#include <planish/base/assert.hpp>

#include <algorithm>

namespace planish::brake_detail {

StageBook::StageBook(const StrokeProblem& problem, const StrokeWeights& weights)
    : problem_(problem),
      weights_(weights),
      full_(all_lines(problem.lines)),
      seen_(no_lines(problem.lines)),
      furthest_(seen_) {}

int StageBook::stage_of(const LineSet& formed) {
  const auto [place, fresh] = numbers_.try_emplace(formed, static_cast<int>(stages_.size()));
  if (fresh) {
    stages_.push_back({&place->first});
    if (count(formed) > count(furthest_)) furthest_ = formed;
  }
  return place->second;
}

std::optional<int> StageBook::find(const LineSet& formed) const {
  const auto known = numbers_.find(formed);
  return known == numbers_.end() ? std::nullopt : std::optional(known->second);
}

bool StageBook::is_dead(const LineSet& formed) const {
  const auto known = find(formed);
  return known && stages_[*known].dead;
}

SetUp StageBook::set_up_in(const StrokeChoice& choice) {
  return {choice.punch, choice.die, choice.reference_up, choice.direction};
}

bool StageBook::is_refuted(const StrokeChoice& choice) const {
  for (const bool gauged : {true, false}) {
    const auto known = choice_numbers_.find({choice.lines, set_up_in(choice), gauged});
    if (known != choice_numbers_.end() && choices_[known->second].refuted) return true;
  }
  return false;
}

int StageBook::set_up_of(const SetUp& set_up) {
  const auto [place, fresh] = set_up_numbers_.try_emplace(set_up, set_ups_.size());
  if (fresh) set_ups_.push_back(set_up);
  return place->second;
}

int StageBook::number_of(const StrokeChoice& choice) {
  const SetUp set_up = set_up_in(choice);
  const auto [place, fresh] = choice_numbers_.try_emplace({choice.lines, set_up, choice.gauged},
                                                          choices_.size());
  if (fresh)
    choices_.push_back(
        {choice, set_up_of(set_up), weights_.stroke + (choice.gauged ? 0.0 : weights_.ungauged)});
  return place->second;
}

bool StageBook::fits_beginning(const LineSet& formed, const StrokeChoice& choice) const {
  const auto next = std::ranges::find_if(problem_.begin_with,
                                         [&](int line) { return !holds(formed, line); });
  return next == problem_.begin_with.end() || holds(choice.lines, *next);
}

const std::vector<Offer>& StageBook::offers(int stage) {
  if (stages_[stage].asked) return stages_[stage].offers;
  const LineSet& formed = *stages_[stage].formed;
  std::vector<Offer> offers;
  for (const StrokeChoice& choice : problem_.choices(formed)) {
    PLANISH_ASSERT(choice.lines.size() == formed.size() && count(choice.lines) > 0);
    PLANISH_ASSERT(disjoint(choice.lines, formed) && within(choice.lines, full_));
    if (fits_beginning(formed, choice)) offers.push_back({number_of(choice)});
  }
  ++asked_;
  offers_kept_ += static_cast<std::int64_t>(offers.size());
  stages_[stage].asked = true;
  stages_[stage].offers = std::move(offers);
  return stages_[stage].offers;
}

bool StageBook::conflicts(const KnownChoice& known, const LineSet& formed) const {
  return std::ranges::any_of(known.conflicts, [&](const std::array<LineSet, 2>& conflict) {
    for (std::size_t i = 0; i < formed.size(); ++i)
      if ((formed[i] & conflict[0][i]) != conflict[1][i]) return false;
    return true;
  });
}

bool StageBook::ask(KnownChoice& known, const LineSet& formed) {
  if (conflicts(known, formed)) return false;
  const StrokeVerdict verdict = problem_.check(formed, known.choice);
  if (verdict.feasible) return true;
  if (!verdict.because) return false;
  PLANISH_ASSERT(verdict.because->size() == formed.size());
  LineSet were = *verdict.because;
  for (std::size_t i = 0; i < were.size(); ++i)
    were[i] &= formed[i];
  known.conflicts.push_back({*verdict.because, were});
  if (count(*verdict.because) == 0 && !known.refuted) {
    known.refuted = true;
    ++refuted_;
  }
  return false;
}

bool StageBook::feasible(int stage, std::size_t offer) {
  Offer& one = stages_[stage].offers[offer];
  KnownChoice& known = choices_[one.choice];
  if (one.state == Offer::State::unknown) {
    const bool yes = !problem_.check || ask(known, *stages_[stage].formed);
    one.state = yes ? Offer::State::feasible : Offer::State::infeasible;
    if (yes) seen_ = joined(std::move(seen_), known.choice.lines);
  }
  return one.state == Offer::State::feasible;
}

double StageBook::change(int from, int to) const {
  if (from == kNoSetUp || from == to) return 0.0;
  const SetUp &a = set_ups_[from], &b = set_ups_[to];
  double cost = 0.0;
  if (a.punch != b.punch || a.die != b.die) cost += weights_.tool_change;
  if (a.reference_up != b.reference_up) cost += weights_.turn_over;
  if (a.direction != b.direction) cost += weights_.rotate;
  return cost;
}

}  // namespace planish::brake_detail
