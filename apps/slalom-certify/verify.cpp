// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/certificate.h>
#include <slalom/app/checks.h>
#include <slalom/app/external_options.h>
#include <slalom/app/interrupt.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/read_file.h>

#include <iostream>
#include <random>

namespace slalom {
namespace {

struct VerifyArguments {
  std::string certificate;
  int jobs = 1;
  bool quiet = false, trust = false;
  std::optional<std::size_t> sample;
  std::optional<std::uint64_t> seed;
};

void verify(const VerifyArguments& arguments) {
  const std::string& path = arguments.certificate;
  const Json stored = parse_certificate(read_file(path, "a certificate"), path);
  AskedQuestion asked = question_of(stored, path);
  if (!arguments.trust)
    require_no_foreign_code(asked.ini, {}, path, "--trust, if you trust the file");
  const InterruptGuard guard;
  Inquiry inquiry;
  inquiry.workers = arguments.jobs;
  inquiry.quiet = arguments.quiet;
  inquiry.interrupted = InterruptGuard::raised;
  const auto expect_unchanged = [&] {
    if (!is_unchanged(stored)) throw job_error(path, "differs: checksum");
  };
  if (arguments.sample) {
    // Chosen here: an author who knew the sample could make these runs right, and no others.
    const std::uint64_t seed = arguments.seed.value_or(std::random_device()());
    const std::string compared = verify_sample(stored, path, *arguments.sample, seed, inquiry);
    expect_unchanged();
    std::cout << path << ": " << compared << " identical, sample " << seed << "\n";
    return;
  }
  const Answer repeated = ask(asked, inquiry);
  const CertificateDifference difference = compare_certificates(stored, repeated.certificate);
  if (!difference.environment.empty())
    std::cout << "environment: " << difference.environment << "\n";
  if (!difference.answer.empty()) throw job_error(path, "differs: " + difference.answer);
  expect_unchanged();
  std::cout << render_text(statement_of(repeated.certificate, path)) << path << ": identical\n";
}

}  // namespace

void define_verify(CLI::App& app) {
  static VerifyArguments arguments;
  CLI::App* verb =
      app.add_subcommand("verify", "Execute the runs of a certificate again and compare them");
  verb->add_option("certificate", arguments.certificate, "A certificate (.certificate.json)")
      ->required();
  verb->add_option("--sample", arguments.sample,
                   "Only that many batches of a risk, chosen at random")
      ->check(above_zero());
  verb->add_option("--seed", arguments.seed, "The sample of an earlier call");
  verb->add_flag("--trust", arguments.trust,
                 "Execute the libraries, modules and commands that the certificate names");
  add_jobs_option(*verb, arguments.jobs, "Worker processes");
  verb->add_flag("--quiet", arguments.quiet, "No progress");
  verb->callback([] { verify(arguments); });
}

}  // namespace slalom
