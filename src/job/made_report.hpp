#pragma once

#include <planish/job/maker.hpp>
#include <planish/schema/json_parts.hpp>

#include <memory>
#include <string>
#include <utility>

namespace planish::job {

/// What a maker made, if its report holds all of it: uses `report_json` and `report_text` of the
/// report's type.
template <typename R>
class MadeReport : public Made {
 public:
  explicit MadeReport(R report) : made_(std::move(report)) {}
  const Report& report() const override { return made_; }
  Report& report() override { return made_; }
  std::string json() const override { return report_json(made_); }
  std::string text() const override { return report_text(made_); }

 protected:
  R made_;
};

/// A report that only repeats the request; lengths in `unit` if the request does not say.
template <typename R>
R begun(const Request& request, LengthUnit unit) {
  R report;
  report.input = request.input.string();
  report.body = request.input == "-" ? "stdin" : request.input.stem().string();
  report.units = request.units.value_or(unit);
  return report;
}

/// The report of a request that ended with an error.
template <typename R>
R failed_report(const Request& request, const Error& error) {
  R report = begun<R>(request, LengthUnit::mm);
  report.refusal = error;
  return report;
}

template <typename M, typename R>
std::unique_ptr<Made> failed_as(const Request& request, const Error& error) {
  return std::make_unique<M>(failed_report<R>(request, error));
}

/// A `Work` on a JSON file, which is parsed again at each edit; nothing else is kept. `parse` makes
/// a `File` of a content and its name, `make_of` the result of a file, a request and its progress.
template <typename File, auto parse, auto make_of>
class SpecWork : public Work {
 public:
  static Result<std::unique_ptr<Work>> open(const InputFile& input, const Progress&) {
    auto work = std::make_unique<SpecWork>();
    if (auto read = work->edit(input); !read) return pass_on(read);
    return work;
  }

  Result<void> edit(const InputFile& input) override {
    auto file = parse(input.content, input.name);
    if (!file) return pass_on(file);
    file_ = std::move(*file);
    return {};
  }
  Outcome<std::unique_ptr<Made>> make(const Request& request, const Progress& progress) override {
    return make_of(file_, request, progress);
  }

 private:
  File file_;
};

/// Points for the page, in mm.
schema::Json page_point(const Vec3& p);
schema::Json page_points(const std::vector<Vec3>& points);
/// JSON on one line; bytes that are not UTF-8 become U+FFFD.
std::string page_text(const schema::Json& json);

}  // namespace planish::job
