#pragma once

#include <planish/job/request.hpp>
#include <planish/shop/shop_checks.hpp>

#include <optional>
#include <string>

namespace planish::job {

/// Puts what a shop says into a request: layers, rules, tools; and its material if it has but one.
void take_shop(Request& to, shop::Shop shop);

/// Puts the material of that name, upper or lower case, into a request with a shop. False where the
/// shop has none of that name.
bool take_material(Request& to, const std::string& name);

/// What is wrong with a request whose shop has several materials and none is chosen; `material`:
/// what the part's file says.
std::optional<Error> unchosen(const Request& request, const std::string& material = {});

}  // namespace planish::job
