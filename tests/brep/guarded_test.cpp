#include "guarded.hpp"

#include "exchange_lock.hpp"
#include "step_out.hpp"

#include <planish/brep/codes.hpp>

#include <Standard_OutOfRange.hxx>
#include <gtest/gtest.h>

#include <stdexcept>

namespace planish::brep {
namespace {

TEST(Guarded, HandsBackWhatTheFunctionReturns) {
  EXPECT_EQ(guarded([] { return 3; }).value(), 3);
  EXPECT_TRUE(guarded([] {}).has_value());
  EXPECT_EQ(guarded([]() -> Result<int> { return fail(code::no_solid, "none"); }).error().code,
            code::no_solid);
}

TEST(Guarded, TurnsExceptionsIntoErrors) {
  const auto kernel = guarded([]() -> int { throw Standard_OutOfRange("row 7"); }, "body-1");
  ASSERT_FALSE(kernel);
  EXPECT_EQ(kernel.error().code, code::kernel_failed);
  EXPECT_NE(kernel.error().message.find("row 7"), std::string::npos);
  EXPECT_NE(kernel.error().message.find("Standard_OutOfRange"), std::string::npos);
  EXPECT_EQ(kernel.error().where, "body-1");

  const auto library = guarded([] { throw std::runtime_error("disc full"); });
  ASSERT_FALSE(library);
  EXPECT_NE(library.error().message.find("disc full"), std::string::npos);
}

TEST(Guarded, SaysThatMemoryIsWanting) {
  const auto kernel = guarded([]() -> int { throw Standard_OutOfMemory("row 7"); }, "body-1");
  ASSERT_FALSE(kernel);
  EXPECT_EQ(kernel.error().code, code::out_of_memory);
  const auto library = guarded([] { throw std::bad_alloc(); });
  ASSERT_FALSE(library);
  EXPECT_EQ(library.error().code, code::out_of_memory);
}

TEST(StepString, SpellsWhatIsNotAscii) {
  EXPECT_EQ(step_string("plate 7"), "plate 7");
  EXPECT_EQ(step_string("it's"), "it''s");
  EXPECT_EQ(step_string("a\\b"), "a\\\\b");
  EXPECT_EQ(step_string("Blech Größe"), "Blech Gr\\X2\\00F6\\X0\\\\X2\\00DF\\X0\\e");
  EXPECT_EQ(step_string("\xF0\x9F\x94\xA9"), "\\X4\\0001F529\\X0\\");
  EXPECT_EQ(step_string("\xFFx"), "\\X2\\FFFD\\X0\\x");
  EXPECT_EQ(step_string("\xC3"), "\\X2\\FFFD\\X0\\");
}

}  // namespace
}  // namespace planish::brep
