// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/certificate.h>

#include <CLI/CLI.hpp>

#include <memory>

namespace slalom {

/// A question as the command line asks it.
struct AskArguments {
  std::unique_ptr<Question> question;
  CampaignArguments campaign;
};

/// Adds the campaign, an option for each field of the question, and --seed, -j, --set and --quiet.
/// `arguments` must outlive the app.
void add_question_options(CLI::App& app, AskArguments& arguments);

/// Throws Error (Job) if the answer is not what the asker requires.
void require_enough(const AskedQuestion& asked, const Answer& answer);

/// Asks it, writes the certificate to `output` unless that is "", and prints what it says. SIGINT
/// and SIGTERM interrupt it.
Answer ask_and_print(AskArguments& arguments, AskedQuestion& asked, const std::string& output);

}  // namespace slalom
