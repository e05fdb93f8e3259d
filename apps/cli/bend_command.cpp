#include "apart.hpp"
#include "commands.hpp"
#include "option_parts.hpp"
#include "output_files.hpp"
#include "refusals.hpp"
#include "terminal.hpp"

#include <planish/job/bend_plan_pages.hpp>
#include <planish/shop/tools_json.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace planish::cli {
namespace {

constexpr auto kBend = "bend";

constexpr auto kBendExamples = R"(Examples:
  planish bend part.step                          the order of strokes, with common tools
  planish bend part.step --tools shop.json -o plan.pdf --json plan.json
  planish bend plates.json --material stainless   what makes a sheet can be bent
  planish bend part.step --fix B3,B1              an order that begins so
  planish bend part.step --weights turn_over=10   a heavy part is turned over seldom
  planish bend --print-tools > shop.json          tools to edit, for --tools

Exit status:
  0 done: there is a plan             3 a file cannot be read, is invalid or cannot be written
  1 internal error, or cancelled      4 refused: no order of strokes forms all bends, or there
  2 wrong usage                         is no flat pattern

More in docs/bend.md.)";

constexpr auto kGraceForOthers = std::chrono::minutes(2);  // reading, unfolding, certifying

/// A word for a metal, or a file that K comes from.
void add_material(CLI::App& app, job::OptionValues& values) {
  const job::Option& metal = job::option("metal");
  const job::Option& material = job::option("material");
  const auto set = [&](const std::string& text) {
    const bool word = std::ranges::find(metal.words, text) != metal.words.end();
    (void)values.set_text(word ? metal : material, text);  // any text is a path
  };
  app.add_option_function<std::string>(
         "--material", set,
         fmt::format("steel, stainless or aluminium: {}; or a material file for K",
                     metal.description))
      ->check(not_empty)
      ->type_name("METAL|FILE.json")
      ->group(std::string(job::heading(job::OptionGroup::brake)));
}

void add_time_limit(CLI::App& app, BendArguments& to) {
  const job::Option& time = job::option("search_time");
  const auto set = [&to, &time](double seconds) {
    to.options.set(time, seconds);
    to.limits.time = kGraceForOthers +
                     std::chrono::milliseconds(static_cast<std::int64_t>(1000.0 * seconds));
  };
  app.add_option_function<double>("--time-limit", set,
                                  "time after which the best plan so far is given; default 60")
      ->check(check_of(kTimeLimit))
      ->type_name("SECONDS")
      ->group("Order");
}

void add_one(CLI::App& app, const job::Option& option, job::OptionValues& values) {
  const std::string said = option.otherwise.empty()
                               ? std::string(option.description)
                               : fmt::format("{}; default {}", option.description,
                                             option.otherwise);
  add_grouped(app, option, said, values);
}

/// Errors of the command line, before any work.
std::optional<Error> unwritable(const BendArguments& arguments) {
  for (const std::string& name : arguments.outputs)
    if (suffix_of(name) != ".pdf" && suffix_of(name) != ".svg")
      return error_of(refuse::output_unclear,
                      {{"option", "-o"}, {"file", name}, {"suffixes", ".pdf, .svg"}});
  if (!arguments.as_made.empty() && suffix_of(arguments.as_made) != ".dxf")
    return error_of(refuse::output_unclear,
                    {{"option", "--as-made"}, {"file", arguments.as_made}, {"suffixes", ".dxf"}});
  std::vector<std::string> names = arguments.outputs;
  names.push_back(arguments.json);
  names.push_back(arguments.as_made);
  const auto files = files_named(names);
  const auto tools = files_named({arguments.options.text("tools"),
                                  arguments.options.text("k_table"),
                                  arguments.options.text("material")});
  for (const auto& file : files) {
    if (const auto fine = check_output(file, arguments.input); !fine) return fine.error();
    if (const auto spared = spare_inputs(file, tools); !spared) return spared.error();
  }
  if (const auto different = all_different(files); !different) return different.error();
  return std::nullopt;
}

class Bend : public Command {
 public:
  Bend(const job::Catalogue& catalogue, const BendArguments& arguments)
      : catalogue_(catalogue), arguments_(arguments), maker_(catalogue.makers.data()) {}

  Outcome make(const process::Parent& parent) override {
    job::Request request;
    request.input = arguments_.input;
    const auto input = job::read_input_file(arguments_.input, "input file");
    if (!input) return failed(input.error());
    const auto maker = catalogue_.maker_for(input->name, input->content);
    if (!maker) return failed(maker.error());
    maker_ = *maker;
    if (const auto wrong = not_taken()) return {.error = wrong};
    if (const auto entered = arguments_.options.enter(request); !entered)
      return failed(entered.error());
    request.bending.ask = job::Bending::Ask::plan;
    request.bending.as_made = !arguments_.as_made.empty();
    auto work = maker_->open(*input, parent.progress);
    if (!work) return failed(work.error());
    auto made = job::shown((*work)->make(request, parent.progress));
    if (!made) return failed(made.error());
    return outcome_of(**made, request);
  }

  Outcome failed(const Error& error) const override {
    job::Request request;
    request.input = arguments_.input;
    request.body = arguments_.options.text("body");
    const auto made = maker_->failed(request, error);
    made->report().task = kBend;
    return {.json = made->json(), .error = error};
  }

 private:
  /// An option that the maker of this input does not have.
  std::optional<Error> not_taken() const {
    for (const job::Option& option : job::options())
      if ((job::is_of_sheet_to_bend(option) || option.name == "material") &&
          arguments_.options.given(option.name) && !maker_->takes(option.name))
        return error_of(refuse::not_for_input,
                        {{"option", option.name}, {"kind", maker_->input_kind()}});
    return std::nullopt;
  }

  /// The plan of all pieces on pages, in each format that was asked for.
  Result<std::vector<OutputFile>> files_of(const job::Made& made,
                                           const job::Request& request) const {
    std::vector<OutputFile> files;
    for (int piece = 0; piece < made.pieces() && !arguments_.as_made.empty(); ++piece) {
      if (made.report().refusal) break;
      auto dxf = job::dxf_as_made(made.piece(piece), request);
      if (!dxf) return pass_on(dxf);
      files.push_back(
          {job::name_of_piece(arguments_.as_made, piece, made.pieces()), std::move(*dxf)});
    }
    if (arguments_.outputs.empty()) return files;
    const std::vector<Page> pages = job::bend_plan_pages(made, request.bending);
    for (const std::string& name : arguments_.outputs) {
      if (suffix_of(name) == ".svg") {
        files.push_back({name, pages_svg(pages)});
        continue;
      }
      auto pdf = pages_pdf(pages, made.report().body + ", bend plan");
      if (!pdf) return pass_on(pdf);
      files.push_back({name, std::move(*pdf)});
    }
    return files;
  }

  Outcome outcome_of(job::Made& made, const job::Request& request) const {
    made.report().task = kBend;
    const std::optional<Error>& refusal = made.report().refusal;
    // A page shows why a part cannot be bent.
    if (refusal && !made.report().plan) return {.json = made.json(), .error = refusal};
    auto files = files_of(made, request);
    if (!files) return failed(files.error());
    Outcome outcome{.files = std::move(*files), .error = refusal};
    append_names(made.report().files, outcome.files);
    // All files are written or none, the report too.
    if (outcome.files.empty() || arguments_.json == "-")
      outcome.json = made.json();
    else
      for (std::filesystem::path& file : files_named({arguments_.json}))
        outcome.files.push_back({std::move(file), made.json()});
    outcome.inputs = files_named({arguments_.input});
    if (arguments_.quiet) return outcome;
    (arguments_.json == "-" ? outcome.aside : outcome.output) = made.text();
    return outcome;
  }

  const job::Catalogue& catalogue_;
  const BendArguments& arguments_;
  const job::Maker* maker_;
};

}  // namespace

CLI::App* add_bend(const Program& program, BendArguments& arguments) {
  const job::Task& task = *program.catalogue.task(kBend);
  CLI::App* command = program.app.add_subcommand(kBend, std::string(task.description));
  add_text(*command, "input", arguments.input, "FILE",
           "STEP file, or the file of another maker, or - for standard input")
      ->required();
  for (const job::Option& option : job::options())
    if (job::is_of_sheet_to_bend(option)) add_one(*command, option, arguments.options);
  add_material(*command, arguments.options);
  for (const std::string_view name : job::kPlanOptions)
    add_one(*command, job::option(name), arguments.options);
  add_time_limit(*command, arguments);
  command
      ->add_flag_callback(
          "--print-tools",
          [] {
            fmt::print("{}", shop::default_tools_json());
            throw CLI::Success();
          },
          "print the built-in tools as a tools file, and exit")
      ->group(std::string(job::heading(job::OptionGroup::brake)));
  add_repeatable(*command, "-o,--output", arguments.outputs,
                 "plan on pages to hang at the machine: .pdf or .svg; may be given several times")
      ->type_name("PATH")
      ->group("Output");
  add_text(*command, "--as-made", arguments.as_made, "OUT.dxf",
           "flat pattern for the inside radii that the tools of the plan leave")
      ->group("Output");
  add_text(*command, "--json", arguments.json, "FILE", "report as JSON; - for standard output")
      ->group("Output");
  command->add_flag("-q,--quiet", arguments.quiet, "print no summary")->group("Output");
  command->footer(kBendExamples);
  return command;
}

int run_bend(const Program& program, const BendArguments& arguments) {
  if (const auto error = unwritable(arguments)) return complain(*error);
  Bend bend(program.catalogue, arguments);
  return run_apart(bend, {arguments.input, arguments.json, arguments.quiet, arguments.limits});
}

}  // namespace planish::cli
