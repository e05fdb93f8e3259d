#pragma once

#include <planish/schema/schema.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <functional>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace planish::test {

/// Values by where they are in a file.
using ValuesAt = std::map<std::string, nlohmann::json>;

/// A file of which every value is to matter to some answer.
struct FileOfValues {
  const schema::Schema& schema;
  nlohmann::json plain;  ///< has every key of the schema
  /// Valid values that matter, by where they are.
  ValuesAt changes;
  std::map<std::string, ValuesAt> also;  ///< what has to change beside a change
  std::set<std::string> told;            ///< for people alone, or the format itself
  /// What is answered with such a file, in one text.
  std::function<std::string(const nlohmann::json&)> answers;
};

/// The pointers of values, a list of anything but objects being one.
inline void add_values(const nlohmann::json& value, const std::string& at,
                       std::set<std::string>& found) {
  const bool is_list_of_objects = value.is_array() && !value.empty() && value[0].is_object();
  if (!value.is_object() && !is_list_of_objects) {
    found.insert(at);
    return;
  }
  for (const auto& [key, item] : value.items())
    add_values(item, at + "/" + key, found);
}

/// The same of a schema, with "0" for each item of a list.
inline void add_keys(const schema::Schema& schema, const std::string& at,
                     std::set<std::string>& found) {
  const bool is_list_of_objects = schema.kind == schema::Schema::Kind::list &&
                                  !schema.parts[0].fields.empty();
  if (is_list_of_objects) return add_keys(schema.parts[0], at + "/0", found);
  if (schema.fields.empty()) found.insert(at);
  for (const schema::Field& field : schema.fields)
    add_keys(field.value, at + "/" + field.key, found);
}

/// A key that is added to the format fails here until a change of it is known that matters.
inline void expect_each_changes_some_answer(const FileOfValues& file) {
  std::set<std::string> values, keys, known;
  add_values(file.plain, "", values);
  add_keys(file.schema, "", keys);
  for (const std::string& value : values)
    known.insert(std::regex_replace(value, std::regex("/[0-9]+"), "/0"));
  for (const std::string& key : keys)
    EXPECT_TRUE(known.contains(key)) << "the file lacks " << key;
  const std::string plain = file.answers(file.plain);
  for (const std::string& value : values) {
    if (file.told.contains(value)) continue;
    const auto change = file.changes.find(value);
    if (change == file.changes.end()) {
      ADD_FAILURE() << "say how " << value << " matters";
      continue;
    }
    nlohmann::json changed = file.plain;
    changed[nlohmann::json::json_pointer(value)] = change->second;
    if (const auto also = file.also.find(value); also != file.also.end())
      for (const auto& [at, other] : also->second)
        changed[nlohmann::json::json_pointer(at)] = other;
    EXPECT_TRUE(file.answers(changed) != plain) << value << " changes nothing";
  }
}

}  // namespace planish::test
