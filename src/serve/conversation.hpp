#pragma once

#include "crew.hpp"
#include "mcp.hpp"
#include "rpc.hpp"
#include "tools.hpp"

#include <planish/serve/serve.hpp>

#include <map>
#include <mutex>
#include <optional>

namespace planish::serve {

/// What is said to one client. Messages are taken by one thread; answers go out from those of the
/// crew too.
class Conversation {
 public:
  Conversation(MessageWriter& writer, const ServeOptions& options, const job::Catalogue& catalogue);

  /// Answers a message, or begins to.
  void take(const std::string& message);
  /// Answers one that cannot be read.
  void refuse(const Error& error);

  /// Whether the client has said `exit`, and the exit status.
  std::optional<int> exit_status() const { return exit_; }
  /// Requests that are not answered yet.
  std::size_t open() const { return crew_.open(); }

 private:
  /// One request or notification.
  struct Call {
    std::optional<Json> id;  ///< empty: a notification
    std::string method;
    Json parameters;
    Sink sink;
  };
  /// A request at work; `silent`: the client wants no answer any more.
  struct AtWork {
    std::shared_ptr<Ticket> ticket;
    bool silent = false;
  };
  /// How the answer to work is worded.
  struct Wording {
    std::function<std::string(const WorkDone&)> done;
    std::function<std::string(const Json& id, const Error&)> failed;
    std::function<std::string(const Json& id, std::string_view stage, double share)> progress;
  };

  void take_one(const Json& message, const Sink& sink);
  void take_request(const Call& call);
  void take_notification(const Call& call);
  void call_tool(const Call& call);
  void begin_work(const Call& call, const Tool& asked, Json parameters, Wording wording);
  void finish(const Call& call, const Wording& wording, Result<WorkDone> done);
  void cancel(const Json& id, bool silent);
  const Tool* tool(const std::string& name) const;

  MessageWriter& writer_;
  const ServeOptions& options_;
  const job::Catalogue& catalogue_;
  const std::vector<Tool> tools_;
  std::string protocol_;
  bool shut_down_ = false;
  std::optional<int> exit_;
  std::mutex mutex_;                       ///< of `at_work_`
  std::map<std::string, AtWork> at_work_;  ///< by id
  Crew crew_;                              ///< ends before all that its threads use
};

}  // namespace planish::serve
