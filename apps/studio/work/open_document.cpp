#include "document.hpp"

#include <fmt/format.h>

namespace planish::studio {
namespace {

enum class Kind { unfold, connect, transition, slit };

bool looks_like_json(const std::string& bytes) {
  const std::size_t first = bytes.find_first_not_of(" \t\r\n\xEF\xBB\xBF");
  return first != std::string::npos && (bytes[first] == '{' || bytes[first] == '[');
}

Result<Kind> kind_of_spec(const Json& json, const std::string& name) {
  const auto has = [&](const char* key) { return json.is_object() && json.contains(key); };
  const std::string format = has("format") && json["format"].is_string()
                                 ? json["format"].get<std::string>()
                                 : "";
  if (format == "planish/plates" || (format.empty() && has("plates"))) return Kind::connect;
  if (format == "planish/transition" || (format.empty() && has("from"))) return Kind::transition;
  if (format == "planish/slits" || (format.empty() && has("leg_curve"))) return Kind::slit;
  return fail(
      ErrorCode::invalid_input,
      format.empty()
          ? fmt::format("{} is JSON, but neither a plates, a transition nor a slit file", name)
          : fmt::format("{} has the format \"{}\"; known are planish/plates, planish/transition "
                        "and planish/slits",
                        name, format),
      name + (format.empty() ? "" : "/format"));
}

Result<Kind> kind_of(const std::string& name, const std::string& bytes) {
  if (!looks_like_json(bytes)) return Kind::unfold;
  const auto json = parse_json(bytes, "file");
  if (!json) return fail(json.error().code, json.error().message, name);
  return kind_of_spec(*json, name);
}

}  // namespace

Result<std::unique_ptr<Document>> open_document(const std::string& name, const std::string& bytes,
                                                const std::filesystem::path& attachments,
                                                const Progress& progress) {
  const auto kind = kind_of(name, bytes);
  if (!kind) return tl::unexpected(kind.error());
  switch (*kind) {
    case Kind::connect:
      return open_connect(name, bytes);
    case Kind::transition:
      return open_transition(name, bytes);
    case Kind::slit:
      return open_slit(name, bytes, attachments);
    case Kind::unfold:
      break;
  }
  return open_unfold(name, bytes, progress);
}

}  // namespace planish::studio
