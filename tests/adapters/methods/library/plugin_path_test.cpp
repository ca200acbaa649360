// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "places.h"

#include <slalom/library/library_method.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace slalom {
namespace {

namespace fs = std::filesystem;

const std::string kPluginFolder = kBuild + "/tests/adapters/methods/library/plugins";
const std::string kFile = "libtest_plugin_good.so";

std::string resolve(const std::string& ini_path, const std::string& plugin) {
  const IniFile ini = IniFile::from_text("[method.a]\nplugin = " + plugin + "\n", ini_path);
  return resolve_plugin_path(ini, "method.a", "plugin");
}

/// Changes the current folder during its lifetime.
class CurrentFolder {
 public:
  explicit CurrentFolder(const fs::path& folder) : previous_(fs::current_path()) {
    fs::current_path(folder);
  }
  ~CurrentFolder() { fs::current_path(previous_); }
  CurrentFolder(const CurrentFolder&) = delete;
  CurrentFolder& operator=(const CurrentFolder&) = delete;

 private:
  fs::path previous_;
};

TEST(ResolvePluginPath, TakesAnAbsolutePathAsItIs) {
  EXPECT_EQ(resolve("/nowhere/campaign.ini", kPluginFolder + "/" + kFile),
            kPluginFolder + "/" + kFile);
}

TEST(ResolvePluginPath, SearchesTheFolderOfTheConfiguration) {
  const CurrentFolder elsewhere("/");
  EXPECT_EQ(resolve(kPluginFolder + "/campaign.ini", kFile), kPluginFolder + "/" + kFile);
  EXPECT_EQ(resolve(kPluginFolder + "/sub/campaign.ini", "../" + kFile),
            kPluginFolder + "/" + kFile);
}

TEST(ResolvePluginPath, SearchesTheCurrentFolder) {
  const CurrentFolder here(kPluginFolder);
  EXPECT_EQ(resolve("/nowhere/campaign.ini", kFile), kPluginFolder + "/" + kFile);
}

TEST(ResolvePluginPath, PrefersTheConfigurationsFolderToTheCurrentOne) {
  const fs::path other = fs::path(kPluginFolder) / "other";
  fs::create_directories(other);
  fs::copy_file(fs::path(kPluginFolder) / kFile, other / kFile,
                fs::copy_options::overwrite_existing);
  const CurrentFolder here(kPluginFolder);
  EXPECT_EQ(resolve((other / "campaign.ini").string(), kFile), (other / kFile).string());
}

TEST(ResolvePluginPath, SearchesTheInstallationOfTheProgram) {
  const fs::path program = fs::canonical("/proc/self/exe").parent_path();
  const fs::path installed = (program / "../lib/slalom").lexically_normal();
  const std::string name = "libtest_plugin_installed.so";
  fs::create_directories(installed);
  fs::copy_file(fs::path(kPluginFolder) / kFile, installed / name,
                fs::copy_options::overwrite_existing);
  EXPECT_EQ(resolve("/nowhere/campaign.ini", name), (installed / name).string());
  fs::remove(installed / name);
}

TEST(ResolvePluginPath, ReportsAllPathsTried) {
  const CurrentFolder here("/tmp");
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "/nowhere/campaign.ini:2: [method.a] plugin: ",
                           {"'libabsent.so' not found",
                            "expected a file at /nowhere/libabsent.so or /tmp/libabsent.so or ",
                            "/lib/slalom/libabsent.so or "},
                           [] { resolve("/nowhere/campaign.ini", "libabsent.so"); }));
}

TEST(ResolvePluginPath, ReportsEachPathOnce) {
  const CurrentFolder here("/tmp");
  try {
    resolve("/tmp/campaign.ini", "libabsent.so");
    FAIL();
  } catch (const Error& error) {
    const std::string text = error.what(), path = "/tmp/libabsent.so";
    EXPECT_NE(text.find(path), std::string::npos) << text;
    EXPECT_EQ(text.find(path), text.rfind(path)) << text;
  }
}

}  // namespace
}  // namespace slalom
