#include "bend_reasons.hpp"

#include "proposal_report.hpp"

#include <planish/drawing/page_parts.hpp>

namespace planish::job {
using namespace drawing;
namespace {

constexpr std::size_t kReasonLetters = 100;  // about as many as a page is wide

}  // namespace

std::vector<BlockedBend> obstacles_of(const Report& report) {
  if (!report.plan || report.plan->status != PlanStatus::infeasible) return {};
  return report.plan->blocked.empty() ? report.plan->in_the_way : report.plan->blocked;
}

void write_reasons(Page& page, const Report& report, const Vec2& from, double bottom) {
  constexpr double kSpacing = 1.5, kGap = 3.0;
  double y = from.y();
  const auto tell = [&](const std::string& text, const TextStyle& style) {
    for (const std::string& line : wrapped(text, kReasonLetters)) {
      if (y > bottom) return;
      page.text({from.x(), y}, line, style);
      y += kSpacing * style.size;
    }
  };
  for (const BlockedBend& blocked : obstacles_of(report))
    tell(blocked_sentence(blocked, report), {.size = 3.4, .colour = kPageAlert});
  if (report.plan->proposals.empty()) return;
  y += kGap;
  tell("It can be bent", {.size = 3.8, .bold = true});
  for (const Proposal& proposal : report.plan->proposals)
    tell("– " + proposal_sentence(proposal, report), {.size = 3.4});
}

}  // namespace planish::job
