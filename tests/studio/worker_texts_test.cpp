#include "worker/worker.hpp"

#include <gtest/gtest.h>

#include <string>

namespace planish::studio {
namespace {

std::string all_bytes() {
  std::string bytes;
  for (int i = 0; i < 256; ++i)
    bytes += static_cast<char>(i);
  return bytes;
}

TEST(WorkerTexts, CarryTasksAndAnswersOfAnyBytes) {
  const auto task = task_of(texts_of(Task{"files", "dxf", all_bytes()}));
  ASSERT_TRUE(task);
  EXPECT_EQ(task->verb, "files");
  EXPECT_EQ(task->argument, "dxf");
  EXPECT_EQ(task->body, all_bytes());
  const auto answer = answer_of(texts_of(Answer{409, "text/plain", all_bytes()}));
  ASSERT_TRUE(answer);
  EXPECT_EQ(answer->status, 409);
  EXPECT_EQ(answer->type, "text/plain");
  EXPECT_EQ(answer->body, all_bytes());
}

TEST(WorkerTexts, ThatAreNoneAreEmpty) {
  const process::Texts none[] = {{},
                                 {"200"},
                                 {"200", "", "", ""},
                                 {"x", "", ""},
                                 {"-5", "", ""},
                                 {"99999", "", ""},
                                 {"200 ", "", ""}};
  for (const process::Texts& texts : none)
    EXPECT_FALSE(answer_of(texts));
  EXPECT_FALSE(task_of({"draft"}));
}

}  // namespace
}  // namespace planish::studio
