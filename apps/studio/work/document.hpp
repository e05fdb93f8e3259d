#pragma once

#include "request.hpp"
#include "shape.hpp"

#include <planish/job/artifact.hpp>
#include <planish/job/bend_order.hpp>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

namespace planish::studio {

/// An opened file with the state kept between requests: the maker's work, and the last full result,
/// because files are mostly requested after the result of the same request.
class Document {
 public:
  /// Opens a file by its content. `attachments` is the folder of the files that it may refer to,
  /// which may be added later. Errors: those of `Catalogue::maker_for` and of the maker.
  static Result<Document> open(const job::Catalogue& catalogue, const std::string& name,
                               const std::string& content, std::filesystem::path attachments,
                               const Progress& progress);

  const job::Maker& maker() const { return *maker_; }
  /// The output of `planish info`, as JSON text; "null" if there is none.
  std::string info(const Progress& progress) const { return work_->info(progress); }

  /// Frees what later requests do not need. Returns whether there was anything.
  bool free_spare() { return work_->free_spare(); }

  /// Errors of both: those of the maker; `bad_option` for a request without spec where the maker
  /// reads one, and for artifacts that the maker does not write.
  Result<Shape> shape(const Asked& asked, job::Effort effort, const Progress& progress);
  Result<job::WrittenArtifact> file(const Asked& asked, const std::string& artifact,
                                    const Progress& progress);
  /// The order in which the sheet is bent, as JSON text: the cheapest one, or the one asked for.
  /// Errors also: those of `job::BendOrder`.
  Result<std::string> plan(const Asked& asked, const Progress& progress);

 private:
  using MadePointer = std::shared_ptr<job::Made>;

  Document(const job::Catalogue& catalogue, const job::Maker& maker, std::string name,
           std::filesystem::path attachments, std::unique_ptr<job::Work> work);
  Result<void> take_spec(const Asked& asked);
  Result<MadePointer> make(const Asked& asked, job::Effort effort, const Progress& progress);
  job::Request request_of(const Asked& asked, job::Effort effort) const;
  Result<job::BendOrder*> order_of(const Asked& asked, const Progress& progress);

  const job::Catalogue* catalogue_;
  const job::Maker* maker_;
  std::string name_;
  std::filesystem::path attachments_;
  std::unique_ptr<job::Work> work_;
  std::optional<std::pair<std::string, MadePointer>> last_;
  /// The last sheet whose strokes were ordered, with the options of the press brake.
  struct Ordered {
    std::string key;
    MadePointer made;
    job::BendOrder order;
  };
  std::optional<Ordered> ordered_;
};

}  // namespace planish::studio
