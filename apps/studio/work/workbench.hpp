#pragma once

#include "answer.hpp"
#include "document.hpp"

#include <planish/base/progress.hpp>

#include <filesystem>
#include <optional>

namespace planish::studio {

/// Answers requests about one document, without processes or sockets. Not thread-safe.
class Workbench {
 public:
  /// `attachments`: the folder of the files that were added to the document.
  explicit Workbench(std::filesystem::path attachments,
                     const job::Catalogue& catalogue = job::built_in())
      : catalogue_(catalogue), attachments_(std::move(attachments)) {}

  /// Answers as in docs/studio-api.md; the answer to `open` has no "id" and no "given" yet. An
  /// exception becomes an answer: 409 `out_of_memory`, else 500 `internal`.
  Answer perform(const Task& task, const Progress& progress = {});

  /// Once a result has been made, frees what later requests do not need: until then the next
  /// request comes at once. Returns whether there was anything.
  bool rest();

 private:
  Answer dispatch(const Task& task, const Progress& progress);
  Answer open(const Task& task, const Progress& progress);
  Answer shape(const Task& task, job::Effort effort, const Progress& progress);
  Answer file(const Task& task, const Progress& progress);
  Answer plan(const Task& task, const Progress& progress);

  const job::Catalogue& catalogue_;
  std::filesystem::path attachments_;
  std::optional<Document> document_;
  bool made_result_ = false;
};

}  // namespace planish::studio
