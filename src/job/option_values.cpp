
#include "refusals.hpp"
#include "taken_shop.hpp"

#include <planish/job/options.hpp>
#include <planish/schema/text_file.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>

// Values of options, whatever gave them: words of a command line, JSON, a form. Each is checked
// against the table, and they are entered in its order, since later ones build on earlier ones: a
// rules file changes the limits of the process. Two that cannot both hold are refused at the later
// one.

namespace planish::job {
using namespace shop;
using namespace schema;
namespace {

using ByBend = std::vector<std::pair<std::string, double>>;

tl::unexpected<Error> must_be(const Option& option, const std::string& what,
                              const std::string& text) {
  return fail(refuse::bad_option_text, {{"option", option.name}, {"wanted", what}, {"text", text}},
              std::string(option.name));
}

bool is_word_of(const Option& option, const std::string& text) {
  return std::ranges::find(option.words, text) != option.words.end();
}

std::optional<double> number_within(const Option& option, const std::string& text) {
  const auto value = parse_number(text);
  const bool whole = option.kind != OptionKind::whole || (value && std::floor(*value) == *value);
  return value && whole && option.range.holds(*value) ? value : std::nullopt;
}

bool is_face_number(const std::string& text) {
  int number = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  return error == std::errc() && stop == end && number >= 1;
}

Result<OptionValue> word_value(const Option& option, const std::string& text) {
  const auto words = fmt::format("{}", fmt::join(option.words, ", "));
  const bool face = option.kind == OptionKind::face;
  if (is_word_of(option, text) || (face && is_face_number(text))) return OptionValue(text);
  return must_be(option, face ? words + " or the number of a face" : "one of " + words, text);
}

Result<OptionValue> bend_value(const Option& option, const std::string& text) {
  const auto equals = text.find('=');
  const auto k = equals == std::string::npos ? std::nullopt
                                             : number_within(option, text.substr(equals + 1));
  if (equals != 0 && k) return OptionValue(ByBend{{text.substr(0, equals), *k}});
  return must_be(option, fmt::format("a bend, an equals sign and {}", option.range.words), text);
}

Result<OptionValue> value_of(const Option& option, const std::string& text) {
  switch (option.kind) {
    case OptionKind::flag:
      if (text == "true" || text == "false") return OptionValue(text == "true");
      return must_be(option, "true or false", text);
    case OptionKind::number:
    case OptionKind::whole:
      if (const auto number = number_within(option, text)) return OptionValue(*number);
      return must_be(option, std::string(option.range.words), text);
    case OptionKind::word:
    case OptionKind::face:
      return word_value(option, text);
    case OptionKind::by_bend:
      return bend_value(option, text);
    case OptionKind::name:
    case OptionKind::file:
      break;
  }
  if (text.empty()) return must_be(option, "a text that is not empty", text);
  return OptionValue(text);
}

// A condition under which a request makes no sense, and the message for it.
struct Contradiction {
  bool holds;
  const Refusal& refusal;
  const char* option;
};

/// Content that has no file of its own is a part of the request.
Error within_content(Error error, const Option& option, const OptionFile& file) {
  const bool pointer = error.where.starts_with(file.name + "/");
  error.where = fmt::format("{}/content{}", option.name,
                            pointer ? error.where.substr(file.name.size()) : "");
  return error;
}

Result<OptionValue> read_file(const Option& option, const std::string& path) {
  auto text = read_text(path, std::string(option.file_kind));
  if (!text) return pass_on(text);
  return OptionValue(OptionFile{path, std::move(*text)});
}

Error without_material(const Shop& shop, const std::string& name, bool reads_files) {
  return error_of(reads_files ? refuse::no_material_or_file : refuse::no_shop_material,
                  {{"material", name}, {"known", material_names(shop)}}, "material");
}

Error not_a_content(const Option& option) {
  return error_of(refuse::name_without_shop, {{"option", option.name}, {"kind", option.file_kind}},
                  std::string(option.name));
}

/// `material` beside a shop: one of the shop's, or a file.
Result<bool> enter_shop_material(const std::string& name, Request& request, bool reads_files) {
  if (take_material(request, name)) {
    request.material = request.shop->chosen().name;
    return true;
  }
  std::error_code ignored;
  if (!reads_files || !std::filesystem::exists(name, ignored))
    return tl::unexpected(without_material(request.shop->shop, name, reads_files));
  return false;
}

/// Its row in the table of options; those of a maker's own come after them.
std::ptrdiff_t rank_of(const Option& option) {
  const auto all = options();
  const auto row = std::ranges::find(all, option.name, &Option::name);
  return row - all.begin();
}

Result<void> store(const Option& option, const OptionValue& value, Request& request) {
  if (option.set) return option.set(request, value);
  request.own.insert_or_assign(std::string(option.name), value);
  return {};
}

Result<void> enter_one(const Option& option, const OptionValue& value, Request& request,
                       bool reads_files) {
  const auto* path = std::get_if<std::string>(&value);
  if (option.name == "material" && path && request.shop) {
    const auto done = enter_shop_material(*path, request, reads_files);
    if (!done) return pass_on(done);
    if (*done) return {};
  }
  if (option.kind == OptionKind::file && path) {
    if (!reads_files) return tl::unexpected(not_a_content(option));
    const auto content = read_file(option, *path);
    if (!content) return pass_on(content);
    return store(option, *content, request);
  }
  auto done = store(option, value, request);
  const auto* file = std::get_if<OptionFile>(&value);
  if (!done && file) return tl::unexpected(within_content(done.error(), option, *file));
  return done;
}

/// Says that K comes from two of the options; null if it comes from one at most. `curves`: the
/// material's are one of them.
std::optional<Error> second_k_rule(const OptionValues& values, bool curves) {
  std::string_view first;
  for (const std::string_view name : {"k", "k_table", "din6935", "material"}) {
    if (!values.given(name) || (name == "material" && !curves)) continue;
    if (!first.empty())
      return error_of(refuse::one_k, {{"first", first}, {"second", name}}, std::string(name));
    first = name;
  }
  return std::nullopt;
}

}  // namespace

Result<void> OptionValues::set_text(const Option& option, const std::string& text) {
  auto value = value_of(option, text);
  if (!value) return pass_on(value);
  set(option, std::move(*value));
  return {};
}

void OptionValues::set(const Option& option, OptionValue value) {
  const auto known = std::ranges::find_if(values_,
                                          [&](const auto& one) { return one.first == &option; });
  if (known == values_.end()) {
    values_.emplace_back(&option, std::move(value));
  } else if (auto* rows = std::get_if<ByBend>(&known->second)) {
    for (auto& row : std::get<ByBend>(value))
      rows->push_back(std::move(row));
  } else {
    known->second = std::move(value);
  }
}

bool OptionValues::given(std::string_view name) const {
  return std::ranges::any_of(values_, [&](const auto& one) {
    const bool* flag = std::get_if<bool>(&one.second);
    return one.first->name == name && (!flag || *flag);
  });
}

std::string OptionValues::text(std::string_view name) const {
  for (const auto& [option, value] : values_)
    if (option->name == name)
      if (const auto* text = std::get_if<std::string>(&value)) return *text;
  return {};
}

std::optional<double> OptionValues::number(std::string_view name) const {
  for (const auto& [option, value] : values_)
    if (option->name == name)
      if (const auto* number = std::get_if<double>(&value)) return *number;
  return std::nullopt;
}

Result<void> OptionValues::check_together() const {
  // Beside a shop a material may be a name of it, which no file says.
  if (auto twice = second_k_rule(*this, !given("shop"))) return tl::unexpected(std::move(*twice));
  for (const Contradiction& one : {
           Contradiction{given("no_rules") && given("rules"), refuse::rules_and_none, "no_rules"},
           {given("tangent_lines") && text("profile") == "solidedge", refuse::tangents_unlayered,
            "tangent_lines"},
           {given("r12") && text("splines") == "keep", refuse::kept_splines, "splines"},
           {given("tick_length") && text("bend_marks") != "ticks", refuse::ticks_alone,
            "tick_length"},
       })
    if (one.holds) return fail(one.refusal, {}, one.option);
  return {};
}

Result<void> OptionValues::enter(Request& request) const {
  if (auto fine = check_together(); !fine) return fine;
  std::multimap<std::ptrdiff_t, const std::pair<const Option*, OptionValue>*> ordered;
  for (const auto& one : values_)
    ordered.emplace(rank_of(*one.first), &one);
  for (const auto& [rank, one] : ordered)
    if (auto done = enter_one(*one->first, one->second, request, reads_files_); !done) return done;
  const bool curves = request.allowance &&
                      std::holds_alternative<MaterialCurves>(*request.allowance);
  if (auto twice = second_k_rule(*this, curves)) return tl::unexpected(std::move(*twice));
  if (!request.shop) return {};
  request.shop->density_given = given("density");
  // `planish bend --material steel` takes a word that it knows for the metal.
  for (const std::string& name : {request.material, text("metal")})
    if (!request.shop->material) take_material(request, name);
  if (auto wrong = unstocked_file(request)) return tl::unexpected(std::move(*wrong));
  request.shop->strength_given = given("metal");
  request.shop->gauge_limits = !given("rules") && !given("process");
  return {};
}

const Option* option_at(std::string_view where) {
  const std::string_view name = where.substr(0, where.find('/'));
  const auto all = options();
  const auto found = std::ranges::find(all, name, &Option::name);
  if (found == all.end()) return nullptr;
  // Behind any other name stands a file that happens to be called so.
  const bool has_places = found->kind == OptionKind::by_bend || found->kind == OptionKind::file;
  return name == where || has_places ? &*found : nullptr;
}

Error at_pointer(Error error, const std::string& options) {
  if (!option_at(error.where)) return error;
  error.where = options + "/" + error.where;
  // What is wrong within the content of a file has its place there.
  if (error.code.status == ExitStatus::usage) error.places.push_back(place::pointer(error.where));
  return error;
}

std::optional<double> parse_number(const std::string& text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace planish::job
