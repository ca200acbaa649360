// SPDX-License-Identifier: BSD-3-Clause
#include "kinds.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/statistics/sequential_rate.h>
#include <slalom/statistics/statistics.h>

#include <fmt/format.h>

namespace slalom {
namespace {

/// All kinds; a new one is registered here.
constexpr std::unique_ptr<Question> (*kKinds[])() = {make_limit_question, make_envelope_question,
                                                     make_risk_question, make_standard_question,
                                                     make_tune_question};

void read_field(const QuestionField& field, const nlohmann::json& json) {
  std::visit(
      [&](auto* value) {
        using Value = std::remove_pointer_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, std::optional<double>>) {
          if (!json.is_null()) *value = json.get<double>();
        } else {
          json.get_to(*value);
        }
      },
      field.value);
}

}  // namespace

std::vector<std::string> question_kinds() {
  std::vector<std::string> names;
  for (const auto& make : kKinds) names.push_back(make()->kind());
  return names;
}

std::unique_ptr<Question> make_question(const std::string& kind) {
  for (const auto& make : kKinds)
    if (auto question = make(); question->kind() == kind) return question;
  throw usage_error("kind", "unknown kind '" + kind + "'", expected_name(kind, question_kinds()));
}

std::string Question::verify_sample(const MethodCampaign&, const Json&, BlockRunner&, std::size_t,
                                    RandomEngine&) const {
  throw usage_error("--sample", "an answer of this kind has no parts", "no --sample");
}

Json fields_to_json(Question& question) {
  Json json = Json::object();
  for (const QuestionField& field : question.fields()) {
    if (!field.stored) continue;
    std::visit(
        [&](const auto* value) {
          if constexpr (std::is_same_v<decltype(value), const std::optional<double>*>)
            json[field.key] = *value ? Json(**value) : Json();
          else
            json[field.key] = *value;
        },
        field.value);
  }
  return json;
}

void read_fields(Question& question, const nlohmann::json& json, const std::string& where) {
  std::vector<std::string> known;
  for (const QuestionField& field : question.fields()) {
    known.push_back(field.key);
    if (!json.is_object() || !json.contains(field.key)) {
      if (!field.required) continue;
      throw usage_error(where, "'" + field.key + "' is missing", field.help);
    }
    try {
      read_field(field, json.at(field.key));
    } catch (const nlohmann::json::exception&) {
      throw usage_error(where + " " + field.key, json.at(field.key).dump() + " is not valid",
                        field.help);
    }
  }
  for (const auto& [key, value] : json.items())
    if (!contains(known, key))
      throw usage_error(where, "unknown key '" + key + "'", expected_name(key, known));
}

void require_probability(const std::string& option, double value) {
  if (!(value > 0 && value < 1))
    throw usage_error(option + " " + format_number(value), "is not a probability that can be shown",
                      "between 0 and 1, both excluded");
}

void require_runs(double rate, double confidence, const std::string& option, std::size_t runs) {
  const std::size_t needed = runs_without_failure(rate, confidence);
  if (runs < needed)
    throw usage_error(option + " " + std::to_string(runs),
                      "a claim of " + format_number(rate) + " at " + format_number(confidence) +
                          " needs at least " + std::to_string(needed) + " runs without a failure",
                      "at least " + std::to_string(needed));
}

std::string rate_text(std::size_t runs, std::size_t successes, double confidence) {
  const double n = static_cast<double>(runs), k = static_cast<double>(successes);
  const Interval interval = clopper_pearson_interval(k, n, confidence);
  return fmt::format("{:.2f} [{:.2f}, {:.2f}]", k / n, interval.low, interval.high);
}

Json failure_json(const BlockRunner& runner, const RunStream& stream, const BlockRun& run) {
  const std::optional<RunDraw> draw = runner.draw(stream, run.index);
  return {{"runs", stream.title},
          {"index", run.index},
          {"outcome", to_string(run.outcome)},
          {"scenario", draw ? Json(draw->scenario.hash()) : Json()},
          {"yaml", draw ? Json(scenario_to_yaml(draw->scenario)) : Json()}};
}

void append_redrawn(Statement& statement, const Json& answer) {
  if (const auto draws = answer.at("redrawn").get<std::size_t>(); draws > 0)
    statement.parts.emplace_back(count_text(draws, "draw") +
                                 " without a solvable scenario replaced by others: no runs");
}

std::string range_text(const Json& range, const std::string& unit) {
  return "[" + format_number(range.at("from")) + ", " + format_number(range.at("to")) + "]" +
         (unit.empty() ? "" : " " + unit);
}

const Json& last_of(const Json& array) {
  return array.at(array.size() - 1);
}

void set_family(IniFile& ini, const std::string& family, const std::string& origin) {
  for (const char* key : {"list", "maps", "weights"}) ini.remove("scenarios", key);
  ini.set("scenarios", "generator", family, origin);
}

}  // namespace slalom
