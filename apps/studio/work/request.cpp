#include "request.hpp"

#include "json_text.hpp"

#include <fmt/format.h>

namespace planish::studio {
namespace {

tl::unexpected<Error> mistake(const std::string& message, const std::string& where) {
  return fail(ErrorCode::invalid_input, message, where);
}

Result<void> read_options(const Json& options, const job::Maker& maker, job::Request& request) {
  const auto values = job::read_options(json_text(options), maker, job::OptionFiles::content,
                                        kOptions);
  if (!values) return tl::unexpected(values.error());
  if (auto entered = values->enter(request); !entered)
    return tl::unexpected(job::at_pointer(entered.error(), kOptions));
  return {};
}

}  // namespace

Result<Asked> parse_asked(const std::string& text, const job::Maker& maker) {
  const auto json = parse_json(text, "request");
  if (!json) return tl::unexpected(json.error());
  if (!json->is_object()) return mistake("the request must be an object", "");
  Asked asked;
  asked.key = text;
  for (const auto& [key, value] : json->items()) {
    if (key == "spec") {
      if (!value.is_null()) asked.spec = json_text(value);
    } else if (key == "options") {
      if (auto read = read_options(value, maker, asked.request); !read)
        return tl::unexpected(read.error());
    } else {
      return mistake(fmt::format("a request has no key \"{}\"", key), "/" + key);
    }
  }
  return asked;
}

}  // namespace planish::studio
