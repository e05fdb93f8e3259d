// How a DXF is written: layers, release, curves, and what is drawn besides the contours. None of
// these changes what is made.
#include "option_tables.hpp"

namespace planish::job {
using namespace schema;
namespace {

Result<void> set_profile(Request& to, const OptionValue& value) {
  const std::string& word = given_text(value);
  to.dxf.layers.reset();
  to.dxf.profile = word == "inventor"    ? LayerProfile::inventor
                   : word == "onshape"   ? LayerProfile::onshape
                   : word == "solidedge" ? LayerProfile::solid_edge
                                         : LayerProfile::standard;
  return {};
}

Result<void> set_r12(Request& to, const OptionValue& value) {
  to.dxf.version = yes(value) ? DxfVersion::r12 : DxfVersion::r2000;
  return {};
}

Result<void> set_splines(Request& to, const OptionValue& value) {
  to.dxf.splines = given_text(value) == "keep" ? Splines::keep : Splines::arcs;
  return {};
}

Result<void> set_bend_marks(Request& to, const OptionValue& value) {
  to.dxf.bend_marks = given_text(value) == "ticks" ? BendMarks::ticks : BendMarks::lines;
  return {};
}

}  // namespace

const std::vector<Option>& dxf_options() {
  static const std::vector<Option> table = joined({
      {OptionGroup::dxf,
       {
           row::word("profile", {"default", "inventor", "onshape", "solidedge"}, "default",
                     "names of the layers", set_profile),
           row::flag("r12", "release 12 (AC1009) instead of 2000: no LWPOLYLINE, no SPLINE",
                     set_r12),
           row::word("splines", {"keep", "arcs"}, "arcs",
                     "curves that are neither lines nor arcs: keep them or make them arcs",
                     set_splines),
           row::number("arc_tolerance", kAboveZero, "largest deviation of such arcs, in mm",
                       stored<&Request::dxf, &DxfOptions::arc_tolerance>, "0.01"),
           row::word("bend_marks", {"lines", "ticks"}, "lines",
                     "whole bend lines, or only their ends", set_bend_marks),
           row::number("tick_length", kAboveZero, "length of each tick, in mm",
                       stored<&Request::dxf, &DxfOptions::tick_length>, "5"),
           row::flag("tangent_lines", "limits of the bend zones, on a separate layer",
                     stored<&Request::dxf, &DxfOptions::tangent_lines>),
           row::flag("bend_text",
                     "text at each bend: its number, direction, angle and radius, and its stroke "
                     "if there is a plan",
                     stored<&Request::dxf, &DxfOptions::bend_text>),
           row::flag("turn_to_blank",
                     "pattern turned so that the longer side of its blank lies along x, with the "
                     "blank's corner at the origin",
                     stored<&Request::dxf, &DxfOptions::turn_to_blank>),
       }},
  });
  return table;
}

}  // namespace planish::job
