#pragma once

#include "line_set.hpp"

#include <planish/brake/stroke_search.hpp>

#include <array>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

namespace planish::brake_detail {

/// What stays between two strokes: tools, side, direction; each set-up has a number.
struct SetUp {
  int punch = 0, die = 0;
  bool reference_up = true;
  int direction = 0;
  auto operator<=>(const SetUp&) const = default;
};

/// No stroke has been made yet.
inline constexpr int kNoSetUp = -1;

/// A choice as it was first given; the same choice in other stages has the same number.
struct KnownChoice {
  StrokeChoice choice;
  int set_up = kNoSetUp;
  double cost = 0.0;     ///< of the stroke, without what comes before
  bool refuted = false;  ///< infeasible in every stage
  /// Lines by which it was infeasible, and which of them were formed.
  std::vector<std::array<LineSet, 2>> conflicts = {};
};

/// A choice that a stage offers.
struct Offer {
  enum class State : signed char { unknown, feasible, infeasible };
  int choice = 0;
  State state = State::unknown;
};

struct Stage {
  const LineSet* formed = nullptr;
  bool asked = false, dead = false;
  std::vector<Offer> offers = {};
};

/// The stages that a search meets, with what was asked about them. Each question is asked once.
class StageBook {
 public:
  StageBook(const StrokeProblem& problem, const StrokeWeights& weights);

  /// The number of a stage, new or known.
  int stage_of(const LineSet& formed);
  const Stage& operator[](int stage) const { return stages_[stage]; }
  /// The number of a stage that was met before.
  std::optional<int> find(const LineSet& formed) const;
  bool is_full(int stage) const { return *stages_[stage].formed == full_; }
  /// From a dead stage no strokes lead to the full one.
  void mark_dead(int stage) { stages_[stage].dead = true; }
  bool is_dead(const LineSet& formed) const;

  /// What a stage offers; asked when first needed.
  const std::vector<Offer>& offers(int stage);
  /// Whether an offer can be made; asked when first needed.
  bool feasible(int stage, std::size_t offer);

  const KnownChoice& choice(int number) const { return choices_[number]; }
  const SetUp& set_up(int number) const { return set_ups_[number]; }
  int set_up_of(const SetUp& set_up);
  /// Cost of a change; none from `kNoSetUp`.
  double change(int from, int to) const;

  std::int64_t asked() const { return asked_; }
  /// Choices that were shown infeasible in every stage so far.
  std::int64_t refuted() const { return refuted_; }
  bool is_refuted(const StrokeChoice& choice) const;
  /// Whether a stage that can be reached forms the line, as far as was asked.
  bool seen(int line) const { return holds(seen_, line); }
  const LineSet& furthest() const { return furthest_; }
  const LineSet& full() const { return full_; }
  /// Offers kept, of all stages: what the memory goes to.
  std::int64_t offers_kept() const { return offers_kept_; }

 private:
  static SetUp set_up_in(const StrokeChoice& choice);
  int number_of(const StrokeChoice& choice);
  bool fits_beginning(const LineSet& formed, const StrokeChoice& choice) const;
  bool conflicts(const KnownChoice& known, const LineSet& formed) const;
  bool ask(KnownChoice& known, const LineSet& formed);

  struct ChoiceKey {
    LineSet lines;
    SetUp set_up;
    bool gauged;
    auto operator<=>(const ChoiceKey&) const = default;
  };

  const StrokeProblem& problem_;
  StrokeWeights weights_;
  LineSet full_, seen_, furthest_;
  std::unordered_map<LineSet, int, LineSetHash> numbers_;
  std::vector<Stage> stages_;
  std::map<ChoiceKey, int> choice_numbers_;
  std::vector<KnownChoice> choices_;
  std::map<SetUp, int> set_up_numbers_;
  std::vector<SetUp> set_ups_;
  std::int64_t asked_ = 0, refuted_ = 0, offers_kept_ = 0;
};

}  // namespace planish::brake_detail
