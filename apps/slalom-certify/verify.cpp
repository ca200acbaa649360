// SPDX-License-Identifier: BSD-3-Clause
#include "certificate.h"
#include "verbs.h"

#include <slalom/app/external_options.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/read_file.h>

#include <iostream>

namespace slalom {
namespace {

struct VerifyArguments {
  std::string certificate;
  CampaignArguments campaign;
  bool trust = false;
};

void verify(const VerifyArguments& arguments) {
  const std::string& path = arguments.certificate;
  const std::string stored = read_file(path, "a certificate");
  CertificateInput input = read_certificate(stored, path);
  IniFile ini = IniFile::from_text(input.ini, path);
  if (!arguments.trust) require_no_foreign_code(ini, {}, path, "--trust, if you trust the file");
  const LimitJob job = make_limit_job(std::move(input.question), std::move(ini));
  const LimitAnswer answer = execute(job, arguments.campaign);
  const CertificateDifference difference =
      compare_certificates(stored, certificate_text(job, answer), path);
  if (!difference.environment.empty())
    std::cout << "environment: " << difference.environment << "\n";
  if (!difference.answer.empty()) throw job_error(path, "differs: " + difference.answer);
  std::cout << limit_text(job, answer) << path << ": identical\n";
}

}  // namespace

void define_verify(CLI::App& app) {
  static VerifyArguments arguments;
  CLI::App* verb =
      app.add_subcommand("verify", "Execute all runs of a certificate again and compare them");
  verb->add_option("certificate", arguments.certificate, "A certificate (.certificate.json)")
      ->required();
  verb->add_flag("--trust", arguments.trust,
                 "Execute the libraries, modules and commands that the certificate names");
  add_jobs_option(*verb, arguments.campaign.jobs, "Worker processes");
  verb->add_flag("--quiet", arguments.campaign.quiet, "No progress");
  verb->callback([] { verify(arguments); });
}

}  // namespace slalom
