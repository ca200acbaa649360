// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/app/block_runner.h>
#include <slalom/app/statement.h>

#include <nlohmann/json.hpp>

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace slalom {

using Json = nlohmann::ordered_json;

/// A value that the asker gives: an option of the verb, and a key of the certificate.
struct QuestionField {
  std::string key;  ///< "max_per_step", as an option "--max-per-step"
  std::variant<double*, std::size_t*, bool*, std::string*, std::optional<double>*,
               std::vector<double>*, std::vector<std::string>*>
      value;
  std::string help;
  bool required = false;
  bool stored = true;  ///< in the certificate
};

/// A question about the reliability of a method; its answer, with all that it depends on, is a
/// certificate. A new kind is one source and one line in question.cpp.
class Question {
 public:
  virtual ~Question() = default;

  virtual std::string kind() const = 0;
  virtual std::string help() const = 0;
  virtual std::vector<QuestionField> fields() = 0;

  /// Sets what the question says about the .ini. Throws Error (Usage) for one that cannot be asked.
  virtual void prepare(IniFile& ini) = 0;
  /// Sets the fields that depend on the campaign. Throws Error (Usage), before the first run of an
  /// answer, for a question that cannot be answered.
  virtual void check(const MethodCampaign& campaign, BlockRunner& runner) = 0;
  /// The answer; the same for any execution.
  virtual Json answer(const MethodCampaign& campaign, BlockRunner& runner) const = 0;
  virtual Statement statement(const Json& answer) const = 0;
  /// Why the answer is not what the asker requires; "" if it is, or if nothing is required.
  virtual std::string unmet_requirement(const Json& answer) const = 0;
  /// Adds what wall-clock figures say, which are no part of the answer; mostly "".
  virtual std::string remark(const Json&, const BlockRunner&) const { return ""; }
  /// The metric that runs need, see DrawExecution; "": none.
  virtual std::string metric() const { return ""; }
  /// Executes a sample of the runs of an answer again, drawn with `engine`, and returns what was
  /// compared. Throws Error: Job for what differs, Usage for answers without parts.
  virtual std::string verify_sample(const MethodCampaign& campaign, const Json& answer,
                                    BlockRunner& runner, std::size_t size,
                                    RandomEngine& engine) const;

  std::string method;
};

/// The kinds, in the order of the help.
std::vector<std::string> question_kinds();
/// A question with its defaults. Throws Error (Usage) for an unknown kind.
std::unique_ptr<Question> make_question(const std::string& kind);

Json fields_to_json(Question& question);
/// Throws Error (Usage) at `where` for fields that are missing, unknown or of another type.
void read_fields(Question& question, const nlohmann::json& json, const std::string& where);

// Parts of answers.

/// Throws Error (Usage) unless 0 < value < 1.
void require_probability(const std::string& option, double value);
/// Throws Error (Usage) if a rate cannot be shown with that many runs (an option and its value).
void require_runs(double rate, double confidence, const std::string& option, std::size_t runs);
/// "0.97 [0.83, 1.00]", with clopper_pearson_interval().
std::string rate_text(std::size_t runs, std::size_t successes, double confidence = 0.95);
/// A run that failed: its stream, number, outcome and, if it has one, its scenario in full.
Json failure_json(const BlockRunner& runner, const RunStream& stream, const BlockRun& run);
/// Adds the number of draws that are no runs, the member `redrawn` of an answer, unless it is 0.
void append_redrawn(Statement& statement, const Json& answer);
/// "[1.2, 1.1] m", of the members `from` and `to`.
std::string range_text(const Json& range, const std::string& unit);
/// The last element. Throws nlohmann::json::exception for what is no array or empty.
const Json& last_of(const Json& array);
/// Makes [scenarios] of the .ini that family only.
void set_family(IniFile& ini, const std::string& family, const std::string& origin);

}  // namespace slalom
