#include "blocks.hpp"
#include "hulls.hpp"
#include "outline.hpp"
#include "refusals.hpp"

#include <planish/base/assert.hpp>
#include <planish/base/tolerance.hpp>
#include <planish/geometry/region.hpp>
#include <planish/nest/nest.hpp>
#include <planish/sheet/codes.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>

// Parts on sheets: outlines, blocks, the nester, and back (docs/decisions/0014). Parts lie along
// their smallest rectangle, their outlines grown by half the gap, in integers that Clipper computes
// with; the room is larger by half a micrometre, so that what fills the sheet exactly fits. The
// nester is not trusted: afterwards each copy must be there, and no outline may cover another.

namespace planish {

using namespace nest_detail;

namespace {

/// By how much a room is larger than it should be on each side, in units, so that parts that fill
/// the sheet exactly fit: half a micrometre.
constexpr ClipperLib::cInt kEase = 5;

/// mm; deviations below are none.
constexpr double kMicrometre = 1e-3;

struct SheetSize {
  double length, width;  ///< mm
  double reach;          ///< half the gap: by how much outlines exceed contours
  double inset;          ///< of the room for outlines from the edge of the sheet
  double margin;
};

SheetSize size_of(const NestOptions& options) {
  const double margin = options.margin.value_or(options.gap);
  return {options.length, options.width, 0.5 * options.gap, margin - 0.5 * options.gap, margin};
}

Result<void> checked(const NestOptions& options) {
  const auto wrong = [](const char* key, double value, const std::string& range) {
    return fail(refuse::bad_nest_option,
                {{"name", std::string("The ") + key}, {"value", value, unit::mm}, {"range", range}},
                key);
  };
  const std::string size = "a value above 0 and up to " + number_text(kLargest) + " mm";
  const auto is_size = [](double value) { return value > 0.0 && value <= kLargest; };
  if (!is_size(options.length)) return wrong("length", options.length, size);
  if (!is_size(options.width)) return wrong("width", options.width, size);
  const double smaller = std::min(options.length, options.width);
  const std::string distance = "a value from 0 to " + number_text(0.5 * smaller) +
                               " mm, half the sheet";
  const auto is_distance = [&](double value) { return value >= 0.0 && value <= 0.5 * smaller; };
  if (!is_distance(options.gap)) return wrong("gap", options.gap, distance);
  const double margin = options.margin.value_or(options.gap);
  if (!is_distance(margin)) return wrong("margin", margin, distance);
  return {};
}

Result<void> checked(const std::vector<NestPart>& parts) {
  for (std::size_t i = 0; i < parts.size(); ++i) {
    PLANISH_ASSERT(parts[i].flat);
    const std::string where = "part " + std::to_string(i + 1);
    if (parts[i].quantity < 1)
      return fail(refuse::bad_quantity, {{"part", i + 1}, {"quantity", parts[i].quantity}}, where);
    if (auto sound = check(*parts[i].flat); !sound) {
      Error error = std::move(sound.error());
      error.code = code::invalid_sheet;
      error.where = where;
      return fail(std::move(error));
    }
    if (parts[i].flat->outer.loop.empty())
      return fail(refuse::no_outer_contour, {{"part", i + 1}}, where);
  }
  return {};
}

/// How a part is brought to the nester: turned, with the corner of its box at the origin.
struct Brought {
  Isometry2 motion = Isometry2::Identity();
  Loop contour;
  Vec2 size;
};

Brought brought(const Loop& contour, double angle) {
  Brought result;
  if (angle != 0.0) result.motion.rotate(angle);
  const Box2 box = bounds(transformed(contour, result.motion));
  result.motion.pretranslate(-box.lo);
  result.contour = transformed(contour, result.motion);
  result.size = box.size();
  return result;
}

/// Angles by which the part may be turned before quarter turns (half turns, with grain) are tried:
/// along the smallest rectangle, unless it lies so as it is.
std::vector<double> first_turns(const Loop& contour, bool grain) {
  constexpr double kChord = 0.01;  // mm
  if (grain) return {0.0};
  const EnclosingRectangle rectangle = smallest_rectangle(sampled(contour, kChord));
  const Vec2 size = bounds(contour).size();
  const bool lies_so = size.prod() <= rectangle.size.prod() * (1.0 + tolerance::kWrittenDigits);
  return lies_so ? std::vector{0.0} : std::vector{-rectangle.angle, 0.0};
}

Vec2 needed_for(const Vec2& size, const SheetSize& sheet) {
  return size.array() + 2.0 * sheet.margin;
}

bool fits_on(const Vec2& needed, const SheetSize& sheet) {
  return needed.x() <= sheet.length + kMicrometre && needed.y() <= sheet.width + kMicrometre;
}

/// The part as it fits, or what it would need.
struct Fit {
  std::optional<Brought> brought;
  Vec2 needed = Vec2::Zero();
};

Fit fit(const Loop& contour, const SheetSize& sheet, bool grain) {
  Fit result;
  for (const double angle : first_turns(contour, grain)) {
    Brought now = brought(contour, angle);
    Vec2 needed = needed_for(now.size, sheet);
    const bool along_y = needed.y() > needed.x();
    if (!grain && along_y != (sheet.width > sheet.length)) std::swap(needed.x(), needed.y());
    if (!result.brought && (result.needed.isZero() || needed.prod() < result.needed.prod()))
      result.needed = needed;
    if (fits_on(needed, sheet)) {
      result.brought = std::move(now);
      break;
    }
  }
  return result;
}

Isometry2 motion_of(const Position& position, const SheetSize& sheet) {
  constexpr std::array<std::array<double, 2>, 4> kTurns{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  const auto& [cosine, sine] = kTurns[position.quarter_turns];
  Isometry2 motion = Isometry2::Identity();
  motion.linear() << cosine, -sine, sine, cosine;
  const Vec2 shift(static_cast<double>(position.shift.X - kEase),
                   static_cast<double>(position.shift.Y - kEase));
  motion.translation() = (shift * kUnit).array() + sheet.inset;
  return motion;
}

double material(const FlatPattern& flat) {
  double area = std::abs(signed_area(flat.outer.loop));
  for (const Contour& opening : flat.openings)
    area -= std::abs(signed_area(opening.loop));
  return area;
}

/// The parts that fit, as shapes, and which part each shape is.
struct Job {
  std::vector<Shape> shapes;
  std::vector<int> part_of;
  std::vector<Isometry2> motions;
  std::vector<TooLarge> too_large;
};

Job job_of(const std::vector<NestPart>& parts, const NestOptions& options, const SheetSize& size) {
  Job job;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const Fit found = fit(parts[i].flat->outer.loop, size, options.grain);
    if (!found.brought) {
      job.too_large.push_back({static_cast<int>(i), found.needed});
      continue;
    }
    job.shapes.push_back({outline_around(found.brought->contour, size.reach), parts[i].quantity});
    job.part_of.push_back(static_cast<int>(i));
    job.motions.push_back(found.brought->motion);
  }
  job.shapes = with_hulls(std::move(job.shapes));
  return job;
}

using Sheets = std::vector<std::vector<Position>>;

/// The members of the blocks, each for itself.
Sheets members(const Sheets& laid, const std::vector<Block>& blocks) {
  Sheets sheets;
  for (const std::vector<Position>& sheet : laid) {
    if (sheet.empty()) continue;
    sheets.emplace_back();
    for (const Position& position : sheet)
      for (const Position& member : blocks[position.shape].members)
        sheets.back().push_back(within(position, member));
    std::ranges::stable_sort(sheets.back(), {}, &Position::shape);
  }
  return sheets;
}

/// Whether each copy is there, and no outline covers another: libnest2d is not trusted.
Result<void> verified(const Sheets& sheets, const Job& job) {
  auto missing = mapped(job.shapes, &Shape::count);
  for (const std::vector<Position>& sheet : sheets) {
    std::vector<Polygon> outlines;
    for (const Position& position : sheet) {
      --missing[position.shape];
      const Isometry2 motion = motion_of(position, {});
      Polygon outline;
      for (const auto& p : job.shapes[position.shape].outline)
        outline.outer.push_back(motion *
                                (Vec2(static_cast<double>(p.X), static_cast<double>(p.Y)) * kUnit));
      outlines.push_back(std::move(outline));
    }
    if (!overlaps(outlines, kMicrometre, 0.0).empty()) return fail(refuse::parts_overlap);
  }
  if (std::ranges::any_of(missing, [](int count) { return count != 0; }))
    return fail(refuse::wrong_quantity);
  return {};
}

}  // namespace

Result<Nesting> nest(const std::vector<NestPart>& parts, const NestOptions& options,
                     const Progress& progress) {
  if (auto good = checked(options); !good) return pass_on(good);
  if (auto good = checked(parts); !good) return pass_on(good);
  const SheetSize size = size_of(options);
  Job job = job_of(parts, options, size);
  const Room room{in_units(size.length - 2.0 * size.inset) + 2 * kEase,
                  in_units(size.width - 2.0 * size.inset) + 2 * kEase, options.grain};
  const std::vector<Block> blocks = blocks_of(job.shapes, room, progress);
  const auto shapes = mapped(blocks, &Block::shape);
  const Sheets sheets = members(lay_out(shapes, room, progress), blocks);
  if (progress.should_stop()) return fail(refuse::cancelled);
  if (auto good = verified(sheets, job); !good) return pass_on(good);

  Nesting nesting;
  nesting.too_large = std::move(job.too_large);
  std::vector<int> copies(parts.size(), 0);
  for (const std::vector<Position>& sheet : sheets) {
    NestedSheet& nested = nesting.sheets.emplace_back();
    for (const Position& position : sheet) {
      const int shape = position.shape;
      const int part = job.part_of[shape];
      nested.placed.push_back(
          {part, copies[part]++, motion_of(position, size) * job.motions[shape]});
      nested.use += material(*parts[part].flat) / (size.length * size.width);
    }
  }
  return nesting;
}

}  // namespace planish
