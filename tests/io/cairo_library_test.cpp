#include "cairo_library.hpp"

#include <gtest/gtest.h>

#include <string>

namespace planish::io_detail {
namespace {

TEST(CairoLibrary, IsLoadedOnceWithEveryFunction) {
  const auto library = cairo();
  ASSERT_TRUE(library);
  EXPECT_EQ(*library, *cairo());
#define PLANISH_CAIRO_IS_THERE(name) EXPECT_NE((*library)->name, nullptr) << #name;
  PLANISH_CAIRO_FUNCTIONS(PLANISH_CAIRO_IS_THERE)
#undef PLANISH_CAIRO_IS_THERE
}

TEST(CairoLibrary, WritesAPage) {
  const auto library = cairo();
  ASSERT_TRUE(library);
  const Cairo& c = **library;
  std::string bytes;
  const auto write = [](void* to, const unsigned char* data, unsigned count) {
    static_cast<std::string*>(to)->append(reinterpret_cast<const char*>(data), count);
    return CAIRO_STATUS_SUCCESS;
  };
  cairo_surface_t* surface = c.pdf_surface_create_for_stream(write, &bytes, 100, 50);
  cairo_t* pen = c.create(surface);
  c.move_to(pen, 1, 2);
  c.line_to(pen, 30, 40);
  c.stroke_preserve(pen);
  c.show_page(pen);
  EXPECT_EQ(c.status(pen), CAIRO_STATUS_SUCCESS);
  c.destroy(pen);
  c.surface_finish(surface);
  EXPECT_EQ(c.surface_status(surface), CAIRO_STATUS_SUCCESS);
  c.surface_destroy(surface);
  EXPECT_TRUE(bytes.starts_with("%PDF-"));
  EXPECT_NE(bytes.find("/MediaBox [ 0 0 100 50 ]"), std::string::npos);
}

}  // namespace
}  // namespace planish::io_detail
