// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace slalom {

inline bool has_browser() {
  return std::system("command -v chromium >/dev/null 2>&1") == 0;
}

/// Whether the page's timers end at once, or its clock is real and what follows its load is not
/// waited for.
enum class PageTime { Virtual, Real };

/// The document of a local file (with a fragment or without) after its scripts have run, which must
/// not report errors. `folder` takes temporary files. `options` of the browser.
inline std::string open_in_browser(const std::string& file, const std::filesystem::path& folder,
                                   const std::string& options = "",
                                   PageTime time = PageTime::Virtual) {
  const auto path = [&folder](const char* name) { return (folder / name).string(); };
  const std::string command =
      "chromium --headless --no-sandbox --disable-gpu --enable-logging=stderr " +
      std::string(time == PageTime::Virtual ? "--virtual-time-budget=3000 " : "") +
      "--user-data-dir='" + path(".profile") + "' " + options + " --dump-dom 'file://" + file +
      "' >'" + path(".dom") + "' 2>'" + path(".log") + "' </dev/null";
  EXPECT_EQ(std::system(command.c_str()), 0) << file;
  std::ifstream log(path(".log"));
  for (std::string line; std::getline(log, line);)
    EXPECT_TRUE(line.find("CONSOLE") == line.npos || line.find("Blocked script") != line.npos)
        << file << ": " << line;
  std::stringstream document;
  document << std::ifstream(path(".dom")).rdbuf();
  return document.str();
}

/// The first group of every match.
inline std::vector<std::string> all_matches(const std::string& text, const std::string& pattern) {
  const std::regex expression(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator i(text.begin(), text.end(), expression), end; i != end; ++i)
    found.push_back((*i)[1]);
  return found;
}

}  // namespace slalom
