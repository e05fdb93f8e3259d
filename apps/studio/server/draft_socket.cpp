#include "draft_socket.hpp"

#include "api.hpp"

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core.hpp>
#include <boost/beast/http.hpp>
#include <boost/beast/websocket.hpp>
#include <fmt/format.h>

#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

namespace planish::studio {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace http = beast::http;
using asio::ip::tcp;
using Request = http::request<http::empty_body>;
using Stream = beast::websocket::stream<beast::tcp_stream>;

constexpr int kMostConnections = 16;          // each takes a thread; pages do without one, by HTTP
constexpr std::chrono::seconds kPatience(5);  // with whoever does not say what he wants
constexpr std::chrono::milliseconds kScarcity(100);  // where the system has no connection left

struct Connection {
  asio::io_context context;  // of its own, which outlives the socket
  tcp::socket socket{context};
};

Caller caller_of(const Request& request) {
  Caller caller;
  for (const auto& field : request)
    if (field.name() == http::field::origin) caller.origins.emplace_back(field.value());
  // Pages cannot add a header here: the token is the path.
  const auto target = request.target();
  if (!target.empty()) caller.tokens.emplace_back(target.substr(1));
  return caller;
}

void turn_away(beast::tcp_stream& socket, const std::string& why) {
  http::response<http::string_body> response(http::status::forbidden, 11);
  response.set(http::field::content_type, kJsonType);
  response.body() = failure(403, "forbidden", why).body;
  response.prepare_payload();
  beast::error_code ignored;
  http::write(socket, response, ignored);
}

/// A shape as it is; what there is instead as JSON with the status that HTTP would have.
void send(Stream& stream, const Answer& answer, beast::error_code& error) {
  const bool shape = answer.status == 200;
  stream.binary(shape);
  const std::string text = shape ? ""
                                 : fmt::format("{{\"status\":{},", answer.status) +
                                       answer.body.substr(1);
  stream.write(asio::buffer(shape ? answer.body : text), error);
}

/// "d1", a line feed and a request.
Answer answered(DocumentStore& store, const std::string& message) {
  const std::size_t end = message.find('\n');
  if (end == std::string::npos)
    return failure(400, "bad_request", "a document, a line feed and a request are expected");
  return store.work(message.substr(0, end), {"draft", "", message.substr(end + 1)});
}

void converse(Stream& stream, DocumentStore& store) {
  beast::error_code error;
  while (!error) {
    beast::flat_buffer buffer;
    stream.read(buffer, error);
    if (!error) send(stream, answered(store, beast::buffers_to_string(buffer.data())), error);
  }
}

/// The request that opens a connection, if it comes soon.
std::optional<Request> first_request(beast::tcp_stream& socket, asio::io_context& context) {
  beast::flat_buffer buffer;
  Request request;
  beast::error_code failed = asio::error::timed_out;
  socket.expires_after(kPatience);
  http::async_read(socket, buffer, request,
                   [&](beast::error_code error, std::size_t) { failed = error; });
  context.run();
  socket.expires_never();
  return failed ? std::nullopt : std::optional(std::move(request));
}

void attend(Connection& connection, const Access& access, DocumentStore& store) {
  beast::tcp_stream socket(std::move(connection.socket));
  const auto request = first_request(socket, connection.context);
  if (!request) return;
  if (const auto why = access.socket_refusal(caller_of(*request))) return turn_away(socket, *why);
  beast::error_code error;
  socket.socket().set_option(tcp::no_delay(true), error);
  Stream stream(std::move(socket));
  stream.read_message_max(kLargestBody);
  stream.accept(*request, error);
  if (!error) converse(stream, store);
}

}  // namespace

struct DraftSocket::Content {
  asio::io_context context;
  tcp::acceptor acceptor{context};
  std::atomic<int> connections = 0;

  void attend_next(const Access& access, DocumentStore& store) {
    beast::error_code error;
    auto connection = std::make_unique<Connection>();
    acceptor.accept(connection->socket, error);
    if (error) std::this_thread::sleep_for(kScarcity);
    if (error || connections >= kMostConnections) return;
    ++connections;
    std::thread([this, &access, &store, taken = std::move(connection)] {
      attend(*taken, access, store);
      --connections;
    }).detach();
  }
};

DraftSocket::DraftSocket() : content_(std::make_unique<Content>()) {}
DraftSocket::~DraftSocket() = default;

Result<int> DraftSocket::bind() {
  const tcp::endpoint any(asio::ip::address_v4::loopback(), 0);
  beast::error_code error;
  tcp::acceptor& acceptor = content_->acceptor;
  acceptor.open(any.protocol(), error);
  if (!error) acceptor.bind(any, error);
  if (!error) acceptor.listen(kMostConnections, error);
  if (error)
    return fail(ErrorCode::internal,
                fmt::format("no port can be had for drafts: {}", error.message()));
  return acceptor.local_endpoint().port();
}

void DraftSocket::serve(const Access& access, DocumentStore& store) {
  std::thread([this, access, &store] {
    for (;;)
      content_->attend_next(access, store);
  }).detach();
}

}  // namespace planish::studio
