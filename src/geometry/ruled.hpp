#pragma once

#include <planish/geometry/developable.hpp>

#include <array>
#include <vector>

namespace planish::geometry_detail {

/// A ruled surface at u: directrix b, ruling g, normal n, and across = g × n, the direction in the
/// tangent plane perpendicular to the ruling towards growing u. Primes are d/du.
struct RulingFrame {
  Vec3 b, b_prime;
  Vec3 g, g_prime;
  Vec3 n, n_prime;
  Vec3 across;
};
RulingFrame frame_at(const Ruled& ruled, double u);

/// `parameters_of` for ruled surfaces.
Vec2 nearest_on(const Ruled& ruled, const Vec3& p, double u_near);

/// The development of one offset of a ruled surface. Where the surface has ruling g and point b(u),
/// the plane has G = (cos ψ, sin ψ) and B(u). A developable's tangent plane turns only about its
/// rulings, so plane and surface see the same rates (math.md#general-developable):
///   ψ′ = −g′·across,  B′ = (b′·g) G + (b′·across) (sin ψ, −cos ψ).
/// Both are integrated with Chebyshev series on spans, halved until the last terms are below 1e-13
/// of the extent.
class RuledImage {
 public:
  RuledImage(const Ruled& ruled, double offset);

  Vec2 develop(const Vec2& uv) const;
  Vec2 fold(const Vec2& p) const;
  Eigen::Matrix2d jacobian(const Vec2& uv) const;

 private:
  static constexpr std::size_t kTerms = 10;
  /// Chebyshev series of (B_x, B_y, ψ) and its rate over [begin, end].
  struct Span {
    double begin, end;
    std::array<Vec3, kTerms> rate;
    std::array<Vec3, kTerms + 1> state;
  };
  /// The image of one ruling.
  struct Line {
    double u;
    Vec3 state, rate;
  };

  static Span integrated(const Ruled& ruled, double offset, double begin, double end,
                         const Vec3& state_at_begin);
  void append(const Ruled& ruled, double offset, double begin, double end, double extent,
              int halvings);
  void move_start_to_origin(double u);
  Line line_at(double u) const;

  std::vector<Span> spans_;
  std::vector<Line> lines_;  // at the ends of the spans
};

}  // namespace planish::geometry_detail
