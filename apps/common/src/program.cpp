#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/ini_file.h>
#include <slalom/core/version.h>

#include <algorithm>
#include <iostream>
#include <new>
#include <vector>

namespace slalom {
namespace {

constexpr int kJobFailed = 1;
constexpr int kWrongUsage = 2;
constexpr int kInterrupted = 130;

/// Messages are one line, whatever the library that made them thinks.
std::string one_line(std::string text) {
  std::replace(text.begin(), text.end(), '\n', ' ');
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

int fail(const std::string& program, const std::string& message, int status) {
  std::cout.flush();
  std::cerr << program << ": " << one_line(message) << std::endl;
  return status;
}

/// The names of the verbs, or none for a program without verbs.
std::vector<std::string> verbs(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands([](const CLI::App*) { return true; })) {
    names.push_back(verb->get_name());
  }
  return names;
}

/// "unknown verb ..." when that is what is wrong, otherwise what CLI11 says.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error, int argc,
                          char** argv) {
  const std::vector<std::string> names = verbs(app);
  const std::string first = argc > 1 ? argv[1] : "";
  if (names.empty() || first.empty() || first[0] == '-' ||
      std::find(names.begin(), names.end(), first) != names.end()) {
    return error.what();
  }
  const std::string nearest = nearest_name(first, names);
  std::string message = "unknown verb '" + first + "'; expected one of";
  for (const std::string& name : names) message += " " + name;
  return nearest.empty() ? message : message + " (did you mean " + nearest + "?)";
}

int report_wrong_usage(const CLI::App& app, const std::string& name, const std::string& message) {
  std::string command = name;
  for (const CLI::App* verb = &app; !verb->get_subcommands().empty();) {
    verb = verb->get_subcommands().front();
    command += " " + verb->get_name();
  }
  return fail(name, message + " (see '" + command + " --help')", kWrongUsage);
}

/// Parses and works; returns 0, throws otherwise.
int parse_and_work(CLI::App& app, int argc, char** argv) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);
  }
  std::cout.flush();
  if (!std::cout) throw job_error("standard output", "cannot be written");
  return 0;
}

}  // namespace

int run_program(const std::string& name, const std::string& description, int argc, char** argv,
                const std::function<void(CLI::App&)>& define, bool needs_arguments) {
  CLI::App app(description, name);
  try {
    app.set_version_flag("--version", name + " " + version(), "Print the version and exit");
    define(app);
    if (!verbs(app).empty()) app.require_subcommand(1);
    if (argc < 2 && needs_arguments) {
      std::cerr << app.help();
      return kWrongUsage;
    }
    return parse_and_work(app, argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_wrong_usage(app, name, usage_message(app, error, argc, argv));
  } catch (const Interrupted& interrupted) {
    return fail(name, std::string("interrupted: ") + interrupted.what(), kInterrupted);
  } catch (const Error& error) {
    return fail(name, error.what(), error.exit_status());
  } catch (const std::bad_alloc&) {
    return fail(name, "not enough memory", kJobFailed);
  } catch (const std::exception& error) {
    return fail(name, reason_of(error), kJobFailed);
  }
}

}  // namespace slalom
