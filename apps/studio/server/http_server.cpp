#include "http_server.hpp"

#include "../refusals.hpp"
#include "connections.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

namespace planish::studio {
namespace {

constexpr auto kHost = "127.0.0.1";
constexpr auto kAnyPath = R"(/.*)";
constexpr std::size_t kLongestTarget = 2048;

// Scripts may set styles on elements; scripts come only from this server.
constexpr auto kContentPolicy =
    "default-src 'self'; script-src 'self'; style-src 'self' 'unsafe-inline'; img-src 'self' data: "
    "blob:; connect-src 'self'; "
    "worker-src 'self' blob:; object-src 'none'; base-uri 'none'; form-action 'none'; "
    "frame-ancestors 'none'";

httplib::Headers security_headers() {
  return {{"Content-Security-Policy", kContentPolicy},
          {"X-Content-Type-Options", "nosniff"},
          {"X-Frame-Options", "DENY"},
          {"Referrer-Policy", "no-referrer"},
          {"Cross-Origin-Opener-Policy", "same-origin"},
          {"Cross-Origin-Resource-Policy", "same-origin"},
          {"Cache-Control", "no-store"}};
}

std::vector<std::string> values_of(const httplib::Request& request, const char* header) {
  std::vector<std::string> values;
  for (std::size_t i = 0; i < request.get_header_value_count(header); ++i)
    values.push_back(request.get_header_value(header, i));
  return values;
}

ApiRequest api_request(const httplib::Request& request) {
  return {request.method == "HEAD" ? "GET" : request.method,
          request.path,
          request.get_param_value("name"),
          {values_of(request, "Host"), values_of(request, "Origin"),
           values_of(request, "X-Planish-Token")}};
}

// Status for invalid input. Dragging passes through invalid input all the time, and browsers log
// every answer with such a status as a failure of the page.
constexpr int kInvalidInput = 422;
constexpr auto kProblemType = "application/problem+json";

void send(httplib::Response& response, const Answer& answer) {
  const bool problem = answer.status == kInvalidInput;
  response.status = problem ? 200 : answer.status;
  if (!answer.type.empty()) response.set_content(answer.body, problem ? kProblemType : answer.type);
}

Answer too_large() {
  return failure(413, "too_large",
                 fmt::format("the body is larger than {} MiB", kLargestBody >> 20));
}

/// Reads the rest of a rejected request: a connection closed with unread data loses the answer.
void skip_body(const httplib::Request& request, const httplib::ContentReader& reader) {
  std::size_t left = kLargestBody;
  const auto skip = [&left](const char*, std::size_t count) {
    left -= std::min(left, count);
    return left > 0;
  };
  if (request.is_multipart_form_data())
    reader([](const httplib::MultipartFormData&) { return true; }, skip);
  else
    reader(skip);
}

/// The body, or the answer if it cannot be had.
tl::expected<std::string, Answer> body_of(const httplib::Request& request,
                                          const httplib::Response& response,
                                          const httplib::ContentReader& reader) {
  if (request.is_multipart_form_data()) {
    skip_body(request, reader);
    return tl::unexpected(failure(400, "bad_request", "forms are not supported"));
  }
  std::string body;
  bool fits = true;
  // A compressed body may be far larger than its length says.
  const bool read = reader([&](const char* bytes, std::size_t count) {
    fits = body.size() + count <= kLargestBody;
    if (fits) body.append(bytes, count);
    return fits;
  });
  if (read) return body;
  if (!fits || response.status == 413) return tl::unexpected(too_large());
  return tl::unexpected(failure(400, "bad_request", "the body could not be read"));
}

void with_body(Api& api, const httplib::Request& request, httplib::Response& response,
               const httplib::ContentReader& reader) {
  const ApiRequest asked = api_request(request);
  if (const auto no = api.turned_away(asked)) {
    skip_body(request, reader);
    return send(response, *no);
  }
  auto body = body_of(request, response, reader);
  send(response, body ? api.answer(asked, std::move(*body)) : body.error());
}

/// An answer that goes on for as long as the page that asked is open: then writing to it fails.
void hold(Presence& presence, httplib::Response& response) {
  constexpr std::chrono::seconds kBeat{1};
  presence.arrive();
  response.set_chunked_content_provider(
      "text/plain",
      [kBeat](std::size_t, httplib::DataSink& sink) {
        std::this_thread::sleep_for(kBeat);
        return sink.write(".", 1);
      },
      [&presence](bool) { presence.leave(); });
}

void without_body(Api& api, Presence* presence, const httplib::Request& request,
                  httplib::Response& response) {
  const ApiRequest asked = api_request(request);
  const auto no = api.turned_away(asked);
  const bool stays = !no && request.method == "GET" && asked.path == "/api/presence";
  if (stays && presence) return hold(*presence, response);
  send(response, no ? *no : stays ? Answer{204, "", ""} : api.answer(asked, {}));
}

/// The library would compress texts at the highest level, which takes seconds, while sending them
/// takes none. Its only switch is what the browser accepts; the request belongs to the library and
/// is not constant.
void answer_uncompressed(const httplib::Request& request) {
  const_cast<httplib::Request&>(request).headers.erase("Accept-Encoding");
}

/// Answers of the library itself have no body.
void explain(const httplib::Request& request, httplib::Response& response) {
  if (!response.body.empty()) return;
  send(response,
       response.status == 413
           ? too_large()
           : failure(response.status, response.status == 404 ? "not_found" : "bad_request",
                     "the request is not understood", request.path));
}

}  // namespace

struct HttpServer::Content {
  ConnectionServer server;
  std::thread listening;
};

HttpServer::HttpServer() : content_(std::make_unique<Content>()) {
  httplib::Server& server = content_->server;
  server.new_task_queue = [] { return new ConnectionThreads; };
  server.set_tcp_nodelay(true);
  server.set_keep_alive_timeout(ConnectionServer::kIdle.count());
  server.set_keep_alive_max_count(ConnectionServer::kMostRequests);
  server.set_payload_max_length(kLargestBody);
  // By default the library lets a second server take the same port and half of the requests.
  server.set_socket_options([](socket_t socket) {
    const int yes = 1;
    setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
  });
}

HttpServer::~HttpServer() {
  content_->server.stop();
  if (content_->listening.joinable()) content_->listening.join();
}

Result<int> HttpServer::bind(int port) {
  httplib::Server& server = content_->server;
  const int taken = port == 0                          ? server.bind_to_any_port(kHost)
                    : server.bind_to_port(kHost, port) ? port
                                                       : -1;
  if (taken > 0) return taken;
  return fail(refuse::port_taken, {{"port", port}, {"host", kHost}}, "--port");
}

void HttpServer::serve(Api& api, Presence* presence) {
  httplib::Server& server = content_->server;
  server.set_default_headers(security_headers());
  server.set_pre_routing_handler([](const httplib::Request& request, httplib::Response& response) {
    answer_uncompressed(request);
    // Checked before paths are matched, which takes memory in proportion to their length.
    if (request.target.size() <= kLongestTarget) return httplib::Server::HandlerResponse::Unhandled;
    send(response, failure(400, "bad_request", "the address is too long"));
    return httplib::Server::HandlerResponse::Handled;
  });
  const auto read = [&api](const httplib::Request& q, httplib::Response& r,
                           const httplib::ContentReader& c) { with_body(api, q, r, c); };
  server.Get(kAnyPath, [&api, presence](const httplib::Request& q, httplib::Response& r) {
    without_body(api, presence, q, r);
  });
  server.Post(kAnyPath, read);
  server.Put(kAnyPath, read);
  server.Delete(kAnyPath, read);
  server.set_error_handler(explain);
  content_->listening = std::thread([&server] { server.listen_after_bind(); });
}

}  // namespace planish::studio
