// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/app/checks.h>
#include <slalom/app/completion.h>
#include <slalom/app/man_page.h>
#include <slalom/app/program.h>
#include <slalom/core/error.h>
#include <slalom/core/orphans.h>
#include <slalom/core/printable.h>
#include <slalom/core/temporary_file.h>
#include <slalom/core/text.h>
#include <slalom/core/version.h>

#include <csignal>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <iostream>
#include <new>
#include <system_error>
#include <unistd.h>
#include <vector>

namespace slalom {
namespace {

constexpr int kJobFailed = 1;
constexpr int kUsageError = 2;
constexpr int kInterrupted = 130;

/// Makes every message one line that a terminal can show.
std::string one_line(std::string text) {
  text = printable_line(text);
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

int fail(const std::string& program, const std::string& message, int status) {
  std::cout.flush();
  std::cerr << program << ": " << one_line(message) << std::endl;
  return status;
}

/// The message of CLI11; of a value that is not of its type as those of checks.h.
std::string message_of(const CLI::App& app, const CLI::ParseError& error) {
  constexpr const char* kBegin = "Could not convert: ";
  const std::string text = error.what();
  const std::size_t end = text.find(" = ");
  if (!starts_with(text, kBegin) || end == std::string::npos) return text;
  const std::string name = text.substr(std::strlen(kBegin), end - std::strlen(kBegin));
  const CLI::App* verb = &app;
  while (!verb->get_subcommands().empty()) verb = verb->get_subcommands().front();
  const CLI::Option* option = verb->get_option_no_throw(name);
  const bool is_integer =
      option != nullptr && option->get_type_name().find("INT") != std::string::npos;
  return name + ": '" + printable_line(text.substr(end + 3)) + "' is not valid; expected " +
         (is_integer ? "an integer" : "a number");
}

/// "unknown verb ..." if the first argument is not a verb, otherwise the message of CLI11.
std::string usage_message(const CLI::App& app, const CLI::ParseError& error, int argc,
                          char** argv) {
  const std::vector<std::string> names = verb_names(app);
  const std::string first = argc > 1 ? argv[1] : "";
  if (names.empty() || first.empty() || first[0] == '-' || contains(names, first)) {
    return message_of(app, error);
  }
  const std::string nearest = nearest_name(first, names);
  std::string message = "unknown verb '" + first + "'; expected one of";
  for (const std::string& name : names) message += " " + name;
  return nearest.empty() ? message : message + " (did you mean " + nearest + "?)";
}

int report_usage_error(const CLI::App& app, const std::string& name, const std::string& message) {
  std::string command = name;
  for (const CLI::App* verb = &app; !verb->get_subcommands().empty();) {
    verb = verb->get_subcommands().front();
    command += " " + verb->get_name();
  }
  return fail(name, message + " (see '" + command + " --help')", kUsageError);
}

/// Throws for "--set SECTION.KEY VALUE", whose last word would be taken for another argument.
void reject_separate_values(int argc, char** argv) {
  const std::vector<std::string> words(argv, argv + argc);
  for (std::size_t i = 1; i + 1 < words.size() && words[i] != "--"; ++i) {
    const std::string& key = words[i + 1];
    if (words[i] != "--set" || key[0] == '-' || key.find('=') != std::string::npos ||
        key.find('.') == std::string::npos)
      continue;
    const std::string value = i + 2 < words.size() ? words[i + 2] : "";
    double number = 0;
    std::error_code ignored;
    const bool is_value = !value.empty() && (value[0] != '-' || parse_number(value, number)) &&
                          !std::filesystem::exists(value, ignored);
    throw CLI::ParseError(
        "--set " + key + ": no value; expected " + key + "=" + (is_value ? value : "VALUE"),
        kUsageError);
  }
}

pid_t program_process = 0;

/// Ends the program on a signal that it does not handle otherwise; its temporary files are removed.
void end_interrupted(int signal) {
  if (getpid() != program_process) {  // a worker: as without this handler
    std::signal(signal, SIG_DFL);
    std::raise(signal);
    return;
  }
  remove_temporary_files();
  constexpr char kText[] = "interrupted\n";
  if (write(STDERR_FILENO, kText, sizeof kText - 1) < 0) _exit(kInterrupted);
  _exit(kInterrupted);
}

/// Prepares the process before anything else: opens all three standard streams, so that no file
/// gets the number of a closed one; turns the signal for a file that becomes too large into an
/// error; removes temporary files after a signal; and ends the processes of methods that outlive
/// their fork server.
void prepare_process() {
  program_process = getpid();
  become_subreaper();
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
    if (fcntl(stream, F_GETFD) < 0 && open("/dev/null", O_RDONLY) < 0) _exit(kJobFailed);
  std::signal(SIGXFSZ, SIG_IGN);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, end_interrupted) == SIG_IGN) std::signal(signal, SIG_IGN);
}

/// Throws Error (Usage) for what would fail later with the name of something else.
void expect_usable_system() {
  std::error_code missing;
  (void)std::filesystem::current_path(missing);
  if (missing) throw usage_error("the current folder", "does not exist", "a folder that exists");
#if defined(__linux__)
  if (access("/proc/self/exe", F_OK) != 0)
    throw usage_error("/proc", "is not mounted",
                      "the files of processes, by which libraries are found");
#endif
}

/// The verb that was given, or the program itself.
const CLI::App& selected(const CLI::App& app) {
  const CLI::App* verb = &app;
  while (!verb->get_subcommands().empty()) verb = verb->get_subcommands().front();
  return *verb;
}

/// Throws Error (Usage) if both are the same file; `option` gives the output, `name` is that of the
/// input in the message.
void refuse_output_over_input(const std::string& output, const std::string& input,
                              const std::string& name, const std::string& option = "-o") {
  std::error_code not_both_exist;
  if (std::filesystem::equivalent(input, output, not_both_exist))
    throw usage_error(option + " " + output, "is also an input, " + name, "a different file");
}

/// Throws Error (Usage) if a file that is written is also another argument: it would be replaced.
void refuse_output_over_arguments(const CLI::App& verb) {
  for (const char* name : {"--output", "--bundle", "--development", "--held-out", "--picture"}) {
    const CLI::Option* output = verb.get_option_no_throw(name);
    if (output == nullptr || output->empty()) continue;
    const std::string path = output->as<std::string>();
    const bool is_output = std::string(name) == "--output";
    for (const CLI::Option* option : verb.get_options()) {
      if (option == output) continue;
      for (const std::string& value : option->results())
        refuse_output_over_input(path, value, value, is_output ? "-o" : name);
    }
  }
}

/// Parses the command line and executes the callbacks; returns 0 or throws.
int parse_and_execute(CLI::App& app, int argc, char** argv) {
  try {
    reject_separate_values(argc, argv);
    app.parse(argc, argv);
  } catch (const CLI::Success& success) {
    return app.exit(success);
  }
  std::cout.flush();
  if (!std::cout) throw job_error("standard output", "cannot be written");
  return 0;
}

/// Arguments that are not in the help, as people do not type them: --man-page for the build, and
/// "--complete WORD..." for the completion of shells. False for all others.
bool print_description(const CLI::App& app, const std::vector<std::string>& arguments) {
  if (arguments == std::vector<std::string>{"--man-page"}) {
    std::cout << man_page(app, "Slalom " + version());
    return true;
  }
  if (arguments.empty() || arguments[0] != "--complete") return false;
  try {
    for (const std::string& word : complete(app, {arguments.begin() + 1, arguments.end()}))
      std::cout << word << "\n";
  } catch (
      const std::exception&) {  // such as a file on the line that cannot be read: no candidates
  }
  return true;
}

}  // namespace

void add_argument(CLI::App& app, const Argument& argument, std::string& value) {
  const auto set = [&value, argument](const std::string& text) {
    if (!value.empty() && value != text)
      throw CLI::ValidationError(argument.position,
                                 "both '" + value + "' and '" + text + "'; expected one");
    value = text;
  };
  // The names must differ: CLI11 2.4 refuses a positional argument with the name of an option.
  app.add_option_function<std::string>(argument.option, set, argument.help);
  app.add_option_function<std::string>(argument.position, set,
                                       argument.help + " (or " + argument.option + ")");
  if (!argument.required) return;
  app.parse_complete_callback([&value, argument] {
    if (value.empty()) throw CLI::RequiredError(argument.position);
  });
}

CLI::Option* add_jobs_option(CLI::App& app, int& jobs, const std::string& help) {
  return app.add_option("-j,--jobs", jobs, help + "; 0: all cores that the program may use")
      ->check(in_range(0, 1024))
      ->capture_default_str();
}

void refuse_output_over_inputs(const std::string& output, const IniFile& ini) {
  refuse_output_over_input(output, ini.name(), ini.name());
  for (const std::string& section : ini.sections())
    for (const std::string& key : ini.keys(section))
      for (const std::string& value : split(ini.get(section, key).value_or(""), ','))
        refuse_output_over_input(output, value, ini.where(section, key) + " = " + value);
}

void print_notice(const std::string& line) {
  std::cerr << line << std::endl;
}

void warn_of_damage(const std::string& path, const std::vector<std::string>& damaged) {
  constexpr std::size_t kMaxNamed = 20;
  if (damaged.empty()) return;
  std::vector<std::string> named = damaged;
  if (named.size() > kMaxNamed) {
    named.resize(kMaxNamed);
    named.emplace_back("...");
  }
  std::cerr << one_line("warning: " + path + ": skipped as damaged: " +
                        std::to_string(damaged.size()) + " (" + join(named, ", ") + ")")
            << "\n";
}

std::vector<std::string> campaign_sections(std::vector<std::string> more) {
  for (const char* section : {"campaign", "scenarios", "generator.*", "robot", "sensor", "laser.*",
                              "odometry", "tracks", "simulation", "people", "reference", "metrics",
                              "limits", "record", "analysis", "tune", "method.*"})
    more.emplace_back(section);
  return more;
}

int run_program(const std::string& name, const std::string& description, int argc, char** argv,
                const std::function<void(CLI::App&)>& define, bool needs_arguments) {
  prepare_process();
  CLI::App app(description, name);
  try {
    app.set_version_flag("--version", name + " " + version(), "Print the version and exit");
    define(app);
    check_numbers(app);
    if (!verb_names(app).empty()) {
      app.require_subcommand(1);
      // Before the callback of the verb.
      app.parse_complete_callback([&app] { refuse_output_over_arguments(selected(app)); });
    }
    if (print_description(app, {argv + 1, argv + argc})) return 0;
    if (argc < 2 && needs_arguments) {
      std::cerr << app.help();
      return kUsageError;
    }
    expect_usable_system();
    return parse_and_execute(app, argc, argv);
  } catch (const CLI::ParseError& error) {
    return report_usage_error(app, name, usage_message(app, error, argc, argv));
  } catch (const Interrupted& interrupted) {
    return fail(name, std::string("interrupted: ") + interrupted.what(), kInterrupted);
  } catch (const Error& error) {
    return fail(name, error.what(), error.exit_status());
  } catch (const std::bad_alloc&) {
    return fail(name, "out of memory", kJobFailed);
  } catch (const std::exception& error) {
    return fail(name, reason_of(error), kJobFailed);
  }
}

}  // namespace slalom
