#include "many_parts.hpp"

#include "apart.hpp"
#include "option_parts.hpp"
#include "terminal.hpp"

#include <planish/job/reason.hpp>

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <set>
#include <thread>

namespace planish::cli {
namespace {

constexpr double kOften = 0.2;  // seconds between lines on a terminal

/// Options of making parts: those that say how each is made and written.
bool is_of_parts(const job::Option& option) {
  static const std::set<std::string_view> kOfOne{"body",   "piece",     "root",     "up",
                                                 "bend_k", "rip_edges", "thickness"};
  return option.on_command_line && !kOfOne.contains(option.name) &&
         option.group != job::OptionGroup::order;
}

std::string duration_text(double seconds) {
  const auto whole = static_cast<long long>(seconds);
  if (whole < 60) return fmt::format("{} s", whole);
  if (whole < 3600) return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace

void add_many_parts(CLI::App& app, const job::Catalogue& catalogue, ManyParts& how,
                    job::OptionValues& values) {
  app.add_option("--jobs", how.workers, "number of processes; default one per core")
      ->check(check_of(kJobs))
      ->type_name("N")
      ->group("Running");
  add_limits(app, how.limits);
  app.add_option_function<std::string>(
         "--progress", [&how](const std::string&) { how.progress_json = true; },
         "json: a line of JSON on standard error for each input done")
      ->check(check_of({.name = "progress",
                        .kind = job::OptionKind::word,
                        .description = {},
                        .words = {"json"}}))
      ->type_name("json")
      ->group("Running");
  for (const job::Option& option : job::options())
    if (is_of_parts(option) && std::ranges::any_of(catalogue.makers, [&](const job::Maker& maker) {
          return maker.takes(option.name);
        }))
      add_grouped(app, option, std::string(option.description), values);
  app.add_flag("-q,--quiet", how.quiet, "print no progress and no summary")->group("Output");
}

int complain(const Error& error, const ManyParts& how) {
  if (how.progress_json) fmt::print(stderr, "{{\"reason\":{}}}\n", job::reason_text(error));
  return complain(error);
}

std::string left_out_text(const std::vector<batch::RefusedFor>& refused,
                          const batch::PassedOver& passed) {
  constexpr std::size_t kMostLines = 10;
  std::string text;
  const auto add = [&](std::size_t all, const auto& line_of) {
    for (std::size_t i = 0; i < std::min(all, kMostLines); ++i)
      text += fmt::format("  {}\n", line_of(i));
    if (all > kMostLines) text += fmt::format("  and {} more\n", all - kMostLines);
  };
  if (!refused.empty()) text += "refused:\n";
  add(refused.size(), [&](std::size_t i) {
    const batch::RefusedFor& one = refused[i];
    const std::string more = one.count == 1 ? "" : fmt::format(" and {} more", one.count - 1);
    return fmt::format("{}{}: {}", one.first, more, one.message.empty() ? one.code : one.message);
  });
  if (passed.count > 0) text += fmt::format("passed over ({}):\n", passed.count);
  add(passed.count, [&](std::size_t i) {
    return fmt::format("{}: {}", passed.files[i].name, passed.files[i].why);
  });
  return text;
}

int status_of(std::size_t made, const std::vector<batch::RefusedFor>& refused) {
  const bool usage = std::ranges::any_of(refused, [](const batch::RefusedFor& one) {
    return one.code == code_name(code::bad_option);
  });
  return made == 0 && usage ? exit_status(code::bad_option) : 0;
}

int workers_of(const ManyParts& how) {
  if (how.workers > 0) return how.workers;
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

Telling::Telling(const ManyParts& how)
    : json_(how.progress_json), line_(!how.quiet && !json_ && isatty(STDERR_FILENO) != 0) {}

Telling::~Telling() {
  if (line_) fmt::print(stderr, "\r\x1b[K");
}

void Telling::operator()(const batch::BatchProgress& at) {
  const double fresh = static_cast<double>(at.done - at.resumed);
  const double rate = at.seconds > 0.0 ? fresh / at.seconds : 0.0;
  const double left = rate > 0.0 ? static_cast<double>(at.all - at.done) / rate : 0.0;
  if (json_)
    fmt::print(stderr,
               "{{\"done\":{},\"all\":{},\"resumed\":{},\"refused\":{},\"rate\":{:.3f},"
               "\"remaining\":{:.1f}}}\n",
               at.done, at.all, at.resumed, at.refused, rate, left);
  if (line_ && at.seconds - told_ > kOften) {
    told_ = at.seconds;
    fmt::print(stderr, "\r\x1b[K{} of {}, {:.1f} a second, {} left, {} refused", at.done, at.all,
               rate, duration_text(left), at.refused);
  }
}

}  // namespace planish::cli
