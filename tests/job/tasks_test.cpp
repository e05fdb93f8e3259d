#include <planish/job/artifact.hpp>

#include <gtest/gtest.h>

namespace planish::job {
namespace {

TEST(Tasks, AreAllThatARequestCanName) {
  const Catalogue& all = built_in();
  for (const Maker& maker : all.makers) {
    ASSERT_TRUE(all.task(maker.name)) << maker.name;
    EXPECT_EQ(all.task(maker.name)->reader, Reader::named);
    EXPECT_EQ(all.task(maker.name)->taking(&maker).options.size(), maker.options.size());
  }
  std::set<std::string_view> names;
  for (const Task& task : all.tasks) {
    EXPECT_TRUE(task.run);
    EXPECT_TRUE(names.insert(task.name).second) << task.name;
    EXPECT_FALSE(all.maker(task.name)) << task.name;
    EXPECT_EQ(task.name.empty(), task.reader == Reader::named);
    if (task.name.empty()) continue;
    EXPECT_EQ(all.task(task.name), &task);
    EXPECT_FALSE(task.description.empty() || task.details.empty()) << task.name;
    EXPECT_TRUE(task.artifacts) << task.name << " has no maker of its own whose it could write";
  }
  EXPECT_EQ(all.task("fold"), nullptr);
  EXPECT_EQ(all.task(""), nullptr);
}

TEST(Tasks, TakeOptionsThatThereAre) {
  const Maker& maker = *built_in().maker("unfold");
  for (const Task& task : tasks())
    for (const OptionUse& use : task.taking(&maker).options)
      EXPECT_EQ(use.entry().name, use.name);
}

TEST(BendingWith, TakesWhatMakesTheSheetAndThePressBrake) {
  for (const Maker& maker : built_in().makers) {
    const Maker bending = bending_with(maker);
    EXPECT_EQ(bending.name, "bend");
    EXPECT_EQ(bending.open, maker.open);
    for (const std::string_view name : kPlanOptions)
      EXPECT_TRUE(bending.takes(name)) << name;
    EXPECT_TRUE(bending.takes("metal"));
    EXPECT_TRUE(bending.takes("search_time"));
    EXPECT_TRUE(bending.takes("as_made"));
    for (const char* written : {"profile", "r12", "bend_marks", "rules", "no_rules", "density",
                                "piece", "check_bending", "relief"})
      EXPECT_FALSE(bending.takes(written)) << written;
    for (const OptionUse& use : bending.options)
      if (is_of_sheet_to_bend(option(use.name))) {
        EXPECT_TRUE(maker.takes(use.name)) << use.name;
      }
    EXPECT_EQ(bending.takes("units"), maker.takes("units"));
    EXPECT_EQ(bending.takes("material"), maker.takes("material"));
  }
  EXPECT_TRUE(bending_with(*built_in().maker("unfold")).takes("k"));
  EXPECT_TRUE(bending_with(*built_in().maker("connect")).takes("inside_radius"));
  EXPECT_FALSE(bending_with(*built_in().maker("unfold")).takes("inside_radius"));
}

TEST(BendingWith, KnowsWhatSaysHowTheSheetIsMade) {
  for (const char* made :
       {"body", "k", "k_table", "root", "up", "inside_radius", "lateral", "shop", "units"})
    EXPECT_TRUE(is_of_sheet_to_bend(option(made))) << made;
  for (const char* other : {"material", "piece", "profile", "rules", "relief", "metal", "weights"})
    EXPECT_FALSE(is_of_sheet_to_bend(option(other))) << other;
}

}  // namespace
}  // namespace planish::job
