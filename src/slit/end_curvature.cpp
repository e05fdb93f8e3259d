// How what is fixed to the last quad moves to second order: the curvature of the manifold of shapes
// that meet the end conditions (newton.cpp), and of the fold into a panel at the end. What must
// hold: a strip is a product of turns, each about a line of the flat sheet, so a number of one
// ridge does not change another's turn (math.md#strip-folding).
#include "end_curvature.hpp"

#include "second_jet.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace planish::slit_detail {
namespace {

constexpr int kOfRidge = 3;  // its fold, and where its ends are
using Second = SecondJet<kOfRidge>;

template <typename T>
using Three = std::array<T, 3>;

template <typename T>
using Two = std::array<T, 2>;

/// A place of an edge by a step along it, to second order.
Two<Second> stepped(const EdgePlace& place, const Second& step) {
  const Second half_square = constant<Second>(0.5) * step * step;
  Two<Second> at;
  for (int axis = 0; axis < 2; ++axis)
    at[axis] = constant<Second>(place.at[axis]) + constant<Second>(place.first[axis]) * step +
               constant<Second>(place.second[axis]) * half_square;
  return at;
}

/// Of a vector in the coordinates of the quad behind a ridge, in those of the quad before it:
/// turned about the line from left to right.
template <typename T>
Three<T> turned(const T& fold, const Two<T>& left, const Two<T>& right, bool is_point,
                const Vec3& v) {
  using std::cos, std::sin, std::sqrt;
  const T z = constant<T>(v.z());
  const T x = is_point ? constant<T>(v.x()) - left[0] : constant<T>(v.x()),
          y = is_point ? constant<T>(v.y()) - left[1] : constant<T>(v.y());
  const T along = right[0] - left[0], across = right[1] - left[1],
          length = sqrt(along * along + across * across);
  const T ax = along / length, ay = across / length, c = cos(fold), s = sin(fold);
  const T dot = (constant<T>(1.0) - c) * (ax * x + ay * y);
  Three<T> result{c * x + s * ay * z + dot * ax, c * y - s * ax * z + dot * ay,
                  c * z + s * (ax * y - ay * x)};
  if (is_point) {
    result[0] += left[0];
    result[1] += left[1];
  }
  return result;
}

/// Those of one ridge's own numbers, fold first.
Eigen::Matrix3d of_ridge(const StripParameters& p, const StripFold& fold, int ridge,
                         const std::vector<WeighedVector>& sum) {
  const Second angle = variable<kOfRidge>(p[ridge], 0);
  const Two<Second> left = stepped(fold.flat[0][ridge], variable<kOfRidge>(0.0, 1)),
                    right = stepped(fold.flat[1][ridge], variable<kOfRidge>(0.0, 2));
  const Frame &before = fold.frames[ridge], &behind = fold.quad(ridge);
  Eigen::Matrix3d all = Eigen::Matrix3d::Zero();
  for (const WeighedVector& one : sum) {
    if (one.ridge <= ridge) continue;
    const Vec3 from = one.is_point ? Vec3(one.at - behind.origin) : one.at;
    const Vec3 local(from.dot(behind.x), from.dot(behind.y), from.dot(behind.z));
    const Three<Second> v = turned(angle, left, right, one.is_point, local);
    const Vec3 weight(one.weight.dot(before.x), one.weight.dot(before.y), one.weight.dot(before.z));
    for (int i = 0; i < kOfRidge; ++i)
      for (int j = 0; j < kOfRidge; ++j)
        for (int k = 0; k < 3; ++k)
          all(i, j) += weight[k] * v[k].v[i].v[j];
  }
  return all;
}

std::vector<Behind> behind_ridges(int quads, const std::vector<WeighedVector>& sum) {
  std::vector<Behind> behind(quads);
  for (const WeighedVector& one : sum) {
    if (one.ridge < 1) continue;
    Behind& last = behind[std::min(one.ridge, quads) - 1];
    if (one.is_point) last.force += one.weight;
    last.moment += one.at * one.weight.transpose();
  }
  for (int ridge = quads - 2; ridge >= 0; --ridge) {
    behind[ridge].force += behind[ridge + 1].force;
    behind[ridge].moment += behind[ridge + 1].moment;
  }
  return behind;
}

/// The same as vectors: one point and three directions.
std::vector<WeighedVector> as_vectors(const Behind& behind, const Vec3& at, int ridge) {
  const Eigen::Matrix3d about = behind.about(at);
  std::vector<WeighedVector> sum{{ridge + 1, true, at, behind.force}};
  for (int axis = 0; axis < 3; ++axis)
    sum.push_back({ridge + 1, false, Vec3::Unit(axis), about.row(axis).transpose()});
  return sum;
}

/// The earlier of two turns carries along what the later one does.
Eigen::MatrixXd of_different_ridges(const std::vector<Twist>& all,
                                    const std::vector<Behind>& behind) {
  const auto count = static_cast<Eigen::Index>(all.size());
  const auto twist = [&](Eigen::Index q) -> const Twist& { return all[q]; };
  Eigen::Matrix3Xd carried(3, count);
  for (Eigen::Index q = 0; q < count; ++q) {
    const Eigen::Matrix3d about = behind[twist(q).ridge].about(twist(q).pole);
    carried.col(q) = about * twist(q).axis - about.trace() * twist(q).axis;
  }
  Eigen::MatrixXd second(count, count);
  for (Eigen::Index a = 0; a < count; ++a)
    for (Eigen::Index b = 0; b <= a; ++b) {
      const bool a_first = twist(a).ridge < twist(b).ridge;
      second(a, b) = second(b, a) = a_first ? twist(a).axis.dot(carried.col(b))
                                            : twist(b).axis.dot(carried.col(a));
    }
  return second;
}

/// A ridge's end that slides along its quad's edge is carried by the turns before, and goes round
/// with the edge.
void add_sliding(Eigen::MatrixXd& second, const StripBase& base, const StripFold& fold,
                 const std::vector<Twist>& all, const WeighedVector& end) {
  const EdgePlace& place = fold.flat[end.side][end.ridge];
  const Vec3 along = base.unit() * fold.before(end.ridge, place.first);
  const int own = abscissa_index(base.quads, end.ridge, end.side);
  second(own, own) += base.unit() * base.unit() *
                      fold.before(end.ridge, place.second).dot(end.weight);
  for (std::size_t q = 0; q < all.size(); ++q) {
    if (all[q].ridge >= end.ridge) continue;
    const double mixed = all[q].axis.cross(along).dot(end.weight);
    second(own, static_cast<Eigen::Index>(q)) += mixed;
    second(static_cast<Eigen::Index>(q), own) += mixed;
  }
}

/// Where a ridge's numbers stand, in the order of `of_ridge`, and how many it has.
struct Numbers {
  std::array<int, kOfRidge> at{};
  int count = 1;
};
Numbers numbers_of(const StripBase& base, int ridge) {
  if (ridge == 0) return {{0, 0, 0}, 1};
  return {{ridge, abscissa_index(base.quads, ridge, 0), abscissa_index(base.quads, ridge, 1)}, 3};
}

/// The part that belongs to one ridge's own numbers.
void set_of_ridge(Eigen::MatrixXd& second, const StripBase& base, const StripParameters& p,
                  const StripFold& fold, int ridge, const std::vector<WeighedVector>& sum) {
  const Eigen::Matrix3d own = of_ridge(p, fold, ridge, sum);
  const Numbers numbers = numbers_of(base, ridge);
  for (int i = 0; i < numbers.count; ++i)
    for (int j = 0; j < numbers.count; ++j)
      second(numbers.at[i], numbers.at[j]) = own(i, j) * (i ? base.unit() : 1.0) *
                                             (j ? base.unit() : 1.0);
}

}  // namespace

Eigen::MatrixXd second_derivatives(const StripBase& base, const StripParameters& p,
                                   const StripFold& fold, const std::vector<Twist>& twists,
                                   const std::vector<Behind>& behind) {
  Eigen::MatrixXd second = of_different_ridges(twists, behind);
  for (int ridge = 0; ridge < base.quads; ++ridge)
    set_of_ridge(second, base, p, fold, ridge,
                 as_vectors(behind[ridge], fold.end(0, ridge), ridge));
  return second;
}

Eigen::MatrixXd second_derivatives(const StripBase& base, const StripParameters& p,
                                   const StripFold& fold, const std::vector<WeighedVector>& sum) {
  const std::vector<Twist> all = twists(base, fold);
  Eigen::MatrixXd second = second_derivatives(base, p, fold, all, behind_ridges(base.quads, sum));
  for (const WeighedVector& one : sum)
    if (one.side >= 0 && one.ridge < base.quads) add_sliding(second, base, fold, all, one);
  return second;
}

std::vector<WeighedVector> weighed_conditions(const StripProblem& problem, const StripFold& fold,
                                              const Eigen::VectorXd& multipliers) {
  std::vector<WeighedVector> sum;
  for (std::size_t i = 0; i < problem.ends.size(); ++i) {
    const EndCondition& condition = problem.ends[i];
    const bool is_point = condition.is_length();
    const double scale = is_point ? 1.0 / problem.base.unit() : 1.0;
    sum.push_back({problem.base.quads, is_point, end_vector(condition.of, problem.base, fold),
                   scale * multipliers[static_cast<Eigen::Index>(i)] * condition.gradient});
  }
  return sum;
}

}  // namespace planish::slit_detail
