// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "private_network.h"
#include "program_run.h"

#include <slalom/core/text.h>

#include <regex>
#include <utility>
#include <vector>

namespace slalom {
namespace {

const std::string kPythonPackage = kBuild + "/lib/python";

/// The commands of the documents print what the documents show: "Commands in documents" in
/// docs/develop/architecture.md.

using Lines = std::vector<std::string>;

/// A step of a document, in order: a file with the lines of a block, or a command and the lines
/// shown below it.
struct Step {
  std::size_t line = 0;  // in the document, from 1
  std::string file, command;
  Lines shown;
};

Lines split_lines(const std::string& text) {
  Lines lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

std::string text_of(const Lines& lines, const std::string& indent = "") {
  std::string text;
  for (const std::string& line : lines) text += indent + line + "\n";
  return text;
}

/// Reads the steps of a document.
class DocumentParser {
 public:
  explicit DocumentParser(const std::string& text) : lines_(split_lines(text)) {}

  std::vector<Step> steps() {
    while (next_ < lines_.size()) {
      const std::string line = take();
      if (starts_with(line, "```")) parse_block(line.substr(3));
      if (starts_with(line, "<!-- $ ")) parse_comment(line.substr(7));
    }
    return std::move(steps_);
  }

 private:
  bool at_end() const { return next_ >= lines_.size(); }
  std::string take() { return at_end() ? "" : lines_[next_++]; }
  bool in_block() const { return !at_end() && !starts_with(lines_[next_], "```"); }

  /// ```LANGUAGE FILE: a file. ```LANGUAGE no-run: ignored. All others: commands with their output.
  void parse_block(const std::string& info) {
    const std::size_t blank = info.find(' ');
    const std::string word = blank == std::string::npos ? "" : info.substr(blank + 1);
    const bool is_file = !word.empty() && word != "no-run";
    if (is_file) steps_.push_back({next_, word, "", {}});
    bool is_shown = is_file;
    while (in_block()) {
      const std::string line = take();
      if (word.empty() && starts_with(line, "$ ")) {
        add_command(line.substr(2), "\\", true);
        is_shown = true;
      } else if (is_shown) {
        steps_.back().shown.push_back(line);
      }
    }
    take();
  }

  /// <!-- $ COMMAND -->, on one or more lines.
  void parse_comment(const std::string& command) {
    add_command(command, "-->", false);
    std::string& added = steps_.back().command;
    if (ends_with(added, "-->")) added.resize(added.size() - 3);
  }

  /// Adds a command with the next lines, as long as its lines end, or do not end, with `mark`.
  void add_command(std::string command, const std::string& mark, bool continued) {
    steps_.push_back({next_, "", "", {}});
    while (!at_end() && ends_with(command, mark) == continued) command += "\n" + take();
    steps_.back().command = command;
  }

  Lines lines_;
  std::size_t next_ = 0;
  std::vector<Step> steps_;
};

bool has_commands(const std::vector<Step>& steps) {
  return std::any_of(steps.begin(), steps.end(),
                     [](const Step& step) { return !step.command.empty(); });
}

/// Whether `line` is `shown`, in which each "..." stands for any text.
bool line_matches(const std::string& shown, const std::string& line) {
  const std::string any = "...";
  std::size_t end = shown.find(any);
  if (end == std::string::npos) return shown == line;
  if (line.compare(0, end, shown, 0, end) != 0) return false;
  std::size_t at = end;
  for (;;) {
    const std::size_t begin = end + any.size();
    end = shown.find(any, begin);
    const std::string part = shown.substr(begin, end - begin);
    if (end == std::string::npos) return line.size() >= at + part.size() && ends_with(line, part);
    const std::size_t found = line.find(part, at);
    if (found == std::string::npos) return false;
    at = found + part.size();
  }
}

/// The first lines at which `printed` differs from `shown`, in which a line "..." stands for any
/// lines: the lengths of the longest parts that agree. Both are complete if all agrees.
std::pair<std::size_t, std::size_t> agreeing_lines(const Lines& shown, const Lines& printed) {
  std::pair<std::size_t, std::size_t> longest = {0, 0};
  std::vector<bool> agrees(printed.size() + 1);  // shown[0, i) with printed[0, j), for each j
  agrees[0] = true;
  for (std::size_t i = 0; i < shown.size(); ++i) {
    std::vector<bool> next(printed.size() + 1);
    for (std::size_t j = 0; j <= printed.size(); ++j)
      next[j] = shown[i] == "..."
                    ? agrees[j] || (j > 0 && next[j - 1])
                    : j > 0 && agrees[j - 1] && line_matches(shown[i], printed[j - 1]);
    const auto first = std::find(next.begin(), next.end(), true);
    if (first == next.end()) return longest;
    longest = {i + 1, first - next.begin()};
    agrees = next;
  }
  if (agrees.back()) longest = {shown.size(), printed.size()};
  return longest;
}

/// Whether it is one of the lines about progress that appear every 10 s: on slow machines only.
bool is_progress(const std::string& line) {
  static const std::regex pattern(R"(.+: \d+/\d+ \(\d+ %\), .+ left)");
  return std::regex_match(line, pattern);
}

std::string line_or_end(const Lines& lines, std::size_t index) {
  return index < lines.size() ? lines[index] : "(the end)";
}

/// Documents with commands.
std::vector<std::filesystem::path> documents() {
  std::vector<std::filesystem::path> paths;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(kDocs))
    if (entry.path().extension() == ".md" &&
        has_commands(DocumentParser(read_text(entry.path())).steps()))
      paths.push_back(entry.path());
  std::sort(paths.begin(), paths.end());
  return paths;
}

class Documents : public ProgramTest, public testing::WithParamInterface<std::filesystem::path> {
 protected:
  /// A private network, if permitted, for methods in other processes.
  static void SetUpTestSuite() {
    enter_private_network();
    has_multicast_ = has_multicast();
  }
  void SetUp() override {
    ProgramTest::SetUp();
    std::filesystem::create_directory_symlink(kConfigs, folder_ / "configs");
    std::filesystem::create_directory_symlink(kDocs + "/images", folder_ / "images");
    std::filesystem::create_directory_symlink(kSource + "/examples", folder_ / "examples");
  }

  /// Runs all commands in one shell, as a reader would, so that a command can use variables and
  /// background processes of an earlier one. The output of command i is in the file .out_i.
  void run_steps(const std::vector<Step>& steps) const {
    std::string script;
    for (std::size_t i = 0; i < steps.size(); ++i) {
      const std::string id = std::to_string(i);
      if (steps[i].command.empty())
        write(steps[i].file, text_of(steps[i].shown));
      else
        script +=
            "{\n" + steps[i].command + "\n} >.out_" + id + " 2>&1\necho $? >.status_" + id + "\n";
    }
    write(".commands", script);
    // The interpreter for which the package is built, which need not be the first on the path.
    EXPECT_EQ(run("PATH=\"" + kPrograms +
                  ":$(dirname " PYTHON "):$PATH\" PYTHONPATH=" + kPythonPackage + " sh .commands")
                  .err,
              "");
  }

  /// Compares the status and the output of command i with the document.
  void check_step(const Step& step, std::size_t i) const {
    Lines printed = split_lines(read(".out_" + std::to_string(i)));
    printed.erase(std::remove_if(printed.begin(), printed.end(), is_progress), printed.end());
    while (!printed.empty() && printed.back().empty()) printed.pop_back();
    const std::string status = read(".status_" + std::to_string(i));
    const std::string problem = difference(step, status.empty() ? -1 : std::stoi(status), printed);
    if (problem.empty()) return;
    ADD_FAILURE() << GetParam().string() << ":" << step.line << ": $ " << step.command
                  << "\nexpected:\n"
                  << text_of(step.shown, "  ") << "printed:\n"
                  << text_of(printed, "  ") << problem;
  }

  inline static bool has_multicast_ = false;

 private:
  /// How the status and the lines of a command differ from the document, or "".
  static std::string difference(const Step& step, int status, const Lines& printed) {
    const bool expects_error =
        std::any_of(step.shown.begin(), step.shown.end(),
                    [](const std::string& line) { return starts_with(line, "slalom-"); });
    if ((status != 0) != expects_error)
      return "exit status " + std::to_string(status) +
             (expects_error ? "; expected that of an error" : "; expected 0");
    const auto [shown_lines, printed_lines] = agreeing_lines(step.shown, printed);
    if (step.shown.empty() || (shown_lines == step.shown.size() && printed_lines == printed.size()))
      return "";
    return "first difference in line " + std::to_string(shown_lines + 1) + " of the output:\n" +
           "  expected: " + line_or_end(step.shown, shown_lines) +
           "\n  printed:  " + line_or_end(printed, printed_lines);
  }
};

TEST_P(Documents, CommandsPrintWhatIsShown) {
  const std::string text = read_text(GetParam());
  if (!has_multicast_ && text.find("$ lcm-logger") != std::string::npos)
    GTEST_SKIP() << "neither a private network nor one with multicast";
  if (text.find("$ python3") != std::string::npos && !std::filesystem::exists(kPythonPackage))
    GTEST_SKIP() << "the Python package is not built under sanitizers";
  const std::vector<Step> steps = DocumentParser(text).steps();
  run_steps(steps);
  for (std::size_t i = 0; i < steps.size(); ++i)
    if (!steps[i].command.empty()) check_step(steps[i], i);
}

INSTANTIATE_TEST_SUITE_P(All, Documents, testing::ValuesIn(documents()),
                         [](const auto& document) { return document.param.stem().string(); });

TEST(DocumentsTest, ReadsFilesCommandsAndTheirOutput) {
  const std::vector<Step> steps = DocumentParser(R"(text
```ini a.ini
[a]
```
<!-- $ touch b
  touch c -->
```
no command
$ one \
    two
first

second
$ three
```
```console no-run
$ four
```
)")
                                      .steps();
  ASSERT_EQ(steps.size(), 4U);
  EXPECT_EQ(steps[0].file, "a.ini");
  EXPECT_EQ(steps[0].shown, Lines{"[a]"});
  EXPECT_EQ(steps[1].command, "touch b\n  touch c ");
  EXPECT_EQ(steps[2].command, "one \\\n    two");
  EXPECT_EQ(steps[2].line, 9U);
  EXPECT_EQ(steps[2].shown, (Lines{"first", "", "second"}));
  EXPECT_EQ(steps[3].command, "three");
  EXPECT_TRUE(steps[3].shown.empty());
}

TEST(DocumentsTest, ThreeDotsStandForAnyTextOrAnyLines) {
  using Agreeing = std::pair<std::size_t, std::size_t>;
  EXPECT_EQ(agreeing_lines({"a", "...", "d"}, {"a", "b", "c", "d"}), (Agreeing{3, 4}));
  EXPECT_EQ(agreeing_lines({"a", "..."}, {"a"}), (Agreeing{2, 1}));
  EXPECT_EQ(agreeing_lines({"a"}, {"a", "b"}), (Agreeing{1, 1}));
  EXPECT_EQ(agreeing_lines({"a", "b"}, {"a", "c"}), (Agreeing{1, 1}));
  EXPECT_EQ(agreeing_lines({"...", "a"}, {"b"}), (Agreeing{1, 0}));
  EXPECT_TRUE(line_matches("time ... s", "time 0.4 s"));
  EXPECT_TRUE(line_matches("{...,\"b\":1,...}", "{\"a\":0,\"b\":1,\"c\":2}"));
  EXPECT_FALSE(line_matches("time ... s", "time 0.4 m"));
  EXPECT_FALSE(line_matches("ab...ba", "aba"));
}

}  // namespace
}  // namespace slalom
