#pragma once

#include <planish/job/unfold.hpp>
#include <planish/sheet/codes.hpp>

#include <numbers>

namespace planish::test {

/// A blank of 100 × 60 mm with one hole of radius 5 and one 90° bend line at x = 40; values that
/// are easy to follow through a change of units.
inline FlatPattern sample_pattern() {
  FlatPattern flat;
  flat.thickness = 2.0;
  flat.outer.loop = {Segment{{0, 0}, {100, 0}}, Segment{{100, 0}, {100, 60}},
                     Segment{{100, 60}, {0, 60}}, Segment{{0, 60}, {0, 0}}};
  Contour hole;
  hole.loop = {Arc{{70, 30}, 5.0, 0.0, -2.0 * std::numbers::pi}};
  flat.openings = {hole};
  FlatBend bend;
  bend.id = "B1";
  bend.kind = BendKind::cylinder;
  bend.angle = Angle::degrees(90);
  bend.inside_radius = 3.0;
  bend.allowance = {0.44, 6.0946897, 3.9053103, "default"};
  bend.direction = BendDirection::down;
  bend.lines = {Segment{{40, 0}, {40, 20}}, Segment{{40, 25}, {40, 60}}};
  bend.length = 55.0;
  flat.bends = {bend};
  flat.area = 6000.0 - 25.0 * std::numbers::pi;
  flat.perimeter = 320.0 + 10.0 * std::numbers::pi;
  return flat;
}

/// The report of that pattern, without anything to complain about.
inline job::UnfoldReport sample_report() {
  job::UnfoldReport report;
  report.input = "parts/bracket.step";
  report.body = "bracket";
  report.summary.thickness = 2.0;
  report.summary.volume = 11843.0;
  report.summary.flanges = 2;
  report.summary.bends = 1;
  report.summary.k_factor = 0.44;
  report.summary.k_source = "default";
  report.flat = sample_pattern();
  report.size = {100.0, 60.0};
  report.certificate.flat_area_half = 5921.5;
  report.certificate.volume_ratio = 1.0;
  report.certificate.length_error = 2e-13;
  report.certificate.refold_deviation = 3e-9;
  return report;
}

/// A body of which no pattern exists.
inline job::UnfoldReport refused_report() {
  job::UnfoldReport report;
  report.input = "parts/bracket.step";
  report.number = 2;
  report.body = "block";
  report.quantity = 3;
  report.refusal = Error{code::not_a_sheet, "no two skins at one distance", "body 2"};
  return report;
}

}  // namespace planish::test
