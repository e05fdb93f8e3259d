#include "bending_options.hpp"
#include "refusals.hpp"
#include "taken_shop.hpp"

#include <planish/base/assert.hpp>
#include <planish/job/options.hpp>
#include <planish/shop/material_json.hpp>
#include <planish/shop/rules_json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <filesystem>

namespace planish::job {
using namespace shop;
using namespace schema;
namespace {

using Done = Result<void>;

const OptionFile& file_of(const OptionValue& value) { return std::get<OptionFile>(value); }
const std::string& given_text(const OptionValue& value) { return std::get<std::string>(value); }
double number_of(const OptionValue& value) { return std::get<double>(value); }
bool yes(const OptionValue& value) { return std::get<bool>(value); }

Done set_k_table(Request& to, const OptionValue& value) {
  const std::string name = std::filesystem::path(file_of(value).name).filename().string();
  auto table = parse_bend_table(file_of(value).text, name);
  if (!table) return pass_on(table);
  to.allowance = std::move(*table);
  return {};
}

Done set_shop(Request& to, const OptionValue& value) {
  auto shop = parse_shop(file_of(value).text, file_of(value).name);
  if (!shop) return pass_on(shop);
  take_shop(to, std::move(*shop));
  return {};
}

Done set_material(Request& to, const OptionValue& value) {
  auto material = parse_material(file_of(value).text, file_of(value).name);
  if (!material) return pass_on(material);
  to.allowance = std::move(*material);
  return {};
}

Done set_process(Request& to, const OptionValue& value) {
  to.rules = rules_for(given_text(value) == "punch" ? Process::punch : Process::laser);
  return {};
}

Done set_rules(Request& to, const OptionValue& value) {
  const auto rules = parse_rules(file_of(value).text, file_of(value).name, to.rules);
  if (!rules) return pass_on(rules);
  to.rules = *rules;
  return {};
}

Done set_profile(Request& to, const OptionValue& value) {
  const std::string& word = given_text(value);
  to.dxf.layers.reset();
  to.dxf.profile = word == "inventor"    ? LayerProfile::inventor
                   : word == "onshape"   ? LayerProfile::onshape
                   : word == "solidedge" ? LayerProfile::solid_edge
                                         : LayerProfile::standard;
  return {};
}

Done set_extruded(Request& to, const OptionValue& value) {
  const std::string& word = given_text(value);
  to.extruded = word == "through"   ? ExtrudedHoles::through
                : word == "outline" ? ExtrudedHoles::outline
                                    : ExtrudedHoles::pilot;
  return {};
}

Done set_relief(Request& to, const OptionValue& value) {
  const std::string& word = given_text(value);
  to.relief.shape = word == "none"     ? Relief::none
                    : word == "square" ? Relief::square
                    : word == "round"  ? Relief::round
                                       : Relief::rip;
  return {};
}

Done set_bend_relief(Request& to, const OptionValue& value) {
  const std::string& word = given_text(value);
  to.relief.beside_bends = word == "square"  ? Relief::square
                           : word == "round" ? Relief::round
                                             : Relief::none;
  return {};
}

Done set_units(Request& to, const OptionValue& value) {
  to.units = given_text(value) == "inch" ? LengthUnit::inch
             : given_text(value) == "m"  ? LengthUnit::m
                                         : LengthUnit::mm;
  return {};
}

// Before all others, which take the place of what it says.
const std::vector<Option>& shop_options() {
  static const std::vector<Option> table{
      {.name = "shop",
       .kind = OptionKind::file,
       .group = "Shop",
       .description = "shop profile: stocked materials with radius and K, layers, limits, tools; "
                      "other options override it",
       .file_type = "FILE.json",
       .file_kind = "shop profile",
       .set = set_shop},
  };
  return table;
}

Done set_rip_edges(Request& to, const OptionValue& value) {
  const std::string& text = given_text(value);
  to.rip_edges.clear();
  const char* at = text.data();
  for (const char* const end = at + text.size();; ++at) {
    int edge = 0;
    const auto [stop, error] = std::from_chars(at, end, edge);
    if (error != std::errc() || edge < 1 || (stop != end && *stop != ','))
      return fail(refuse::bad_rip_edges, {{"text", text}}, "rip_edges");
    to.rip_edges.push_back(edge);
    if ((at = stop) == end) return {};
  }
}

const std::vector<Option>& bend_options() {
  static const std::vector<Option> table{
      {.name = "k",
       .kind = OptionKind::number,
       .group = "Bends",
       .description = "K-factor of every bend: the neutral line lies at K times the thickness from "
                      "the inside",
       .range = kShare,
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.allowance = ConstantK{number_of(value), "constant"};
         return {};
       }},
      {.name = "k_table",
       .kind = OptionKind::file,
       .group = "Bends",
       .description = "bend table: columns r/t (or r and t in mm), optionally angle, and k, ba or "
                      "bd",
       .file_type = "FILE.csv",
       .file_kind = "bend table",
       .set = set_k_table},
      {.name = "din6935",
       .kind = OptionKind::flag,
       .group = "Bends",
       .description = "K by DIN 6935, from the inside radius and the thickness",
       .set = [](Request& to, const OptionValue& value) -> Done {
         if (yes(value)) to.allowance = Din6935{};
         return {};
       }},
      {.name = "material",
       .kind = OptionKind::file,
       .group = "Bends",
       .description = "K from the material's stress-strain curves, for each inside radius; with "
                      "`shop`, the name of one of its materials",
       .file_type = "FILE.json",
       .file_kind = "material file",
       .set = set_material},
      {.name = "bend_k",
       .kind = OptionKind::by_bend,
       .group = "Bends",
       .description = "K-factor of one bend, as in B1=0.4; may be given several times",
       .range = kShare,
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.bend_k = std::get<std::vector<std::pair<std::string, double>>>(value);
         return {};
       }},
      {.name = "root",
       .kind = OptionKind::face,
       .group = "Bends",
       .description = "face that stays where it is; `planish info --sheets` lists the faces",
       .otherwise = "largest",
       .words = {"largest"},
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.root = given_text(value);
         return {};
       }},
      {.name = "rip_edges",
       .kind = OptionKind::name,
       .group = "Bends",
       .description = "edges along which a closed part is cut open, by their numbers in the file, "
                      "as in 21,56",
       .set = set_rip_edges},
      {.name = "up",
       .kind = OptionKind::face,
       .group = "Bends",
       .description = "skin that faces up: the one with this face, the one that is unfolded "
                      "(reference) or the other; auto: the one from which more bends go up",
       .otherwise = "auto",
       .words = {"auto", "reference", "other"},
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.up = given_text(value);
         return {};
       }},
  };
  return table;
}

Done set_lateral(Request& to, const OptionValue& value) {
  const std::string& word = given_text(value);
  to.join.lateral = word == "straight" ? LateralBoundary::straight
                    : word == "arc"    ? LateralBoundary::arc
                    : word == "corner" ? LateralBoundary::corner
                                       : LateralBoundary::automatic;
  return {};
}

const std::vector<Option>& join_options() {
  static const std::vector<Option> table{
      {.name = "inside_radius",
       .kind = OptionKind::number,
       .group = "Joining",
       .description = "inside radius of bends between two plates that give none, in mm",
       .range = kAtLeastZero,
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.join.inside_radius = number_of(value);
         return {};
       }},
      {.name = "lateral",
       .kind = OptionKind::word,
       .group = "Joining",
       .description = "lateral boundaries of bends between two plates that give none",
       .words = {"auto", "straight", "arc", "corner"},
       .set = set_lateral},
      {.name = "trade_off",
       .kind = OptionKind::number,
       .group = "Joining",
       .description = "how much longer a bend may be for being wider, for bends that do not say",
       .range = kAtLeastZero,
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.join.trade_off = number_of(value);
         return {};
       }},
      {.name = "largest_span",
       .kind = OptionKind::number,
       .group = "Joining",
       .description = "longest distance from plate to plate that a bend bridges, in mm",
       .range = kAboveZero,
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.join.largest_span = number_of(value);
         return {};
       }},
  };
  return table;
}

const std::vector<Option>& form_options() {
  static const std::vector<Option> table{
      {.name = "extruded",
       .kind = OptionKind::word,
       .group = "Formed features",
       .description = "what is cut for holes through them: the pilot hole that is pierced before "
                      "forming, the finished hole, or nothing, free edges included",
       .otherwise = "pilot",
       .words = {"pilot", "through", "outline"},
       .set = set_extruded},
  };
  return table;
}

const std::vector<Option>& relief_options() {
  static const std::vector<Option> table{
      {.name = "relief",
       .kind = OptionKind::word,
       .group = "Corners",
       .description = "how to mend corners that were drawn without relief and overlap a little "
                      "when flat: by the smallest gap, by a relief as wide as the sheet is thick, "
                      "or not at all",
       .otherwise = "rip",
       .words = {"none", "rip", "square", "round"},
       .set = set_relief},
      {.name = "bend_relief",
       .kind = OptionKind::word,
       .group = "Corners",
       .description = "reliefs to cut beside bends that would tear the sheet, as wide and deep as "
                      "the rules ask",
       .otherwise = "none",
       .words = {"none", "square", "round"},
       .set = set_bend_relief},
      {.name = "rip_width",
       .kind = OptionKind::number,
       .group = "Corners",
       .description = "width of rips, in mm; 0: a slit is one line, cut once",
       .otherwise = "0",
       .range = kAtLeastZero,
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.relief.width = number_of(value);
         return {};
       }},
  };
  return table;
}

const std::vector<Option>& dxf_options() {
  static const std::vector<Option> table{
      {.name = "profile",
       .kind = OptionKind::word,
       .group = "DXF",
       .description = "names of the layers",
       .otherwise = "default",
       .words = {"default", "inventor", "onshape", "solidedge"},
       .set = set_profile},
      {.name = "r12",
       .kind = OptionKind::flag,
       .group = "DXF",
       .description = "release 12 (AC1009) instead of 2000: no LWPOLYLINE, no SPLINE",
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.dxf.version = yes(value) ? DxfVersion::r12 : DxfVersion::r2000;
         return {};
       }},
      {.name = "splines",
       .kind = OptionKind::word,
       .group = "DXF",
       .description = "curves that are neither lines nor arcs: keep them or make them arcs",
       .otherwise = "arcs",
       .words = {"keep", "arcs"},
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.dxf.splines = given_text(value) == "keep" ? Splines::keep : Splines::arcs;
         return {};
       }},
      {.name = "arc_tolerance",
       .kind = OptionKind::number,
       .group = "DXF",
       .description = "largest deviation of such arcs, in mm",
       .otherwise = "0.01",
       .range = kAboveZero,
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.dxf.arc_tolerance = number_of(value);
         return {};
       }},
      {.name = "bend_marks",
       .kind = OptionKind::word,
       .group = "DXF",
       .description = "whole bend lines, or only their ends",
       .otherwise = "lines",
       .words = {"lines", "ticks"},
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.dxf.bend_marks = given_text(value) == "ticks" ? BendMarks::ticks : BendMarks::lines;
         return {};
       }},
      {.name = "tick_length",
       .kind = OptionKind::number,
       .group = "DXF",
       .description = "length of each tick, in mm",
       .otherwise = "5",
       .range = kAboveZero,
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.dxf.tick_length = number_of(value);
         return {};
       }},
      {.name = "tangent_lines",
       .kind = OptionKind::flag,
       .group = "DXF",
       .description = "limits of the bend zones, on a separate layer",
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.dxf.tangent_lines = yes(value);
         return {};
       }},
      {.name = "bend_text",
       .kind = OptionKind::flag,
       .group = "DXF",
       .description = "text at each bend: its number, direction, angle and radius, and its stroke "
                      "if there is a plan",
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.dxf.bend_text = yes(value);
         return {};
       }},
      {.name = "turn_to_blank",
       .kind = OptionKind::flag,
       .group = "DXF",
       .description = "pattern turned so that the longer side of its blank lies along x, with the "
                      "blank's corner at the origin",
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.dxf.turn_to_blank = yes(value);
         return {};
       }},
  };
  return table;
}

const std::vector<Option>& check_options() {
  static const std::vector<Option> table{
      {.name = "process",
       .kind = OptionKind::word,
       .group = "Checks",
       .description = "how openings and contours are cut; sets the limits of the rules",
       .otherwise = "laser",
       .words = {"laser", "punch"},
       .set = set_process},
      {.name = "rules",
       .kind = OptionKind::file,
       .group = "Checks",
       .description = "limits of the rules of manufacture, instead of those of the process",
       .file_type = "FILE.json",
       .file_kind = "rules file",
       .set = set_rules},
      {.name = "no_rules",
       .kind = OptionKind::flag,
       .group = "Checks",
       .description = "do not check the rules of manufacture",
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.rules.enabled = !yes(value);
         return {};
       }},
      {.name = "write_overlapping",
       .kind = OptionKind::flag,
       .group = "Checks",
       .description = "write the pattern even if it overlaps itself",
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.write_overlapping = yes(value);
         return {};
       }},
      {.name = "density",
       .kind = OptionKind::number,
       .group = "Checks",
       .description = "kg/dm³, for the mass: steel 7.85, aluminium 2.70",
       .range = kAboveZero,
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.density = number_of(value);
         return {};
       }},
  };
  return table;
}

const std::vector<Option>& general_options() {
  static const std::vector<Option> table{
      {.name = "body",
       .kind = OptionKind::name,
       .group = "Input",
       .description = "body to use if there are several: its number (see `planish info`) or name",
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.body = given_text(value);
         return {};
       }},
      {.name = "units",
       .kind = OptionKind::word,
       .group = "Output",
       .description = "unit of the DXF and of the reports",
       .words = {"mm", "inch", "m"},
       .set = set_units},
      {.name = "piece",
       .kind = OptionKind::whole,
       .group = "Output",
       .description = "piece to show if there are several, from 0",
       .otherwise = "0",
       .range = {"a whole number of at least 0", 0.0},
       .on_command_line = false,
       .set = [](Request& to, const OptionValue& value) -> Done {
         to.piece = static_cast<int>(number_of(value));
         return {};
       }},
  };
  return table;
}

}  // namespace

std::span<const Option> options() {
  static const std::vector<Option> all = [] {
    std::vector<Option> joined;
    for (const auto* group :
         {&general_options(), &shop_options(), &bend_options(), &join_options(), &form_options(),
          &relief_options(), &dxf_options(), &check_options(), &bending_options()})
      joined.insert(joined.end(), group->begin(), group->end());
    return joined;
  }();
  return all;
}

const Option& OptionUse::entry() const { return own ? *own : option(name); }

const Option& option(std::string_view name) {
  const auto all = options();
  const auto found = std::ranges::find(all, name, &Option::name);
  PLANISH_ASSERT(found != all.end());
  return *found;
}

}  // namespace planish::job
