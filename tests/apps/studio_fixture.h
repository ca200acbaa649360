#pragma once

#include "program_run.h"

#include <csignal>
#include <fcntl.h>
#include <unistd.h>

namespace slalom {

/// Slalom Studio as a user sits before it: the real program in a real X server without a screen,
/// drawn by OpenGL in software, played by scripts. Skipped where there is no Xvfb.
class StudioTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (std::system("command -v Xvfb >/dev/null 2>&1") != 0) GTEST_SKIP() << "no Xvfb";
    start_server();
    ASSERT_FALSE(display_.empty()) << "Xvfb does not start";
  }
  void TearDown() override {
    if (server_ > 0) {
      kill(server_, SIGTERM);
      waitpid(server_, nullptr, 0);
    }
    ProgramTest::TearDown();
  }

  /// What a window runs in. Leaks are not looked for: OpenGL drivers keep what they have until the
  /// end. Nor is it told when what `new` gave is given to free(): MRPT's build of nanogui, which
  /// is of C++14, does so with widgets that programs of C++17 made.
  std::string environment() const {
    return "DISPLAY=" + display_ +
           " LIBGL_ALWAYS_SOFTWARE=1 ASAN_OPTIONS=detect_leaks=0:alloc_dealloc_mismatch=0 ";
  }

  /// `slalom-studio ARGUMENTS --script ...` in the test's folder.
  Ended play(const std::string& script, const std::string& arguments = "") const {
    write("script.txt", script);
    return run(environment() + "slalom-studio " + arguments + " --script script.txt");
  }

  /// The same; fails where the script does. What it printed.
  std::string expect_played(const std::string& script, const std::string& arguments = "") const {
    const Ended ended = play(script, arguments);
    EXPECT_EQ(ended.status, 0) << ended.err << ended.out;
    return ended.out;
  }

  /// "a.scenarios": so many small generated places, named random_0000 and so on.
  void make_list(int count, const std::string& name = "a.scenarios", int seed = 7) const {
    write("generate.ini", kSmallCampaign);
    const Ended ended =
        run("slalom-scenarios generate -c generate.ini -n " + std::to_string(count) + " --seed " +
            std::to_string(seed) + " -o " + name + " --quiet");
    ASSERT_EQ(ended.status, 0) << ended.err;
  }

  std::string display_;  ///< ":7"

 private:
  void start_server() {
    int ends[2];
    ASSERT_EQ(pipe(ends), 0);
    server_ = fork();
    if (server_ == 0) {
      const std::string fd = std::to_string(ends[1]);
      const int silence = open("/dev/null", O_WRONLY);
      dup2(silence, STDERR_FILENO);
      execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "1920x1080x24", "-nolisten",
             "tcp", static_cast<char*>(nullptr));
      _exit(127);
    }
    close(ends[1]);
    std::string number;
    for (char c = 0; read_one(ends[0], c) && c != '\n';) number += c;
    close(ends[0]);
    if (!number.empty()) display_ = ":" + number;
  }
  static bool read_one(int file, char& c) { return ::read(file, &c, 1) == 1; }

  pid_t server_ = -1;
};

}  // namespace slalom
