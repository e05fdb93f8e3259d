#pragma once

#include <planish/process/child_process.hpp>

namespace planish::process {

/// The descriptor at which a child finds its socket.
constexpr int kChildSocket = 3;

/// In the child: ends it with `parent`, ignores Ctrl-C, limits its memory and leaves no core file.
/// Returns whether the parent is still there.
bool settle_in(long parent, std::uint64_t memory);

/// Answers what comes at the socket until nobody asks any more; returns the exit status.
int answer_questions(int socket, const Answering& answering,
                     const std::function<void()>& after = {});

}  // namespace planish::process
