#pragma once

#include "line_set.hpp"

#include <planish/brake/stroke_search.hpp>

#include <map>
#include <optional>
#include <set>
#include <unordered_map>
#include <vector>

namespace planish::brake_detail {

/// No tools: those before were taken off, which is paid for, and any may be next.
inline constexpr int kNoTools = -1;
inline constexpr int kOnBed = -2;

/// What stays between two strokes: tools, side, direction; each set-up has a number. Of tools that
/// can stand on the bed together `die` is the number of the bed, and `punch` is kOnBed.
struct SetUp {
  int punch = 0, die = 0;
  bool reference_up = true;
  int direction = 0;
  auto operator<=>(const SetUp&) const = default;

  bool has_tools() const { return punch != kNoTools; }
  SetUp without_tools() const { return {kNoTools, kNoTools, reference_up, direction}; }
  bool has_same_tools(const SetUp& other) const { return punch == other.punch && die == other.die; }
  /// What it costs to go on with another.
  double change_to(const SetUp& other, const StrokeWeights& weights) const {
    return (has_tools() && !has_same_tools(other) ? weights.tool_change : 0.0) +
           (reference_up != other.reference_up ? weights.turn_over : 0.0) +
           (direction != other.direction ? weights.rotate : 0.0);
  }
};

/// What of a choice costs a change.
inline SetUp set_up_of(const StrokeChoice& choice) {
  const bool shared = choice.bed >= 0;
  return {shared ? kOnBed : choice.punch, shared ? choice.bed : choice.die, choice.reference_up,
          choice.direction};
}

/// No stroke has been made yet.
inline constexpr int kNoSetUp = -1;

/// A choice as it was first given; the same choice in other stages has the same number.
struct KnownChoice {
  StrokeChoice choice;
  int set_up = kNoSetUp;
  double cost = 0.0;  ///< of the stroke, without what comes before
  int family = 0;     ///< of the choices that differ in the gauge alone
};

/// Lines by which a choice was infeasible, and which of them were formed.
struct Conflict {
  LineSet lines, formed;
  bool holds_in(const LineSet& stage) const;
};

/// What is known of a choice in all stages together.
struct Family {
  std::vector<Conflict> conflicts = {};
  bool refuted = false;       ///< infeasible in every stage
  std::size_t looked_at = 0;  ///< conflicts, for `refuted`
};

/// Where all these lines are formed, that line cannot be any more.
struct Blocking {
  int line = 0;
  LineSet by;
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
  /// From a dead stage no strokes lead to the full one: all were tried, or a line that is left can
  /// no longer be formed in any way that is possible.
  void mark_dead(int stage) { stages_[stage].dead = true; }
  bool is_dead(const LineSet& formed) const;

  /// What a stage offers; asked when first needed.
  const std::vector<Offer>& offers(int stage);
  /// Whether an offer can be made; asked when first needed.
  bool feasible(int stage, std::size_t offer);
  /// Whether some stroke can be the last: with all other lines formed. Taken for granted where the
  /// lines pressed together are not known, or are many.
  bool can_end();

  const KnownChoice& choice(int number) const { return choices_[number]; }
  const SetUp& set_up(int number) const { return set_ups_[number]; }
  int set_up_of(const SetUp& set_up);
  /// Cost of a change; none from `kNoSetUp`.
  double change(int from, int to) const;

  std::int64_t asked() const { return asked_; }
  /// How often a reason was learned why a choice is infeasible.
  std::int64_t learned() const { return learned_; }
  /// Whether reasons show that a choice is infeasible in every stage.
  bool is_refuted(const StrokeChoice& choice);
  /// Whether a stage that can be reached forms the line, as far as was asked.
  bool seen(int line) const { return holds(seen_, line); }
  const LineSet& furthest() const { return furthest_; }
  const LineSet& full() const { return full_; }
  /// Offers kept, of all stages: what the memory goes to.
  std::int64_t offers_kept() const { return offers_kept_; }

 private:
  static SetUp way_of(const StrokeChoice& choice);
  int number_of(const StrokeChoice& choice);
  bool fits_beginning(const LineSet& formed, const StrokeChoice& choice) const;
  int family_of(const LineSet& lines, const SetUp& set_up);
  void list_families();
  bool is_covered(const StrokeChoice& choice) const;
  bool ask(const KnownChoice& known, const LineSet& formed);
  bool can_end_with(const LineSet& lines);
  void learn(const KnownChoice& known, const LineSet& formed, const LineSet& because);
  std::optional<LineSet> blocked_for_good(int line, const LineSet& formed) const;

  using FamilyKey = std::pair<LineSet, SetUp>;
  using ChoiceKey = std::pair<FamilyKey, bool>;

  const StrokeProblem& problem_;
  StrokeWeights weights_;
  LineSet full_, seen_, furthest_;
  std::unordered_map<LineSet, int, LineSetHash> numbers_;
  std::vector<Stage> stages_;
  std::map<ChoiceKey, int> choice_numbers_;
  std::vector<KnownChoice> choices_;
  std::map<FamilyKey, int> family_numbers_;
  std::vector<Family> families_;
  /// The families in which a line is possible; empty if others may be pressed with it, so that it
  /// is not known which they are.
  std::vector<std::vector<int>> families_of_line_;
  std::vector<std::set<SetUp>> possible_of_line_;
  std::vector<Blocking> blockings_;
  std::map<SetUp, int> set_up_numbers_;
  std::vector<SetUp> set_ups_;
  std::int64_t asked_ = 0, learned_ = 0, offers_kept_ = 0;
};

}  // namespace planish::brake_detail
