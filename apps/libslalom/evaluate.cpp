// SPDX-License-Identifier: BSD-3-Clause
#include "calls.h"
#include "own_methods.h"
#include "results.h"
#include "scenarios.h"

#include <slalom/app/certificate.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <limits>
#include <map>
#include <memory>
#include <string>
#include <utility>

namespace slalom {
namespace {

using Json = nlohmann::json;

constexpr std::int64_t kMaxWorkers = 1000;

/// Throws Error (Usage) for another than an integer of the range.
std::int64_t read_integer(const Json& given, const std::string& key, std::int64_t otherwise,
                          std::int64_t low, std::int64_t high) {
  if (!given.contains(key)) return otherwise;
  const Json& value = given[key];
  const bool fits = value.is_number_integer() && value >= low && value <= high;
  if (!fits)
    throw usage_error("options " + key, "'" + value.dump() + "' is not valid",
                      "an integer in [" + std::to_string(low) + ", " + std::to_string(high) + "]");
  return value;
}

/// Sets what evaluate() has besides the sections of an .ini.
Options read_evaluation(const Json& given) {
  const std::vector<std::string> known = {"settings",    "metrics", "descriptors", "seed",
                                          "repetitions", "workers", "in_process",  "output"};
  for (const auto& [key, value] : given.items())
    if (!contains(known, key))
      throw usage_error("options", "unknown key '" + key + "'", expected_name(key, known));
  Options options;
  read_run_options(to_ini(given.value("settings", Json::object())), options);
  for (const auto& [key, ids] :
       {std::pair("metrics", &options.metrics), std::pair("descriptors", &options.descriptors)})
    if (given.contains(key) && !given[key].is_null())
      *ids = given[key].get<std::vector<std::string>>();
  constexpr auto kMaxSeed = std::numeric_limits<std::int64_t>::max();
  options.seed = static_cast<std::uint64_t>(read_integer(given, "seed", 1, 0, kMaxSeed));
  options.repetitions = static_cast<int>(read_integer(given, "repetitions", 1, 1, 1000000));
  options.workers = static_cast<int>(read_integer(given, "workers", 1, 0, kMaxWorkers));
  options.in_process = given.value("in_process", false);
  options.output = given.value("output", "");
  return options;
}

slalom_results* evaluate_json(const Json& methods, const slalom_own_methods* own,
                              const slalom_scenarios* scenarios, const Json& given,
                              slalom_progress progress, void* context) {
  if (scenarios == nullptr) throw usage_error("scenarios", "are a null pointer", "a list");
  Options options = read_evaluation(given);
  bool stopped = false;
  options.cancel = [&] {
    stopped = stopped || is_interrupted();
    return stopped;
  };
  if (progress != nullptr)
    options.progress = [&](const std::string& phase, std::size_t done, std::size_t total) {
      stopped = stopped || is_interrupted() || progress(context, phase.c_str(), done, total) != 0;
    };
  ResultTable table = evaluate(read_methods(methods, own), scenarios->scenarios, options);
  if (stopped) throw Error(ErrorKind::Job, "interrupted");
  return std::make_unique<slalom_results>(slalom_results{std::move(table), options.output, nullptr})
      .release();
}

Json certify(const std::string& kind, const Json& question, const Json& method,
             const slalom_own_methods* own, const Json& settings, Inquiry inquiry) {
  AskedQuestion asked{make_question(kind), to_ini(settings)};
  read_fields(*asked.question, question, kind);
  Json named = method;
  named["name"] = asked.question->method;
  const Methods methods = read_methods(Json::array({named}), own);
  if (method.contains("type")) {
    inquiry.given = methods.list().at(0);
    inquiry.configure = [own, named](const std::map<std::string, std::string>& options) {
      const std::string name = named.at("name");
      Methods configured;
      configured.add(name, own_method(*own, named.at("type"), name, options));
      return configured.list().at(0);
    };
  } else {
    // A method that an .ini can name is in the certificate, which therefore can be verified.
    const std::string section = "method." + asked.question->method;
    const IniFile ini = to_ini({{section, method.at("keys")}});
    for (const std::string& key : ini.keys(section))
      asked.ini.set(section, key, *ini.get(section, key));
  }
  inquiry.quiet = true;
  inquiry.interrupted = is_interrupted;
  const Answer answer = ask(asked, inquiry);
  return {{"certificate", answer.certificate},
          {"text", render_text(asked.question->statement(answer.certificate.at("answer")))}};
}

}  // namespace
}  // namespace slalom

using namespace slalom;

slalom_results* slalom_evaluate(const char* methods, const slalom_own_methods* own,
                                const slalom_scenarios* scenarios, const char* options,
                                slalom_progress progress, void* context) {
  return guarded<slalom_results*>(nullptr, [&] {
    return evaluate_json(json_of(methods, "methods"), own, scenarios, json_of(options, "options"),
                         progress, context);
  });
}

char* slalom_certify(const char* kind, const char* question, const char* method,
                     const slalom_own_methods* own, const char* settings, int workers,
                     const char* output) {
  return guarded<char*>(nullptr, [&] {
    Inquiry inquiry;
    inquiry.workers = workers;
    inquiry.output = text_of(output, "output");
    return to_owned(certify(text_of(kind, "kind"), json_of(question, "question"),
                            json_of(method, "method"), own, json_of(settings, "settings"), inquiry)
                        .dump());
  });
}
