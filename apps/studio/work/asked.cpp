#include "asked.hpp"

#include "json_text.hpp"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>

namespace planish::studio {
namespace {

using Read = std::function<bool(const Json&)>;

template <typename T>
Read choice(T& target, std::map<std::string, T> words) {
  return [&target, words = std::move(words)](const Json& value) {
    if (!value.is_string()) return false;
    const auto found = words.find(value.get<std::string>());
    if (found == words.end()) return false;
    target = found->second;
    return true;
  };
}

Read whole(int& target, int least) {
  return [&target, least](const Json& value) {
    constexpr int kMost = 1'000'000;
    if (!value.is_number_integer() || value < least || value > kMost) return false;
    target = value.get<int>();
    return true;
  };
}

/// A word, or a face's number.
Read face(std::string& target) {
  return [&target](const Json& value) {
    if (value.is_string()) target = value.get<std::string>();
    if (value.is_number_integer()) target = value.dump();
    return value.is_string() || value.is_number_integer();
  };
}

std::optional<double> share(const Json& value) {
  if (!value.is_number()) return std::nullopt;
  const double number = value.get<double>();
  return number >= 0.0 && number <= 1.0 ? std::optional(number) : std::nullopt;
}

Read k_factor(std::optional<AllowanceRule>& target) {
  return [&target](const Json& value) {
    if (value == "din6935") target = Din6935{};
    if (const auto k = share(value)) target = ConstantK{*k, "constant"};
    return target.has_value();
  };
}

Read k_by_bend(std::vector<std::pair<std::string, double>>& target) {
  return [&target](const Json& value) {
    if (!value.is_object()) return false;
    for (const auto& [id, number] : value.items()) {
      const auto k = share(number);
      if (!k) return false;
      target.emplace_back(id, *k);
    }
    return true;
  };
}

Read positive(std::optional<double>& target) {
  return [&target](const Json& value) {
    if (!value.is_number() || !(value.get<double>() > 0.0) || !std::isfinite(value.get<double>()))
      return false;
    target = value.get<double>();
    return true;
  };
}

Read yes_or_no(std::optional<bool>& target) {
  return [&target](const Json& value) {
    if (value.is_boolean()) target = value.get<bool>();
    return value.is_boolean();
  };
}

std::map<std::string, Read> options_of(Asked& asked) {
  return {{"body", whole(asked.body, 1)},
          {"root", face(asked.root)},
          {"up", face(asked.up)},
          {"k", k_factor(asked.k)},
          {"bend_k", k_by_bend(asked.bend_k)},
          {"density", positive(asked.density)},
          {"piece", whole(asked.piece, 0)},
          {"align_scans", yes_or_no(asked.align_scans)},
          {"profile",
           choice<LayerProfile>(asked.dxf.profile, {{"standard", LayerProfile::standard},
                                                    {"inventor", LayerProfile::inventor},
                                                    {"onshape", LayerProfile::onshape},
                                                    {"solid_edge", LayerProfile::solid_edge}})},
          {"splines",
           choice<Splines>(asked.dxf.splines, {{"arcs", Splines::arcs}, {"keep", Splines::keep}})},
          {"version", choice<DxfVersion>(asked.dxf.version,
                                         {{"r2000", DxfVersion::r2000}, {"r12", DxfVersion::r12}})},
          {"units", choice<std::optional<LengthUnit>>(asked.units, {{"mm", LengthUnit::mm},
                                                                    {"inch", LengthUnit::inch},
                                                                    {"m", LengthUnit::m}})}};
}

tl::unexpected<Error> mistake(const std::string& message, const std::string& where) {
  return fail(ErrorCode::invalid_input, message, where);
}

Result<void> read_options(const Json& options, Asked& asked) {
  if (!options.is_object()) return mistake("options must be an object", "/options");
  const auto known = options_of(asked);
  for (const auto& [key, value] : options.items()) {
    const auto option = known.find(key);
    if (option == known.end())
      return mistake(fmt::format("there is no option \"{}\"", key), "/options/" + key);
    // What is null is not given.
    if (!value.is_null() && !option->second(value))
      return mistake(
          fmt::format("the option \"{}\" cannot be {}", key, json_text(value).substr(0, 40)),
          "/options/" + key);
  }
  return {};
}

}  // namespace

Result<Asked> parse_asked(const std::string& text) {
  const auto json = parse_json(text, "request");
  if (!json) return tl::unexpected(json.error());
  if (!json->is_object()) return mistake("the request must be an object", "");
  Asked asked;
  asked.key = text;
  for (const auto& [key, value] : json->items()) {
    if (key == "spec") {
      if (!value.is_null()) asked.spec = json_text(value);
    } else if (key == "options") {
      if (auto read = read_options(value, asked); !read) return tl::unexpected(read.error());
    } else {
      return mistake(fmt::format("a request has no key \"{}\"", key), "/" + key);
    }
  }
  return asked;
}

job::MakeRequest make_request(const Asked& asked, const std::string& name, job::Effort effort) {
  job::MakeRequest request;
  request.effort = effort;
  request.density = asked.density;
  request.input = name;
  request.allowance = asked.k;
  request.units = asked.units;
  return request;
}

}  // namespace planish::studio
