#include "refusals.hpp"

#include <planish/base/id_vector.hpp>
#include <planish/shop/rates.hpp>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

// Prices from a shop's rates (pack.md#rates): a part costs its setup once, and each piece the sum
// of what is counted times its rate. Nothing is guessed: a material without rates, or a rate by
// weight where the mass is unknown, is an error, never a price that is too low.

namespace planish::shop {
namespace {

using RatesJson = nlohmann::ordered_json;

struct RateKey {
  std::string_view name;
  double Rates::Row::*value;
};
constexpr std::array kRateKeys{
    RateKey{"cut", &Rates::Row::cut},   RateKey{"pierce", &Rates::Row::pierce},
    RateKey{"bend", &Rates::Row::bend}, RateKey{"setup", &Rates::Row::setup},
    RateKey{"kg", &Rates::Row::kg},     RateKey{"area", &Rates::Row::area}};

tl::unexpected<Error> wrong_rates(const std::string& file, const std::string& pointer,
                                  const Refusal& refusal, Facts facts = {}) {
  facts.emplace_back("file", file);
  if (!pointer.empty()) facts.emplace_back("field", place::pointer(pointer));
  return fail(refusal, facts, file + pointer);
}

Result<Rates::Row> rates_row(const std::string& file, const std::string& pointer,
                             const RatesJson& json) {
  if (!json.is_object()) return wrong_rates(file, pointer, refuse::row_no_object);
  Rates::Row row;
  for (const auto& [key, value] : json.items()) {
    const std::string at = pointer + "/" + escaped_token(key);
    const auto found = std::ranges::find(kRateKeys, key, &RateKey::name);
    if (found == kRateKeys.end()) {
      const auto known = mapped(kRateKeys, &RateKey::name);
      return wrong_rates(file, at, refuse::unknown_rate,
                         {{"known", fmt::format("{}", fmt::join(known, ", "))}});
    }
    if (!value.is_number() || !(value.get<double>() >= 0.0))
      return wrong_rates(file, at, refuse::bad_rate);
    row.*(found->value) = value.get<double>();
  }
  return row;
}

double cost_at(const PricedPart& part, const Rates::Row& rates) {
  const double each = rates.cut * part.cut_length +
                      rates.pierce * static_cast<double>(part.pierces) +
                      rates.bend * static_cast<double>(part.bends) +
                      rates.kg * part.mass.value_or(0.0) +
                      rates.area * part.size.x() * part.size.y();
  return rates.setup + each * part.quantity;
}

}  // namespace

Result<Rates> Rates::parse(const std::string& text, const std::string& file) {
  const RatesJson json = RatesJson::parse(text, nullptr, false);
  if (!json.is_object()) return wrong_rates(file, "", refuse::rates_no_object);
  Rates rates;
  rates.name_ = file;
  for (const auto& [key, value] : json.items()) {
    const std::string at = "/" + escaped_token(key);
    if (key == "format" || key == "version") {
      const bool fits = key == "format" ? value == "planish/rates" : value == 1;
      if (!fits) return wrong_rates(file, at, refuse::not_rates);
    } else if (key == "currency" && value.is_string()) {
      rates.currency_ = value.get<std::string>();
    } else if (key == "materials" && value.is_object()) {
      for (const auto& [material, row] : value.items()) {
        auto read = rates_row(file, at + "/" + escaped_token(material), row);
        if (!read) return pass_on(read);
        rates.rows_.emplace(material, *read);
      }
    } else {
      return wrong_rates(file, at, refuse::unknown_rates_key);
    }
  }
  if (rates.rows_.empty()) return wrong_rates(file, "/materials", refuse::no_rates);
  return rates;
}

Result<double> Rates::cost_of(const PricedPart& part) const {
  const auto row = rows_.find(part.material);
  if (row == rows_.end()) {
    const auto known = mapped(rows_, [](const auto& entry) { return entry.first; });
    return fail(refuse::no_rates_of,
                {{"file", name_},
                 {"material", part.material},
                 {"part", part.name},
                 {"known", fmt::format("{}", fmt::join(known, ", "))}},
                "rates");
  }
  if (row->second.kg > 0.0 && !part.mass)
    return fail(refuse::mass_unknown,
                {{"part", part.name}, {"file", name_}, {"material", part.material}}, "rates");
  return cost_at(part, row->second);
}

}  // namespace planish::shop
