// How far inside the part a line is: of the two sides that are left when it is cut, the lines on
// the one that has fewer.
#include "line_depth.hpp"

#include <algorithm>

namespace planish::brake_detail {
namespace {

/// Lines that hang on a body if the given one is cut.
int lines_beyond(const Workpiece& work, int cut, int body) {
  const std::vector<bool> reached = reached_from(work, body, cut);
  int beyond = 0;
  for (int i = 0; i < std::ssize(work.lines); ++i)
    if (!is_same(work, i, cut) && reached[work.lines[i].bodies[0]]) ++beyond;
  return beyond;
}

}  // namespace

std::vector<int> line_depths(const Workpiece& work) {
  std::vector<int> depths;
  for (int i = 0; i < std::ssize(work.lines); ++i)
    depths.push_back(std::min(lines_beyond(work, i, work.lines[i].bodies[0]),
                              lines_beyond(work, i, work.lines[i].bodies[1])));
  return depths;
}

}  // namespace planish::brake_detail
