#include "bend_text.hpp"
#include "svg_labels.hpp"
#include "svg_shapes.hpp"

#include <planish/geometry/plane.hpp>
#include <planish/io/flat_writers.hpp>
#include <planish/sheet/pattern_facts.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// The flat pattern for people (formats.md#svg). All sizes on the page follow the height of the
// letters, which grows with the part. Later groups are painted over earlier ones: sheet, bend
// zones, features, bend lines, contours, slits, labels. Labels are placed clear of lines
// (svg_labels.cpp), and body and legend grow the page, so nothing is cut off.

namespace planish {

using namespace io_detail;

namespace {

constexpr const char* kUpColor = "#1d5fc4";
constexpr const char* kDownColor = "#c62828";
constexpr const char* kUpTint = "#cfe0fa";
constexpr const char* kDownTint = "#fad9d6";
constexpr const char* kFeatureColor = "#2e7d32";
constexpr const char* kOutlineColor = "#101418";
constexpr const char* kSheetColor = "#eef1f4";
constexpr const char* kNoteColor = "#3c4650";

const char* color_of(BendDirection d) { return d == BendDirection::up ? kUpColor : kDownColor; }
const char* tint_of(BendDirection d) { return d == BendDirection::up ? kUpTint : kDownTint; }

/// The height of the letters, which all sizes on the page follow. It grows with the part, but
/// letters are never taller than a long narrow part is wide.
double font_for(const Box2& part) {
  const Vec2 size = part.size();
  const double diagonal = size.norm();
  return std::clamp(0.07 * size.minCoeff(), 0.008 * diagonal, 0.024 * diagonal);
}

/// Of outlines on the side that faces down, in terms of those of bend lines.
constexpr double kHiddenDashes = 0.5;

double line_width(double font) { return 0.09 * font; }

std::string dashes(double font) {
  return fmt::format("{} {}", svg_number(0.8 * font), svg_number(0.4 * font));
}

Box2 part_box(const FlatPattern& pattern) {
  Box2 box = bounds(pattern.outer.loop);
  for (const FlatBend& bend : pattern.bends) {
    for (const Segment& line : bend.lines)
      box.add(bounds(Curve2(line)));
  }
  if (box.empty() || !(box.size().norm() > 0.0)) {
    box = {};
    box.add(Vec2(0.0, 0.0));
    box.add(Vec2(1.0, 1.0));
  }
  return box;
}

std::string contour_path(const FlatPattern& pattern) {
  std::string path = svg_path(pattern.outer.loop);
  for (const Contour& opening : pattern.openings)
    path += svg_path(opening.loop);
  return path;
}

std::string zones(const FlatPattern& pattern) {
  std::string text = "<g class=\"bend-zones\" clip-path=\"url(#material)\">\n";
  for (const FlatBend& bend : pattern.bends) {
    for (const auto& zone : bend_zones(bend)) {
      text += fmt::format("<path fill=\"{}\" d=\"M{}L{}L{}L{}Z\"/>\n", tint_of(bend.direction),
                          svg_point(zone[0]), svg_point(zone[1]), svg_point(zone[2]),
                          svg_point(zone[3]));
    }
  }
  return text + "</g>\n";
}

std::string features(const FlatPattern& pattern, double font) {
  std::string text = fmt::format(
      "<g class=\"features\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\">\n", kFeatureColor,
      svg_number(0.6 * line_width(font)));
  for (const FlatFeature& feature : pattern.features) {
    const bool hidden = feature.side == FormSide::down;
    const std::string dashed = hidden ? fmt::format(" stroke-dasharray=\"{}\"",
                                                    dashes(kHiddenDashes * font))
                                      : "";
    std::string title = xml_escaped(feature.kind);
    if (feature.side != FormSide::both) title += fmt::format(", {}", side_name(feature.side));
    for (const Loop& outline : feature.outlines)
      text += fmt::format("<path d=\"{}\"{}><title>{}</title></path>\n", svg_path(outline), dashed,
                          title);
  }
  return text + "</g>\n";
}

std::string line_element(const Segment& line) {
  return fmt::format("<path d=\"M{}L{}\"/>\n", svg_point(line.a), svg_point(line.b));
}

std::string bend_lines(const FlatPattern& pattern, double font) {
  std::string text = fmt::format(
      "<g class=\"bend-lines\" fill=\"none\" stroke-width=\"{}\" stroke-dasharray=\"{}\">\n",
      svg_number(line_width(font)), dashes(font));
  for (const FlatBend& bend : pattern.bends) {
    text += fmt::format("<g stroke=\"{}\"><title>{}</title>\n", color_of(bend.direction),
                        xml_escaped(bend.id));
    for (const Segment& line : bend.lines)
      text += line_element(line);
    text += "</g>\n";
  }
  return text + "</g>\n";
}

std::string slits(const FlatPattern& pattern, double font) {
  std::string text = fmt::format(
      "<g class=\"slits\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\">\n", kOutlineColor,
      svg_number(line_width(font)));
  for (const Curve2& slit : pattern.slits)
    text += fmt::format("<path d=\"{}\"/>\n", svg_open_path(slit));
  return text + "</g>\n";
}

struct BendLabel {
  PlacedLabel label;
  BendDirection direction = BendDirection::up;
};

/// Lines that labels should not cover.
std::vector<Segment> obstacles(const FlatPattern& pattern, double font) {
  std::vector<Segment> segments;
  const auto add_loop = [&](const Loop& loop) {
    const std::vector<Vec2> corners = sampled(loop, 0.1 * font);
    std::ranges::copy(sides_of(corners), std::back_inserter(segments));
  };
  if (!pattern.outer.loop.empty()) add_loop(pattern.outer.loop);
  for (const Contour& opening : pattern.openings)
    add_loop(opening.loop);
  for (const FlatFeature& feature : pattern.features)
    std::ranges::for_each(feature.outlines, add_loop);
  for (const FlatBend& bend : pattern.bends)
    segments.insert(segments.end(), bend.lines.begin(), bend.lines.end());
  for (const Curve2& slit : pattern.slits) {
    const std::vector<Vec2> points = sampled(slit, 0.1 * font);
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      segments.push_back({points[i], points[i + 1]});
  }
  return segments;
}

/// Half the width of the bend zone.
double half_width(const FlatBend& bend, const Segment& line) {
  const Vec2 along = (line.b - line.a).normalized();
  const Vec2 across = perpendicular(along);
  double width = 0.0;
  for (const Segment& tangent : bend.tangent_lines) {
    width = std::max(width, std::abs(across.dot(0.5 * (tangent.a + tangent.b) - line.a)));
  }
  return width;
}

std::vector<std::vector<Vec2>> rings(const FlatPattern& pattern, double chord) {
  std::vector<std::vector<Vec2>> rings;
  if (!pattern.outer.loop.empty()) rings.push_back(sampled(pattern.outer.loop, chord));
  for (const Contour& opening : pattern.openings)
    rings.push_back(sampled(opening.loop, chord));
  return rings;
}

std::vector<PlacedLabel> point_labels(const FlatPattern& pattern, double font) {
  constexpr double kSmaller = 0.75;  // than the bends' labels
  if (pattern.labels.empty()) return {};
  const auto requests = mapped(pattern.labels, [&](const FlatLabel& label) {
    return PointRequest{label.text, label.at};
  });
  return place_point_labels(requests, rings(pattern, 0.1 * font), obstacles(pattern, font),
                            kSmaller * font);
}

std::vector<BendLabel> bend_labels(const FlatPattern& pattern, double font,
                                   const std::vector<PlacedLabel>& points) {
  std::vector<LabelRequest> requests;
  std::vector<BendDirection> directions;
  for (const FlatBend& bend : pattern.bends) {
    if (bend.lines.empty()) continue;
    const Segment line = *longest_line(bend);
    requests.push_back({bend_text(bend), line, half_width(bend, line)});
    directions.push_back(bend.direction);
  }
  const auto placed = place_labels(requests, obstacles(pattern, font), font, points);
  std::vector<BendLabel> labels;
  for (std::size_t i = 0; i < placed.size(); ++i)
    labels.push_back({placed[i], directions[i]});
  return labels;
}

std::string label_element(const PlacedLabel& label, const char* color) {
  return fmt::format(
      "<text transform=\"translate({}) rotate({})\" y=\"{}\" font-size=\"{}\" fill=\"{}\" "
      "stroke-width=\"{}\">{}</text>\n",
      svg_point(label.center), svg_number(-Angle::radians(label.angle).degrees(), 3),
      svg_number(0.36 * label.font), svg_number(label.font), color, svg_number(0.22 * label.font),
      xml_escaped(label.text));
}

std::string leaders(const std::vector<BendLabel>& bends, double font) {
  std::string text = fmt::format("<g class=\"leaders\" stroke-width=\"{}\">\n",
                                 svg_number(0.4 * line_width(font)));
  for (const BendLabel& bend : bends) {
    if (!bend.label.leader) continue;
    text += fmt::format("<path stroke=\"{}\" d=\"M{}L{}\"/>\n", color_of(bend.direction),
                        svg_point(bend.label.leader->a), svg_point(bend.label.leader->b));
  }
  return text + "</g>\n";
}

std::string labels(const std::vector<BendLabel>& bends, const std::vector<PlacedLabel>& points) {
  // A pale rim separates the letters from a line that they cross.
  std::string text =
      "<g class=\"labels\" text-anchor=\"middle\" stroke=\"#ffffff\" stroke-opacity=\"0.75\" "
      "stroke-linejoin=\"round\" paint-order=\"stroke\">\n";
  for (const PlacedLabel& point : points)
    text += label_element(point, kOutlineColor);
  for (const BendLabel& bend : bends)
    text += label_element(bend.label, color_of(bend.direction));
  return text + "</g>\n";
}

/// An item of the legend: a sample line (unless its length is 0), followed by text.
struct Note {
  std::string text;
  double sample = 0.0;
  const char* color = kNoteColor;
  bool dashed = false;
};

double note_width(const Note& note, double font) {
  return note.sample + (note.sample > 0.0 ? 0.5 * font : 0.0) + text_width(note.text, font);
}

/// 1, 2 or 5 times a power of ten, at most `length`.
double round_length(double length) {
  const double power = std::pow(10.0, std::floor(std::log10(length)));
  const double digit = length / power;
  return power * (digit >= 5.0 ? 5.0 : digit >= 2.0 ? 2.0 : 1.0);
}

std::vector<Note> notes_of(const FlatPattern& pattern, const Box2& part, double font) {
  const Vec2 size = blank_size(pattern);
  const double bar = round_length(std::max(0.2 * part.size().maxCoeff(), 3.0 * font));
  std::vector<Note> notes;
  notes.push_back({fmt::format("{} × {} × {} mm", svg_number(size.x(), 2), svg_number(size.y(), 2),
                               svg_number(pattern.thickness, 3))});
  notes.push_back({svg_number(bar) + " mm", bar});
  const auto has = [&](BendDirection d) {
    return std::ranges::any_of(pattern.bends,
                               [d](const FlatBend& bend) { return bend.direction == d; });
  };
  if (has(BendDirection::up)) notes.push_back({"bend up", 3.0 * font, kUpColor, true});
  if (has(BendDirection::down)) notes.push_back({"bend down", 3.0 * font, kDownColor, true});
  if (std::ranges::any_of(pattern.features,
                          [](const FlatFeature& feature) { return !feature.outlines.empty(); }))
    notes.push_back({"formed feature", 2.0 * font, kFeatureColor});
  return notes;
}

std::string note_element(const Note& note, const Vec2& at, double font) {
  std::string text;
  double x = at.x();
  if (note.sample > 0.0) {
    const Segment line{at, at + Vec2(note.sample, 0.0)};
    text += fmt::format("<path stroke=\"{}\" stroke-width=\"{}\"{} d=\"M{}L{}", note.color,
                        svg_number(line_width(font)),
                        note.dashed ? fmt::format(" stroke-dasharray=\"{}\"", dashes(font)) : "",
                        svg_point(line.a), svg_point(line.b));
    // The scale bar has end marks, for measuring between them.
    if (note.color == kNoteColor) {
      const double h = 0.3 * font;
      text += fmt::format("M{}v{}M{}v{}", svg_point(line.a + Vec2(0, h)), svg_number(2.0 * h),
                          svg_point(line.b + Vec2(0, h)), svg_number(2.0 * h));
    }
    text += "\"/>\n";
    x += note.sample + 0.5 * font;
  }
  return text + fmt::format("<text x=\"{}\" y=\"{}\" fill=\"{}\">{}</text>\n", svg_number(x),
                            svg_number(-at.y() + 0.36 * font), note.color, xml_escaped(note.text));
}

/// Notes in rows below `body`, which grows to hold them.
std::string legend(const std::vector<Note>& notes, double font, Box2& body) {
  const Vec2 corner(body.lo.x(), body.lo.y() - 1.8 * font);
  const double width = std::max(body.size().x(), 20.0 * font);
  std::string text = fmt::format("<g class=\"legend\" font-size=\"{}\">\n", svg_number(font));
  Vec2 at = corner;
  for (const Note& note : notes) {
    const double w = note_width(note, font);
    if (at.x() > corner.x() && at.x() + w > corner.x() + width) {
      at = Vec2(corner.x(), at.y() - 1.6 * font);
    }
    text += note_element(note, at, font);
    body.add(Vec2(at.x() + w, at.y() - 0.6 * font));
    at.x() += w + 1.8 * font;
  }
  return text + "</g>\n";
}

std::string page(const Box2& box, const std::string& content) {
  const Vec2 size = box.size();
  const std::string frame = fmt::format("{} {} {} {}", svg_number(box.lo.x()),
                                        svg_number(-box.hi.y()), svg_number(size.x()),
                                        svg_number(size.y()));
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" version=\"1.1\" width=\"{0}mm\" height=\"{1}mm\" "
      "viewBox=\"{2}\" font-family=\"Arial, Helvetica, 'DejaVu Sans', sans-serif\">\n"
      "<rect x=\"{3}\" y=\"{4}\" width=\"{0}\" height=\"{1}\" fill=\"#ffffff\"/>\n{5}</svg>\n",
      svg_number(size.x()), svg_number(size.y()), frame, svg_number(box.lo.x()),
      svg_number(-box.hi.y()), content);
}

}  // namespace

std::string svg_text(const FlatPattern& pattern, const SvgOptions& options) {
  require_valid(pattern);
  const Box2 part = part_box(pattern);
  const double font = font_for(part);
  const std::string path = contour_path(pattern);
  Box2 body = part;

  std::string content = fmt::format(
      "<clipPath id=\"material\"><path clip-rule=\"evenodd\" d=\"{0}\"/></clipPath>\n"
      "<path class=\"sheet\" fill=\"{1}\" fill-rule=\"evenodd\" d=\"{0}\"/>\n",
      path, kSheetColor);
  content += zones(pattern) + features(pattern, font) + bend_lines(pattern, font);
  content += fmt::format(
      "<path class=\"contours\" fill=\"none\" stroke=\"{}\" stroke-width=\"{}\" "
      "stroke-linejoin=\"round\" d=\"{}\"/>\n",
      kOutlineColor, svg_number(line_width(font)), path);
  if (!pattern.slits.empty()) content += slits(pattern, font);
  if (options.labels || options.names) {
    const std::vector<PlacedLabel> points = options.names ? point_labels(pattern, font)
                                                          : std::vector<PlacedLabel>{};
    const std::vector<BendLabel> bends = options.labels ? bend_labels(pattern, font, points)
                                                        : std::vector<BendLabel>{};
    const auto make_room = [&](const PlacedLabel& label) {
      for (const Vec2& corner : corners(label))
        body.add(corner);
    };
    for (const PlacedLabel& point : points)
      make_room(point);
    for (const BendLabel& bend : bends)
      make_room(bend.label);
    content += leaders(bends, font) + labels(bends, points);
  }
  if (options.legend) content += legend(notes_of(pattern, part, font), font, body);

  const double margin = std::max(options.margin, 0.0);
  body.lo.array() -= margin;
  body.hi.array() += margin;
  return page(body, content);
}

}  // namespace planish
