#pragma once

#include "../work/answer.hpp"

#include <chrono>
#include <cstdint>
#include <optional>
#include <string>

namespace planish::studio {

/// Messages between server and worker over a socket pair. A frame is its kind (one byte), the
/// length of its content (four bytes, in this machine's order) and the content.
enum class FrameKind : std::uint8_t { task = 1, progress = 2, answer = 3 };

struct Frame {
  FrameKind kind = FrameKind::task;
  std::string content;
};

/// Progress of a task: a stage's name and the share done, 0 to 1.
struct Stage {
  std::string name;
  double share = 0.0;
};

using Moment = std::chrono::steady_clock::time_point;

enum class FrameFailure { ended, late };

/// `ended`: the other side is gone; `late`: not all of it was accepted before `until`.
tl::expected<void, FrameFailure> send_frame(int socket, const Frame& frame,
                                            std::optional<Moment> until = std::nullopt);

/// The next frame. `ended`: the other side is gone, or sent something else; `late`: no frame came
/// before `until`.
tl::expected<Frame, FrameFailure> receive_frame(int socket,
                                                std::optional<Moment> until = std::nullopt);

Frame task_frame(const Task& task);
Frame progress_frame(const Stage& stage);
Frame answer_frame(const Answer& answer);
/// Empty if the content is not a task.
std::optional<Task> task_of(const Frame& frame);
std::optional<Stage> stage_of(const Frame& frame);
std::optional<Answer> answer_of(const Frame& frame);

}  // namespace planish::studio
