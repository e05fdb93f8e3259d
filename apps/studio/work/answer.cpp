#include "answer.hpp"

#include "json_text.hpp"

#include <planish/job/reason.hpp>

namespace planish::studio {
namespace {

int status_of(ErrorCode code) {
  if (code == code::cancelled) return 409;
  return code == code::internal ? 500 : 422;
}

}  // namespace

Answer failure(int status, const std::string& code, const std::string& message,
               const std::string& where) {
  return {status, kJsonType, json_text({{"code", code}, {"message", message}, {"where", where}})};
}

Answer failure(int status, const Error& error) {
  return {status, kJsonType, job::reason_text(error)};
}

Answer failure(const Error& error) { return failure(status_of(error.code), error); }

}  // namespace planish::studio
