#include "slit/sample_sheets.hpp"

#include <planish/brep/codes.hpp>
#include <planish/brep/step.hpp>
#include <planish/slit/mould.hpp>
#include <planish/slit/session.hpp>

#include <gtest/gtest.h>

// What a slit sheet gives as STEP, read back as any reader of solids sees it.

namespace planish::test {
namespace {

FoldedSlitSheet folded_chair() {
  auto session = solved_slit_sheet(chair(), 0);
  if (!session) throw std::runtime_error(session.error().message);
  return session->folded();
}

TEST(SlitSolids, SurfaceOfAChairIsOneShell) {
  const Sheet sheet = sheet_of(folded_chair());
  const auto text = folded_surface_step(sheet, "chair");
  ASSERT_TRUE(text) << text.error().message;
  // A shell is no solid, and that is what a reader of solids says.
  const auto file = read_step_text(*text, "chair.step");
  ASSERT_FALSE(file);
  EXPECT_EQ(file.error().code, code::shell_not_solid);
  std::size_t shells = 0, faces = 0;
  for (std::size_t at = text->find("OPEN_SHELL("); at != std::string::npos;
       at = text->find("OPEN_SHELL(", at + 1))
    ++shells;
  for (std::size_t at = text->find("ADVANCED_FACE("); at != std::string::npos;
       at = text->find("ADVANCED_FACE(", at + 1))
    ++faces;
  EXPECT_EQ(shells, 1u);
  EXPECT_EQ(faces, sheet.faces.size());
}

TEST(SlitSolids, MouldOfAChairHasTheSameVolumeAsStep) {
  const auto mould = mould_of(folded_chair());
  ASSERT_TRUE(mould) << mould.error().message;
  const auto text = mesh_solid_step(mesh_of(*mould), "mould");
  ASSERT_TRUE(text) << text.error().message;
  const auto file = read_step_text(*text, "mould.step");
  ASSERT_TRUE(file) << file.error().message;
  EXPECT_EQ(file->bodies.size(), mould->ribs.size());
  double volume = 0.0;
  for (const Body& body : file->bodies)
    volume += body.quantity() * body.volume();
  EXPECT_NEAR(volume / mould->volume, 1.0, 1e-9);
}

TEST(SlitSolids, MouldAsOneBodyIsOneSolidOfTheSameVolume) {
  const auto mould = mould_of(folded_chair(), {.form = MouldForm::body});
  ASSERT_TRUE(mould) << mould.error().message;
  const auto text = mesh_solid_step(mesh_of(*mould), "mould");
  ASSERT_TRUE(text) << text.error().message;
  const auto file = read_step_text(*text, "mould.step");
  ASSERT_TRUE(file) << file.error().message;
  ASSERT_EQ(file->bodies.size(), 1u);
  EXPECT_NEAR(file->bodies[0].volume() / mould->volume, 1.0, 1e-9);
}

}  // namespace
}  // namespace planish::test
