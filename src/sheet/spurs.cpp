#include "spurs.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <optional>
#include <utility>

namespace planish {
namespace {

struct Piece {
  Curve2 curve;
  std::vector<Origin> origins;
};

double distance_to_line(const Vec2& p, const Segment& line) {
  const Vec2 along = (line.b - line.a).normalized(), d = p - line.a;
  return std::abs(along.x() * d.y() - along.y() * d.x());
}

double length_of(const Segment& segment) { return (segment.b - segment.a).norm(); }

/// Whether the path turns round between the two pieces and comes back on its own line.
bool turns_round(const Segment& there, const Segment& back, double tolerance) {
  if ((there.b - there.a).dot(back.b - back.a) >= 0.0) return false;
  return length_of(there) > length_of(back) ? distance_to_line(back.b, there) <= tolerance
                                            : distance_to_line(there.a, back) <= tolerance;
}

/// The path so far, in which no piece runs back along the one before.
class Path {
 public:
  explicit Path(double tolerance) : tolerance_(tolerance) {}

  void append(Piece piece) {
    while (auto rest = folded_back(pieces_.empty() ? nullptr : &pieces_.back(), piece)) {
      pieces_.pop_back();
      if (rest->before) return pieces_.push_back(std::move(*rest->before));
      if (!rest->after) return;
      piece = std::move(*rest->after);
    }
    pieces_.push_back(std::move(piece));
  }

  /// The last piece and the first follow each other too.
  void close() {
    while (pieces_.size() > 1) {
      auto rest = folded_back(&pieces_.back(), pieces_.front());
      if (!rest) return;
      pieces_.pop_back();
      pieces_.pop_front();
      if (rest->before) pieces_.push_back(std::move(*rest->before));
      if (rest->after) pieces_.push_front(std::move(*rest->after));
    }
  }

  const std::deque<Piece>& pieces() const { return pieces_; }
  const std::vector<Segment>& slits() const { return slits_; }

 private:
  struct Rest {
    std::optional<Piece> before, after;
  };

  /// What is left of two pieces that turn round between them; nothing when they do not.
  std::optional<Rest> folded_back(const Piece* before, const Piece& after) {
    if (before == nullptr) return std::nullopt;
    const auto* there = std::get_if<Segment>(&before->curve);
    const auto* back = std::get_if<Segment>(&after.curve);
    if (there == nullptr || back == nullptr || !turns_round(*there, *back, tolerance_))
      return std::nullopt;
    const double longer = length_of(*there) - length_of(*back);
    Rest rest;
    if (longer > tolerance_) {
      slits_.push_back({back->a, back->b});
      rest.before = Piece{Segment{there->a, back->b}, before->origins};
    } else {
      slits_.push_back({there->b, there->a});
      if (longer < -tolerance_) rest.after = Piece{Segment{there->a, back->b}, after.origins};
    }
    return rest;
  }

  double tolerance_;
  std::deque<Piece> pieces_;
  std::vector<Segment> slits_;
};

/// Both as one where they lie in one line and touch.
std::optional<Segment> joined(const Segment& a, const Segment& b, double tolerance) {
  const Segment& longer = length_of(a) < length_of(b) ? b : a;
  const Segment& other = length_of(a) < length_of(b) ? a : b;
  if (distance_to_line(other.a, longer) > tolerance ||
      distance_to_line(other.b, longer) > tolerance)
    return std::nullopt;
  const Vec2 along = (longer.b - longer.a).normalized();
  const auto at = [&](const Vec2& p) { return along.dot(p - longer.a); };
  const auto [from, to] = std::minmax({at(other.a), at(other.b)});
  if (from > length_of(longer) + tolerance || to < -tolerance) return std::nullopt;
  const Vec2 &first = at(other.a) < at(other.b) ? other.a : other.b,
             &last = at(other.a) < at(other.b) ? other.b : other.a;
  return Segment{from < 0.0 ? first : longer.a, to > length_of(longer) ? last : longer.b};
}

std::vector<Segment> joined(std::vector<Segment> pieces, double tolerance) {
  std::vector<Segment> whole;
  while (!pieces.empty()) {
    Segment slit = pieces.back();
    pieces.pop_back();
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (const auto both = joined(slit, pieces[i], tolerance)) {
        slit = *both;
        pieces.erase(pieces.begin() + static_cast<std::ptrdiff_t>(i));
        i = static_cast<std::size_t>(-1);
      }
    whole.push_back(slit);
  }
  std::reverse(whole.begin(), whole.end());
  return whole;
}

}  // namespace

WithoutSpurs without_spurs(const Contour& contour, double tolerance) {
  Path path(tolerance);
  for (std::size_t i = 0; i < contour.loop.size(); ++i)
    path.append(
        {contour.loop[i], i < contour.origins.size() ? contour.origins[i] : std::vector<Origin>{}});
  path.close();
  WithoutSpurs result;
  if (path.slits().empty()) return {contour, {}};
  for (const Piece& piece : path.pieces()) {
    result.contour.loop.push_back(piece.curve);
    result.contour.origins.push_back(piece.origins);
  }
  result.slits = joined(path.slits(), tolerance);
  return result;
}

}  // namespace planish
