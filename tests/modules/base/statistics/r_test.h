// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>
#include <vector>

namespace slalom {

/// Compares with R; skipped if Rscript is not installed.
class RTest : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v Rscript >/dev/null 2>&1") != 0)
      GTEST_SKIP() << "needs the package r-base-core";
  }

  /// Runs an R script and returns the numbers that it prints.
  static std::vector<double> r(const std::string& script) {
    std::string path = testing::TempDir() + "slalom_XXXXXX";
    const int file = mkstemp(path.data());
    EXPECT_GE(file, 0);
    if (file >= 0) close(file);
    std::ofstream(path) << "options(digits = 15)\n" << script << "\n";
    FILE* pipe = popen(("Rscript --vanilla " + path + " 2>/dev/null").c_str(), "r");
    std::string text;
    char buffer[4096];
    for (std::size_t n = 0; pipe && (n = fread(buffer, 1, sizeof buffer, pipe)) > 0;)
      text.append(buffer, n);
    if (pipe) pclose(pipe);
    std::remove(path.c_str());
    std::istringstream words(text);
    std::vector<double> numbers;
    for (double number = 0; words >> number;) numbers.push_back(number);
    return numbers;
  }
};

}  // namespace slalom
