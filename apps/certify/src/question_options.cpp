// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/campaign_names.h>
#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/app/question_options.h>
#include <slalom/core/error.h>

#include <algorithm>
#include <iostream>

namespace slalom {
namespace {

/// The names that complete the values of a field.
NameSource names_for(const std::string& key) {
  if (key == "method") return known_methods;
  if (key == "of" || key == "rows") return [](const Words&) { return parameter_names(); };
  return nullptr;
}

CLI::Option* add_field(CLI::App& app, const QuestionField& field) {
  std::string name = "--" + field.key;
  std::replace(name.begin(), name.end(), '_', '-');
  return std::visit(
      [&](auto* value) {
        using Value = std::remove_pointer_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, bool>)
          return app.add_flag(name, *value, field.help);
        else if constexpr (std::is_same_v<Value, std::optional<double>>)
          return app.add_option(name, *value, field.help);
        else
          return app.add_option(name, *value, field.help)->capture_default_str();
      },
      field.value);
}

}  // namespace

void add_question_options(CLI::App& app, AskArguments& arguments) {
  CampaignArguments& campaign = arguments.campaign;
  add_argument(app, {"campaign", "-c,--config", "The campaign's .ini"}, campaign.config);
  for (const QuestionField& field : arguments.question->fields()) {
    CLI::Option* option = add_field(app, field);
    if (field.required) option->required();
    if (const NameSource names = names_for(field.key)) complete_with(option, names);
  }
  app.add_option("--seed", campaign.seed, "Seed instead of [campaign] seed");
  add_jobs_option(app, campaign.jobs, "Worker processes");
  complete_with(
      app.add_option("--set", campaign.overrides, "Override a key of the .ini: SECTION.KEY=VALUE")
          ->take_all()
          ->allow_extra_args(false),
      setting_names);
  app.add_flag("--quiet", campaign.quiet, "No progress and no messages, except errors");
}

Answer ask_and_print(AskArguments& arguments, AskedQuestion& asked, const std::string& output) {
  const InterruptGuard guard;
  Inquiry inquiry;
  inquiry.workers = arguments.campaign.jobs;
  inquiry.quiet = arguments.campaign.quiet;
  inquiry.output = output;
  inquiry.interrupted = InterruptGuard::raised;
  Answer answer = ask(asked, inquiry);
  std::cout << render_text(asked.question->statement(answer.certificate.at("answer")))
            << answer.remark;
  return answer;
}

void require_enough(const AskedQuestion& asked, const Answer& answer) {
  const std::string unmet_requirement =
      asked.question->unmet_requirement(answer.certificate.at("answer"));
  if (!unmet_requirement.empty()) throw Error(ErrorKind::Job, unmet_requirement);
}

}  // namespace slalom
