#pragma once

#include <planish/batch/batch.hpp>
#include <planish/job/artifact.hpp>
#include <planish/job/options.hpp>

#include <CLI/CLI.hpp>

namespace planish::cli {

/// How commands run that work on many parts.
struct ManyParts {
  int workers = 0;  ///< 0: one a core
  bool quiet = false, progress_json = false;
  process::Limits limits;
};

/// Ends with an error; with --progress json also as a line of JSON, {"reason": …}.
int complain(const Error& error, const ManyParts& how);

/// Defines --jobs, the limits, --progress, --quiet, and the options that say how each part is made
/// and written; parsing fills `how` and `values`, which must outlive `app`.
void add_many_parts(CLI::App& app, const job::Catalogue& catalogue, ManyParts& how,
                    job::OptionValues& values);

/// What is not among the results, as lines behind them: why parts were refused, what was passed
/// over.
std::string left_out_text(const std::vector<batch::RefusedFor>& refused,
                          const batch::PassedOver& passed);

/// The exit status of work that is done: that of wrong usage where the options left nothing to
/// make.
int status_of(std::size_t made, const std::vector<batch::RefusedFor>& refused);

int workers_of(const ManyParts& how);

/// Tells how far a batch is: on a line of the terminal, or as lines of JSON.
class Telling {
 public:
  explicit Telling(const ManyParts& how);
  ~Telling();
  Telling(const Telling&) = delete;
  Telling& operator=(const Telling&) = delete;

  void operator()(const batch::BatchProgress& at);

 private:
  bool json_, line_;
  double told_ = 0.0;
};

}  // namespace planish::cli
