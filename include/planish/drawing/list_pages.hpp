#pragma once

#include <planish/drawing/part_view.hpp>
#include <planish/io/pages.hpp>
#include <planish/sheet/flat_pattern.hpp>

#include <string>
#include <vector>

namespace planish::drawing {

/// A part in a list: its pictures, and three lines beside them, a fourth where it needs help.
struct ListedPart {
  std::string name, work, state;
  int quantity = 1;
  const FlatPattern* flat = nullptr;
  const PartView* view = nullptr;  ///< null: the folded part is not drawn
  bool alert = false;              ///< its state is to be noticed
  std::string help = {};           ///< what would help
};

/// Parts under a heading, and a line with their sums.
struct ListedGroup {
  std::string heading;
  std::vector<ListedPart> parts;
  std::string sums;
};

struct ListedLine {
  std::string text;
  bool alert = false;
};

/// Lines under a heading.
struct ListedLines {
  ListedLine heading;
  std::vector<ListedLine> lines;
};

struct ListDrawing {
  std::string title;
  std::vector<ListedGroup> groups;
  std::string sums;  ///< of all groups; empty: none
  std::vector<ListedLines> sections;
};

/// A list of parts on pages, A4 upright, each page with its number. Requires flat patterns with an
/// outer contour.
std::vector<Page> list_pages(const ListDrawing& drawing);

}  // namespace planish::drawing
