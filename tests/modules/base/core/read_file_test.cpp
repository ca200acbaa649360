// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/read_file.h>

#include <filesystem>
#include <fstream>
#include <sys/stat.h>

namespace slalom {
namespace {

namespace fs = std::filesystem;

/// A folder with a sparse file of 3 MB and a pipe that nobody writes to.
class ReadFile : public ::testing::Test {
 protected:
  ReadFile() {
    std::string name = (fs::temp_directory_path() / "slalom_read_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
    std::ofstream(path("sparse")).close();
    fs::resize_file(path("sparse"), 3 * kMegabyte);
    mkfifo(path("pipe").c_str(), 0600);
  }
  ~ReadFile() override { fs::remove_all(folder_); }
  ReadFile(const ReadFile&) = delete;
  ReadFile& operator=(const ReadFile&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

 private:
  fs::path folder_;
};

::testing::AssertionResult refuses(const std::string& path,
                                   std::initializer_list<std::string> words) {
  const auto check = [&](auto action) {
    return throws_error(ErrorKind::File, path + ": ", words, action);
  };
  const auto reading = check([&] { read_file(path, "a map", 2 * kMegabyte); });
  return reading ? check([&] { require_regular_file(path, "a map", 2 * kMegabyte); }) : reading;
}

TEST_F(ReadFile, ReturnsAllBytesOfARegularFile) {
  std::ofstream(path("bytes"), std::ios::binary) << std::string("a\0\n\xFF", 4);
  EXPECT_EQ(read_file(path("bytes")), std::string("a\0\n\xFF", 4));
  EXPECT_EQ(read_file(path("sparse")), std::string(3 * kMegabyte, '\0'));
  require_regular_file(path("sparse"), "a map");
}

TEST_F(ReadFile, TextsHaveNoByteOrderMark) {
  std::ofstream(path("marked"), std::ios::binary) << "\xEF\xBB\xBF[a]\n";
  EXPECT_EQ(read_text(path("marked"), "a text"), "[a]\n");
  EXPECT_EQ(read_file(path("marked")).size(), 7U);
  std::ofstream(path("short"), std::ios::binary) << "\xEF\xBB";
  EXPECT_EQ(read_text(path("short"), "a text"), "\xEF\xBB");
}

TEST_F(ReadFile, ReadsFilesWhoseSizeIsUnknown) {
  EXPECT_NE(read_file("/proc/self/status").find("Pid:"), std::string::npos);
}

TEST_F(ReadFile, FollowsLinks) {
  fs::create_symlink(path("sparse"), path("link"));
  EXPECT_EQ(read_file(path("link")).size(), 3 * kMegabyte);
  fs::create_symlink(path("pipe"), path("link_to_pipe"));
  EXPECT_TRUE(refuses(path("link_to_pipe"), {"is a pipe"}));
}

TEST_F(ReadFile, RefusesWhatIsNotARegularFileWithoutWaiting) {
  const std::string expected = "expected a map, a regular file of at most 2 MB";
  EXPECT_TRUE(refuses(path("pipe"), {"cannot be read (is a pipe)", expected}));
  EXPECT_TRUE(refuses(path(""), {"cannot be read (is a folder)", expected}));
  EXPECT_TRUE(refuses("/dev/zero", {"cannot be read (is a device)", expected}));
}

TEST_F(ReadFile, RefusesFilesThatAreTooLarge) {
  EXPECT_TRUE(
      refuses(path("sparse"), {"is too large", "expected a map, a regular file of at most 2 MB"}));
  EXPECT_TRUE(throws_error(ErrorKind::File, "/proc/self/status: ", {"is too large"},
                           [] { read_file("/proc/self/status", "a map", 100); }));
}

TEST_F(ReadFile, NamesTheReasonWhenAFileIsMissing) {
  EXPECT_TRUE(refuses(path("missing"), {"cannot be read (No such file", "expected a map"}));
}

TEST_F(ReadFile, ATextThatIsNotUtf8IsRefusedWithItsLine) {
  const std::string file = path("a.yaml");
  std::ofstream(file) << "a: 1\nb: \xFF\xFE\n";
  EXPECT_TRUE(throws_error(ErrorKind::File, file + ":2", {"not UTF-8", "a list"},
                           [&] { read_utf8(file, "a list"); }));
  std::ofstream(file) << "a: \xC3\xA4\n";
  EXPECT_EQ(read_utf8(file, "a list"), "a: \xC3\xA4\n");
}

}  // namespace
}  // namespace slalom
