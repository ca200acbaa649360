#include "error_text.h"

#include <slalom/library/library_method.h>

#include <gtest/gtest.h>

#include <filesystem>

namespace slalom {
namespace {

namespace fs = std::filesystem;

const std::string kFolder = PLUGIN_FOLDER;
const std::string kFile = "libtest_plugin_good.so";

std::string resolve(const std::string& ini_path, const std::string& plugin) {
  const IniFile ini = IniFile::from_text("[method.a]\nplugin = x\n", ini_path);
  return resolve_plugin_path(ini, "method.a", plugin);
}

/// Another current folder while it lives.
class CurrentFolder {
 public:
  explicit CurrentFolder(const fs::path& folder) : before_(fs::current_path()) {
    fs::current_path(folder);
  }
  ~CurrentFolder() { fs::current_path(before_); }
  CurrentFolder(const CurrentFolder&) = delete;
  CurrentFolder& operator=(const CurrentFolder&) = delete;

 private:
  fs::path before_;
};

TEST(ResolvePluginPath, TakesAnAbsolutePathAsItIs) {
  EXPECT_EQ(resolve("/nowhere/campaign.ini", kFolder + "/" + kFile), kFolder + "/" + kFile);
}

TEST(ResolvePluginPath, LooksBesideTheConfiguration) {
  const CurrentFolder elsewhere("/");
  EXPECT_EQ(resolve(kFolder + "/campaign.ini", kFile), kFolder + "/" + kFile);
  EXPECT_EQ(resolve(kFolder + "/sub/campaign.ini", "../" + kFile), kFolder + "/" + kFile);
}

TEST(ResolvePluginPath, LooksInTheCurrentFolder) {
  const CurrentFolder here(kFolder);
  EXPECT_EQ(resolve("/nowhere/campaign.ini", kFile), kFolder + "/" + kFile);
}

TEST(ResolvePluginPath, PrefersTheConfigurationsFolderToTheCurrentOne) {
  const fs::path other = fs::path(kFolder) / "other";
  fs::create_directories(other);
  fs::copy_file(fs::path(kFolder) / kFile, other / kFile, fs::copy_options::overwrite_existing);
  const CurrentFolder here(kFolder);
  EXPECT_EQ(resolve((other / "campaign.ini").string(), kFile), (other / kFile).string());
}

TEST(ResolvePluginPath, FindsWhatIsInstalledBesideTheProgram) {
  const fs::path program = fs::canonical("/proc/self/exe").parent_path();
  const fs::path installed = (program / "../lib/slalom").lexically_normal();
  const std::string name = "libtest_plugin_installed.so";
  fs::create_directories(installed);
  fs::copy_file(fs::path(kFolder) / kFile, installed / name, fs::copy_options::overwrite_existing);
  EXPECT_EQ(resolve("/nowhere/campaign.ini", name), (installed / name).string());
  fs::remove(installed / name);
}

TEST(ResolvePluginPath, SaysEverywhereItLooked) {
  const CurrentFolder here("/tmp");
  const std::string text =
      error_text(Culprit::Usage, [] { resolve("/nowhere/campaign.ini", "libabsent.so"); });
  EXPECT_EQ(text.rfind("/nowhere/campaign.ini:2: [method.a] plugin: no library 'libabsent.so'; "
                       "expected a file at /nowhere/libabsent.so or /tmp/libabsent.so or ",
                       0),
            0U)
      << text;
  EXPECT_NE(text.find("/lib/slalom/libabsent.so or "), std::string::npos) << text;
}

}  // namespace
}  // namespace slalom
