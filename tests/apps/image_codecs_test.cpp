// SPDX-License-Identifier: BSD-3-Clause
#include "places.h"
#include "temporary_folder.h"

#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>

#include <cstdio>
#include <fstream>
#include <memory>
#include <set>
#include <sstream>
#include <string>

namespace slalom {
namespace {

bool is_loaded(const std::string& library) {
  std::ostringstream maps;
  maps << std::ifstream("/proc/self/maps").rdbuf();
  return maps.str().find(library) != std::string::npos;
}

/// Names of the functions that a library exports from cv.
std::set<std::string> functions_of(const std::string& library) {
  const std::unique_ptr<FILE, int (*)(FILE*)> nm(
      popen(("nm -D --defined-only '" + library + "'").c_str(), "r"), pclose);
  std::set<std::string> names;
  char address[32], kind = 0, name[512];
  while (nm && std::fscanf(nm.get(), "%31s %c %511s", address, &kind, name) == 3)
    if (kind == 'T' && std::string(name).compare(0, 6, "_ZN2cv") == 0) names.insert(name);
  return names;
}

TEST(ImageCodecs, AreThoseOfOpenCvsLibrary) {
  EXPECT_FALSE(functions_of(OPENCV_IMGCODECS).empty());
  EXPECT_EQ(functions_of(kMethods + "/runtime/libopencv_imgcodecs.so"),
            functions_of(OPENCV_IMGCODECS));
}

TEST(ImageCodecs, AreLoadedWhenAnImageIsWrittenOrRead) {
  const TemporaryFolder folder;
  const std::string path = folder / "a.png";
  mrpt::img::CImage image(3, 2, mrpt::img::CH_GRAY);
  image.setPixel(0, 0, 0);
  image.setPixel(2, 1, 0x777777);
  EXPECT_FALSE(is_loaded("libgdal.so"));
  ASSERT_TRUE(image.saveToFile(path));
  EXPECT_TRUE(is_loaded("libgdal.so"));
  mrpt::img::CImage read;
  ASSERT_TRUE(read.loadFromFile(path, 0));
  EXPECT_EQ(read.getWidth(), 3U);
  EXPECT_EQ(read.at<std::uint8_t>(2, 1), 0x77);
}

}  // namespace
}  // namespace slalom
