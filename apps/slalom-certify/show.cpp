// SPDX-License-Identifier: BSD-3-Clause
#include "verbs.h"

#include <slalom/app/certificate.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_list.h>

#include <filesystem>
#include <iostream>

namespace slalom {
namespace {

void write_failures(const Json& certificate, const std::string& path, const std::string& output) {
  const std::vector<Scenario> scenarios = failed_scenarios(certificate, path);
  if (scenarios.empty())
    throw usage_error(path, "contains no failure in full", "-o with .html, .tex or .svg");
  ScenarioList::write(output, [&](ScenarioList& list) { list.add_all(scenarios); });
}

void show(const std::string& path, const std::string& output) {
  const Json certificate = read_certificate(path);
  const Statement statement = statement_of(certificate, path);
  if (output.empty()) {
    std::cout << render_text(statement);
    return;
  }
  const std::string extension = std::filesystem::path(output).extension().string();
  if (extension == ".scenarios") return write_failures(certificate, path, output);
  const std::string svg = render_svg(statement);
  if (extension == ".html")
    write_file_atomically(output, certificate_page(certificate, path));
  else if (extension == ".tex")
    write_file_atomically(output, render_latex(statement));
  else if (extension == ".svg" && !svg.empty())
    write_file_atomically(output, svg);
  else
    throw usage_error("-o " + output,
                      extension == ".svg" ? "certificates of this kind have no figure"
                                          : "its extension is unknown",
                      ".html, .tex, .svg of limit and envelope, .scenarios");
}

}  // namespace

void define_show(CLI::App& app) {
  static std::string path, output;
  CLI::App* verb = app.add_subcommand(
      "show", "Print a certificate, or write it as a page, LaTeX, figure or list of its failures");
  verb->add_option("certificate", path, "A certificate (.certificate.json)")->required();
  verb->add_option("-o,--output", output,
                   "A page (.html), a LaTeX document (.tex), the figure (.svg) or the scenarios of "
                   "the failures (.scenarios)");
  verb->callback([] { show(path, output); });
}

}  // namespace slalom
