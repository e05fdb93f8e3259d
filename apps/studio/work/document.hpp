#pragma once

#include "answer.hpp"
#include "asked.hpp"
#include "json_text.hpp"
#include "shape.hpp"

#include <planish/base/progress.hpp>
#include <planish/base/result.hpp>
#include <planish/job/report.hpp>

#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

namespace planish::studio {

/// A file that was made, and the type of its content.
struct MadeFile {
  std::string type;
  std::string bytes;
};

/// One opened file with what is kept between requests. Errors of all: those of the job, and
/// `bad_option` for options that this kind does not take and formats that it does not have.
class Document {
 public:
  Document() = default;
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;
  virtual ~Document() = default;

  virtual std::string_view kind() const = 0;
  /// What `planish info` says of it; null where it says nothing.
  virtual Json info(const Progress&) const { return nullptr; }
  virtual Result<Shape> shape(const Asked& asked, job::Effort effort, const Progress& progress) = 0;
  virtual Result<MadeFile> file(const Asked& asked, const std::string& format,
                                const Progress& progress) = 0;
};

/// Opens a file by its content. A text is that of a spec if it is a JSON object; its "format", or
/// else its keys, say which. `attachments` is the folder of the files that it may name. Errors:
/// those of `read_step` and of the parsers.
Result<std::unique_ptr<Document>> open_document(const std::string& name, const std::string& bytes,
                                                const std::filesystem::path& attachments,
                                                const Progress& progress);

Result<std::unique_ptr<Document>> open_unfold(const std::string& name, const std::string& bytes,
                                              const Progress& progress);
Result<std::unique_ptr<Document>> open_connect(const std::string& name, const std::string& json);
Result<std::unique_ptr<Document>> open_transition(const std::string& name, const std::string& json);
Result<std::unique_ptr<Document>> open_slit(const std::string& name, const std::string& json,
                                            const std::filesystem::path& attachments);

}  // namespace planish::studio
