// SPDX-License-Identifier: BSD-3-Clause
#include "tune_space.h"

#include <slalom/app/method_option.h>
#include <slalom/campaign/method_parameters.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {
namespace {

constexpr char kSection[] = "tune";
constexpr char kExpectedSpace[] = "LOW, HIGH[, log][, integer], or choices: A | B | ...";

/// The parameter of one line of [tune], without its default.
SpaceParameter parse_line(const std::string& name, const std::string& text,
                          const std::string& where) {
  SpaceParameter parameter;
  parameter.name = name;
  if (text.find('|') != std::string::npos) {
    parameter.choices = split(text, '|');
    return parameter;
  }
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() < 2 || !parse_number(parts[0], parameter.low) ||
      !parse_number(parts[1], parameter.high))
    throw usage_error(where, "'" + text + "' is not a range", kExpectedSpace);
  for (std::size_t i = 2; i < parts.size(); ++i) {
    if (parts[i] != "log" && parts[i] != "integer")
      throw usage_error(where, "'" + parts[i] + "' is unknown", kExpectedSpace);
    (parts[i] == "log" ? parameter.log : parameter.integer) = true;
  }
  return parameter;
}

/// The default as the .ini has it; else that which the method declares.
void set_default(SpaceParameter& parameter, const std::vector<TunableParameter>& declared,
                 const IniFile& ini, const std::string& method, const std::string& where) {
  const std::string section = "method." + method;
  const std::optional<std::string> text = get_method_option(ini, method, parameter.name, where);
  if (!parameter.choices.empty()) {
    const auto& choices = parameter.choices;
    const auto found = std::find(choices.begin(), choices.end(), text.value_or(""));
    if (found == choices.end())
      throw usage_error(where, "no choice is the default",
                        "what " + parameter.name + " is in [" + section + "] or its config");
    parameter.default_value = static_cast<double>(found - choices.begin());
    return;
  }
  if (text) {
    if (!parse_number(*text, parameter.default_value))
      throw usage_error(
          ini.get(section, parameter.name) ? ini.where(section, parameter.name) : where,
          "'" + *text + "' is not valid", "a number, which is tuned");
    return;
  }
  for (const TunableParameter& one : declared)
    if (one.name == parameter.name) {
      parameter.default_value = one.default_value;
      return;
    }
  throw usage_error(where, "its default is unknown",
                    parameter.name + " in [" + section + "]" +
                        (parameter.name.find('.') != std::string::npos
                             ? ", in config, config_set or parameter_set"
                             : ""));
}

/// The ends of a range, or the choices.
std::vector<double> ends_of(const SpaceParameter& parameter) {
  if (parameter.choices.empty()) return {parameter.low, parameter.high};
  std::vector<double> indices;
  for (std::size_t i = 0; i < parameter.choices.size(); ++i)
    indices.push_back(static_cast<double>(i));
  return indices;
}

/// Builds the method with each of these values: a search would take those that it refuses for
/// failures.
void require_accepted_ends(const MethodCampaign& campaign, const ParameterSpace& space,
                           const OptionLocation& where) {
  for (std::size_t i = 0; i < space.size(); ++i) {
    const SpaceParameter& parameter = space.parameters()[i];
    for (const double value : ends_of(parameter)) {
      Configuration configuration = space.defaults();
      configuration[i] = value;
      try {
        tunable_parameters(campaign.configure(options_of(space, configuration)), campaign.options);
      } catch (const Error& refusal) {
        if (refusal.kind() != ErrorKind::Usage) throw;
        const std::string range = parameter.choices.empty() ? format_number(parameter.low) + ", " +
                                                                  format_number(parameter.high)
                                                            : join(parameter.choices, " | ");
        throw usage_error(
            where(parameter.name) + " = " + range,
            campaign.method.name + " refuses " + space.text(i, value) + ": " + refusal.what());
      }
    }
  }
}

}  // namespace

ParameterSpace read_space(const MethodCampaign& campaign) {
  const IniFile& ini = campaign.ini;
  const std::vector<TunableParameter> declared =
      tunable_parameters(campaign.method, campaign.options);
  std::vector<SpaceParameter> parameters;
  for (const std::string& key : ini.keys(kSection)) {
    const std::string where = ini.where(kSection, key);
    SpaceParameter parameter = parse_line(key, *ini.get(kSection, key), where);
    set_default(parameter, declared, ini, campaign.method.name, where);
    parameters.push_back(std::move(parameter));
  }
  if (parameters.empty())
    for (const TunableParameter& one : declared) {
      SpaceParameter parameter{one.name, one.default_value, one.low, one.high,
                               one.log,  one.integer,       {},      std::nullopt};
      set_default(parameter, declared, ini, campaign.method.name, campaign.method.where);
      parameters.push_back(std::move(parameter));
    }
  if (parameters.empty())
    throw usage_error(campaign.method.where, "the method declares no ranges of its parameters",
                      "[tune] with OPTION = " + std::string(kExpectedSpace));
  const OptionLocation where = [&](const std::string& name) {
    return ini.get(kSection, name) ? ini.where(kSection, name) : campaign.method.where + " " + name;
  };
  ParameterSpace space(std::move(parameters), where);
  // An option that nobody reads is an error before the first run.
  tunable_parameters(campaign.configure(options_of(space, space.defaults())), campaign.options);
  require_accepted_ends(campaign, space, where);
  return space;
}

std::map<std::string, std::string> options_of(const ParameterSpace& space,
                                              const Configuration& configuration) {
  std::map<std::string, std::string> options;
  for (std::size_t i = 0; i < space.size(); ++i) {
    const SpaceParameter& parameter = space.parameters()[i];
    std::string& text = options[parameter.name] = space.text(i, configuration[i]);
    // A node refuses a file with an integer where its parameter is a double.
    const bool is_real = parameter.choices.empty() && !parameter.integer;
    if (is_real && parameter.name.find('.') != std::string::npos &&
        text.find_first_of(".e") == std::string::npos)
      text += ".0";
  }
  return options;
}

}  // namespace slalom
