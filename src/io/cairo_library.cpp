#include "cairo_library.hpp"

#include "refusals.hpp"

#include <dlfcn.h>
namespace planish::io_detail {
namespace {

constexpr const char* kLibrary = "libcairo.so.2";

/// Finds functions by name, and remembers the first that is missing.
class Symbols {
 public:
  explicit Symbols(void* library) : library_(library) {}

  template <typename Function>
  void find(Function*& function, const char* name) {
    function = reinterpret_cast<Function*>(dlsym(library_, name));
    if (function == nullptr && missing_ == nullptr) missing_ = name;
  }
  const char* missing() const { return missing_; }

 private:
  void* library_;
  const char* missing_ = nullptr;
};

Result<Cairo> load() {
  void* library = dlopen(kLibrary, RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) return fail(refuse::no_cairo, {{"library", kLibrary}});
  Cairo cairo;
  Symbols symbols(library);
#define PLANISH_CAIRO_FIND(name) symbols.find(cairo.name, "cairo_" #name);
  PLANISH_CAIRO_FUNCTIONS(PLANISH_CAIRO_FIND)
#undef PLANISH_CAIRO_FIND
  if (symbols.missing() != nullptr)
    return fail(refuse::old_cairo, {{"library", kLibrary}, {"function", symbols.missing()}});
  return cairo;
}

}  // namespace

Result<const Cairo*> cairo() {
  static const Result<Cairo> loaded = load();
  if (!loaded) return pass_on(loaded);
  return &*loaded;
}

}  // namespace planish::io_detail
