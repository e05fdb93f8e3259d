#include "apart.hpp"
#include "commands.hpp"
#include "option_parts.hpp"
#include "refusals.hpp"
#include "terminal.hpp"

#include <planish/base/message.hpp>
#include <planish/job/run.hpp>
#include <planish/pack/pack.hpp>
#include <planish/schema/text_file.hpp>

#include <fmt/format.h>

namespace planish::cli {
namespace {

constexpr auto kPackExamples = R"(Examples:
  planish pack chair.step -o shop/                      every body of an assembly
  planish pack parts/ -o shop/ --materials steel.csv --density 7.85 --zip
  planish pack flat/ -o shop/                           the results of a batch
  planish pack chair.step -o shop/ --nest 3000x1500 --gap 5 --grain
  planish pack chair.step -o shop/ --rates rates.json

Exit status: as of batch, 0 also where parts are refused: the list and the cover name them.
More in docs/pack.md.)";

Result<std::optional<pack::GivenFile>> given(const std::string& file, const std::string& kind) {
  if (file.empty()) return std::nullopt;
  auto text = schema::read_text(file, kind);
  if (!text) return pass_on(text);
  return pack::GivenFile{std::filesystem::path(file).filename().string(), std::move(*text)};
}

/// "3000x1500"
std::optional<pack::Stock> stock_in(const std::string& text) {
  const auto by = text.find_first_of("xX");
  if (by == std::string::npos) return std::nullopt;
  const auto length = job::parse_number(text.substr(0, by)),
             width = job::parse_number(text.substr(by + 1));
  if (!length || !width || *length <= 0.0 || *width <= 0.0) return std::nullopt;
  return pack::Stock{*length, *width};
}

Result<pack::PackOptions> options_of_pack(const PackArguments& arguments) {
  pack::PackOptions options;
  options.options = job::options_json(arguments.options);
  options.workers = workers_of(arguments.how);
  options.limits = arguments.how.limits;
  options.plan = !arguments.no_plan;
  options.drawings = !arguments.no_drawings;
  options.zip = arguments.zip;
  for (const auto& [option, value] : arguments.options.all())
    if (arguments.no_plan && option->group == job::OptionGroup::brake)
      return fail(refuse::plan_and_none, {{"option", flag_of(option->name)}}, "no-plan");
  auto rates = given(arguments.rates, "rates file");
  if (!rates) return pass_on(rates);
  options.rates = std::move(*rates);
  if (!arguments.stock.empty()) {
    options.stock = stock_in(arguments.stock);
    if (!options.stock) return fail(refuse::bad_stock, {{"text", arguments.stock}}, "nest");
    options.stock->gap = arguments.gap.value_or(options.stock->gap);
    options.stock->grain = arguments.grain;
  } else if (arguments.gap || arguments.grain) {
    return fail(refuse::stock_unsaid, {}, "nest");
  }
  job::Request tried;
  if (const auto entered = arguments.options.enter(tried); !entered) return pass_on(entered);
  return options;
}

std::string summary_text(const pack::PackResult& result, const std::string& out) {
  std::string text = tell(
                         "{parts:distinct part} in {groups:group}, {pieces:piece}; "
                         "{refused:body/bodies} refused\n",
                         {{"parts", result.parts},
                          {"groups", result.groups},
                          {"pieces", result.pieces},
                          {"refused", result.refused}})
                         .sentence;
  if (result.sheets > 0) text += tell("{sheets:sheet}\n", {{"sheets", result.sheets}}).sentence;
  for (const std::string& note : result.notes)
    text += note + "\n";
  return text +
         tell("wrote {n:file} to {out}\n", {{"n", result.files.size()}, {"out", out}}).sentence +
         left_out_text(result.refused_for, result.passed_over);
}

}  // namespace

CLI::App* add_pack(const Program& program, PackArguments& arguments) {
  CLI::App* command = program.app.add_subcommand("pack",
                                                 "make everything for production, in one folder");
  command
      ->add_option("input", arguments.inputs, "files, folders or @lists, or the results of a batch")
      ->required()
      ->check(not_empty)
      ->type_name("INPUT");
  add_text(*command, "-o,--output", arguments.output, "FOLDER/", "folder of the pack")
      ->required()
      ->group("Output");
  command->add_flag("--zip", arguments.zip, "also write the pack as one file, pack.zip")
      ->group("Output");
  command
      ->add_flag("--no-drawings", arguments.no_drawings, "make no PDF of each part, and no cover")
      ->group("Output");
  add_text(*command, "--rates", arguments.rates, "FILE.json",
           "the shop's rates for cutting, bending and material")
      ->group("Shop");
  add_text(*command, "--nest", arguments.stock, "LENGTHxWIDTH",
           "nest the parts of each group on sheets of this size, in mm")
      ->group("Shop");
  command->add_option("--gap", arguments.gap, "gap between parts on a sheet, in mm; default 5")
      ->check(check_of({.name = "gap",
                        .kind = job::OptionKind::number,
                        .description = {},
                        .range = schema::kAtLeastZero}))
      ->type_name("N")
      ->group("Shop");
  command->add_flag("--grain", arguments.grain, "keep parts along the grain of the sheet")
      ->group("Shop");
  command
      ->add_flag("--no-plan", arguments.no_plan,
                 "do not check whether a press brake can bend each part")
      ->group("Shop");
  add_many_parts(*command, program.catalogue, arguments.how, arguments.options);
  command->footer(kPackExamples);
  return command;
}

int run_pack(const Program& program, const PackArguments& arguments) {
  const auto options = options_of_pack(arguments);
  if (!options) return complain(options.error(), arguments.how);
  std::optional<Telling> telling(std::in_place, arguments.how);
  const auto result = pack::make_pack(
      arguments.inputs, arguments.output, *options, program.catalogue,
      [&](const batch::BatchProgress& at) { (*telling)(at); }, interrupted);
  telling.reset();
  if (!result) return complain(result.error(), arguments.how);
  if (!arguments.how.quiet) fmt::print("{}", summary_text(*result, arguments.output));
  return status_of(result->parts, result->refused_for);
}

}  // namespace planish::cli
