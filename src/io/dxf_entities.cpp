#include "dxf_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string_view>

// DXF entities, of which dxflib writes only some as readers want them. A Bézier chain becomes one
// B-spline: at a joint whose spans can run at one speed a knot and the joint's pole are taken out,
// so that the curve is C1 even for readers that cut it at triple knots; elsewhere all three knots
// stay. Arcs run counter-clockwise, and letters beyond ASCII are written as \U+XXXX.

namespace planish::io_detail {
namespace {

constexpr int kPlanarSpline = 8;
constexpr int kClosed = 1;

/// Head of an entity. Not dxflib's, which leaves out the linetype with R12.
void begin(DxfWriter& w, const char* type, const char* subclass, const EntityStyle& style,
           double dash_scale = 1.0) {
  w.entity(type);
  if (!w.r12()) w.subClass("AcDbEntity");
  w.dxfString(8, style.layer);
  w.linetype(style.dashed ? "DASHED" : "CONTINUOUS");
  w.color(style.color);
  if (!w.r12() && dash_scale != 1.0) w.linetypeScale(dash_scale);
  if (!w.r12()) w.subClass(subclass);
}

void write(DxfWriter& w, const EntityStyle& style, const Circle& circle) {
  begin(w, "CIRCLE", "AcDbCircle", style);
  w.coord(10, circle.center.x(), circle.center.y());
  w.dxfReal(40, circle.radius);
}

void write_lwpolyline(DxfWriter& w, const EntityStyle& style, const Polyline& polyline) {
  begin(w, "LWPOLYLINE", "AcDbPolyline", style);
  w.dxfInt(90, static_cast<int>(polyline.vertices.size()));
  w.dxfInt(70, kClosed);
  for (const BulgeVertex& v : polyline.vertices) {
    w.dxfReal(10, v.point.x());
    w.dxfReal(20, v.point.y());
    if (v.bulge != 0.0) w.dxfReal(42, v.bulge);
  }
}

void write_r12_polyline(DxfWriter& w, const EntityStyle& style, const Polyline& polyline) {
  begin(w, "POLYLINE", "", style);
  w.dxfInt(66, 1);  // vertices follow
  w.coord(10, 0.0, 0.0);
  w.dxfInt(70, kClosed);
  for (const BulgeVertex& v : polyline.vertices) {
    w.entity("VERTEX");
    w.dxfString(8, style.layer);
    w.coord(10, v.point.x(), v.point.y());
    if (v.bulge != 0.0) w.dxfReal(42, v.bulge);
  }
  w.entity("SEQEND");
  w.dxfString(8, style.layer);
}

void write(DxfWriter& w, const EntityStyle& style, const Polyline& polyline) {
  if (w.r12()) {
    write_r12_polyline(w, style, polyline);
  } else {
    write_lwpolyline(w, style, polyline);
  }
}

double degrees_in_turn(double radians) {
  const double degrees = std::fmod(radians * 180.0 / std::numbers::pi, 360.0);
  return degrees < 0.0 ? degrees + 360.0 : degrees;
}

void write(DxfWriter& w, const EntityStyle& style, const Arc& arc) {
  const double end = arc.start + arc.sweep;
  begin(w, "ARC", "AcDbCircle", style);
  w.coord(10, arc.center.x(), arc.center.y());
  w.dxfReal(40, arc.radius);
  if (!w.r12()) w.subClass("AcDbArc");
  // DXF arcs run counter-clockwise.
  w.dxfReal(50, degrees_in_turn(arc.sweep > 0.0 ? arc.start : end));
  w.dxfReal(51, degrees_in_turn(arc.sweep > 0.0 ? end : arc.start));
}

void write(DxfWriter& w, const EntityStyle& style, const Segment& line) {
  write_line(w, style, line, 1.0);
}

/// A Bézier chain as a B-spline: at a joint either all three knots stay, or, if the spans can be
/// parametrised with one speed, the joint's pole and one of its knots are removed, so that the
/// curve is C1 even for readers that cut it at triple knots.
struct BSpline {
  std::vector<Vec2> poles;
  std::vector<double> knots;
};

BSpline b_spline(const CubicSpline& chain) {
  const auto& p = chain.poles;
  BSpline result{{p[0], p[1]}, {0.0, 0.0, 0.0, 0.0}};
  double knot = 1.0;
  double width = 1.0;
  for (std::size_t joint = 3; joint + 1 < p.size(); joint += 3) {
    const Vec2 before = p[joint] - p[joint - 1];
    const Vec2 after = p[joint + 1] - p[joint];
    const double speed = after.norm() / before.norm();
    // Speeds and widths outside these are a sign of handles without length; then start again.
    constexpr double kSlowest = 1e-3, kFastest = 1e3, kNarrowest = 1e-6, kWidest = 1e6;
    constexpr double kStraight = 1e-10;  // units of the file
    const bool sane = speed > kSlowest && speed < kFastest && width * speed < kWidest &&
                      width * speed > kNarrowest;
    const bool smooth = sane && (after - speed * before).norm() < kStraight;
    result.poles.push_back(p[joint - 1]);
    if (!smooth) result.poles.push_back(p[joint]);
    result.poles.push_back(p[joint + 1]);
    result.knots.insert(result.knots.end(), smooth ? 2 : 3, knot);
    width = smooth ? width * speed : 1.0;
    knot += width;
  }
  result.poles.push_back(p[p.size() - 2]);
  result.poles.push_back(p.back());
  result.knots.insert(result.knots.end(), 4, knot);
  return result;
}

void write(DxfWriter& w, const EntityStyle& style, const CubicSpline& chain) {
  const BSpline spline = b_spline(chain);
  begin(w, "SPLINE", "AcDbSpline", style);
  w.coord(210, 0.0, 0.0, 1.0);
  w.dxfInt(70, kPlanarSpline);
  w.dxfInt(71, 3);
  w.dxfInt(72, static_cast<int>(spline.knots.size()));
  w.dxfInt(73, static_cast<int>(spline.poles.size()));
  w.dxfInt(74, 0);
  for (const double knot : spline.knots)
    w.dxfReal(40, knot);
  for (const Vec2& pole : spline.poles)
    w.coord(10, pole.x(), pole.y());
}

void write(DxfWriter& w, const EntityStyle& style, const Loop& chain) {
  for (const Curve2& curve : chain) {
    std::visit([&](const auto& c) { write(w, style, c); }, curve);
  }
}

/// UTF-8 as ASCII: what lies beyond as \U+XXXX, control characters as spaces.
std::string without_others(const std::string& text) {
  std::string written;
  for (std::size_t i = 0; i < text.size();) {
    const auto lead = static_cast<unsigned char>(text[i]);
    const int more = lead < 0xC0 ? 0 : lead < 0xE0 ? 1 : lead < 0xF0 ? 2 : 3;
    unsigned code = more == 0 ? lead : lead & (0x3Fu >> more);
    for (int k = 1; k <= more && i + k < text.size(); ++k)
      code = code << 6 | (static_cast<unsigned char>(text[i + k]) & 0x3Fu);
    i += static_cast<std::size_t>(more) + 1;
    if (code < 0x20 || code == 0x7F) {
      written += ' ';
    } else {
      written += code < 0x7F ? std::string(1, static_cast<char>(code))
                             : fmt::format("\\U+{:04X}", std::min(code, 0xFFFFu));
    }
  }
  return written;
}

std::string in_dxf(std::string text) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 3> kSigns{
      {{"°", "%%d"}, {"×", "x"}, {"…", "-"}}};
  for (const auto& [sign, written] : kSigns)
    for (std::size_t at = text.find(sign); at != std::string::npos; at = text.find(sign))
      text.replace(at, sign.size(), written);
  return without_others(text);
}

}  // namespace

void write_line(DxfWriter& w, const EntityStyle& style, const Segment& line, double dash_scale) {
  begin(w, "LINE", "AcDbLine", style, dash_scale);
  w.coord(10, line.a.x(), line.a.y());
  w.coord(11, line.b.x(), line.b.y());
}

void write_text(DxfWriter& w, const EntityStyle& style, const DxfText& text) {
  constexpr int kMiddle = 4;  // in both directions
  begin(w, "TEXT", "AcDbText", style);
  w.coord(10, text.at.x(), text.at.y());
  w.dxfReal(40, text.height);
  w.dxfString(1, in_dxf(text.text));
  w.dxfReal(50, text.turned.degrees());
  w.dxfInt(72, kMiddle);
  w.coord(11, text.at.x(), text.at.y());
  if (!w.r12()) w.subClass("AcDbText");
}

void write_outline(DxfWriter& w, const EntityStyle& style, const Outline& outline) {
  std::visit([&](const auto& o) { write(w, style, o); }, outline);
}

}  // namespace planish::io_detail
