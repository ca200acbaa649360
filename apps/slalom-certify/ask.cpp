// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/program.h>
#include <slalom/app/question_options.h>

#include <list>

namespace slalom {
namespace {

struct VerbArguments {
  AskArguments ask;
  std::string output;
};

void ask_verb(VerbArguments& arguments) {
  IniFile ini = load_campaign_ini(arguments.ask.campaign);
  if (!arguments.output.empty()) refuse_output_over_inputs(arguments.output, ini);
  AskedQuestion asked{std::move(arguments.ask.question), std::move(ini)};
  require_enough(asked, ask_and_print(arguments.ask, asked, arguments.output));
}

}  // namespace

void define_questions(CLI::App& app) {
  static std::list<VerbArguments> all;
  for (const std::string& kind : question_kinds()) {
    if (kind == "tune") continue;  // a program of its own
    VerbArguments& arguments = all.emplace_back();
    arguments.ask.question = make_question(kind);
    CLI::App* verb = app.add_subcommand(kind, arguments.ask.question->help());
    add_question_options(*verb, arguments.ask);
    verb->add_option("-o,--output", arguments.output,
                     "The certificate (.certificate.json) to write");
    verb->callback([&arguments] { ask_verb(arguments); });
  }
}

}  // namespace slalom
