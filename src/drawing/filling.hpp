#pragma once

#include <planish/io/pages.hpp>

#include <optional>
#include <string>
#include <vector>

namespace planish::drawing {

// A page, A4 upright, and the room between its margins, mm.
constexpr double kSheetWidth = 210.0, kSheetHeight = 297.0, kEdge = 12.0;
constexpr double kInner = kSheetWidth - 2.0 * kEdge;

/// Whether pages have their numbers where there is but one.
enum class PageNumbers { where_several, always };

/// Pages with a title that are filled from above.
class Filling {
 public:
  Filling(std::string title, std::optional<std::string> subtitle, PageNumbers numbers);

  Page& page() { return pages_.back(); }
  double top() const { return top_; }
  void skip(double height) { top_ += height; }
  /// Goes on on the next page where there is no room.
  void need(double height);
  std::vector<Page> take() &&;

 private:
  void begin();

  std::string title_;
  std::optional<std::string> subtitle_;  ///< without one the pages begin higher
  PageNumbers numbers_;
  std::vector<Page> pages_;
  double top_ = 0.0;
};

}  // namespace planish::drawing
