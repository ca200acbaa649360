// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/core/temporary_file.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sys/wait.h>
#include <unistd.h>

namespace slalom {
namespace {

namespace fs = std::filesystem;

class TemporaryFileTest : public ::testing::Test {
 protected:
  TemporaryFileTest() {
    std::string name = (fs::temp_directory_path() / "slalom_temporary_XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) throw std::runtime_error("no temporary folder");
    folder_ = name;
  }
  ~TemporaryFileTest() override { fs::remove_all(folder_); }
  TemporaryFileTest(const TemporaryFileTest&) = delete;
  TemporaryFileTest& operator=(const TemporaryFileTest&) = delete;

  std::string path(const std::string& name) const { return (folder_ / name).string(); }
  auto count() const { return std::distance(fs::directory_iterator(folder_), {}); }

  /// The name of a file that a process left that ended without removing it.
  std::string left_behind(const std::string& name) const {
    int channel[2];
    if (pipe(channel) != 0) return "";
    if (fork() == 0) {
      const TemporaryFile file(path(name));
      std::ofstream(file.name()) << "part";
      if (write(channel[1], file.name().data(), file.name().size()) < 0) _exit(1);
      _exit(0);  // no destructors, as after kill -9
    }
    close(channel[1]);
    std::string text(4096, '\0');
    const ssize_t size = read(channel[0], text.data(), text.size());
    close(channel[0]);
    wait(nullptr);
    return text.substr(0, static_cast<std::size_t>(std::max<ssize_t>(size, 0)));
  }

  fs::path folder_;
};

TEST_F(TemporaryFileTest, ReplacesTheFileWhenPublished) {
  std::ofstream(path("a")) << "old";
  {
    TemporaryFile file(path("a"), ".png");
    EXPECT_EQ(fs::path(file.name()).parent_path(), folder_);
    EXPECT_EQ(fs::path(file.name()).extension(), ".png");
    std::ofstream(file.name()) << "new";
    file.publish();
  }
  EXPECT_EQ(count(), 1);
  EXPECT_EQ(fs::file_size(path("a")), 3U);
}

TEST_F(TemporaryFileTest, IsRemovedUnlessPublished) {
  {
    const TemporaryFile file(path("a"));
    std::ofstream(file.name()) << "x";
    std::ofstream(file.name() + "-journal") << "x";
  }
  EXPECT_EQ(count(), 0);
}

TEST_F(TemporaryFileTest, NamesTheFileThatCannotBeReplaced) {
  fs::create_directories(path("a/b"));
  TemporaryFile file(path("a"));
  std::ofstream(file.name()) << "x";
  EXPECT_TRUE(throws_error(ErrorKind::Job, path("a") + ": ",
                           {"cannot be replaced", "expected a writable path"},
                           [&] { file.publish(); }));
}

TEST_F(TemporaryFileTest, AreRemovedWhenTheProgramIsInterrupted) {
  const TemporaryFile first(path("a")), second(path("b"));
  for (const TemporaryFile* file : {&first, &second}) std::ofstream(file->name()) << "x";
  if (fork() == 0) {  // a child has none of its own
    remove_temporary_files();
    _exit(0);
  }
  wait(nullptr);
  EXPECT_EQ(count(), 2);
  remove_temporary_files();
  EXPECT_EQ(count(), 0);
}

TEST_F(TemporaryFileTest, OfAKilledProgramAreRemovedByTheNext) {
  const std::string left = left_behind("a");
  ASSERT_TRUE(fs::exists(left)) << left;
  std::ofstream(path("a.tmp-0")) << "of somebody else";
  std::ofstream(path("a.tmp-01234567-1-0")) << "of another host";
  const TemporaryFile own(path("c"));
  std::ofstream(own.name()) << "x";
  EXPECT_FALSE(fs::exists(left));
  EXPECT_EQ(count(), 3);
}

}  // namespace
}  // namespace slalom
