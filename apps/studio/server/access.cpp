#include "access.hpp"

#include "../refusals.hpp"

#include <fmt/format.h>
#include <sys/random.h>

#include <algorithm>
#include <array>
#include <cstddef>

namespace planish::studio {
namespace {

constexpr auto kOtherPages = "requests from other pages are not answered";

}  // namespace

Result<std::string> random_token() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    return fail(refuse::no_random_numbers);
  std::string token;
  for (const unsigned char byte : bytes)
    token += fmt::format("{:02x}", byte);
  return token;
}

bool same_secret(const std::string& a, const std::string& b) {
  unsigned different = a.size() == b.size() ? 0U : 1U;
  for (std::size_t i = 0; i < b.size(); ++i)
    different |= static_cast<unsigned char>(b[i]) ^
                 static_cast<unsigned char>(a.empty() ? '\0' : a[i % a.size()]);
  return different == 0;
}

Access::Access(int port, std::string token)
    : hosts_{fmt::format("127.0.0.1:{}", port), fmt::format("localhost:{}", port)},
      token_(std::move(token)) {}

bool Access::is_own_host(const std::string& host) const {
  return std::ranges::find(hosts_, host) != hosts_.end();
}

bool Access::is_own_origin(const std::string& origin) const {
  constexpr std::string_view kScheme = "http://";
  return origin.starts_with(kScheme) && is_own_host(origin.substr(kScheme.size()));
}

std::optional<std::string> Access::host_refusal(const Caller& caller) const {
  // Another site's name may be made to resolve to this machine (DNS rebinding); Host then has that
  // name.
  if (caller.hosts.size() != 1 || !is_own_host(caller.hosts.front()))
    return "this server answers 127.0.0.1 and localhost only";
  for (const std::string& origin : caller.origins)
    if (!is_own_origin(origin)) return kOtherPages;
  return std::nullopt;
}

std::optional<std::string> Access::token_refusal(const Caller& caller) const {
  if (caller.tokens.size() == 1 && same_secret(caller.tokens.front(), token_)) return std::nullopt;
  return "the token is missing or wrong: open the address that planish studio printed";
}

std::optional<std::string> Access::refusal(const Caller& caller) const {
  const auto why = host_refusal(caller);
  return why ? why : token_refusal(caller);
}

}  // namespace planish::studio
