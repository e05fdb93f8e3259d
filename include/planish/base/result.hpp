#pragma once

#include <planish/base/message.hpp>

#include <tl/expected.hpp>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace planish {

/// A foreseeable failure. `message` is one sentence, made from `places` and `numbers` by the
/// template beside the code (`Refusal`). `where` is the place as text: a file, a face, a bend, or
/// the path of a field of the request as a JSON pointer (`/bends/1/inside_radius`); empty when the
/// whole input is meant. Front ends use `places`, never the sentence.
struct Error {
  ErrorCode code = code::internal;
  std::string message = {};
  std::string where = {};
  std::vector<Place> places = {};
  std::vector<NamedQuantity> numbers = {};
  std::vector<Remedy> remedies = {};  ///< the best first
  std::vector<Named> named = {};      ///< what `message` names
};

/// The error of a refusal, its sentences made from the facts. `where` is the first pointer among
/// the places, else all places as text, unless it is given.
Error error_of(const Refusal& refusal, const Facts& facts, std::string where = {});

/// The message in pieces, of which a front end spells options and places its own way.
std::vector<Piece> wording(const Error& error);

/// The message as words of another sentence, without its data.
Told words_of(const Error& error);

/// The error with its sentences in another unit. Its numbers and options stay in mm.
Error in_units(Error error, LengthUnit unit);

/// Puts a text before the message.
void say_before(Error& error, std::string_view text);
void say_before(Error& error, const Told& words);

/// Names a place in the message by another one.
void rename_place(Error& error, const Place& from, const Place& to);

/// Puts another message or words behind it, with a blank between, without their data.
void say_after(Error& error, const Error& more);
void say_after(Error& error, const Told& more);

/// A value or an `Error`. Not to be dropped.
template <typename T>
class [[nodiscard]] Result : public tl::expected<T, Error> {
 public:
  using tl::expected<T, Error>::expected;
};

/// `return fail(refuse::thing, {{"bend", place::bend(name)}, {"radius", radius, unit::mm}});`
inline tl::unexpected<Error> fail(const Refusal& refusal, const Facts& facts = {},
                                  std::string where = {}) {
  return tl::unexpected<Error>(error_of(refusal, facts, std::move(where)));
}
inline tl::unexpected<Error> fail(Error error) { return tl::unexpected<Error>(std::move(error)); }

/// Shorthand for `tl::unexpected(Error{...})`.
inline tl::unexpected<Error> fail(const ErrorCode& code, std::string message,
                                  std::string where = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(where)});
}

/// Passes the error of a failed result on: `if (!sheet) return pass_on(sheet);`. Moves it out.
template <typename T>
tl::unexpected<Error> pass_on(Result<T>& failed) {
  return tl::unexpected<Error>(std::move(failed.error()));
}
template <typename T>
tl::unexpected<Error> pass_on(const Result<T>& failed) {
  return tl::unexpected<Error>(failed.error());
}

}  // namespace planish
