#include "guarded.hpp"

#include "refusals.hpp"

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Message_Printer.hxx>

#include <mutex>

namespace planish::brep {

void silence_kernel() {
  static std::once_flag once;
  std::call_once(
      once, [] { Message::DefaultMessenger()->RemovePrinters(STANDARD_TYPE(Message_Printer)); });
}

Error foreign_error(const std::string& kind, const char* message, std::string where) {
  std::string what = kind;
  if (message != nullptr && *message != '\0') what += ": " + std::string(message);
  return error_of(refuse::kernel_failed, {{"what", what}}, std::move(where));
}

Error no_memory(std::string where) { return error_of(refuse::kernel_memory, {}, std::move(where)); }

}  // namespace planish::brep
