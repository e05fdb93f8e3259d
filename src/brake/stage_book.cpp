// What a search has learned of stages. A stroke is infeasible because of a few lines that are
// formed or not; it is so in each stage that agrees on them. If such reasons cover all cases, the
// stroke is infeasible everywhere, told apart by splitting on the lines of the shortest reason; if
// one by formed lines alone holds for each way to press a line, the stage is dead. What must hold:
// reasons are true (StrokeVerdict), and what is formed stays so (bend.md#search).
#include "stage_book.hpp"

#include <planish/base/assert.hpp>

#include <algorithm>

namespace planish::brake_detail {
namespace {

constexpr std::size_t kMostBlockings = 500;  // each stage is held against all of them
constexpr int kMostCases = 5'000;            // told apart for one family: about 1 ms

/// Whether in each stage in which lines are formed as `formed` says, for those that are `known`, a
/// conflict holds. Not if that takes more than the cases left.
bool hold_in_all(const std::vector<Conflict>& conflicts, const LineSet& known,
                 const LineSet& formed, int& cases) {
  if (--cases < 0) return false;
  const Conflict* shortest = nullptr;
  int open = 0;
  for (const Conflict& conflict : conflicts) {
    const LineSet shared = common(conflict.lines, known);
    if (common(shared, conflict.formed) != common(shared, formed)) continue;
    const int lines = count(conflict.lines) - count(shared);
    if (lines == 0) return true;
    if (!shortest || lines < open) {
      shortest = &conflict;
      open = lines;
    }
  }
  if (!shortest) return false;
  for (const int line : members(shortest->lines)) {
    if (holds(known, line)) continue;
    LineSet both = known, with = formed;
    insert(both, line);
    insert(with, line);
    return hold_in_all(conflicts, both, formed, cases) && hold_in_all(conflicts, both, with, cases);
  }
  return false;
}

bool hold_everywhere(const Family& family) {
  if (family.conflicts.empty()) return false;
  const LineSet nothing(family.conflicts.front().lines.size());
  int cases = kMostCases;
  return hold_in_all(family.conflicts, nothing, nothing, cases);
}

}  // namespace

bool Conflict::holds_in(const LineSet& stage) const { return common(lines, stage) == formed; }

StageBook::StageBook(const StrokeProblem& problem, const StrokeWeights& weights)
    : problem_(problem),
      weights_(weights),
      full_(all_lines(problem.lines)),
      seen_(no_lines(problem.lines)),
      furthest_(seen_),
      families_of_line_(problem.lines),
      possible_of_line_(problem.lines) {
  list_families();
}

void StageBook::list_families() {
  std::vector<bool> alone(families_of_line_.size(), true);
  for (const StrokeChoice& row : problem_.possible) {
    const std::vector<int> lines = members(row.lines);
    for (const int line : lines) {
      if (lines.size() > 1) alone[line] = false;
      possible_of_line_[line].insert(way_of(row));
      families_of_line_[line].push_back(family_of(row.lines, way_of(row)));
    }
  }
  for (std::size_t line = 0; line < alone.size(); ++line)
    if (!alone[line]) families_of_line_[line].clear();
}

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
  if (known && stages_[*known].dead) return true;
  return std::ranges::any_of(blockings_, [&](const Blocking& blocking) {
    return !holds(formed, blocking.line) && within(blocking.by, formed);
  });
}

/// With its own tools: what is feasible with one is not so with another that stands beside it.
SetUp StageBook::way_of(const StrokeChoice& choice) {
  return {choice.punch, choice.die, choice.reference_up, choice.direction};
}

bool StageBook::is_refuted(const StrokeChoice& choice) {
  const auto known = family_numbers_.find({choice.lines, way_of(choice)});
  if (known == family_numbers_.end()) return false;
  Family& family = families_[known->second];
  if (family.looked_at != family.conflicts.size()) family.refuted = hold_everywhere(family);
  family.looked_at = family.conflicts.size();
  return family.refuted;
}

int StageBook::set_up_of(const SetUp& set_up) {
  const auto [place, fresh] = set_up_numbers_.try_emplace(set_up, set_ups_.size());
  if (fresh) set_ups_.push_back(set_up);
  return place->second;
}

int StageBook::family_of(const LineSet& lines, const SetUp& set_up) {
  const auto [place, fresh] = family_numbers_.try_emplace({lines, set_up}, families_.size());
  if (fresh) families_.emplace_back();
  return place->second;
}

int StageBook::number_of(const StrokeChoice& choice) {
  const SetUp way = way_of(choice);
  const auto [place, fresh] = choice_numbers_.try_emplace({{choice.lines, way}, choice.gauged},
                                                          choices_.size());
  if (fresh)
    choices_.push_back({choice, set_up_of(brake_detail::set_up_of(choice)), weights_.of(choice),
                        family_of(choice.lines, way)});
  return place->second;
}

/// What `possible` leaves out would be proven infeasible.
bool StageBook::is_covered(const StrokeChoice& choice) const {
  if (problem_.possible.empty()) return true;
  return std::ranges::all_of(members(choice.lines), [&](int line) {
    return possible_of_line_[line].contains(way_of(choice));
  });
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
    PLANISH_ASSERT(is_covered(choice));
    if (fits_beginning(formed, choice)) offers.push_back({number_of(choice)});
  }
  ++asked_;
  offers_kept_ += static_cast<std::int64_t>(offers.size());
  stages_[stage].asked = true;
  stages_[stage].offers = std::move(offers);
  return stages_[stage].offers;
}

bool StageBook::ask(const KnownChoice& known, const LineSet& formed) {
  for (const Conflict& conflict : families_[known.family].conflicts)
    if (conflict.holds_in(formed)) return false;
  const StrokeVerdict verdict = problem_.check(formed, known.choice);
  if (!verdict.feasible && verdict.because) learn(known, formed, *verdict.because);
  return verdict.feasible;
}

void StageBook::learn(const KnownChoice& known, const LineSet& formed, const LineSet& because) {
  PLANISH_ASSERT(because.size() == formed.size());
  families_[known.family].conflicts.push_back({because, common(because, formed)});
  ++learned_;
  if (count(known.choice.lines) != 1 || blockings_.size() >= kMostBlockings) return;
  const int line = members(known.choice.lines).front();
  const auto by = blocked_for_good(line, formed);
  // By nothing at all: that is a line that the bound finds possible nowhere.
  if (by && count(*by) > 0) blockings_.push_back({line, *by});
}

/// What is formed stays so, and with it every conflict by formed lines alone.
std::optional<LineSet> StageBook::blocked_for_good(int line, const LineSet& formed) const {
  const std::vector<int>& ways = families_of_line_[line];
  if (ways.empty()) return std::nullopt;
  LineSet by(formed.size());
  for (const int way : ways) {
    std::optional<LineSet> least;
    for (const Conflict& conflict : families_[way].conflicts) {
      if (conflict.lines != conflict.formed || !within(conflict.lines, formed)) continue;
      LineSet with = joined(by, conflict.lines);
      if (!least || count(with) < count(*least)) least = std::move(with);
    }
    if (!least) return std::nullopt;
    by = std::move(*least);
  }
  return by;
}

bool StageBook::feasible(int stage, std::size_t offer) {
  Offer& one = stages_[stage].offers[offer];
  const KnownChoice& known = choices_[one.choice];
  if (one.state == Offer::State::unknown) {
    const bool yes = !problem_.check || ask(known, *stages_[stage].formed);
    one.state = yes ? Offer::State::feasible : Offer::State::infeasible;
    if (yes) seen_ = joined(std::move(seen_), known.choice.lines);
  }
  return one.state == Offer::State::feasible;
}

bool StageBook::can_end() {
  constexpr std::size_t kMostTogether = 4;
  std::set<LineSet> last;
  for (const StrokeChoice& row : problem_.possible) {
    const std::vector<int> lines = members(row.lines);
    if (lines.size() > kMostTogether) return true;
    for (std::size_t subset = 1; subset < std::size_t{1} << lines.size(); ++subset) {
      LineSet pressed(full_.size());
      for (std::size_t i = 0; i < lines.size(); ++i)
        if ((subset >> i & 1) != 0) insert(pressed, lines[i]);
      last.insert(std::move(pressed));
    }
  }
  return last.empty() ||
         std::ranges::any_of(last, [&](const LineSet& lines) { return can_end_with(lines); });
}

/// The stage before may be out of reach, so nothing is noted but why a choice is infeasible.
bool StageBook::can_end_with(const LineSet& lines) {
  const LineSet before = without(full_, lines);
  return std::ranges::any_of(problem_.choices(before), [&](const StrokeChoice& choice) {
    if (choice.lines != lines || !fits_beginning(before, choice)) return false;
    return !problem_.check ||
           ask({choice, kNoSetUp, 0.0, family_of(lines, way_of(choice))}, before);
  });
}

double StageBook::change(int from, int to) const {
  return from == kNoSetUp || from == to ? 0.0 : set_ups_[from].change_to(set_ups_[to], weights_);
}

}  // namespace planish::brake_detail
