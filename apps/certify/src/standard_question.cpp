// SPDX-License-Identifier: BSD-3-Clause
#include "kinds.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/statistics/sequential_rate.h>

#include <fmt/format.h>

#include <cmath>

namespace slalom {
namespace {

constexpr std::size_t kMaxTrials = 1000000;

/// The question which tests the method passes, after ASTM F3244-21 and ISO 18646-2:2024?
class StandardQuestion : public Question {
 public:
  std::string kind() const override { return "standard"; }
  std::string help() const override {
    return "Run test methods after ASTM F3244-21 and ISO 18646-2:2024, with verdicts in terms of "
           "reliability and confidence";
  }
  std::vector<QuestionField> fields() override;
  void prepare(IniFile& ini) override;
  void check(const MethodCampaign& campaign, BlockRunner& runner) override;
  Json answer(const MethodCampaign& campaign, BlockRunner& runner) const override;
  Statement statement(const Json& answer) const override;
  std::string unmet_requirement(const Json& answer) const override;

 private:
  RunStream stream(const MethodCampaign& campaign, const std::string& family, double speed) const;

  std::vector<std::string> families_ = {"passage", "avoid", "sudden_obstacle", "defined_area",
                                        "follow_path"};
  std::vector<double> speeds_ = {0.5, 1};
  std::size_t trials_ = 30;
  double reliability_ = 0.8, confidence_ = 0.85;
  bool require_ = false;
};

std::vector<QuestionField> StandardQuestion::fields() {
  return {
      {"method", &method, "The method that is tested", true},
      {"families", &families_, "The tests: families of scenarios, with their options in the .ini"},
      {"speeds", &speeds_, "Maximum speeds of the robot as fractions of robot.max_v"},
      {"trials", &trials_, "Runs of each test at each speed"},
      {"reliability", &reliability_, "Rate of success that a test demonstrates"},
      {"confidence", &confidence_, "Confidence with which it must, of each verdict by itself"},
      {"require", &require_, "Exit status 1 unless all tests are passed", false, false}};
}

void StandardQuestion::prepare(IniFile& ini) {
  if (families_.empty()) throw usage_error("--families", "no test", "a family of scenarios");
  for (const std::string& family : families_) set_family(ini, family, "--families ");
}

void StandardQuestion::check(const MethodCampaign& campaign, BlockRunner& runner) {
  require_probability("--reliability", reliability_);
  require_probability("--confidence", confidence_);
  if (speeds_.empty()) throw usage_error("--speeds", "no speed", "a fraction of robot.max_v");
  for (const double speed : speeds_)
    if (!(speed > 0 && speed <= 1))
      throw usage_error("--speeds", format_number(speed) + " is out of range",
                        "a fraction of robot.max_v above 0, at most 1");
  if (trials_ > kMaxTrials || shown_confidence(trials_, 0, reliability_) < confidence_) {
    const std::string needed =
        format_number(std::ceil(math::log(1 - confidence_) / math::log(reliability_)));
    throw usage_error("--trials " + std::to_string(trials_),
                      format_number(reliability_) + " at " + format_number(confidence_) +
                          " needs at least " + needed + " runs without a failure",
                      "at least " + needed + ", at most " + std::to_string(kMaxTrials));
  }
  for (const std::string& family : families_)
    for (const double speed : speeds_) runner.check(stream(campaign, family, speed));
}

RunStream StandardQuestion::stream(const MethodCampaign& campaign, const std::string& family,
                                   double speed) const {
  RunStream stream{"standard/" + family + "/" + format_number(speed),
                   family + " at " + format_number(100 * speed) + " %", campaign.ini};
  const std::string max_v = format_number(campaign.options.robot.max_v * speed);
  set_family(stream.ini, family, "--families ");
  stream.ini.set("robot", "max_v", max_v, "--speeds ");
  // The obstacle appears in front of a robot at this speed.
  if (family == "sudden_obstacle")
    stream.ini.set("generator.sudden_obstacle", "robot_speed", max_v, "--speeds ");
  return stream;
}

Json StandardQuestion::answer(const MethodCampaign& campaign, BlockRunner& runner) const {
  Json tests = Json::array();
  std::size_t passed = 0, redrawn = 0;
  for (const std::string& family : families_)
    for (const double speed : speeds_) {
      std::size_t failures = 0, collisions = 0;
      const RunStream runs = stream(campaign, family, speed);
      runner.run(runs, trials_, [&](const BlockRun& run) {
        failures += run.outcome == Outcome::Success ? 0 : 1;
        collisions += run.outcome == Outcome::Collision ? 1 : 0;
        return true;
      });
      redrawn += runner.redrawn(runs);
      // Rounded, as its last bits depend on the mathematical library.
      const double shown =
          std::round(shown_confidence(trials_, failures, reliability_) * 1e6) / 1e6;
      passed += shown >= confidence_ ? 1 : 0;
      tests.push_back({{"test", family},
                       {"speed", speed},
                       {"max_v", campaign.options.robot.max_v * speed},
                       {"runs", trials_},
                       {"failures", failures},
                       {"collisions", collisions},
                       {"confidence", shown},
                       {"passed", shown >= confidence_}});
    }
  return {{"claim", fmt::format("{} of {} tests passed", passed, tests.size())},
          {"passed", passed},
          {"redrawn", redrawn},
          {"resolution", campaign.options.simulation.resolution},
          {"seed", campaign.options.seed},
          {"tests", tests},
          {"outcomes", runner.hash_all("standard/")}};
}

std::string StandardQuestion::unmet_requirement(const Json& answer) const {
  if (!require_ || answer.at("passed") == answer.at("tests").size()) return "";
  return "--require: " + answer.at("claim").get<std::string>() + "; expected all";
}

Statement StandardQuestion::statement(const Json& answer) const {
  Statement statement;
  statement.title = "tests of " + method + ", reliability " + format_number(reliability_) +
                    ", confidence " + format_number(confidence_);
  StatementTable table{
      "", "lrrrrl", {"test", "max_v", "failures", "collisions", "confidence", "verdict"}, {}};
  for (const Json& test : answer.at("tests"))
    table.rows.push_back(
        {test.at("test").get<std::string>(), format_number(test.at("max_v")) + " m/s",
         fmt::format("{}/{}", test.at("failures").get<std::size_t>(),
                     test.at("runs").get<std::size_t>()),
         std::to_string(test.at("collisions").get<std::size_t>()),
         // Rounded down: the text must not say more.
         fmt::format("{:.3f}", std::floor(test.at("confidence").get<double>() * 1000) / 1000),
         test.at("passed").get<bool>() ? "passed" : "not passed"});
  statement.parts.emplace_back(std::move(table));
  statement.parts.emplace_back("claim: " + answer.at("claim").get<std::string>() +
                               ", in cells of " + format_number(answer.at("resolution")) + " m");
  append_redrawn(statement, answer);
  statement.parts.emplace_back(
      "after ASTM F3244-21 and ISO 18646-2:2024, not conformant: a simulation in two dimensions");
  return statement;
}

}  // namespace

std::unique_ptr<Question> make_standard_question() {
  return std::make_unique<StandardQuestion>();
}

}  // namespace slalom
