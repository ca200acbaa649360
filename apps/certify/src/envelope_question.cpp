// SPDX-License-Identifier: BSD-3-Clause
#include "figures.h"
#include "kinds.h"

#include <slalom/app/parameter_field.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/statistics/sequential_rate.h>

#include <fmt/format.h>

namespace slalom {
namespace {

/// The question in which values of two parameters the method is reliable: rows of the second, each
/// of which is a FixedSequence over the bins of the first at its part of 1 - confidence.
class EnvelopeQuestion : public Question {
 public:
  std::string kind() const override { return "envelope"; }
  std::string help() const override {
    return "Find the values of two parameters for which the method succeeds with a reliability";
  }
  std::vector<QuestionField> fields() override;
  void prepare(IniFile& ini) override;
  void check(const MethodCampaign& campaign, BlockRunner& runner) override;
  Json answer(const MethodCampaign& campaign, BlockRunner& runner) const override;
  Statement statement(const Json& answer) const override;
  std::string unmet_requirement(const Json& answer) const override;

 private:
  RunStream stream(const IniFile& ini, std::size_t row, std::size_t cell) const;
  Json row_answer(std::size_t row, const IniFile& ini, BlockRunner& runner) const;
  double row_confidence() const;
  std::size_t row_budget() const { return budget_ / rows_.bins.count(); }

  ParameterField of_, rows_{"rows"};
  std::vector<std::string> maps_;
  double reliability_ = 0.95, confidence_ = 0.95;
  std::size_t budget_ = 20000, max_per_cell_ = 600;
  std::optional<double> require_;
};

std::vector<QuestionField> EnvelopeQuestion::fields() {
  return {{"method", &method, "The method that is tested", true},
          {"of", &of_.of, "The parameter of the columns, as that of limit", true},
          {"from", &of_.from, "Its easy end; default: as the .ini or the family has it"},
          {"to", &of_.to, "Its hard end"},
          {"step", &of_.step, "Width of its bins, as that of limit"},
          {"rows", &rows_.of, "The parameter of the rows, of the same family or of robot or sensor",
           true},
          {"rows_from", &rows_.from, "Its first end; default: the easy one of its range"},
          {"rows_to", &rows_.to, "Its last end"},
          {"rows_step", &rows_.step, "Width of its bins"},
          {"maps", &maps_,
           "Maps instead of the sources of the .ini, for parameters of robot or sensor"},
          {"reliability", &reliability_, "Rate of success to show"},
          {"confidence", &confidence_,
           "Confidence of all cells together: 1 minus the probability that one is wrong"},
          {"budget", &budget_, "Runs for all cells; each row has its equal part"},
          {"max_per_cell", &max_per_cell_, "Runs for one cell"},
          {"require", &require_, "Exit status 1 unless this fraction of the cells is claimed",
           false, false}};
}

void EnvelopeQuestion::prepare(IniFile& ini) {
  if (!maps_.empty()) {
    set_family(ini, "", "--maps ");
    ini.set("scenarios", "maps", join(maps_, ", "), "--maps ");
  }
  for (ParameterField* field : {&of_, &rows_}) {
    const Parameter parameter = parse_parameter(field->of, "--" + field->option);
    if (!parameter.family.empty() && !maps_.empty())
      throw usage_error("--" + field->option + " " + field->of, "is a parameter of a family",
                        "one of robot or sensor with --maps");
    if (!parameter.family.empty() && !of_.parameter.family.empty() &&
        parameter.family != of_.parameter.family)
      throw usage_error("--rows " + rows_.of, "is of another family than " + of_.of,
                        "one of " + of_.parameter.family + ", robot or sensor");
    field->prepare(ini);
  }
  if (of_.of == rows_.of)
    throw usage_error("--rows " + rows_.of, "is the parameter of the columns", "another one");
}

double EnvelopeQuestion::row_confidence() const {
  return 1 - (1 - confidence_) / static_cast<double>(rows_.bins.count());
}

void EnvelopeQuestion::check(const MethodCampaign& campaign, BlockRunner& runner) {
  require_probability("--reliability", reliability_);
  require_probability("--confidence", confidence_);
  rows_.resolve(campaign, runner);
  of_.resolve(campaign, runner);
  require_runs(reliability_, row_confidence(), "--max-per-cell", max_per_cell_);
  const std::size_t needed = runs_without_failure(reliability_, row_confidence());
  if (row_budget() < needed)
    throw usage_error("--budget " + std::to_string(budget_),
                      std::to_string(rows_.bins.count()) + " rows need at least " +
                          std::to_string(needed) + " runs without a failure each",
                      "at least " + std::to_string(needed * rows_.bins.count()));
  if (require_ && !(*require_ >= 0 && *require_ <= 1))
    throw usage_error("--require", format_number(*require_) + " is out of range", "0 to 1");
  const RunStream all = {
      "", "", campaign.ini, {rows_.in({0, rows_.bins.count()}), of_.in({0, of_.bins.count()})}};
  runner.check(all);
}

RunStream EnvelopeQuestion::stream(const IniFile& ini, std::size_t row, std::size_t cell) const {
  return {"envelope/" + std::to_string(row) + "/" + std::to_string(cell),
          rows_.bins.text({row, row + 1}) + " " + of_.bins.text({cell, cell + 1}),
          ini,
          {rows_.in({row, row + 1}), of_.in({cell, cell + 1})}};
}

Json EnvelopeQuestion::row_answer(std::size_t row, const IniFile& ini, BlockRunner& runner) const {
  FixedSequence sequence(
      {reliability_, row_confidence(), of_.bins.count(), max_per_cell_, row_budget()});
  while (const auto cell = sequence.current())
    runner.run(stream(ini, row, *cell), max_per_cell_, [&](const BlockRun& run) {
      sequence.add(*cell, run.outcome == Outcome::Success);
      return sequence.current() == *cell;
    });
  Json cells = Json::array();
  for (const RateTest& test : sequence.tests())
    if (test.runs() > 0)
      cells.push_back(
          {{"runs", test.runs()}, {"failures", test.failures()}, {"claimed", test.reached()}});
  return {{"from", rows_.bins.edge(row)},
          {"to", rows_.bins.hardest({row, row + 1})},
          {"cells", std::move(cells)},
          {"claimed", sequence.reached()}};
}

Json EnvelopeQuestion::answer(const MethodCampaign& campaign, BlockRunner& runner) const {
  Json rows = Json::array(), columns = Json::array();
  std::size_t claimed = 0;
  for (std::size_t cell = 0; cell < of_.bins.count(); ++cell)
    columns.push_back({{"from", of_.bins.edge(cell)}, {"to", of_.bins.hardest({cell, cell + 1})}});
  for (std::size_t row = 0; row < rows_.bins.count(); ++row) {
    rows.push_back(row_answer(row, campaign.ini, runner));
    claimed += rows.back().at("claimed").get<std::size_t>();
  }
  const std::size_t cells = rows.size() * columns.size();
  return {{"claim", fmt::format("success >= {} in {} of {} cells", format_number(reliability_),
                                claimed, cells)},
          {"claimed", claimed},
          {"cells", cells},
          {"unit", of_.bins.unit},
          {"rows_unit", rows_.bins.unit},
          {"resolution", campaign.options.simulation.resolution},
          {"seed", campaign.options.seed},
          {"columns", columns},
          {"rows", rows},
          {"outcomes", runner.hash_all("envelope/")}};
}

std::string EnvelopeQuestion::unmet_requirement(const Json& answer) const {
  const double fraction = answer.at("claimed").get<double>() / answer.at("cells").get<double>();
  if (!require_ || fraction >= *require_) return "";
  return "--require " + format_number(*require_) + ": " + answer.at("claim").get<std::string>() +
         "; expected at least that fraction of them";
}

Statement EnvelopeQuestion::statement(const Json& answer) const {
  Statement statement;
  statement.title = of_.of + " by " + rows_.of + " of " + method + ", reliability " +
                    format_number(reliability_) + ", confidence " + format_number(confidence_);
  StatementTable table{"", "l", {rows_.of}, {}};
  for (const Json& column : answer.at("columns")) {
    table.header.push_back(range_text(column, answer.at("unit").get<std::string>()));
    table.alignment += "r";
  }
  for (const Json& row : answer.at("rows")) {
    std::vector<std::string> texts = {range_text(row, answer.at("rows_unit").get<std::string>())};
    for (const Json& cell : row.at("cells"))
      texts.push_back(fmt::format("{}/{}{}", cell.at("failures").get<std::size_t>(),
                                  cell.at("runs").get<std::size_t>(),
                                  cell.at("claimed").get<bool>() ? " yes" : " no "));
    texts.resize(table.header.size(), "-   ");
    table.rows.push_back(std::move(texts));
  }
  statement.parts.emplace_back(std::move(table));
  statement.parts.emplace_back(
      "failures/runs, and whether the reliability is claimed; a row ends at its first cell "
      "without");
  statement.parts.emplace_back("claim: " + answer.at("claim").get<std::string>() +
                               ", in cells of " + format_number(answer.at("resolution")) + " m");
  statement.parts.emplace_back(envelope_figure(of_.of, rows_.of, answer));
  return statement;
}

}  // namespace

std::unique_ptr<Question> make_envelope_question() {
  return std::make_unique<EnvelopeQuestion>();
}

}  // namespace slalom
