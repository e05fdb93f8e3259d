#include "filling.hpp"

#include <planish/drawing/page_parts.hpp>

#include <fmt/format.h>

#include <utility>

namespace planish::drawing {

Filling::Filling(std::string title, std::optional<std::string> subtitle, PageNumbers numbers)
    : title_(std::move(title)), subtitle_(std::move(subtitle)), numbers_(numbers) {
  begin();
}

void Filling::begin() {
  Page& page = pages_.emplace_back(kSheetWidth, kSheetHeight);
  constexpr double kRoom = 165.0, kLargest = 6.5, kSmaller = 4.2, kSubtitle = 7.0;
  page.text({kEdge, kEdge + 5.0}, title_,
            {.size = fitting_size(title_, kRoom, kLargest), .bold = true});
  double line = kEdge + 8.0;
  if (subtitle_) {
    page.text({kEdge, kEdge + 12.0}, *subtitle_,
              {.size = fitting_size(*subtitle_, kInner, kSmaller)});
    line += kSubtitle;
  }
  page.line({kEdge, line}, {kSheetWidth - kEdge, line}, {.width = 0.4});
  top_ = line + 4.0;
}

void Filling::need(double height) {
  if (top_ + height > kSheetHeight - kEdge) begin();
}

std::vector<Page> Filling::take() && {
  if (numbers_ == PageNumbers::where_several && pages_.size() == 1) return std::move(pages_);
  for (std::size_t p = 0; p < pages_.size(); ++p)
    pages_[p].text({kSheetWidth - kEdge, kEdge + 5.0}, fmt::format("{} / {}", p + 1, pages_.size()),
                   {.size = 3.5, .anchor = TextAnchor::end, .colour = kPageGrey});
  return std::move(pages_);
}

}  // namespace planish::drawing
