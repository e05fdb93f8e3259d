#pragma once

#include <planish/base/result.hpp>

/// The sentences with which `process` refuses.
namespace planish::refuse {

constexpr Refusal not_started{code::internal, "No process could be started: {reason}."};

// How a child ended.
constexpr Refusal child_cancelled{code::cancelled, "Cancelled."};
constexpr Refusal child_out_of_time{code::out_of_time, "{input} was given up after {time}{during}.",
                                    "Allow more time, or divide the input."};
constexpr Refusal child_out_of_memory{code::out_of_memory,
                                      "{input} needs more memory than {memory}{during}.",
                                      "Allow more, or divide the input."};
constexpr Refusal child_crashed{code::crashed, "The work on {input} crashed{during} ({reason}).",
                                "Damaged files make the CAD kernel do that, so check the file in a "
                                "CAD program and export it again."};
constexpr Refusal child_asserted{code::crashed, "The work on {input} crashed{during} ({reason}).",
                                 "This is a defect of Planish: report it with the file."};

}  // namespace planish::refuse
