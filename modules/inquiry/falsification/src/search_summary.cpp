// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/text.h>
#include <slalom/falsification/search_summary.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace slalom {
namespace {

std::string tally_text(const SearchTally& tally) {
  std::vector<std::string> parts;
  for (const auto& [outcome, runs] : tally.outcomes)
    parts.push_back(std::to_string(runs) + " " + outcome);
  return count_text(tally.failures, "failure") + " in " + count_text(tally.runs, "run") + " (" +
         join(parts, ", ") +
         (tally.without_witness > 0
              ? "; " + count_text(tally.without_witness, "failure") + " without a witness"
              : "") +
         ")";
}

/// States what the upper limit counts, and which runs without success it does not.
std::string limit_text(const SearchTally& tally, const SearchOptions& options) {
  std::vector<std::string> names, others;
  for (const Outcome outcome : options.outcomes) names.push_back(to_string(outcome));
  for (const auto& [outcome, runs] : tally.outcomes)
    if (outcome != to_string(Outcome::Success) && !contains(names, outcome))
      others.push_back(std::to_string(runs) + " " + outcome);
  if (tally.without_witness > 0)
    others.push_back(std::to_string(tally.without_witness) + " failures without a witness");
  return "          0 of " + std::to_string(tally.runs) + " failed" +
         (options.fairness.witness == NeedsWitness::Always ? " where a witness reaches the goal"
                                                           : "") +
         ": with 95 % confidence at most " +
         format_number(std::round(tally.rule_of_three() * 1e6) / 1e6) +
         " of such scenarios do\n          a failure is " + join(names, ", ") +
         (others.empty() ? "" : "; not counted: " + join(others, ", ")) + "\n";
}

nlohmann::json tally_json(const SearchTally& tally) {
  return {{"runs", tally.runs},
          {"failures", tally.failures},
          {"without_witness", tally.without_witness},
          {"outcomes", tally.outcomes}};
}

}  // namespace

std::string search_text(const SearchResult& result, const KeptFailures& kept,
                        const SearchOptions& options) {
  const SearchState& state = result.state;
  std::string text = "random    " + tally_text(state.random) + "\n";
  if (state.random.failures == 0 && state.random.runs > 0)
    text += limit_text(state.random, options);
  text += "adaptive  " + tally_text(state.adaptive) + "\nended     " + result.stopped + "\n";
  if (kept.failures.empty()) return text;
  text += "kept      " + count_text(kept.failures.size(), "failure");
  if (kept.diversity) text += ", diversity " + format_fixed(*kept.diversity, 2);
  return text + (kept.near_duplicates > 0
                     ? "; " + count_text(kept.near_duplicates, "near-duplicate") + " left out\n"
                     : "\n");
}

std::string search_json(const SearchResult& result, const KeptFailures& kept, std::uint64_t seed) {
  nlohmann::json json = {{"seed", seed},
                         {"random", tally_json(result.state.random)},
                         {"adaptive", tally_json(result.state.adaptive)},
                         {"ended", result.stopped},
                         {"near_duplicates", kept.near_duplicates}};
  if (kept.diversity) json["diversity"] = *kept.diversity;
  if (result.state.random.failures == 0 && result.state.random.runs > 0)
    json["upper_limit_95"] = result.state.random.rule_of_three();
  return json.dump();
}

}  // namespace slalom
