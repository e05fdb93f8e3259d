#include "guarded.hpp"

#include <planish/brep/codes.hpp>

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
  std::string text = "The CAD kernel failed (" + kind;
  if (message != nullptr && *message != '\0') text += ": " + std::string(message);
  return {code::kernel_failed, text + ").", std::move(where)};
}

Error no_memory(std::string where) {
  return {code::out_of_memory, "The CAD kernel needs more memory than there is.", std::move(where)};
}

}  // namespace planish::brep
