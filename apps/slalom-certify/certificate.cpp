// SPDX-License-Identifier: BSD-3-Clause
#include "certificate.h"

#include <slalom/analysis/statistics.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace slalom {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;
constexpr char kExpected[] = "a certificate that slalom-certify has written";

std::string success_text(const BinRuns& runs) {
  const Interval interval = wilson_interval(runs.rate(), static_cast<double>(runs.runs), 0.95);
  return fmt::format("{:.2f} [{:.2f}, {:.2f}]", runs.rate(), interval.low, interval.high);
}

/// Why a step was the last one.
std::string end_text(const LimitJob& job, const LimitAnswer& answer, const BinRuns& step) {
  if (step.reached) return "claimed";
  std::size_t claim_runs = 0;
  for (const BinRuns& other : answer.result.steps) claim_runs += other.runs;
  if (step.runs >= job.question.search.max_per_step) return "undecided after --max-per-step";
  if (claim_runs >= job.question.search.budget) return "undecided at the end of --budget";
  return "not claimed";
}

std::string claim_text(const LimitJob& job, const LimitAnswer& answer) {
  const LimitQuestion& question = job.question;
  const std::string rate = format_number(question.search.reliability);
  std::vector<std::string> claimed;
  for (const BinRuns& step : answer.result.steps)
    if (step.reached) claimed.push_back(question.bins.text(step.bins));
  if (!claimed.empty())
    return "success >= " + rate + (claimed.size() > 1 ? " in each of " : " in ") +
           join(claimed, ", ");
  std::vector<BinRuns> seen = answer.result.curve;
  seen.insert(seen.end(), answer.result.steps.begin(), answer.result.steps.end());
  const auto best =
      std::max_element(seen.begin(), seen.end(),
                       [](const BinRuns& a, const BinRuns& b) { return a.rate() < b.rate(); });
  return "nothing can be claimed at " + rate + ": best seen " + success_text(*best) + " in " +
         question.bins.text(best->bins);
}

Json to_json(const std::vector<BinRuns>& phase, const Bins& bins, bool claim) {
  Json rows = Json::array();
  for (const BinRuns& runs : phase) {
    Json row = {{"from", bins.edge(runs.bins.first)},
                {"to", bins.hardest(runs.bins)},
                {"runs", runs.runs},
                {"failures", runs.failures}};
    if (claim) row["claimed"] = runs.reached;
    rows.push_back(std::move(row));
  }
  return rows;
}

Json question_json(const LimitQuestion& question) {
  return {{"method", question.method},
          {"of", question.parameter.name},
          {"from", question.bins.from},
          {"to", question.bins.to},
          {"step", question.bins.step},
          {"reliability", question.search.reliability},
          {"confidence", question.search.confidence},
          {"blocks", question.search.blocks},
          {"budget", question.search.budget},
          {"max_per_step", question.search.max_per_step}};
}

Json answer_json(const LimitJob& job, const LimitAnswer& answer) {
  const Bins& bins = job.question.bins;
  const std::optional<double> limit = limit_of(job.question, answer.result);
  return {{"claim", claim_text(job, answer)},
          {"limit", limit ? Json(*limit) : Json()},
          {"unit", bins.unit},
          {"resolution", job.config.options.simulation.resolution},
          {"seed", job.config.options.seed},
          {"pilot", to_json(answer.result.pilot, bins, false)},
          {"steps", to_json(answer.result.steps, bins, true)},
          {"curve", to_json(answer.result.curve, bins, false)},
          {"outcomes", answer.outcomes}};
}

nlohmann::json parse(const std::string& text, const std::string& where) {
  try {
    return nlohmann::json::parse(text);
  } catch (const nlohmann::json::exception& error) {
    throw file_error(where, error.what(), kExpected);
  }
}

/// "steps: [...] instead of [...]" for the first member that differs; "" if none does.
std::string difference(const nlohmann::json& stored, const nlohmann::json& repeated) {
  for (const auto& [key, value] : repeated.items()) {
    const nlohmann::json before =
        stored.is_object() ? stored.value(key, nlohmann::json()) : nlohmann::json();
    if (value != before) return key + ": " + value.dump() + " instead of " + before.dump();
  }
  return "";
}

}  // namespace

std::optional<double> limit_of(const LimitQuestion& question, const LimitResult& result) {
  const std::size_t claimed = result.claimed();
  if (claimed == 0) return std::nullopt;
  return question.bins.hardest(result.steps[claimed - 1].bins);
}

std::string limit_text(const LimitJob& job, const LimitAnswer& answer) {
  const LimitQuestion& question = job.question;
  const LimitResult& result = answer.result;
  std::size_t width = 0;
  for (const auto* phase : {&result.steps, &result.curve})
    for (const BinRuns& runs : *phase)
      width = std::max(width, question.bins.text(runs.bins).size());
  const auto row = [&](const BinRuns& runs, const std::string& end) {
    return fmt::format("  {:<{}}  {:>9}  {:>11}  {}\n", question.bins.text(runs.bins), width,
                       count_text(runs.runs, "run"), count_text(runs.failures, "failure"), end);
  };
  std::string text = fmt::format(
      "{} of {}, reliability {}, confidence {}\n", question.parameter.name, question.method,
      format_number(question.search.reliability), format_number(question.search.confidence));
  for (const BinRuns& step : result.steps) text += row(step, end_text(job, answer, step));
  text += "claim: " + claim_text(job, answer) + "\n";
  if (const auto limit = limit_of(question, result))
    text += "limit: " + question.bins.value_text(*limit) + ", in cells of " +
            format_number(job.config.options.simulation.resolution) + " m\n";
  if (!result.curve.empty()) text += "not part of the claim:\n";
  for (const BinRuns& bin : result.curve) text += row(bin, success_text(bin));
  std::size_t pilot = 0;
  for (const BinRuns& probe : result.pilot) pilot += probe.runs;
  return text + fmt::format("{} runs, {} of them of the pilot\n", result.runs(), pilot);
}

std::string certificate_text(const LimitJob& job, const LimitAnswer& answer) {
  Json files = Json::object();
  for (const auto& [key, hash] : hash_method_files(job.config)) files[key] = hash;
  const Json json = {{"format", kFormat},
                     {"kind", "limit"},
                     {"question", question_json(job.question)},
                     {"answer", answer_json(job, answer)},
                     {"environment",
                      {{"slalom", version()},
                       {"mrpt", mrpt_version()},
                       {"compiler", compiler_version()},
                       {"files", files}}},
                     {"campaign.ini", job.ini.canonical_text()}};
  return json.dump(2) + "\n";
}

CertificateInput read_certificate(const std::string& text, const std::string& where) {
  const nlohmann::json json = parse(text, where);
  try {
    if (json.at("format").get<int>() != kFormat || json.at("kind").get<std::string>() != "limit")
      throw file_error(where, "unknown format or kind", kExpected);
    const nlohmann::json& q = json.at("question");
    CertificateInput input;
    LimitQuestion& question = input.question;
    q.at("method").get_to(question.method);
    question.parameter = parse_parameter(q.at("of").get<std::string>());
    q.at("from").get_to(question.bins.from);
    q.at("to").get_to(question.bins.to);
    q.at("step").get_to(question.bins.step);
    q.at("reliability").get_to(question.search.reliability);
    q.at("confidence").get_to(question.search.confidence);
    q.at("blocks").get_to(question.search.blocks);
    q.at("budget").get_to(question.search.budget);
    q.at("max_per_step").get_to(question.search.max_per_step);
    json.at("campaign.ini").get_to(input.ini);
    return input;
  } catch (const nlohmann::json::exception& error) {
    throw file_error(where, error.what(), kExpected);
  }
}

CertificateDifference compare_certificates(const std::string& stored, const std::string& repeated,
                                           const std::string& where) {
  const nlohmann::json before = parse(stored, where), now = parse(repeated, where);
  const auto compare = [&](const char* part) {
    return difference(before.value(part, nlohmann::json()), now.at(part));
  };
  return {compare("answer"), compare("environment")};
}

}  // namespace slalom
