#pragma once

#include <planish/base/result.hpp>

#include <string>
#include <utility>

namespace planish::schema {

/// The error of a field of a request or of another JSON document: its pointer is the place, `field`
/// in the sentence, and so is `where`.
inline Error error_at(const Refusal& refusal, std::string pointer, Facts facts = {}) {
  facts.insert(facts.begin(), {"field", place::pointer(pointer)});
  return error_of(refusal, facts, std::move(pointer));
}
inline tl::unexpected<Error> fail_at(const Refusal& refusal, std::string pointer,
                                     Facts facts = {}) {
  return fail(error_at(refusal, std::move(pointer), std::move(facts)));
}

}  // namespace planish::schema
