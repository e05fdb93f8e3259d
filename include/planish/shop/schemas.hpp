#pragma once

namespace planish::schema {
struct Schema;
}

namespace planish::shop {

/// Schemas of what a shop's files hold; the parsers accept nothing else.
const schema::Schema& rules_schema();
const schema::Schema& material_schema();
const schema::Schema& tools_schema();
const schema::Schema& shop_schema();

}  // namespace planish::shop
