#pragma once

#include <planish/base/result.hpp>

/// The sentences with which the program refuses.
namespace planish::refuse {

// What is written where.
constexpr Refusal output_unclear{code::bad_option,
                                 "{option} \"{file}\" does not say what to write.",
                                 "End the name in one of {suffixes}."};
constexpr Refusal output_of_other_option{code::bad_option, "{option} writes no {suffix} files.",
                                         "Give {other} {file} instead."};
constexpr Refusal outputs_unnamed{code::bad_option,
                                  "Standard input has no name from which to name the outputs.",
                                  "Give {option} FILE, or --check for no output."};
constexpr Refusal plates_unnamed{
    code::bad_option, "Standard input has no name to call the plates file after.", "Give -o FILE."};
constexpr Refusal one_standard_input{code::bad_option,
                                     "Only one of the inputs can be standard input (-)."};
constexpr Refusal check_writes_no_pattern{code::bad_option, "--check writes no pattern.",
                                          "Leave --format out."};
constexpr Refusal check_writes_no_file{code::bad_option, "--check writes no file.",
                                       "Leave {option} out."};
constexpr Refusal format_twice{code::bad_option, "--format names {format} twice.",
                               "Leave one of them out."};
constexpr Refusal format_of_file{
    code::bad_option,
    "--format goes with a folder or without -o: the name of a file already sets its format."};

// Several bodies.
constexpr Refusal all_and_body{code::bad_option, "--all and --body contradict each other.",
                               "Leave one of them out."};
constexpr Refusal faces_of_all{
    code::bad_option,
    "--root and --up cannot name a face with --all: every body numbers its own faces."};
constexpr Refusal all_without_folder{code::bad_option, "--all writes several files.",
                                     "Name their folder with -o FOLDER/."};
constexpr Refusal all_into_file{code::bad_option, "--all writes several files.",
                                "Give -o a folder, not a file."};
constexpr Refusal all_into_folders{code::bad_option, "--all writes into one folder.",
                                   "Give -o once."};
constexpr Refusal or_all_bodies{code::bad_option, "Or take all of them with --all -o FOLDER/."};

constexpr Refusal not_for_input{code::bad_option, "`{option}` does not go with a {kind}."};
constexpr Refusal bad_stock{
    code::bad_option,
    "--nest must be like 3000x1500, length and width of a sheet in mm, not \"{text}\"."};
constexpr Refusal stock_unsaid{code::bad_option,
                               "--gap and --grain belong to --nest, which is not given."};
constexpr Refusal merge_and_make{code::bad_option,
                                 "--merge makes no parts, and {option} says how they are made.",
                                 "Give it to the shards, and leave it out here."};
constexpr Refusal plan_and_none{code::bad_option,
                                "--no-plan leaves the press brake out, and {option} belongs to it.",
                                "Leave one of them out."};
constexpr Refusal bad_format{code::bad_option, "--format {format} is unknown.",
                             "Choose from these: {known}."};
constexpr Refusal bad_shard{code::bad_option, "--shard must be like 3/64: which one, of how many."};
constexpr Refusal no_such_name{code::bad_option,
                               "There is no {what} \"{name}\"; there are {known}."};
constexpr Refusal no_standard_output{code::cannot_write, "Cannot write to standard output."};
constexpr Refusal no_studio{code::internal,
                            "The studio cannot be started, {reason} ({program}). It must lie "
                            "beside planish, and is not built with PLANISH_STUDIO=OFF."};
constexpr Refusal program_defect{code::internal, "{reason}."};

}  // namespace planish::refuse
