// How the sheet is made and laid flat: the neutral line of its bends, the faces by which it lies,
// bends between plates, formed features, corners.
#include "option_tables.hpp"
#include "refusals.hpp"

#include <planish/shop/material_json.hpp>

#include <charconv>
#include <filesystem>

namespace planish::job {
using namespace shop;
using namespace schema;
namespace {

using Done = Result<void>;

Done set_k(Request& to, const OptionValue& value) {
  to.allowance = ConstantK{std::get<double>(value), "constant"};
  return {};
}

Done set_k_table(Request& to, const OptionValue& value) {
  const std::string name = std::filesystem::path(file_of(value).name).filename().string();
  auto table = parse_bend_table(file_of(value).text, name);
  if (!table) return pass_on(table);
  to.allowance = std::move(*table);
  return {};
}

Done set_din6935(Request& to, const OptionValue& value) {
  if (yes(value)) to.allowance = Din6935{};
  return {};
}

Done set_material(Request& to, const OptionValue& value) {
  auto material = parse_material(file_of(value).text, file_of(value).name);
  if (!material) return pass_on(material);
  // Called as its file where the file names none: without the suffix.
  const std::filesystem::path called = material->name;
  to.material = called.extension() == ".json" ? called.stem().string() : material->name;
  to.allowance = std::move(*material);
  return {};
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

Done set_lateral(Request& to, const OptionValue& value) {
  const std::string& word = given_text(value);
  to.join.lateral = word == "straight" ? LateralBoundary::straight
                    : word == "arc"    ? LateralBoundary::arc
                    : word == "corner" ? LateralBoundary::corner
                                       : LateralBoundary::automatic;
  return {};
}

Done set_trim(Request& to, const OptionValue& value) {
  const std::string& word = given_text(value);
  if (word != "auto") to.join.trim = word == "yes";
  return {};
}

Done set_extruded(Request& to, const OptionValue& value) {
  const std::string& word = given_text(value);
  to.extruded = word == "through"   ? ExtrudedHoles::through
                : word == "outline" ? ExtrudedHoles::outline
                                    : ExtrudedHoles::pilot;
  return {};
}

Relief relief_of(const OptionValue& value) {
  const std::string& word = given_text(value);
  return word == "none"     ? Relief::none
         : word == "square" ? Relief::square
         : word == "round"  ? Relief::round
                            : Relief::rip;
}

Done set_relief(Request& to, const OptionValue& value) {
  to.relief.shape = relief_of(value);
  return {};
}

Done set_bend_relief(Request& to, const OptionValue& value) {
  to.relief.beside_bends = relief_of(value);
  return {};
}

}  // namespace

const std::vector<Option>& sheet_options() {
  static const std::vector<Option> table = joined({
      {OptionGroup::bends,
       {
           row::number("k", kShare,
                       "K-factor of every bend: the neutral line lies at K times the thickness "
                       "from the inside",
                       set_k),
           row::file(
               "k_table", "FILE.csv", "bend table",
               "bend table: columns r/t (or r and t in mm), optionally angle, and k, ba or bd",
               set_k_table),
           row::flag("din6935", "K by DIN 6935, from the inside radius and the thickness",
                     set_din6935),
           row::file("material", "FILE.json", "material file",
                     "K from the material's stress-strain curves, for each inside radius; with "
                     "`shop`, the name of one of its materials",
                     set_material),
           {.name = "bend_k",
            .kind = OptionKind::by_bend,
            .description = "K-factor of one bend, as in B1=0.4; may be given several times",
            .range = kShare,
            .set = stored<&Request::bend_k>},
           row::word("root", {"largest"}, "largest",
                     "face that stays where it is; `planish info --sheets` lists the faces",
                     stored<&Request::root>, OptionKind::face),
           row::number("thickness", kAboveZero,
                       "thickness of the sheet, in mm, where it is not the one found: of strips as "
                       "narrow as a bar, of milled sheets",
                       stored<&Request::thickness>),
           row::name("rip_edges",
                     "edges along which a closed part is cut open, by their numbers in the file, "
                     "as in 21,56",
                     set_rip_edges),
           row::word("up", {"auto", "reference", "other"}, "auto",
                     "skin that faces up: the one with this face, the one that is unfolded "
                     "(reference) or the other; auto: the one from which more bends go up",
                     stored<&Request::up>, OptionKind::face),
       }},
      {OptionGroup::joining,
       {
           row::number("inside_radius", kAtLeastZero,
                       "inside radius of bends between two plates that give none, in mm",
                       stored<&Request::join, &JoinOptions::inside_radius>),
           row::word("lateral", {"auto", "straight", "arc", "corner"}, "",
                     "lateral boundaries of bends between two plates that give none", set_lateral),
           row::number("trade_off", kAtLeastZero,
                       "how much longer a bend may be for being wider, for bends that do not say",
                       stored<&Request::join, &JoinOptions::trade_off>),
           row::number("largest_span", kAboveZero,
                       "longest distance from plate to plate that a bend bridges, in mm",
                       stored<&Request::join, &JoinOptions::largest_span>),
           row::word("trim", {"auto", "yes", "no"}, "",
                     "whether plates that touch are cut back so that bends fit between them; auto: "
                     "where all of them touch",
                     set_trim),
       }},
      {OptionGroup::forms,
       {
           row::word("extruded", {"pilot", "through", "outline"}, "pilot",
                     "what is cut for holes through them: the pilot hole that is pierced before "
                     "forming, the finished hole, or nothing, free edges included",
                     set_extruded),
           row::flag("overbend", "mould in which strips are bent so far that they keep their shape",
                     stored<&Request::overbend>),
       }},
      {OptionGroup::corners,
       {
           row::word(
               "relief", {"none", "rip", "square", "round"}, "rip",
               "how to mend corners that were drawn without relief and overlap a little when flat: "
               "by the smallest gap, by a relief as wide as the sheet is thick, or not at all",
               set_relief),
           row::word("bend_relief", {"none", "square", "round"}, "none",
                     "reliefs to cut beside bends that would tear the sheet, as wide and deep as "
                     "the rules ask",
                     set_bend_relief),
           row::number("rip_width", kAtLeastZero,
                       "width of rips, in mm; 0: a slit is one line, cut once",
                       stored<&Request::relief, &ReliefOptions::width>, "0"),
       }},
  });
  return table;
}

}  // namespace planish::job
