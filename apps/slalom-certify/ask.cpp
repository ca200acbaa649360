// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/campaign_names.h>
#include <slalom/app/certificate.h>
#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>

#include <algorithm>
#include <iostream>
#include <list>

namespace slalom {
namespace {

struct AskArguments {
  std::unique_ptr<Question> question;
  CampaignArguments campaign;
  std::string output;
};

void ask_verb(AskArguments& arguments) {
  IniFile ini = load_campaign_ini(arguments.campaign);
  if (!arguments.output.empty()) refuse_output_over_inputs(arguments.output, ini);
  AskedQuestion asked{std::move(arguments.question), std::move(ini)};
  const InterruptGuard guard;
  Inquiry inquiry;
  inquiry.workers = arguments.campaign.jobs;
  inquiry.quiet = arguments.campaign.quiet;
  inquiry.output = arguments.output;
  inquiry.interrupted = InterruptGuard::raised;
  const Answer answered = ask(asked, inquiry);
  const Json& answer = answered.certificate.at("answer");
  std::cout << render_text(asked.question->statement(answer)) << answered.remark;
  const std::string shortfall = asked.question->shortfall(answer);
  if (!shortfall.empty()) throw Error(ErrorKind::Job, shortfall);
}

/// The names that complete the values of a field.
NameSource names_for(const std::string& key) {
  if (key == "method") return known_methods;
  if (key == "of" || key == "rows") return [](const Words&) { return parameter_names(); };
  return nullptr;
}

CLI::Option* add_field(CLI::App& verb, const QuestionField& field) {
  std::string name = "--" + field.key;
  std::replace(name.begin(), name.end(), '_', '-');
  return std::visit(
      [&](auto* value) {
        using Value = std::remove_pointer_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, bool>)
          return verb.add_flag(name, *value, field.help);
        else if constexpr (std::is_same_v<Value, std::optional<double>> ||
                           std::is_same_v<Value, std::string>)
          return verb.add_option(name, *value, field.help);
        else
          return verb.add_option(name, *value, field.help)->capture_default_str();
      },
      field.value);
}

void define_question(CLI::App& app, AskArguments& arguments) {
  Question& question = *arguments.question;
  CampaignArguments& campaign = arguments.campaign;
  CLI::App* verb = app.add_subcommand(question.kind(), question.help());
  add_argument(*verb, {"campaign", "-c,--config", "The campaign's .ini"}, campaign.config);
  for (const QuestionField& field : question.fields()) {
    CLI::Option* option = add_field(*verb, field);
    if (field.required) option->required();
    if (const NameSource names = names_for(field.key)) complete_with(option, names);
  }
  verb->add_option("-o,--output", arguments.output, "The certificate (.certificate.json) to write");
  verb->add_option("--seed", campaign.seed, "Seed instead of [campaign] seed");
  add_jobs_option(*verb, campaign.jobs, "Worker processes");
  complete_with(
      verb->add_option("--set", campaign.overrides, "Override a key of the .ini: SECTION.KEY=VALUE")
          ->take_all()
          ->allow_extra_args(false),
      setting_names);
  verb->add_flag("--quiet", campaign.quiet, "No progress and no messages, except errors");
  verb->callback([&arguments] { ask_verb(arguments); });
}

}  // namespace

void define_questions(CLI::App& app) {
  static std::list<AskArguments> all;
  for (const std::string& kind : question_kinds())
    define_question(app, all.emplace_back(AskArguments{make_question(kind), {}, ""}));
}

}  // namespace slalom
