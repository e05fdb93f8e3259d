#pragma once

#include <planish/base/result.hpp>

#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

#include <exception>
#include <new>
#include <string>
#include <type_traits>
#include <utility>

namespace planish::brep {

/// Removes the kernel's printers from its messenger, once per process: a library must not write to
/// the console. `guarded` calls it.
void silence_kernel();

/// The error for a foreign exception: `kernel_failed`, `what` with the message, `where`.
Error foreign_error(const std::string& kind, const char* message, std::string where);
/// The error for a failed allocation: `out_of_memory`.
Error no_memory(std::string where);

template <typename T>
struct ResultOf {
  using type = Result<T>;
};
template <typename T>
struct ResultOf<Result<T>> {
  using type = Result<T>;
};

/// Runs `f` and returns its result; an exception becomes a `kernel_failed` error with its message,
/// or `out_of_memory`. `f` may return a Result or a plain value. The kernel's Standard_Failure is
/// not a std::exception, so it is caught first. Every call from outside into kernel code goes
/// through here.
template <typename F>
typename ResultOf<std::invoke_result_t<F>>::type guarded(F&& f, std::string where = {}) {
  silence_kernel();
  try {
    if constexpr (std::is_void_v<std::invoke_result_t<F>>) {
      std::forward<F>(f)();
      return {};
    } else {
      return std::forward<F>(f)();
    }
  } catch (const Standard_OutOfMemory&) {
    return tl::unexpected(no_memory(std::move(where)));
  } catch (const std::bad_alloc&) {
    return tl::unexpected(no_memory(std::move(where)));
  } catch (const Standard_Failure& failure) {
    return tl::unexpected(
        foreign_error(failure.DynamicType()->Name(), failure.GetMessageString(), std::move(where)));
  } catch (const std::exception& failure) {
    return tl::unexpected(foreign_error("exception", failure.what(), std::move(where)));
  }
}

}  // namespace planish::brep
