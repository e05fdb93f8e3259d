// Strips stay where the second derivative of the Lagrange function of all of them is positive along
// what is free to them together. What a strip by itself cannot leave is taken out of its numbers;
// contacts, which two strips share, are made so stiff that a motion against them cannot pay
// (Finsler's lemma), as that keeps blocks of strips apart. A contact's direction is fixed to the
// quad on which it is: it turns with it, and the force of one strip on the other with both. If the
// matrix is not positive, its eigenvectors of negative eigenvalues tell which strips move.
#include "stability.hpp"

#include "block_matrix.hpp"
#include "strip_objective.hpp"

#include <planish/base/tolerance.hpp>
#include <planish/base/union_find.hpp>

#include <Eigen/QR>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <optional>
#include <utility>

namespace planish::slit_detail {
namespace {

/// The numbers of a strip that its ends, limits and the ground leave free, in an orthonormal basis.
class FreeNumbers {
 public:
  FreeNumbers(const RestingStrip& strip, const std::vector<EndCondition>& ends)
      : units_(units_of(strip.problem().base)) {
    Eigen::MatrixXd held = units_.asDiagonal() * strip.held(ends);
    for (Eigen::Index i = 0; i < held.cols(); ++i)
      held.col(i).normalize();  // one that is zero stays so
    if (held.cols() == 0) return;
    split_.compute(held);
    rank_ = split_.rank();
  }

  int count() const { return static_cast<int>(units_.size() - rank_); }

  /// Derivatives by all numbers, a column for each, as those by the free ones.
  Eigen::MatrixXd of(const Eigen::MatrixXd& derivatives) const {
    Eigen::MatrixXd turned = units_.asDiagonal() * derivatives;
    if (rank_ > 0) turned.applyOnTheLeft(split_.householderQ().adjoint());
    return turned.bottomRows(count());
  }
  Eigen::MatrixXd both_of(const Eigen::MatrixXd& hessian) const {
    return of(of(hessian).transpose());
  }

 private:
  Eigen::VectorXd units_;
  Eigen::ColPivHouseholderQR<Eigen::MatrixXd> split_;
  Eigen::Index rank_ = 0;
};

/// What the other half of a sheet leaves free to the one half while it does the opposite.
std::vector<EndCondition> swaying(const RestingStrip& strip) {
  using Of = EndCondition::Of;
  if (strip.problem().far_facet) return strip.problem().ends;  // the uncut sheet there holds it
  const Vec3& across = strip.fold().quad(strip.problem().base.quads - 1).y;
  return {{Of::middle, Vec3::UnitY(), 0.0},
          {Of::middle, Vec3::UnitZ(), 0.0},
          {Of::across, Vec3::UnitX().cross(across), 0.0}};
}

/// The quad on which a point is.
int quad_of(const StripPoint& point, int quads) {
  int ridge = quads;
  for (const StripPoint::Share& share : point.shares)
    ridge = std::min(ridge, share.ridge);
  return std::min(ridge, quads - 1);
}

/// Columns, to which others are added.
class Columns {
 public:
  void add(const Eigen::MatrixXd& columns) {
    const Eigen::Index before = all_.cols();
    all_.conservativeResize(columns.rows(), before + columns.cols());
    all_.rightCols(columns.cols()) = columns;
  }
  const Eigen::MatrixXd& all() const { return all_; }

 private:
  Eigen::MatrixXd all_;
};

/// All that two strips, the earlier one first, share.
struct Shared {
  Columns first, second;              ///< derivatives of distances that contacts keep, side by side
  Columns turns_first, turns_second;  ///< products of columns: second derivatives
};

/// A motion, and which strips take part in it.
struct Motion {
  Eigen::VectorXd by_numbers;
  std::vector<bool> moves;
};

/// The strips' second derivatives by their free numbers. `kept`: contacts that hold both ways.
class Together {
 public:
  Together(const std::vector<const RestingStrip*>& strips, const std::vector<Contact>& kept,
           double unit, bool sways)
      : strips_(strips), free_(free_numbers(strips, sways)), matrix_(counts_of(free_)) {
    for (int i = 0; i < matrix_.rows(); ++i)
      matrix_.on_diagonal(i) = free_[i].both_of(strips[i]->of_lagrange_function());
    std::map<std::pair<int, int>, Shared> shared;
    for (const Contact& contact : kept)
      add(contact, unit, shared[std::minmax(contact.here.strip, contact.there.strip)]);
    for (int i = 0; i < matrix_.rows(); ++i)
      if (matrix_.size(i) > 0)
        stiffest_ = std::max(stiffest_, matrix_.on_diagonal(i).diagonal().cwiseAbs().maxCoeff());
    for (const auto& [pair, its] : shared)
      hold(pair.first, pair.second, its);
    for (int i = 0; i < matrix_.rows(); ++i)
      matrix_.on_diagonal(i).diagonal().array() += strips[i]->next_to_nothing() +
                                                   tolerance::kRounding * stiffest_;
  }

  /// Motions that lose energy, the one that loses most first; each across all others.
  std::vector<Motion> losing() const {
    std::vector<Motion> all;
    if (BlockCholesky::of(matrix_, 0.0)) return all;
    Eigen::MatrixXd found(matrix_.dimensions(), 0);
    constexpr int kMostMotions = 8;
    for (int i = 0; i < kMostMotions; ++i) {
      const Eigen::VectorXd motion = least_motion(found);
      if (motion.dot(matrix_.times(motion)) >= 0.0) break;
      all.push_back({motion, those_that_move(motion)});
      found.conservativeResize(Eigen::NoChange, i + 1);
      found.col(i) = motion;
    }
    return all;
  }

  /// How fast a motion opens a contact, mm.
  double opening(const Contact& contact, const Motion& motion) const {
    const int i = contact.here.strip, j = contact.there.strip;
    return part(motion.by_numbers, i)
               .dot(free_[i].of(strips_[i]->along(contact.here, contact.normal)).col(0)) -
           part(motion.by_numbers, j)
               .dot(free_[j].of(strips_[j]->along(contact.there, contact.normal)).col(0));
  }

 private:
  Eigen::VectorXd part(const Eigen::VectorXd& motion, int strip) const {
    return motion.segment(matrix_.begin(strip), matrix_.size(strip));
  }

  /// A strip moves that has no small part in a motion.
  std::vector<bool> those_that_move(const Eigen::VectorXd& motion) const {
    constexpr double kTakesPart = 0.2;  // of that of the strip that moves most
    Eigen::VectorXd parts(matrix_.rows());
    for (int i = 0; i < matrix_.rows(); ++i)
      parts[i] = part(motion, i).norm();
    std::vector<bool> move;
    for (int i = 0; i < matrix_.rows(); ++i)
      move.push_back(parts[i] > kTakesPart * parts.maxCoeff());
    return move;
  }

  void add(const Contact& contact, double unit, Shared& shared) {
    const int i = contact.here.strip, j = contact.there.strip;
    const RestingStrip &here = *strips_[i], &there = *strips_[j];
    const Eigen::MatrixXd of_here = free_[i].of(here.along(contact.here, contact.normal)),
                          of_there = free_[j].of(there.along(contact.there, -contact.normal));
    (i < j ? shared.first : shared.second).add(of_here);
    (i < j ? shared.second : shared.first).add(of_there);
    // The normal turns with the quad on which it is.
    const double force = contact.multiplier / unit;
    const int quad = quad_of(contact.there, there.problem().base.quads);
    const Eigen::Matrix3Xd turning = there.turning(quad, contact.normal);
    const Vec3 apart = contact.here.in(here.fold()) - contact.there.in(there.fold());
    Eigen::MatrixXd moved_here(here.parameters(), 3), moved_there(there.parameters(), 3);
    for (int axis = 0; axis < 3; ++axis) {
      moved_here.col(axis) = here.along(contact.here, Vec3::Unit(axis));
      moved_there.col(axis) = there.along(contact.there, Vec3::Unit(axis));
    }
    Eigen::MatrixXd own = force * moved_there * turning;
    own += own.transpose().eval();
    // A quad's turn, squared, shortens what stands on it.
    own += force * apart.dot(contact.normal) * turning.transpose() * turning;
    matrix_.on_diagonal(j) += free_[j].both_of(own);
    const Eigen::MatrixXd a = free_[i].of(-force * moved_here),
                          b = free_[j].of(turning.transpose());
    (i < j ? shared.turns_first : shared.turns_second).add(a);
    (i < j ? shared.turns_second : shared.turns_first).add(b);
  }

  /// Distances that contacts keep, as far as they differ.
  void hold(int i, int j, const Shared& shared) {
    constexpr double kStiff = 1e5;
    Eigen::MatrixXd kept(matrix_.size(i) + matrix_.size(j), shared.first.all().cols());
    kept.topRows(matrix_.size(i)) = shared.first.all();
    kept.bottomRows(matrix_.size(j)) = shared.second.all();
    for (Eigen::Index c = 0; c < kept.cols(); ++c)
      kept.col(c).normalize();
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> split(kept);
    const Eigen::MatrixXd basis = split.householderQ() *
                                  Eigen::MatrixXd::Identity(kept.rows(), split.rank());
    const Eigen::MatrixXd a = basis.topRows(matrix_.size(i)), b = basis.bottomRows(matrix_.size(j));
    const double stiff = kStiff * stiffest_;
    matrix_.on_diagonal(i) += stiff * a * a.transpose();
    matrix_.on_diagonal(j) += stiff * b * b.transpose();
    Columns of_i, of_j;
    of_i.add(stiff * a);
    of_i.add(shared.turns_first.all());
    of_j.add(b);
    of_j.add(shared.turns_second.all());
    matrix_.couple(i, j, of_i.all(), of_j.all());
  }

  /// The eigenvector of the least eigenvalue beside those found, by inverse iteration from just
  /// below it.
  Eigen::VectorXd least_motion(const Eigen::MatrixXd& found) const {
    constexpr int kBisections = 60, kIterations = 40;
    constexpr double kLittle = 1e-3, kJustBelow = 0.01;  // of what is added
    double low = 0.0, high = matrix_.bound();            // added: not positive, positive
    std::optional<BlockCholesky> factors = BlockCholesky::of(matrix_, high);
    for (int i = 0; i < kBisections && high - low > kJustBelow * high; ++i) {
      const double middle = low > 0.0 ? std::sqrt(low * high) : kLittle * high;
      if (auto tried = BlockCholesky::of(matrix_, middle))
        high = middle, factors = std::move(tried);
      else
        low = middle;
    }
    Eigen::VectorXd motion = Eigen::VectorXd::LinSpaced(matrix_.dimensions(), 1.0, 2.0);
    for (int i = 0; i < kIterations; ++i) {
      motion -= found * (found.transpose() * motion);
      motion = factors->solve(motion.normalized());
    }
    motion -= found * (found.transpose() * motion);
    return motion.normalized();
  }

  static std::vector<FreeNumbers> free_numbers(const std::vector<const RestingStrip*>& strips,
                                               bool sways) {
    std::vector<FreeNumbers> all;
    for (const RestingStrip* strip : strips)
      all.emplace_back(*strip, sways ? swaying(*strip) : strip->problem().ends);
    return all;
  }
  static std::vector<int> counts_of(const std::vector<FreeNumbers>& all) {
    std::vector<int> counts;
    for (const FreeNumbers& one : all)
      counts.push_back(one.count());
    return counts;
  }

  const std::vector<const RestingStrip*>& strips_;
  std::vector<FreeNumbers> free_;
  BlockMatrix matrix_;
  double stiffest_ = 0.0;
};

/// The contacts within a group, by its members.
std::vector<Contact> contacts_within(const std::vector<int>& group,
                                     const std::vector<Contact>& contacts) {
  std::vector<Contact> within;
  for (Contact contact : contacts) {
    const auto here = std::ranges::find(group, contact.here.strip),
               there = std::ranges::find(group, contact.there.strip);
    if (here == group.end() || there == group.end()) continue;
    contact.here.strip = static_cast<int>(here - group.begin());
    contact.there.strip = static_cast<int>(there - group.begin());
    within.push_back(std::move(contact));
  }
  return within;
}

/// Strips that contacts join, directly or through others.
std::vector<std::vector<int>> groups_of(int strips, const std::vector<Contact>& contacts) {
  UnionFind joined(strips);
  for (const Contact& contact : contacts)
    joined.unite(contact.here.strip, contact.there.strip);
  std::vector<std::vector<int>> groups(strips);
  for (int strip = 0; strip < strips; ++strip)
    groups[joined.root(strip)].push_back(strip);
  std::erase_if(groups, [](const std::vector<int>& group) { return group.empty(); });
  return groups;
}

/// Of contacts that only touch, the one that a motion closes fastest and the one that its opposite
/// does, if that blocks both; one is enough where one half of a sheet moves forth as the other
/// moves back. Their places in the list, the later one first.
std::vector<int> blocking(const Together& together, const Motion& motion,
                          const std::vector<Contact>& touching, double unit, bool sways) {
  constexpr double kBlocks = 1e-3;  // of the unit, for a motion of unit length
  std::array<double, 2> fastest{};
  std::array<int, 2> which{-1, -1};
  for (int i = 0; i < std::ssize(touching); ++i) {
    const double opening = together.opening(touching[i], motion) / unit;
    const std::size_t closed_by = opening < 0.0 ? 0 : 1;
    if (std::abs(opening) <= std::max(kBlocks, fastest[closed_by])) continue;
    fastest[closed_by] = std::abs(opening);
    which[closed_by] = i;
  }
  if (!sways && (which[0] < 0 || which[1] < 0)) return {};
  std::ranges::sort(which, std::greater());
  return {which.begin(), std::ranges::find(which, -1)};
}

/// Strips of a group that do not stay. Contacts that press hold; of those that only touch, the ones
/// that are found to block a motion.
std::vector<bool> those_that_leave(const std::vector<const RestingStrip*>& strips,
                                   const std::vector<Contact>& contacts, double unit, bool sways) {
  std::vector<Contact> kept, touching;
  for (const Contact& contact : contacts)
    (contact.multiplier > 0.0 ? kept : touching).push_back(contact);
  while (true) {
    const Together together(strips, kept, unit, sways);
    std::vector<bool> leave(strips.size(), false);
    std::vector<int> blocked;
    for (const Motion& motion : together.losing()) {
      blocked = blocking(together, motion, touching, unit, sways);
      if (!blocked.empty()) break;
      for (std::size_t i = 0; i < leave.size(); ++i)
        leave[i] = leave[i] || motion.moves[i];
    }
    if (blocked.empty()) return leave;
    for (const int i : blocked) {
      kept.push_back(touching[i]);
      touching.erase(touching.begin() + i);
    }
  }
}

}  // namespace

std::vector<bool> those_that_stay(const std::vector<RestingStrip>& strips,
                                  const std::vector<Contact>& contacts, double unit,
                                  bool symmetric) {
  std::vector<bool> stay(strips.size(), true);
  for (const std::vector<int>& group : groups_of(static_cast<int>(strips.size()), contacts)) {
    std::vector<const RestingStrip*> members;
    for (const int strip : group)
      members.push_back(&strips[strip]);
    const std::vector<Contact> within = contacts_within(group, contacts);
    for (const bool sways : {false, true}) {
      if (sways && !symmetric) break;
      const std::vector<bool> leave = those_that_leave(members, within, unit, sways);
      for (std::size_t i = 0; i < group.size(); ++i)
        if (leave[i]) stay[group[i]] = false;
    }
  }
  return stay;
}

}  // namespace planish::slit_detail
