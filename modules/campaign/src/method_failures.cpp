#include <slalom/campaign/method_failures.h>
#include <slalom/core/printable.h>
#include <slalom/core/text.h>

#include <tuple>

namespace slalom {

bool is_method_failure(const std::string& outcome) {
  return starts_with(outcome, "method_");
}

void MethodFailures::add(const RunRecord& run) {
  Method& method = methods_[run.method];
  ++method.runs;
  if (!is_method_failure(run.outcome)) return;
  ++method.failed;
  Failure& failure = method.failures[run.outcome];
  const auto key = [](const RunRecord& one) {
    return std::tie(one.scenario_name, one.scenario_hash, one.repetition);
  };
  if (failure.runs == 0 || key(run) < key(failure.first)) failure.first = run;
  ++failure.runs;
}

std::vector<std::string> MethodFailures::lines() const {
  std::vector<std::string> lines;
  for (const auto& [name, method] : methods_)
    for (const auto& [outcome, failure] : method.failures) {
      const RunRecord& first = failure.first;
      lines.push_back(printable_line(
          name + ": " + std::to_string(failure.runs) + " of " + std::to_string(method.runs) +
          (method.runs == 1 ? " run" : " runs") + " ended with " + outcome + ": " +
          first.outcome_detail + " (first: " + first.scenario_name + "/" + first.method + "/" +
          std::to_string(first.repetition) + ")"));
    }
  return lines;
}

std::vector<std::string> MethodFailures::methods_without_a_sound_run() const {
  std::vector<std::string> names;
  for (const auto& [name, method] : methods_)
    if (method.failed == method.runs) names.push_back(name);
  return names;
}

}  // namespace slalom
