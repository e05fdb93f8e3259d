#pragma once

#include "support/sheets.hpp"

#include <planish/drawing/bend_pages.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace planish::drawing {

inline std::vector<std::string> words_of(const std::vector<Page>& pages) {
  std::vector<std::string> words;
  for (const Page& page : pages)
    for (const Page::Text& text : page.texts())
      words.push_back(text.text);
  return words;
}

inline std::ptrdiff_t times(const std::vector<Page>& pages, const std::string& text) {
  return std::ranges::count(words_of(pages), text);
}

/// A plan that presses each bend of a sheet in a stroke of its own.
class PlannedPages : public ::testing::Test {
 protected:
  void take(const Sheet& sheet) {
    flat_ = *flat_sheet(sheet);
    for (const FlatBend& bend : flat_.pattern.bends)
      plan_.strokes.push_back({.bends = {bend.bend},
                               .angle = bend.angle,
                               .punch = "P88",
                               .die = "V16",
                               .punch_rows = {{0.5, {40.0, 15.0}}},
                               .die_rows = {},
                               .force = 12.3,
                               .clearance = 5.0});
  }
  std::vector<Page> pages(LengthUnit units = LengthUnit::mm) {
    const ToolProfile square{{0.0, 0.0}, {10.0, 0.0}, {10.0, 10.0}, {0.0, 10.0}};
    StrokePicture picture;
    picture.lying = picture.bent = {square};
    picture.punch = picture.die = square;
    return bend_pages({.title = "panel",
                       .metal = "steel 400 N/mm²",
                       .thickness = 2.0,
                       .size = {254.0, 127.0},
                       .mass = 1.5,
                       .units = units,
                       .flat = flat_.pattern,
                       .layout = flat_.layout,
                       .bed = bed_,
                       .plan = has_plan_ ? &plan_ : nullptr,
                       .blocked = blocked_,
                       .obstacles = obstacles_,
                       .proposals = proposals_,
                       .flanges = flanges_,
                       .checks = checks_,
                       .notes = notes_},
                      std::vector<StrokePicture>(has_plan_ ? plan_.strokes.size() : 0, picture));
  }

  FlatSheet flat_;
  Plan plan_;
  bool has_plan_ = true;
  double bed_ = 3060.0;
  std::vector<BendId> blocked_;
  std::vector<std::string> obstacles_, proposals_, notes_;
  std::vector<FlangeName> flanges_;
  std::vector<std::optional<FlangeCheck>> checks_;
};

}  // namespace planish::drawing
