#pragma once

#include <planish/base/result.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::studio {

/// 128 random bits as 32 hexadecimal digits. Error: `internal` if the system cannot supply them.
Result<std::string> random_token();

/// Whether both are equal, in a time that does not reveal where they differ.
bool same_secret(const std::string& a, const std::string& b);

/// What a request says about its origin; a header given twice appears twice.
struct Caller {
  std::vector<std::string> hosts, origins, tokens;
};

/// Admits callers who know the address that was printed.
class Access {
 public:
  Access(int port, std::string token);

  /// A sentence for a rejected caller; empty for others. `host_refusal` suffices for the page
  /// itself, which anyone may see.
  std::optional<std::string> host_refusal(const Caller& caller) const;
  std::optional<std::string> refusal(const Caller& caller) const;

 private:
  bool is_own_host(const std::string& host) const;
  bool is_own_origin(const std::string& origin) const;
  std::optional<std::string> token_refusal(const Caller& caller) const;

  std::vector<std::string> hosts_;  ///< "127.0.0.1:8731", "localhost:8731"
  std::string token_;
};

}  // namespace planish::studio
