#pragma once

#include <planish/job/part_materials.hpp>
#include <planish/job/report.hpp>
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

/// What a part is made of and how often: enters in its report what the list of materials says of
/// it, or else the material chosen for all. What its file says stays where nobody says otherwise.
void enter_material(Report& report, const Request& request);

/// The request for the part of a report, which is entered as above: with a shop's density, strength
/// and K of that material, which then has the shop's spelling. Error: as `unchosen`.
Result<Request> request_of_part(const Request& request, Report& report);

/// What is wrong with the file of a material that a shop of several does not have.
std::optional<Error> unstocked_file(const Request& request);

/// What is wrong with a request whose shop has several materials and none is chosen; `material`:
/// what the part's file says.
std::optional<Error> unchosen(const Request& request, const std::string& material = {});

}  // namespace planish::job
