#pragma once

#include <planish/base/result.hpp>
#include <planish/batch/codes.hpp>

/// The sentences with which `batch` refuses.
namespace planish::refuse {

constexpr Refusal ended_from_outside{code::worker_died,
                                     "The process working on {input} was killed from outside twice "
                                     "({reason}), perhaps because memory ran short.",
                                     "Use fewer --jobs, and run the batch again."};

// Inputs.
constexpr Refusal no_file_or_folder{code::cannot_read, "There is no file or folder {file}."};
constexpr Refusal no_listed_file{code::cannot_read, "There is no file or folder {file}.",
                                 "A quantity stands behind a blank: part.step x20."};
constexpr Refusal list_not_utf8{code::invalid_input, "The list {file} is not text in UTF-8.",
                                "Save it as UTF-8."};
constexpr Refusal same_input_name{code::bad_option,
                                  "Two inputs are called {name}: {first} and {second}.",
                                  "Name the folder that contains both."};
constexpr Refusal nothing_to_do{code::no_input,
                                "There is nothing to do: no input is a STEP file (.step, .stp) or "
                                "a JSON file that planish reads."};
constexpr Refusal all_passed_over{
    code::no_input,
    "There is nothing to do: {count:file was/files were} passed over, {first} among them, and "
    "none is a STEP file (.step, .stp) or a JSON file that planish reads."};
constexpr Refusal bad_copies{
    code::invalid_input,
    "A quantity like x20 must be a whole number from 1 to {most}, not \"{times}\"."};
constexpr Refusal counted_twice{code::invalid_input,
                                "{file} is listed twice: by {first} and by {second}.",
                                "List it once, with the quantity of both."};
constexpr Refusal quantities_twice{
    code::bad_option, "`materials` has a column quantity, and {said_by} gives a quantity too.",
    "Leave one of them out."};
constexpr Refusal no_input_says{
    code::bad_option, "The shop profile has the materials {known}, and no input names one of them.",
    "Choose one with `material`, or that of each part with `materials`."};
constexpr Refusal not_in_list{
    code::bad_option,
    "{list} has no row for {count:input}, {files}, and no material of the shop is named there.",
    "Add rows for them or one for *, or choose a material with `material`."};
constexpr Refusal no_row_fits{
    code::bad_option, "No row of {list} is about any of these parts: none is called {pattern}.",
    "Write the names of bodies or files in its column part; * stands for any letters."};
constexpr Refusal list_in_itself{code::cannot_read, "The list {file} names itself."};
constexpr Refusal output_in_input{
    code::bad_option, "The results would go into {output}, which is in the input folder {folder}.",
    "Name a folder outside it with -o."};

// Results of this batch and of others.
constexpr Refusal batch_unfinished{code::cannot_read, "The batch in {folder} is not finished.",
                                   "Run it again to go on."};
constexpr Refusal journal_damaged{code::cannot_read, "{file} is damaged at {name}.",
                                  "Remove it, and run the batch again."};
constexpr Refusal record_damaged{code::cannot_read, "{file} is damaged.", "Run that batch again."};
constexpr Refusal folder_taken{code::cannot_write, "Another batch is writing to {folder}.",
                               "Wait until it is done, or name another folder with -o."};
constexpr Refusal interrupted{code::cancelled, "Interrupted.",
                              "Run the same command again to go on."};
constexpr Refusal shape_unread{code::cannot_read, "A stored shape cannot be read: {reason}"};

// Shards.
constexpr Refusal no_batch{code::cannot_read,
                           "{folder} holds neither results of planish batch nor shards."};
constexpr Refusal shard_unfinished{code::cannot_read, "The shard in {folder} is not finished.",
                                   "Run --shard {shard} again, then merge."};
constexpr Refusal other_batch{
    code::cannot_read, "{folder} and {other} belong to different batches.",
    "Merge shards with the same inputs, options, number of shards and version of planish."};
constexpr Refusal shard_twice{code::cannot_read,
                              "{folder} holds shard {shard}, which another folder holds too."};
constexpr Refusal shard_missing{code::cannot_read, "Shard {shard} is missing.",
                                "Run --shard {shard}, then merge."};
constexpr Refusal merged_into_itself{code::bad_option, "{folder} is one of the folders to merge.",
                                     "Name another folder with -o."};

}  // namespace planish::refuse
