#include "apart.hpp"

#include "terminal.hpp"

#include <planish/job/options.hpp>

#include <fmt/format.h>

#include <memory>

namespace planish::cli {
namespace {

using job::ChildProcess;
using job::Texts;
using std::chrono::steady_clock;

constexpr auto kMake = "make", kConclude = "conclude";
constexpr auto kProducts = "products", kEnding = "ending";

Texts texts_of(const Products& products) {
  Texts texts{kProducts, std::to_string(products.inputs.size())};
  for (const auto& input : products.inputs)
    texts.push_back(input.string());
  for (const File& file : products.files)
    texts.insert(texts.end(), {file.path.string(), file.content});
  return texts;
}

Texts texts_of(const Ending& ending) {
  Texts texts{kEnding, ending.json, ending.output, ending.aside};
  if (!ending.error) return texts;
  const Texts error = job::texts_of(*ending.error);
  texts.insert(texts.end(), error.begin(), error.end());
  return texts;
}

std::optional<Products> products_in(const Texts& texts) {
  if (texts.size() < 2 || texts[0] != kProducts) return std::nullopt;
  const auto inputs = job::parse_number(texts[1]);
  if (!inputs || *inputs < 0 || *inputs > static_cast<double>(texts.size() - 2))
    return std::nullopt;
  const auto first_file = texts.begin() + 2 + static_cast<std::ptrdiff_t>(*inputs);
  if ((texts.end() - first_file) % 2 != 0) return std::nullopt;
  Products products;
  products.inputs.assign(texts.begin() + 2, first_file);
  for (auto text = first_file; text != texts.end(); text += 2)
    products.files.push_back({*text, *(text + 1)});
  return products;
}

std::optional<Ending> ending_in(const Texts& texts) {
  constexpr std::size_t kOwn = 4;
  if (texts.size() < kOwn || texts[0] != kEnding) return std::nullopt;
  Ending ending{texts[1], texts[2], texts[3], std::nullopt};
  if (texts.size() == kOwn) return ending;
  ending.error = job::error_in({texts.begin() + kOwn, texts.end()});
  return ending.error ? std::optional(std::move(ending)) : std::nullopt;
}

Texts answer_of(Command& command, const Texts& question, const job::Parent& parent) {
  if (!question.empty() && question[0] == kConclude)
    return texts_of(command.conclude(job::error_in({question.begin() + 1, question.end()})));
  const auto step = command.make(parent);
  if (const auto* products = std::get_if<Products>(&step)) return texts_of(*products);
  return texts_of(std::get<Ending>(step));
}

std::string name_of(const std::string& input) {
  return input == "-" ? "standard input" : std::filesystem::path(input).filename().string();
}

/// Writes all files, each whole, in folders that are made for them; the first reason why not.
std::optional<Error> write_products(const Products& products) {
  for (const File& file : products.files)
    if (file.path.has_parent_path())
      if (auto error = make_folder(file.path.parent_path())) return error;
  return write_all(products.files, products.inputs);
}

/// A command's process, and what is asked of it.
class Apart {
 public:
  Apart(Command& command, const Running& running)
      : command_(command), running_(running), line_(!running.quiet) {}

  Ending run() {
    const auto until = steady_clock::now() + running_.limits.time;
    for (;;) {
      const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - steady_clock::now());
      auto answer = made(left);
      if (answer) return finished(*answer);
      const bool crashed = answer.error().code == ErrorCode::crashed;
      if (!crashed || !command_.leaves_out(answer.error())) return command_.lost(answer.error());
    }
  }

 private:
  Result<Texts> made(std::chrono::milliseconds time) {
    const auto answering = [this](const Texts& question, const job::Parent& parent) {
      return answer_of(command_, question, parent);
    };
    auto child = ChildProcess::copy(answering, running_.limits.memory);
    if (!child) return tl::unexpected(child.error());
    child_ = std::move(*child);
    return asked({kMake}, time);
  }

  Result<Texts> asked(const Texts& question, std::chrono::milliseconds time) {
    const auto hear = [this](const Texts& note) { command_.hear(note); };
    auto answer = child_->ask(question, time, {line_.progress(), hear});
    if (!answer) return tl::unexpected(error_of(answer.error()));
    return std::move(*answer);
  }

  Ending finished(const Texts& answer) {
    const auto products = products_in(answer);
    if (!products) return ended(answer);
    if (interrupted()) return command_.lost(error_of({job::ChildEnd::Cause::cancelled}));
    Texts question{kConclude};
    if (const auto unwritten = write_products(*products)) {
      const Texts error = job::texts_of(*unwritten);
      question.insert(question.end(), error.begin(), error.end());
    }
    const auto concluded = asked(question, running_.limits.time);
    return concluded ? ended(*concluded) : command_.lost(concluded.error());
  }

  Ending ended(const Texts& answer) const {
    if (auto ending = ending_in(answer)) return std::move(*ending);
    return command_.lost(error_of({{}, job::kDamagedAnswer}));
  }

  Error error_of(const job::ChildEnd& end) const {
    return job::error_of(end, name_of(running_.input), running_.limits);
  }

  Command& command_;
  const Running& running_;
  ProgressLine line_;
  std::unique_ptr<ChildProcess> child_;
};

int said(const Ending& ending, const Running& running) {
  const int status = ending.error ? complain(*ending.error) : 0;
  if (ending.error && ending.error->code == ErrorCode::cancelled) return status;
  if (!ending.json.empty())
    if (const auto unwritten = write_report(running.json, ending.json)) {
      const int other = complain(*unwritten);
      return ending.error ? status : other;
    }
  fmt::print("{}", ending.output);
  fmt::print(stderr, "{}", ending.aside);
  return status;
}

}  // namespace

Ending Command::conclude(const std::optional<Error>&) { return {}; }

int run_apart(Command& command, const Running& running) {
  // The line of progress is gone before anything is said.
  const Ending ending = Apart(command, running).run();
  return said(ending, running);
}

void add_limits(CLI::App& app, job::Limits& limits) {
  constexpr double kLeast = 0.001, kDay = 86400.0, kLeastMiB = 64.0, kMostMiB = 1U << 24U;
  constexpr double kMilli = 1000.0, kMebi = 1U << 20U;
  const auto set_time = [&limits](double seconds) {
    limits.time = std::chrono::milliseconds(static_cast<std::int64_t>(seconds * kMilli));
  };
  app.add_option_function<double>("--time-limit", set_time,
                                  "what takes longer is given up; default 120")
      ->check(CLI::Range(kLeast, kDay))
      ->type_name("SECONDS")
      ->group("Limits");
  const auto set_memory = [&limits](double mebibytes) {
    limits.memory = static_cast<std::uint64_t>(mebibytes * kMebi);
  };
  app.add_option_function<double>("--memory-limit", set_memory,
                                  "what needs more memory is given up; default 4096")
      ->check(CLI::Range(kLeastMiB, kMostMiB))
      ->type_name("MIB")
      ->group("Limits");
}

}  // namespace planish::cli
