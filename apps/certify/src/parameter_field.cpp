// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/parameter_field.h>
#include <slalom/app/question.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>

namespace slalom {

std::string ParameterField::end_option(const std::string& end) const {
  return option == "of" ? "--" + end : "--" + option + "-" + end;
}

void ParameterField::prepare(IniFile& ini) {
  parameter = parse_parameter(of, "--" + option);
  if (!parameter.family.empty()) set_family(ini, parameter.family, "--" + option + " ");
}

void ParameterField::resolve(const MethodCampaign& campaign, BlockRunner& runner) {
  const double cell = campaign.options.simulation.resolution;
  const double smallest_step = parameter.integer ? 1 : parameter.is_length() ? 2 * cell : 0;
  if (from.has_value() != to.has_value())
    throw usage_error(end_option(from ? "to" : "from"), "is missing",
                      "both ends of the range, or none of them");
  if (!from) resolve_range(campaign, runner, smallest_step);
  if (!step) step = rounded(std::max(std::abs(*to - *from) / 10, smallest_step));
  bins = {*from,
          *to,
          *step,
          parameter.integer,
          parameter.unit,
          end_option("from"),
          end_option("to"),
          end_option("step")};
  bins.count();
  if (!parameter.integer && bins.step < smallest_step * (1 - 1e-9))
    throw usage_error(
        end_option("step") + " " + format_number(bins.step),
        "is less than two cells of " + format_number(cell) + " m (simulation.resolution)",
        "at least " + format_number(smallest_step) +
            ", or --set simulation.resolution=" + format_number(bins.step / 2));
}

void ParameterField::resolve_range(const MethodCampaign& campaign, BlockRunner& runner,
                                   double smallest_step) {
  std::vector<double> ends = parameter.defaults;
  for (std::size_t i = 0; i < ends.size(); ++i)
    if (const auto text = campaign.ini.get(parameter.section, parameter.keys[i]))
      parse_number(*text, ends[i]);
  const auto [low, high] = std::minmax_element(ends.begin(), ends.end());
  double range = *high - *low + (parameter.integer ? 1 : 0);
  if (ends.size() < 2 || !(*high > *low))
    throw usage_error(end_option("from"), of + " has no range of its own",
                      "the easy and the hard end");
  double width = step.value_or(std::max(range / 10, smallest_step));
  if (parameter.integer) width = std::ceil(width);
  const double count = std::max(1.0, std::floor(range / width + 1e-9));
  bins = {*low, *low + count * width, width, parameter.integer, parameter.unit};
  if (count < 2)
    throw usage_error(end_option("from"),
                      "the range of " + of + " is one step, " + bins.text({0, 1}),
                      end_option("from") + " and " + end_option("to"));
  const auto successes = [&](std::size_t bin) {
    const RunStream stream{"ends/" + option + "/" + std::to_string(bin),
                           of + " in " + bins.text({bin, bin + 1}),
                           campaign.ini,
                           {in({bin, bin + 1})}};
    runner.check(stream);
    std::size_t successes_of_bin = 0;
    runner.run(stream, kPilotRuns, [&](const BlockRun& run) {
      successes_of_bin += run.outcome == Outcome::Success ? 1 : 0;
      return true;
    });
    return successes_of_bin;
  };
  const std::size_t last = static_cast<std::size_t>(count) - 1;
  const std::size_t at_low = successes(0), at_high = successes(last);
  if (at_low == at_high)
    throw usage_error(end_option("from"),
                      "which end of " + of + " is easy cannot be told: the method succeeds in " +
                          std::to_string(at_low) + " of " + std::to_string(kPilotRuns) +
                          " runs in " + bins.text({0, 1}) + " and in " +
                          bins.text({last, last + 1}),
                      end_option("from") + " and " + end_option("to"));
  const bool rising = at_low > at_high;
  from = rising ? *low : *high;
  to = rounded(rising ? *low + count * width : *high - count * width);
  step = rounded(width);
}

}  // namespace slalom
