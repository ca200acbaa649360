// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/certificate.h>
#include <slalom/core/available_cores.h>
#include <slalom/core/error.h>
#include <slalom/core/hash.h>
#include <slalom/core/read_file.h>
#include <slalom/core/version.h>
#include <slalom/io/result_file.h>
#include <slalom/io/scenario_yaml.h>
#include <slalom/io/svg_scene.h>

#include <set>

namespace slalom {
namespace {

constexpr int kFormat = 3;
constexpr char kExpected[] = "a certificate that slalom-certify has written";

MethodCampaign campaign_of(const AskedQuestion& asked, const Inquiry& inquiry) {
  const std::string& method = asked.question->method;
  if (!inquiry.given) return read_method_campaign(asked.ini, method);
  return {asked.ini,        read_campaign_options(asked.ini), *inquiry.given, {}, false,
          inquiry.configure};
}

Json environment_json(const MethodCampaign& campaign) {
  Json files = Json::object();
  for (const auto& [key, hash] : campaign.files) files[key] = hash;
  return {{"slalom", version()},
          {"mrpt", mrpt_version()},
          {"compiler", compiler_version()},
          {"files", files}};
}

BlockRunner runner_of(const MethodCampaign& campaign, const Inquiry& inquiry,
                      const Question& question, const std::string& identity) {
  BlockExecution execution;
  execution.workers =
      campaign.one_worker && inquiry.workers == 0 ? 1 : worker_count(inquiry.workers);
  execution.quiet = inquiry.quiet;
  execution.interrupted = inquiry.interrupted;
  if (!inquiry.output.empty()) execution.journal = inquiry.output + ".runs";
  execution.identity = identity;
  execution.metric = question.metric();
  return {campaign, std::move(execution)};
}

/// Hash of all but the checksum itself. Other programs may order members and write numbers
/// otherwise.
std::string checksum_of(const Json& certificate) {
  nlohmann::json content(certificate);
  content.erase("checksum");
  nlohmann::json values = content.flatten();
  for (auto& value : values)
    if (value.is_number()) value = value.get<double>();
  return Hasher().add(values.dump()).hex();
}

/// "steps: [...] instead of [...]" for the first member that differs; "" if none does.
std::string difference(const nlohmann::json& stored, const nlohmann::json& repeated) {
  for (const auto& [key, value] : repeated.items()) {
    const nlohmann::json before =
        stored.is_object() ? stored.value(key, nlohmann::json()) : nlohmann::json();
    if (value == before && stored.contains(key)) continue;
    if (value.is_array() && before.is_array() && value.size() == before.size())
      for (std::size_t i = 0; i < value.size(); ++i)
        if (value[i].is_object() && value[i] != before[i])
          return key + "[" + std::to_string(i) + "]." + difference(before[i], value[i]);
    return key + ": " + value.dump() + " instead of " + before.dump();
  }
  for (const auto& [key, value] : stored.items())
    if (!repeated.contains(key)) return key + ": nothing instead of " + value.dump();
  return "";
}

/// The answer, and the runs that failed by errors of the method. Of a question that cannot be
/// answered no journal is left.
std::pair<Json, std::string> answer_of(Question& question, const MethodCampaign& campaign,
                                       BlockRunner& runner) {
  try {
    question.check(campaign, runner);
    Json facts = question.answer(campaign, runner);
    return {std::move(facts), runner.method_failures()};
  } catch (const Error& error) {
    if (error.kind() == ErrorKind::Usage) runner.remove_journal();
    throw;
  }
}

}  // namespace

Answer ask(AskedQuestion& asked, const Inquiry& inquiry) {
  Question& question = *asked.question;
  question.prepare(asked.ini);
  const MethodCampaign campaign = campaign_of(asked, inquiry);
  const Json environment = environment_json(campaign);
  const std::string identity = Hasher()
                                   .add(question.kind())
                                   .add(fields_to_json(question).dump())
                                   .add(campaign.ini.canonical_text())
                                   .add(environment.dump())
                                   .hex();
  BlockRunner runner = runner_of(campaign, inquiry, question, identity);
  const auto [facts, failures] = answer_of(question, campaign, runner);
  Answer answer{{{"format", kFormat},
                 {"kind", question.kind()},
                 {"question", fields_to_json(question)},
                 {"answer", facts},
                 {"environment", environment},
                 {"campaign.ini", campaign.ini.canonical_text()}},
                question.remark(facts, runner) + (failures.empty() ? "" : failures + "\n")};
  answer.certificate["checksum"] = checksum_of(answer.certificate);
  if (inquiry.output.empty()) return answer;
  write_file_atomically(inquiry.output, answer.certificate.dump(2) + "\n");
  runner.remove_journal();
  return answer;
}

bool answers(const Json& certificate, AskedQuestion& asked) {
  asked.question->prepare(asked.ini);
  const MethodCampaign campaign = campaign_of(asked, {});
  const Json files = environment_json(campaign).at("files");
  return certificate.at("kind") == asked.question->kind() &&
         certificate.at("question") == fields_to_json(*asked.question) &&
         certificate.at("campaign.ini") == campaign.ini.canonical_text() &&
         certificate.value("environment", Json::object()).value("files", Json()) == files;
}

Json parse_certificate(const std::string& text, const std::string& where) {
  // Copies and hashes of deeper ones would take all of the stack.
  const auto is_flat = [&](int depth, Json::parse_event_t, const Json&) {
    constexpr int kMaxDepth = 100;
    if (depth > kMaxDepth)
      throw file_error(where, "has more than " + std::to_string(kMaxDepth) + " levels", kExpected);
    return true;
  };
  try {
    Json json = Json::parse(text, is_flat);
    if (json.at("format").get<int>() != kFormat)
      throw file_error(where, "format " + json.at("format").dump() + " is unknown", kExpected);
    json.at("kind").get<std::string>();
    json.at("campaign.ini").get<std::string>();
    if (!json.at("question").is_object() || !json.at("answer").is_object())
      throw file_error(where, "has no question or no answer", kExpected);
    return json;
  } catch (const nlohmann::json::exception& error) {
    throw file_error(where, error.what(), kExpected);
  }
}

bool is_unchanged(const Json& certificate) {
  return certificate.value("checksum", Json()) == checksum_of(certificate);
}

Json read_certificate(const std::string& path) {
  Json certificate = parse_certificate(read_file(path, "a certificate"), path);
  if (!is_unchanged(certificate))
    throw file_error(path, "does not match its checksum: it was changed", kExpected);
  return certificate;
}

AskedQuestion question_of(const Json& certificate, const std::string& where) {
  try {
    AskedQuestion asked{make_question(certificate.at("kind").get<std::string>()),
                        IniFile::from_text(certificate.at("campaign.ini"), where)};
    read_fields(*asked.question, certificate.at("question"), where + " question");
    return asked;
  } catch (const Error& error) {
    throw file_error(where, error.what(), kExpected);
  }
}

Statement statement_of(const Json& certificate, const std::string& where) {
  AskedQuestion asked = question_of(certificate, where);
  try {
    return asked.question->statement(certificate.at("answer"));
  } catch (const nlohmann::json::exception& error) {
    throw file_error(where, error.what(), kExpected);
  }
}

std::string verify_sample(const Json& certificate, const std::string& where, std::size_t size,
                          std::uint64_t seed, const Inquiry& inquiry) {
  AskedQuestion asked = question_of(certificate, where);
  asked.question->prepare(asked.ini);
  const MethodCampaign campaign = campaign_of(asked, inquiry);
  BlockRunner runner = runner_of(campaign, inquiry, *asked.question, "");
  asked.question->check(campaign, runner);
  RandomEngine engine(seed);
  try {
    return asked.question->verify_sample(campaign, certificate.at("answer"), runner, size, engine);
  } catch (const nlohmann::json::exception& error) {
    throw file_error(where, error.what(), kExpected);
  }
}

CertificateDifference compare_certificates(const Json& stored, const Json& repeated) {
  const auto compare = [&](const char* part) {
    // Unordered: files may have been written again by other programs.
    return difference(nlohmann::json(stored.value(part, Json())),
                      nlohmann::json(repeated.at(part)));
  };
  return {compare("answer"), compare("environment")};
}

namespace {

/// The failures of an answer that are in it in full: a text and a scenario each.
std::vector<std::pair<std::string, Scenario>> failures_in(const Json& certificate,
                                                          const std::string& where) {
  std::vector<std::pair<std::string, Scenario>> failures;
  const Json& answer = certificate.at("answer");
  try {
    for (const Json& failure : answer.value("failures", Json::array())) {
      const std::string text = failure.at("runs").get<std::string>() + ", run " +
                               std::to_string(failure.at("index").get<std::size_t>()) + ": " +
                               failure.at("outcome").get<std::string>();
      if (failure.at("yaml").is_null()) continue;
      failures.emplace_back(text, scenario_from_yaml(failure.at("yaml"), where));
    }
  } catch (const nlohmann::json::exception& error) {
    throw file_error(where, error.what(), kExpected);
  }
  return failures;
}

}  // namespace

std::string certificate_page(const Json& certificate, const std::string& where) {
  const AskedQuestion asked = question_of(certificate, where);
  SceneOptions options;
  options.max_pixels = 280;
  options.robot_radius = read_robot_model(asked.ini).radius;
  std::string more;
  const auto failures = failures_in(certificate, where);
  if (!failures.empty()) more += "<h2>Failures</h2>\n<div class=\"failures\">\n";
  for (const auto& [text, scenario] : failures)
    more += "<figure>" + render_svg(scenario, options) + "<figcaption>" + html_escape(text) +
            "</figcaption></figure>\n";
  if (!failures.empty())
    more +=
        "</div>\n<p>slalom-certify show FILE -o failures.scenarios writes their scenarios.</p>\n";
  more += "<h2>Campaign</h2>\n<pre>" +
          html_escape(certificate.at("campaign.ini").get<std::string>()) + "</pre>\n";
  return render_html(statement_of(certificate, where), more);
}

std::vector<Scenario> failed_scenarios(const Json& certificate, const std::string& where) {
  std::vector<Scenario> scenarios;
  std::set<std::string> hashes;
  for (auto& [text, scenario] : failures_in(certificate, where))
    if (hashes.insert(scenario.hash()).second) scenarios.push_back(std::move(scenario));
  return scenarios;
}

}  // namespace slalom
