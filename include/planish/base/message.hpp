#pragma once

#include <planish/base/code.hpp>
#include <planish/base/length_unit.hpp>
#include <planish/base/place.hpp>

#include <concepts>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace planish {

/// Units as reports spell them in `numbers` (formats.md#places).
namespace unit {
inline constexpr std::string_view none = "", mm = "mm", mm2 = "mm²", mm3 = "mm³", degrees = "°",
                                  percent = "%", kilometres = "km", seconds = "s",
                                  mebibytes = "MiB", kilonewtons = "kN", kilograms = "kg";
}  // namespace unit

/// A measured value that a sentence states.
struct Quantity {
  double value = 0.0;
  std::string_view unit = unit::none;
  friend bool operator==(const Quantity&, const Quantity&) = default;
};

struct NamedQuantity {
  std::string name;
  Quantity quantity;
};

/// A part of a sentence that can be spelled in another way: an option of the program, a place, or a
/// quantity with its unit.
struct Named {
  std::size_t at = 0;  ///< bytes of the sentence before it
  std::string text = {};
  std::string option = {};  ///< the option's name as requests spell it; empty: another part
  Place place = {};
  std::optional<Quantity> quantity = {};  ///< empty: an option or a place
  int digits = 0;                         ///< significant ones of the quantity
  bool shows_unit = true;                 ///< likewise
  friend bool operator==(const Named&, const Named&) = default;
};

/// A sentence made from data, beside the data.
struct Told {
  std::string sentence;
  std::vector<Place> places = {};           ///< in the order of the facts
  std::vector<NamedQuantity> numbers = {};  ///< likewise
  std::vector<Named> named = {};            ///< in the order of the sentence
};

/// What would help: an option of the program and its value, or a change to the input in words, or
/// both: then `change` says what the option does.
struct Remedy {
  std::string option = {};  ///< name of the option as requests spell it: "rip_edges"
  std::string value = {};
  std::string change = {};
  std::vector<Named> named = {};  ///< in `change`
  friend bool operator==(const Remedy&, const Remedy&) = default;
};

/// How an option of a request is spelled on the command line: "--k-table" for "k_table".
std::string flag_of(std::string_view option);

/// One value that fills a template: a place, a quantity or words, under the name that the template
/// uses. Several facts of one name make a list. Words may be a sentence of their own: then what
/// they name is named in the whole.
class Fact {
 public:
  Fact(std::string_view name, Place place) : name_(name), value_(std::move(place)) {}
  Fact(std::string_view name, double value, std::string_view unit)
      : name_(name), value_(Quantity{value, unit}) {}
  /// A number without unit, a count.
  template <typename Count>
  requires std::integral<Count> Fact(std::string_view name, Count count)
      : name_(name), value_(Quantity{static_cast<double>(count), unit::none}) {}
  Fact(std::string_view name, Told words) : name_(name), value_(std::move(words)) {}
  Fact(std::string_view name, std::string words) : Fact(name, Told{std::move(words)}) {}
  Fact(std::string_view name, std::string_view words) : Fact(name, std::string(words)) {}
  Fact(std::string_view name, const char* words) : Fact(name, std::string(words)) {}

  std::string_view name() const { return name_; }
  const Place* place() const { return std::get_if<Place>(&value_); }
  const Quantity* quantity() const { return std::get_if<Quantity>(&value_); }
  const Told* words() const { return std::get_if<Told>(&value_); }

 private:
  std::string_view name_;
  std::variant<Place, Quantity, Told> value_;
};

using Facts = std::vector<Fact>;

/// A piece of a sentence: plain text if it names nothing.
struct Piece {
  std::string text = {};
  std::string option = {};
  std::optional<Place> place = {};
};

/// Fills a template. In it stands
/// - `{@name}` for a place, or all places of that name: "face 12", "faces 3, 5 and 12";
/// `{@name:id}`
///   for the same without the kind: "12", "3, 5 and 12";
/// - `{name}` for a quantity with its unit, to four significant digits, or for words;
/// - `{name:6}` for a quantity to six digits; `{name:number}` for one without its unit, where the
///   next one shows it: "12 × 4 mm";
/// - `{name:bend}` for a count and its noun: "1 bend", "3 bends"; `{name:body/bodies}` where the
///   plural is irregular;
/// - `` `name` `` for an option by its name in requests, in backticks that stay: `` `{option}` ``
///   where the name is a fact.
/// What a template needs and the facts do not hold is left as it stands, braces and all. Facts that
/// the template does not name are data all the same: a place that the sentence leaves out.
Told tell(std::string_view pattern, const Facts& facts);

/// The sentence in pieces, of which a front end spells options and places its own way.
std::vector<Piece> wording(const Told& told);

/// Writes the lengths, areas and volumes of a sentence in another unit, and the coordinates of its
/// points; what someone has written anew stays.
void say_in(LengthUnit unit, std::string& sentence, std::vector<Named>& named);
Told in_units(Told told, LengthUnit unit);

/// Puts another sentence with its data behind one, with `between` between them.
void say_after(Told& told, std::string_view between, const Told& more);

/// A number as a sentence shows it: `digits` significant digits, trailing zeros dropped, no minus
/// before 0 and no exponent from 0.001 up to 100,000 and for whole numbers below 10^12.
std::string number_text(double value, int digits = 4);

/// "a", "a and b", "a, b and c".
std::string listed(std::span<const std::string> words);

/// One of the sentences with which a module refuses, beside its code. A module keeps them in one
/// table, `src/<module>/refusals.hpp`. A sentence begins with a capital, unless with a name, and
/// ends with a full stop.
struct Refusal {
  const ErrorCode& code;
  std::string_view pattern;      ///< what is wrong, for `tell`
  std::string_view change = {};  ///< what to do about it, a sentence of its own, for `tell`
  std::string_view option = {};  ///< the option that does it, "rip_edges"; empty: none does
  std::string_view value = {};   ///< of that option, for `tell`
};

}  // namespace planish
