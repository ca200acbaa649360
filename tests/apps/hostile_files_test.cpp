// SPDX-License-Identifier: BSD-3-Clause
#include "program_run.h"

#include <sys/stat.h>

namespace slalom {
namespace {

constexpr const char* kGeneration = R"([scenarios]
generator = random
count = 1
[generator.random]
width = 6
height = 6
min_distance = 3
)";

/// Files that are not regular, under names that decide how they would be read. Every command runs
/// under a time limit, so that one that waits fails the test.
class HostileFiles : public ProgramTest {
 protected:
  void SetUp() override {
    ProgramTest::SetUp();
    for (const char* name : {"pipe", "pipe.ini", "pipe.yaml", "pipe.gridmap", "pipe.simplemap.gz",
                             "pipe.png", "pipe.pgm", "pipe.map", "pipe.xyz", "pipe.scenarios",
                             "pipe.results", "pipe.csv", "pipe.rawlog", "pipe.so"})
      ASSERT_EQ(mkfifo((folder_ / name).c_str(), 0600), 0);
    std::filesystem::create_symlink("/dev/zero", folder_ / "zero.ini");
    std::filesystem::create_symlink("/dev/zero", folder_ / "zero.yaml");
    std::filesystem::create_symlink("/dev/zero", folder_ / "zero.xyz");
    std::filesystem::create_directory(folder_ / "folder.ini");
    std::filesystem::create_directory(folder_ / "folder.results");
    write("huge.ini", "");
    std::filesystem::resize_file(folder_ / "huge.ini", std::uintmax_t{1} << 40U);
    write("small.ini", kSmallCampaign);
  }

  void expect_refused(const std::string& command, const std::string& file, const std::string& type,
                      int status = 3) const {
    expect_failure("timeout 60 " + command, status,
                   {file + ": ", type, "expected", "regular file"});
  }
};

TEST_F(HostileFiles, AreRefusedInPlaceOfConfigurations) {
  expect_refused("slalom-evaluate pipe.ini -o out", "pipe.ini", "is a pipe");
  expect_refused("slalom-evaluate zero.ini -o out", "zero.ini", "is a device");
  expect_refused("slalom-evaluate folder.ini -o out", "folder.ini", "is a folder");
  expect_refused("slalom-evaluate huge.ini -o out", "huge.ini", "is too large");
  expect_refused("slalom-scenarios generate -c pipe.ini -o a.scenarios", "pipe.ini", "is a pipe");
  expect_refused("slalom-simulate run -c small.ini --scenarios pipe.scenarios -o a.results",
                 "pipe.scenarios", "is a pipe");
}

TEST_F(HostileFiles, AreRefusedInPlaceOfMaps) {
  for (const char* map :
       {"pipe.yaml", "pipe.gridmap", "pipe.simplemap.gz", "pipe.pgm", "pipe.map", "pipe.xyz"})
    expect_refused(std::string("slalom-scenarios import ") + map +
                       " -o a.scenarios --image-resolution 0.1 --cell-size 0.1 --pairs 1 --seed 1",
                   map, "is a pipe");
  expect_refused("slalom-scenarios import zero.xyz -o a.scenarios --pairs 1", "zero.xyz",
                 "is a device");
  write("map.yaml",
        "image: pipe.png\nresolution: 0.1\norigin: [0, 0, 0]\n"
        "occupied_thresh: 0.65\nfree_thresh: 0.2\nnegate: 0\n");
  expect_refused("slalom-scenarios import map.yaml -o a.scenarios --pairs 1", "pipe.png",
                 "is a pipe");
}

TEST_F(HostileFiles, AreRefusedInPlaceOfListsAndResults) {
  expect_refused("slalom-scenarios list pipe.scenarios", "pipe.scenarios", "is a pipe");
  expect_refused("slalom-analyze table pipe.results", "pipe.results", "is a pipe");
  expect_failure("slalom-analyze dump folder.results", 3,
                 {"folder.results: is a folder", "expected one result file", "merge"});
  expect_refused("slalom-analyze table pipe.csv", "pipe.csv", "is a pipe");
  expect_refused("slalom-replay check pipe.rawlog", "pipe.rawlog", "is a pipe");
  expect_refused("slalom-replay info pipe.csv", "pipe.csv", "is a pipe");
}

TEST_F(HostileFiles, AreRefusedInPlaceOfFilesOfMethods) {
  const auto campaign = [this](const std::string& method) {
    write("method.ini",
          std::string("[campaign]\nmethods = m\n") + kGeneration + "[method.m]\n" + method);
    return std::string("slalom-evaluate method.ini -o out --quiet");
  };
  expect_refused(campaign("adapter = mrpt_holonomic\nclass = CHolonomicND\nconfig = pipe.ini\n"),
                 "pipe.ini", "is a pipe", 2);
  expect_refused(campaign("adapter = mrpt_navigator\nconfig = pipe.ini\n"), "pipe.ini", "is a pipe",
                 2);
  for (const char* method : {"adapter = mrpt_holonomic\nclass = X\nplugin = pipe.so\n",
                             "adapter = library\nplugin = pipe.so\n"})
    expect_failure("timeout 60 " + campaign(method), 2,
                   {"pipe.so: cannot be read (is a pipe)", "expected a file"});
}

TEST_F(HostileFiles, NamesAreShownWithoutControlCharacters) {
  write("a.scenario.yaml",
        "name: \"a\\e]0;b\\x07\\u009b2J\"\nrepresentation: continuous\nbounds: [0, 0, 4, 4]\n"
        "start: [1, 1, 0]\ngoal: [3, 3]\ndiscs: []\npolygons: []\n");
  const ProgramResult imported = run("slalom-scenarios import a.scenario.yaml -o a.scenarios");
  ASSERT_EQ(imported.status, 0) << imported.err;
  for (const char* verb : {"list", "describe --descriptors density"}) {
    const ProgramResult shown = run(std::string("slalom-scenarios ") + verb + " a.scenarios");
    EXPECT_EQ(shown.status, 0) << shown.err;
    EXPECT_NE(shown.out.find("a\\x1b]0;b\\x07\\xc2\\x9b2J"), std::string::npos) << shown.out;
    EXPECT_EQ(shown.out.find('\x1b'), std::string::npos);
  }
}

TEST_F(HostileFiles, NamesMustBeUtf8) {
  write("a.scenario.yaml", "name: caf\xe9\nrepresentation: continuous\n");
  expect_failure("slalom-scenarios import a.scenario.yaml -o a.scenarios", 3,
                 {"a.scenario.yaml:1: ", "not UTF-8", "expected"});
  write("b.ini", std::string("[campaign]\nname = caf\xe9\n") + kGeneration);
  expect_failure("slalom-evaluate b.ini -o out", 2, {"b.ini:2: ", "not UTF-8", "expected"});
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

}  // namespace
}  // namespace slalom
