// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/man_page.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cctype>

namespace slalom {
namespace {

/// Text of a page: hyphens that can be copied as typed, and no line that is taken for a request.
std::string escaped(const std::string& text) {
  std::string page;
  for (const char c : text) {
    if (c == '\\')
      page += "\\e";
    else if (c == '-')
      page += "\\-";
    else if (c == '\n')
      page += "\n\\&";
    else
      page += c;
  }
  return page.empty() || (page[0] != '.' && page[0] != '\'') ? page : "\\&" + page;
}

std::string bold(const std::string& text) {
  return "\\fB" + escaped(text) + "\\fR";
}

std::string upper(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return text;
}

/// The first sentence, without its period.
std::string first_sentence(const std::string& text) {
  const std::size_t end = text.find(". ");
  std::string sentence = text.substr(0, end);
  if (ends_with(sentence, ".")) sentence.pop_back();
  return sentence;
}

/// A table of options or positional arguments.
std::string options_text(const CLI::App& app, bool positional) {
  const CLI::Formatter formatter;
  std::string page;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_positional() != positional || option->get_group().empty()) continue;
    page += ".TP\n" + bold(formatter.make_option_name(option, positional)) +
            escaped(formatter.make_option_opts(option)) + "\n" +
            escaped(formatter.make_option_desc(option)) + "\n";
  }
  return page;
}

std::string usage_text(const CLI::App& app, const std::string& command) {
  std::string usage = trim(CLI::Formatter().make_usage(&app, command));
  usage.erase(0, usage.find(command) + command.size());
  return bold(command) + escaped(usage) + "\n";
}

std::vector<const CLI::App*> verbs_of(const CLI::App& app) {
  return app.get_subcommands([](const CLI::App* verb) { return !verb->get_group().empty(); });
}

std::string verbs_text(const CLI::App& app, const std::string& command) {
  std::string page;
  for (const CLI::App* verb : verbs_of(app)) {
    const std::string name = command + " " + verb->get_name();
    page += ".SS " + escaped(name.substr(name.find(' ') + 1)) + "\n" + usage_text(*verb, name) +
            ".PP\n" + escaped(verb->get_description()) + "\n" + options_text(*verb, true) +
            options_text(*verb, false) + verbs_text(*verb, name);
  }
  return page;
}

std::string section(const std::string& title, const std::string& text) {
  return text.empty() ? "" : ".SH " + title + "\n" + text;
}

}  // namespace

std::string man_page(const CLI::App& app, const std::string& version) {
  const std::string& name = app.get_name();
  const std::string description = app.get_description();
  return ".TH " + upper(escaped(name)) + " 1 \"\" \"" + version + "\" \"User Commands\"\n" +
         section("NAME", escaped(name + " - " + first_sentence(description)) + "\n") +
         section("SYNOPSIS", usage_text(app, name)) +
         section("DESCRIPTION", escaped(description) + "\n") +
         section("ARGUMENTS", options_text(app, true)) +
         section("OPTIONS", options_text(app, false)) + section("VERBS", verbs_text(app, name));
}

}  // namespace slalom
