// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "program_run.h"

#include <csignal>
#include <fcntl.h>
#include <map>
#include <unistd.h>

namespace slalom {

/// A virtual X server.
class XServer {
 public:
  XServer() {
    int pipe_ends[2];
    if (pipe(pipe_ends) != 0) return;
    process_ = fork();
    if (process_ == 0) {
      const std::string fd = std::to_string(pipe_ends[1]);
      const int null_device = open("/dev/null", O_WRONLY);
      dup2(null_device, STDERR_FILENO);
      execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "1920x1080x24", "-nolisten",
             "tcp", "-noreset", static_cast<char*>(nullptr));
      _exit(127);
    }
    close(pipe_ends[1]);
    std::string number;
    for (char c = 0; ::read(pipe_ends[0], &c, 1) == 1 && c != '\n';) number += c;
    close(pipe_ends[0]);
    if (!number.empty()) display_ = ":" + number;
  }
  ~XServer() {
    if (process_ <= 0) return;
    kill(process_, SIGTERM);
    waitpid(process_, nullptr, 0);
  }
  XServer(const XServer&) = delete;
  XServer& operator=(const XServer&) = delete;

  const std::string& display() const { return display_; }  ///< ":7"; empty if it did not start

 private:
  pid_t process_ = -1;
  std::string display_;
};

/// Runs Slalom Studio in a virtual X server, one for all tests, with software OpenGL, controlled by
/// scripts. Skipped without Xvfb.
class StudioTest : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    if (std::system("command -v Xvfb >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "needs the package xvfb";
    static const XServer server;
    display_ = server.display();
    ASSERT_FALSE(display_.empty()) << "Xvfb does not start";
  }

  /// Environment variables of the program. Leak detection is off, because OpenGL drivers free their
  /// memory only at exit. The check for free() of memory from `new` is off, because MRPT's build of
  /// nanogui (C++14) does so with widgets that C++17 programs create.
  std::string environment() const {
    return "DISPLAY=" + display_ +
           " LIBGL_ALWAYS_SOFTWARE=1 ASAN_OPTIONS=detect_leaks=0:alloc_dealloc_mismatch=0 ";
  }

  /// `slalom-studio ARGUMENTS --script ...` in the test's folder.
  ProgramResult play(const std::string& script, const std::string& arguments = "") const {
    write("script.txt", script);
    return run(environment() + "slalom-studio " + arguments + " --script script.txt");
  }

  /// The same; fails if the script does. Returns its standard output.
  std::string expect_played(const std::string& script, const std::string& arguments = "") const {
    const ProgramResult result = play(script, arguments);
    EXPECT_EQ(result.status, 0) << result.err << result.out;
    return result.out;
  }

  /// Generates a list of small scenarios, named random_0000 and so on.
  void make_list(int count, const std::string& name = "a.scenarios", int seed = 7) const {
    write("generate.ini", kSmallCampaign);
    std::string& bytes = lists()[{count, seed}];
    if (!bytes.empty()) return write(name, bytes);
    const ProgramResult result =
        run("slalom-scenarios generate -c generate.ini -n " + std::to_string(count) + " --seed " +
            std::to_string(seed) + " -o " + name + " --quiet");
    ASSERT_EQ(result.status, 0) << result.err;
    bytes = read(name);
  }

  std::string display_;

 private:
  /// The lists that were generated, by number of scenarios and seed.
  static std::map<std::pair<int, int>, std::string>& lists() {
    static std::map<std::pair<int, int>, std::string> made;
    return made;
  }
};

}  // namespace slalom
