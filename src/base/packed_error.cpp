// Every field of an error is one text, lists are led by their length, and numbers are written as
// hexadecimal floating point, so that they come back to the last bit.

#include <planish/base/packed_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <mutex>
#include <set>

namespace planish {
namespace {

constexpr std::string_view kMark = "error";
constexpr long long kMostWhole = 2147483647;

/// The string of a set that never loses one.
std::string_view kept(std::string_view text) {
  static std::mutex mutex;
  static std::set<std::string, std::less<>> texts;
  const std::lock_guard lock(mutex);
  return *texts.emplace(text).first;
}

class Packing {
 public:
  void text(std::string_view value) { texts_.emplace_back(value); }
  void whole(long long value) { texts_.push_back(std::to_string(value)); }
  void number(double value) { texts_.push_back(fmt::format("{:a}", value)); }

  void id(const Place::Id& id) {
    whole(static_cast<long long>(id.index()));
    if (const int* number = std::get_if<int>(&id)) whole(*number);
    if (const std::string* name = std::get_if<std::string>(&id)) text(*name);
  }
  void place(const Place& place) {
    whole(static_cast<int>(place.kind));
    id(place.id);
    whole(std::ssize(place.at));
    for (const double x : place.at)
      number(x);
    whole(std::ssize(place.faces));
    for (const int face : place.faces)
      whole(face);
  }

  std::vector<std::string> take() { return std::move(texts_); }

 private:
  std::vector<std::string> texts_;
};

/// Reads what `Packing` wrote. After a fault everything read is empty, and `fine` says so.
class Unpacking {
 public:
  explicit Unpacking(std::span<const std::string> texts) : texts_(texts) {}

  std::string text() {
    if (at_ < texts_.size()) return texts_[at_++];
    fine_ = false;
    return {};
  }
  long long whole(long long least, long long most) {
    const std::string word = text();
    char* end = nullptr;
    const long long value = std::strtoll(word.c_str(), &end, 10);
    fine_ = fine_ && !word.empty() && *end == '\0' && value >= least && value <= most;
    return fine_ ? value : least;
  }
  long long count() { return whole(0, std::ssize(texts_)); }
  double number() {
    const std::string word = text();
    char* end = nullptr;
    const double value = std::strtod(word.c_str(), &end);
    fine_ = fine_ && !word.empty() && *end == '\0';
    return value;
  }
  Place::Id id() {
    switch (whole(0, 2)) {
      case 1:
        return static_cast<int>(whole(-kMostWhole, kMostWhole));
      case 2:
        return text();
      default:
        return {};
    }
  }
  Place place() {
    Place place;
    place.kind = static_cast<PlaceKind>(whole(0, static_cast<int>(PlaceKind::line)));
    place.id = id();
    for (long long left = count(); left > 0 && fine_; --left)
      place.at.push_back(number());
    for (long long left = count(); left > 0 && fine_; --left)
      place.faces.push_back(static_cast<int>(whole(0, kMostWhole)));
    return place;
  }

  bool fine() const { return fine_; }
  bool at_end() const { return at_ == texts_.size(); }

 private:
  std::span<const std::string> texts_;
  std::size_t at_ = 0;
  bool fine_ = true;
};

}  // namespace

ErrorCode received_code(std::string_view name, ExitStatus status) { return {kept(name), status}; }

std::vector<std::string> packed(const Error& error) {
  Packing out;
  out.text(kMark);
  out.text(error.code.name);
  out.whole(exit_status(error.code));
  out.text(error.message);
  out.text(error.where);
  out.whole(std::ssize(error.places));
  for (const Place& place : error.places)
    out.place(place);
  out.whole(std::ssize(error.numbers));
  for (const NamedQuantity& number : error.numbers) {
    out.text(number.name);
    out.number(number.quantity.value);
    out.text(number.quantity.unit);
  }
  out.whole(std::ssize(error.remedies));
  for (const Remedy& remedy : error.remedies) {
    out.text(remedy.option);
    out.text(remedy.value);
    out.text(remedy.change);
  }
  out.whole(std::ssize(error.named));
  for (const Named& named : error.named) {
    out.whole(static_cast<long long>(named.at));
    out.text(named.text);
    out.text(named.option);
    out.place(named.place);
  }
  return out.take();
}

std::optional<Error> unpacked(std::span<const std::string> texts) {
  Unpacking in(texts);
  if (in.text() != kMark) return std::nullopt;
  Error error;
  const std::string name = in.text();
  error.code = received_code(name, static_cast<ExitStatus>(in.whole(0, 4)));
  error.message = in.text();
  error.where = in.text();
  for (long long left = in.count(); left > 0 && in.fine(); --left)
    error.places.push_back(in.place());
  for (long long left = in.count(); left > 0 && in.fine(); --left) {
    NamedQuantity number{in.text(), {in.number()}};
    number.quantity.unit = kept(in.text());
    error.numbers.push_back(std::move(number));
  }
  for (long long left = in.count(); left > 0 && in.fine(); --left) {
    Remedy remedy{in.text(), in.text(), in.text()};
    error.remedies.push_back(std::move(remedy));
  }
  for (long long left = in.count(); left > 0 && in.fine(); --left) {
    const auto at = static_cast<unsigned>(in.whole(0, kMostWhole));
    Named named{at, in.text(), in.text()};
    named.place = in.place();
    error.named.push_back(std::move(named));
  }
  if (!in.fine() || !in.at_end()) return std::nullopt;
  return error;
}

}  // namespace planish
