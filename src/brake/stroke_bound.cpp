// The least that is still to be paid, whatever stages allow: a tour of set-ups that serves each
// class of lines once, by dynamic programming over the classes left (Held and Karp's), at each
// step relaxed over side, direction and tools one after the other, since a change costs their sum.
// What must hold: it is a lower bound, so tools that are never better count as those that are, and
// of many classes the tour leaves some out (bend.md#search).
#include "stroke_bound.hpp"

#include <planish/base/assert.hpp>

#include <algorithm>
#include <limits>

namespace planish::brake_detail {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr std::size_t kTourSteps = 1 << 16;     // of one tour: about 0.1 ms
constexpr std::size_t kKeptCosts = 20'000'000;  // 160 MB

template <typename Key>
void add_key(std::map<Key, std::size_t>& keys, const Key& key) {
  keys.try_emplace(key, keys.size());
}

/// Whether nothing is cheaper in the second column of a table, whose rows are `width` long.
bool no_dearer(const std::vector<std::vector<double>>& lines, std::size_t width, std::size_t a,
               std::size_t b) {
  for (const std::vector<double>& costs : lines)
    for (std::size_t row = 0; row < costs.size(); row += width)
      if (costs[row + a] > costs[row + b]) return false;
  return true;
}

/// A column of that table.
std::vector<double> column_of(const std::vector<std::vector<double>>& lines, std::size_t width,
                              std::size_t column) {
  std::vector<double> found;
  for (const std::vector<double>& costs : lines)
    for (std::size_t row = column; row < costs.size(); row += width)
      found.push_back(costs[row]);
  return found;
}

}  // namespace

std::size_t StrokeBound::CountsHash::operator()(const Counts& counts) const {
  std::uint64_t hash = 0xCBF29CE484222325u;  // FNV-1a
  for (const std::uint16_t n : counts)
    hash = (hash ^ n) * 0x100000001B3u;
  return hash;
}

StrokeBound::StrokeBound(const StrokeProblem& problem, const StrokeWeights& weights,
                         const std::set<std::size_t>& refuted)
    : weights_(weights), knows_(!problem.possible.empty()), class_of_line_(problem.lines, 0) {
  if (!knows_) return;
  Rows rows;
  for (std::size_t i = 0; i < problem.possible.size(); ++i)
    if (!refuted.contains(i)) rows.push_back(&problem.possible[i]);
  for (const StrokeChoice& choice : problem.possible) {
    add_key(sides_, choice.reference_up);
    add_key(directions_, choice.direction);
    const SetUp set_up = set_up_of(choice);
    add_key(tools_, {set_up.punch, set_up.die});
  }
  size_ = {sides_.size(), directions_.size(), tools_.size()};
  std::vector<Costs> lines = line_costs(rows);
  merge_tools(lines);
  classify(lines);
}

std::size_t StrokeBound::place_of(const SetUp& set_up) const {
  const auto side = sides_.find(set_up.reference_up);
  const auto direction = directions_.find(set_up.direction);
  const auto tools = tools_.find({set_up.punch, set_up.die});
  // A choice that `possible` does not cover.
  PLANISH_ASSERT(side != sides_.end() && direction != directions_.end() && tools != tools_.end());
  return place(side->second, direction->second, tools->second);
}

std::vector<StrokeBound::Costs> StrokeBound::line_costs(const Rows& rows) const {
  std::vector<Costs> lines(class_of_line_.size(), Costs(places(), kNever));
  for (const StrokeChoice* row : rows) {
    const std::vector<int> pressed = members(row->lines);
    const double cost = weights_.of(*row) / static_cast<double>(pressed.size());
    const std::size_t at = place_of(set_up_of(*row));
    for (const int line : pressed)
      lines[line][at] = std::min(lines[line][at], cost);
  }
  return lines;
}

/// Tools that are never better than others are taken for those: that makes no tour dearer. Most
/// differ in nothing, so only the first of each kind is held against the others.
void StrokeBound::merge_tools(std::vector<Costs>& lines) {
  const std::size_t width = size_[2];
  std::map<Costs, std::size_t> kinds;
  std::vector<std::size_t> first, kept, column(width);
  for (std::size_t t = 0; t < width; ++t) {
    const auto [kind, fresh] = kinds.try_emplace(column_of(lines, width, t), t);
    column[t] = kind->second;
    if (fresh) first.push_back(t);
  }
  for (const std::size_t t : first) {
    for (const std::size_t other : first)
      if (other != t && no_dearer(lines, width, other, column[t])) column[t] = other;
    if (column[t] == t) kept.push_back(t);
  }
  for (Costs& costs : lines) {
    Costs merged;
    for (std::size_t row = 0; row < costs.size(); row += width)
      for (const std::size_t t : kept)
        merged.push_back(costs[row + t]);
    costs = std::move(merged);
  }
  for (auto& [pair, number] : tools_) {
    while (column[number] != number)
      number = column[number];
    number = std::ranges::lower_bound(kept, number) - kept.begin();
  }
  size_[2] = kept.size();
}

StrokeBound::LineClass StrokeBound::class_of(const Costs& costs) const {
  LineClass one{costs, *std::ranges::min_element(costs)};
  for (int axis = 0; axis < 3; ++axis)
    one.at[axis].resize(size_[axis]);
  for (std::size_t s = 0; s < size_[0]; ++s)
    for (std::size_t d = 0; d < size_[1]; ++d)
      for (std::size_t t = 0; t < size_[2]; ++t) {
        double& cost = one.above[place(s, d, t)];
        if (cost == kNever) continue;
        one.at[0][s] = one.at[1][d] = one.at[2][t] = true;
        cost -= one.least;
      }
  return one;
}

void StrokeBound::classify(const std::vector<Costs>& lines) {
  std::map<std::pair<long, Costs>, std::vector<int>> members_of;
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const double least = *std::ranges::min_element(lines[line]);
    if (least == kNever) hopeless_.push_back(static_cast<int>(line));
    members_of[{std::ranges::count(lines[line], least), lines[line]}].push_back(
        static_cast<int>(line));
  }
  if (!hopeless_.empty()) return;
  for (const auto& [key, members] : members_of) {
    for (const int line : members)
      class_of_line_[line] = static_cast<int>(classes_.size());
    classes_.push_back(class_of(key.second));
  }
  while (toured_ < classes_.size() && ((toured_ + 1) << (toured_ + 1)) * places() <= kTourSteps)
    ++toured_;
}

double StrokeBound::operator()(const LineSet& formed, const SetUp* from) {
  if (!hopeless_.empty()) return kNever;
  Counts counts(std::max<std::size_t>(classes_.size(), 1));
  bool all = true;
  for (std::size_t line = 0; line < class_of_line_.size(); ++line)
    if (!holds(formed, static_cast<int>(line))) {
      ++counts[class_of_line_[line]];
      all = false;
    }
  if (all) return 0.0;
  if (!knows_) return weights_.stroke;
  const Costs& least = costs(counts);
  if (!from) return *std::ranges::min_element(least);
  if (from->has_tools()) return least[place_of(*from)];
  const std::size_t first = place(sides_.at(from->reference_up), directions_.at(from->direction),
                                  0);
  return *std::min_element(least.begin() + first, least.begin() + first + size_[2]);
}

const StrokeBound::Costs& StrokeBound::costs(const Counts& counts) {
  if (const auto known = known_.find(counts); known != known_.end()) return known->second;
  if (known_.size() * places() > kKeptCosts) known_.clear();
  Costs least(places(), 0.0);
  tour(least, counts);
  if (toured_ < classes_.size()) count_changes(least, counts);
  double strokes = 0.0;
  for (std::size_t c = 0; c < classes_.size(); ++c)
    strokes += counts[c] * classes_[c].least;
  for (double& cost : least)
    cost += strokes;
  return known_.emplace(counts, std::move(least)).first->second;
}

/// Changing sides, direction and tools costs the sum of the three, so one axis after the other.
void StrokeBound::spread(Costs& costs) const {
  const std::array<double, 3> weight{weights_.turn_over, weights_.rotate, weights_.tool_change};
  std::size_t stride = places();
  for (int axis = 0; axis < 3; ++axis) {
    const std::size_t block = stride;
    stride /= size_[axis];
    for (std::size_t from = 0; from < costs.size(); from += block)
      for (std::size_t at = from; at < from + stride; ++at) {
        double least = kNever;
        for (std::size_t i = at; i < from + block; i += stride)
          least = std::min(least, costs[i]);
        for (std::size_t i = at; i < from + block; i += stride)
          costs[i] = std::min(costs[i], least + weight[axis]);
      }
  }
}

void StrokeBound::tour(Costs& least, const Counts& counts) const {
  std::vector<std::size_t> left;
  for (std::size_t c = 0; c < toured_; ++c)
    if (counts[c] > 0) left.push_back(c);
  const std::size_t all = std::size_t{1} << left.size();
  std::vector<Costs> by_mask(all, Costs(places(), kNever));
  by_mask[0].assign(places(), 0.0);
  for (std::size_t mask = 1; mask < all; ++mask) {
    Costs& costs = by_mask[mask];
    for (std::size_t i = 0; i < left.size(); ++i) {
      if ((mask >> i & 1) == 0) continue;
      const Costs& without = by_mask[mask & ~(std::size_t{1} << i)];
      const LineClass& served = classes_[left[i]];
      for (std::size_t at = 0; at < costs.size(); ++at)
        costs[at] = std::min(costs[at], without[at] + counts[left[i]] * served.above[at]);
    }
    spread(costs);
  }
  least = std::move(by_mask[all - 1]);
}

/// From each place of an axis, classes of which no two have a place in common there: each takes a
/// change.
std::vector<double> StrokeBound::changes(const Counts& counts, int axis) const {
  std::vector<const std::vector<bool>*> left;
  for (std::size_t c = 0; c < classes_.size(); ++c)
    if (counts[c] > 0) left.push_back(&classes_[c].at[axis]);
  const auto size = [](const std::vector<bool>* at) { return std::ranges::count(*at, true); };
  std::ranges::stable_sort(left, {}, size);
  std::vector<double> found(size_[axis], 0.0);
  for (std::size_t from = 0; from < found.size(); ++from) {
    std::vector<bool> taken(found.size(), false);
    taken[from] = true;
    for (const std::vector<bool>* at : left) {
      bool free = true;
      for (std::size_t i = 0; i < taken.size(); ++i)
        free = free && !(taken[i] && (*at)[i]);
      if (!free) continue;
      found[from] += 1.0;
      for (std::size_t i = 0; i < taken.size(); ++i)
        if ((*at)[i]) taken[i] = true;
    }
  }
  return found;
}

void StrokeBound::count_changes(Costs& least, const Counts& counts) const {
  const std::vector<double> sides = changes(counts, 0), directions = changes(counts, 1),
                            tools = changes(counts, 2);
  for (std::size_t s = 0; s < size_[0]; ++s)
    for (std::size_t d = 0; d < size_[1]; ++d)
      for (std::size_t t = 0; t < size_[2]; ++t) {
        double& cost = least[place(s, d, t)];
        cost = std::max(cost, weights_.turn_over * sides[s] + weights_.rotate * directions[d] +
                                  weights_.tool_change * tools[t]);
      }
}

}  // namespace planish::brake_detail
