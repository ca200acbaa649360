// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"

#include <slalom/app/method_dependencies.h>
#include <slalom/core/read_file.h>
#include <slalom/io/result_file.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <unistd.h>

namespace slalom {
namespace {

class MethodDependencies : public ::testing::Test {
 protected:
  MethodDependencies() { std::filesystem::create_directories(folder_ + "/parts"); }
  ~MethodDependencies() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    write_file_atomically(folder_ + "/" + name, text);
    return folder_ + "/" + name;
  }

  /// The keys of the files of [method.m] with these lines, `files` being known.
  std::vector<std::string> keys_of(const std::string& lines,
                                   const std::map<std::string, std::string>& files = {}) const {
    const IniFile ini = IniFile::from_text("[method.m]\n" + lines, folder_ + "/campaign.ini");
    std::vector<std::string> keys;
    for (const auto& [key, path] : dependencies_of_methods(ini, {"method.m"}, files)) {
      EXPECT_TRUE(std::filesystem::is_regular_file(path)) << path;
      keys.push_back(key);
    }
    return keys;
  }

  void compile(const std::string& command) const {
    const std::string shell = "cd '" + folder_ + "' && " SLALOM_COMPILER " " + command;
    ASSERT_EQ(std::system(shell.c_str()), 0) << shell;
  }

  const std::string folder_ = (std::filesystem::temp_directory_path() /
                               ("slalom_method_dependencies_" + std::to_string(getpid())))
                                  .string();
};

using Keys = std::vector<std::string>;

TEST_F(MethodDependencies, OfAPythonModuleAreTheModulesOfItsFolderAlsoThoseOfFunctions) {
  const std::string module = write("mine.py",
                                   "import json\n"
                                   "import near\n"
                                   "import not_installed_anywhere\n"
                                   "def step():\n"
                                   "  from parts import late\n");
  write("near.py", "import further\n");
  write("further.py", "import near\n");  // a cycle
  write("unused.py", "");
  write("parts/__init__.py", "");
  write("parts/late.py", "");
  EXPECT_EQ(keys_of("module = mine.py\n", {{"method.m.module", module}}),
            (Keys{"method.m.module/further.py", "method.m.module/near.py",
                  "method.m.module/parts/__init__.py", "method.m.module/parts/late.py"}));
}

TEST_F(MethodDependencies, OfAModuleThatCannotBeParsedAreNone) {
  const std::string module = write("mine.py", "def (:\n");
  EXPECT_EQ(keys_of("", {{"method.m.module", module}}), Keys{});
}

TEST_F(MethodDependencies, OfACommandLineAreTheProgramItsFilesAndTheirModules) {
  write("method.sh", "#!/bin/sh\n");
  write("my method.py", "");
  write("script.py", "import near\n");
  write("near.py", "");
  write("weights.bin", "");
  EXPECT_EQ(keys_of("launch = LANG=C exec ./method.sh --weights=weights.bin\n"),
            (Keys{"method.m.launch/method.sh", "method.m.launch/weights.bin"}));
  Keys keys = keys_of("launch = test -e /bin/sh && exec python3 'script.py' 2>/dev/null\n");
  // An interpreter outside of the system is part of it, with its libraries.
  keys.erase(std::remove_if(keys.begin(), keys.end(),
                            [](const std::string& key) { return key.find(".py") == key.npos; }),
             keys.end());
  EXPECT_EQ(keys, (Keys{"method.m.launch/near.py", "method.m.launch/script.py"}));
}

TEST_F(MethodDependencies, OfProgramsInPathAreThoseOutsideOfTheSystem) {
  write("parts/my_program", "#!/bin/sh\n");
  const std::string before = std::getenv("PATH");
  setenv("PATH", (folder_ + "/parts:" + before).c_str(), 1);
  const Keys keys = keys_of("adapter = lcm\nlaunch = exec my_program | cat\n");
  setenv("PATH", before.c_str(), 1);
  EXPECT_EQ(keys, Keys{"method.m.launch/my_program"});
}

TEST_F(MethodDependencies, OfALibraryAreTheLibrariesThatItIsLinkedWith) {
  write("far.cpp", "int far() { return 1; }\n");
  write("near.cpp", "int far(); int near() { return far(); }\n");
  write("plugin.cpp", "int near(); int plugin() { return near(); }\n");
  const std::string linked = " -shared -fPIC -L. -Wl,-rpath,\"$PWD:$PWD/parts\" ";
  compile(linked + "-o parts/libfar.so far.cpp");
  compile(linked + "-o libnear.so near.cpp -Lparts -lfar");
  compile(linked + "-o libplugin.so plugin.cpp -lnear");
  EXPECT_EQ(keys_of("", {{"method.m.plugin", folder_ + "/libplugin.so"}}),
            (Keys{"method.m.plugin/libnear.so", "method.m.plugin/parts/libfar.so"}));
}

/// A field of protocol buffers with bytes as its content.
std::string field(int number, const std::string& content) {
  return std::string(1, static_cast<char>(number * 8 + 2)) +
         std::string(1, static_cast<char>(content.size())) + content;
}

/// An ONNX model with a tensor whose data are in a file (onnx.proto: graph 7, initializer 5,
/// external_data 13, key 1, value 2), after a version (1) and a name (2).
std::string model_with(const std::string& location) {
  const std::string entry = field(1, "location") + field(2, location);
  return std::string("\x08\x08", 2) + field(7, field(2, "net") + field(5, field(13, entry)));
}

TEST_F(MethodDependencies, OfAModelAreItsExternalData) {
  write("parts/weights", "");
  const std::string model = write("policy.onnx", model_with("parts/weights"));
  EXPECT_EQ(keys_of("", {{"method.m.model", model}}), Keys{"method.m.model/parts/weights"});
  // A tensor of a constant: node 1, attribute 5, t 5.
  const std::string entry = field(1, "location") + field(2, "parts/weights");
  const std::string constant =
      write("constant.onnx", field(7, field(1, field(5, field(5, field(13, entry))))));
  EXPECT_EQ(keys_of("", {{"method.m.model", constant}}), Keys{"method.m.model/parts/weights"});
  const std::string whole = model_with("parts/weights");
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_EQ(keys_of("", {{"method.m.model", write("cut.onnx", whole.substr(0, size))}}), Keys{});
}

TEST_F(MethodDependencies, OfAModelAreNoFilesOutsideOfItsFolderAndNoneThatOtherBytesName) {
  for (const char* folder : {"/private", "/models"})
    std::filesystem::create_directory(folder_ + folder);
  write("private/key", "");
  write("models/inside", "");
  std::filesystem::create_symlink("../private/key", folder_ + "/models/link");
  for (const std::string& location : {std::string("../private/key"), folder_ + "/private/key",
                                      std::string("link"), std::string("inside/../../private/key")})
    EXPECT_EQ(keys_of("", {{"method.m.model", write("models/m.onnx", model_with(location))}}),
              Keys{})
        << location;
  // The same bytes in the text of a description (doc_string of the model: 6).
  const std::string text = field(1, "location") + field(2, "inside");
  EXPECT_EQ(keys_of("", {{"method.m.model", write("models/m.onnx", field(6, text))}}), Keys{});
}

TEST_F(MethodDependencies, OfOtherOptionsAreTheFilesThatTheyName) {
  write("table.csv", "");
  write("plain", "");
  EXPECT_EQ(keys_of("table = table.csv\ngain = 0.5\nname = plain\nfolder = parts/\n"),
            Keys{"method.m.table/table.csv"});
}

TEST_F(MethodDependencies, AreFoundInTheCurrentFolder) {
  write("script.py", "import near\n");
  write("near.py", "");
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder_);
  const IniFile ini = IniFile::from_text("[method.m]\nlaunch = exec sh script.py\n", "m.ini");
  Keys keys;
  for (const auto& [key, path] : dependencies_of_methods(ini, {"method.m"}, {}))
    keys.push_back(key);
  const auto known = dependencies_of_methods(ini, {}, {{"method.m.module", "script.py"}});
  std::filesystem::current_path(before);
  EXPECT_EQ(keys, (Keys{"method.m.launch/near.py", "method.m.launch/script.py"}));
  EXPECT_EQ(known.count("method.m.module/near.py"), 1U);
}

TEST_F(MethodDependencies, OfWhatSlalomContainsAreNone) {
  EXPECT_EQ(keys_of("", {{"method.m.plugin", kFollowTheGap}}), Keys{});
  // Programs of Slalom are found by their own folder too, so PATH must not matter.
  const std::string before = std::getenv("PATH");
  setenv("PATH", (kPrograms + ":" + before).c_str(), 1);
  const Keys keys = keys_of("launch = exec slalom-lcm-method --plugin libx.so\n");
  setenv("PATH", before.c_str(), 1);
  EXPECT_EQ(keys, Keys{});
}

}  // namespace
}  // namespace slalom
