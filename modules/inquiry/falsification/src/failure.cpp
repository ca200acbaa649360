// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/falsification/failure.h>
#include <slalom/io/rawlog_path.h>

#include <map>

namespace slalom {
namespace {

std::string fairness_text(const FairnessReport& fairness, bool has_witnesses) {
  std::string text =
      fairness.fair() ? "fair: " : "NOT fair (" + join(fairness.violations, "; ") + "): ";
  text += "bottleneck " + format_fixed(fairness.geometry.bottleneck, 2) + " robot widths, " +
          format_fixed(fairness.geometry.start_clearance, 2) + " m free at the start, ";
  text += !fairness.witness.empty() ? fairness.witness + " reaches the goal"
          : has_witnesses           ? "no witness reaches the goal"
                                    : "no other method was asked";
  return text + (fairness.repeatable ? ", repeated bit for bit" : ", not repeated");
}

std::string size_text(const Bounds& bounds) {
  return format_fixed(bounds.width(), 2) + " m x " + format_fixed(bounds.height(), 2) + " m";
}

}  // namespace

void name_failures(std::vector<Failure>& failures, const std::string& method) {
  std::map<std::string, int> counts;
  for (Failure& failure : failures) {
    const std::string kind = method + "_" + to_string(failure.small.trial.outcome);
    failure.small.scenario =
        failure.small.scenario.renamed(kind + "_" + std::to_string(++counts[kind]));
  }
}

bool find_neighbors(std::vector<Failure>& failures, const FalsificationSetup& setup,
                    const NeighborOptions& options) {
  std::vector<Scenario> originals;
  for (const Failure& failure : failures) originals.push_back(failure.original);
  auto neighbors = successful_neighbors(setup, originals, options);
  if (!neighbors) return false;
  for (std::size_t i = 0; i < failures.size(); ++i)
    failures[i].neighbors = std::move((*neighbors)[i]);
  return true;
}

std::string failure_text(const Failure& failure, const FalsificationSetup& setup) {
  const ShrinkResult& small = failure.small;
  const std::string before = std::to_string(small.parts_before);
  const std::string after = std::to_string(small.parts_after);
  std::string text = small.scenario.name() + ": " + setup.method.name + " ends as " +
                     to_string(small.trial.outcome) + "\n";
  text += "  found      " + failure.origin + "\n";
  if (!small.scenario.people().empty()) text += "  ended      " + small.trial.detail + "\n";
  text += "  shrunk     obstacles " + before + " -> " + after + ", " +
          size_text(failure.original.bounds()) + " -> " + size_text(small.scenario.bounds()) +
          ", " + count_text(small.runs, "run") + ", end moved " + format_fixed(small.moved, 2) +
          " m\n";
  text += "  " + fairness_text(small.fairness, !setup.witnesses_in(small.scenario).empty()) + "\n";
  text += small.minimal ? "  minimal: each obstacle was removed alone\n"
                        : "  not proven minimal: the limit of runs is reached\n";
  for (const Removal& removal : small.removals)
    text += "    without " + removal.part + ": " + removal.verdict + "\n";
  return text;
}

std::string show_command(const Failure& failure, const FalsificationSetup& setup,
                         const std::string& folder) {
  const std::string results = folder + "/check/runs.results";
  return "slalom-evaluate " + folder + "/failures.ini -o " + folder +
         "/check && slalom-replay play " +
         rawlog_path(results, failure.small.scenario.hash(), setup.method.name, setup.repetition) +
         " --gui";
}

}  // namespace slalom
