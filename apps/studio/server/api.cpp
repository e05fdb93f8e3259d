#include "api.hpp"

#include "description.hpp"
#include "embedded.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>
#include <vector>

namespace planish::studio {
namespace {

constexpr std::string_view kApi = "/api/";

std::vector<std::string> segments(std::string_view path) {
  std::vector<std::string> all;
  while (!path.empty()) {
    const std::size_t slash = path.find('/');
    all.emplace_back(path.substr(0, slash));
    path.remove_prefix(slash == std::string_view::npos ? path.size() : slash + 1);
  }
  return all;
}

Answer nothing_there(const std::string& path) {
  return failure(404, "not_found", fmt::format("there is nothing at {}", path), path);
}

std::string_view type_of(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 15> kTypes{
      {{".html", "text/html; charset=utf-8"},
       {".js", "text/javascript; charset=utf-8"},
       {".css", "text/css; charset=utf-8"},
       {".json", "application/json"},
       {".svg", "image/svg+xml"},
       {".png", "image/png"},
       {".ico", "image/x-icon"},
       {".woff2", "font/woff2"},
       {".wasm", "application/wasm"},
       {".webmanifest", "application/manifest+json"},
       {".webp", "image/webp"},
       {".txt", "text/plain; charset=utf-8"},
       {".xyz", "text/plain; charset=utf-8"},
       {".map", "application/json"},
       {".step", "model/step"}}};
  for (const auto& [suffix, type] : kTypes)
    if (name.ends_with(suffix)) return type;
  return "application/octet-stream";
}

Answer embedded_answer(const std::string& name, const std::string& path) {
  const EmbeddedFile* file = embedded_file(name);
  if (!file) return nothing_there(path);
  return {200, std::string(type_of(name)), std::string(file->bytes)};
}

Answer page(const ApiRequest& request) {
  if (request.method != "GET") return nothing_there(request.path);
  return embedded_answer("page" + (request.path == "/" ? "/index.html" : request.path),
                         request.path);
}

Answer examples(const ApiRequest& request) {
  constexpr std::string_view kFolder = "/api/examples/";
  if (request.path.size() <= kFolder.size()) return example_list();
  return embedded_answer("examples/" + request.path.substr(kFolder.size()), request.path);
}

Answer kept(KeptFiles& files, const ApiRequest& request, const std::string& name,
            const std::string& body) {
  if (name.empty() && request.method == "GET") return files.list();
  if (!name.empty() && request.method == "GET") return files.read(name);
  if (!name.empty() && request.method == "PUT") return files.write(name, body);
  if (!name.empty() && request.method == "DELETE") return files.remove(name);
  return nothing_there(request.path);
}

/// Answers /api/documents/…, by method and the parts of the path after "documents".
Answer documents(DocumentStore& store, const ApiRequest& request,
                 const std::vector<std::string>& at, std::string body) {
  const std::string& method = request.method;
  const bool posted = method == "POST";
  if (at.empty() && posted) return store.take(request.name, body, Origin::page);
  if (at.empty() && method == "GET") return store.list();
  if (at.size() == 1 && method == "DELETE") return store.close(at[0]);
  if (at.size() == 2 && posted && (at[1] == "draft" || at[1] == "result" || at[1] == "plan"))
    return store.work(at[0], {at[1], "", std::move(body)});
  if (at.size() == 2 && posted && at[1] == "open") return store.open(at[0]);
  if (at.size() == 2 && posted && at[1] == "cancel") return store.cancel(at[0]);
  if (at.size() == 2 && method == "GET" && at[1] == "progress") return store.progress(at[0]);
  if (at.size() == 3 && posted && at[1] == "files")
    return store.work(at[0], {"files", at[2], std::move(body)});
  if (at.size() == 3 && method == "PUT" && at[1] == "attachments")
    return store.attach(at[0], at[2], body);
  return nothing_there(request.path);
}

}  // namespace

std::optional<Answer> Api::turned_away(const ApiRequest& request) const {
  const bool open_to_all = !request.path.starts_with(kApi);
  const auto why = open_to_all ? access_.host_refusal(request.caller)
                               : access_.refusal(request.caller);
  if (!why) return std::nullopt;
  return failure(403, "forbidden", *why);
}

Answer Api::answer(const ApiRequest& request, std::string body) {
  if (!request.path.starts_with(kApi)) return page(request);
  auto at = segments(std::string_view(request.path).substr(kApi.size()));
  const std::string first = at.empty() ? "" : at.front();
  if (first == "examples" && request.method == "GET") return examples(request);
  if (first == "description" && at.size() == 1 && request.method == "GET")
    return description(job::built_in());
  if (first == "kept" && at.size() <= 2)
    return kept(kept_, request, at.size() == 2 ? at[1] : "", body);
  if (first != "documents") return nothing_there(request.path);
  at.erase(at.begin());
  return documents(store_, request, at, std::move(body));
}

}  // namespace planish::studio
