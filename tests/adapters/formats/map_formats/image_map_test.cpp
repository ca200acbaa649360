// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"
#include "map_readers.h"

#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>

namespace slalom {
namespace {

using Map = mrpt::maps::COccupancyGridMap2D;

ImageMapOptions half_meter() {
  ImageMapOptions options;
  options.resolution = 0.5;
  return options;
}

/// Gray values of two rows, the upper one first.
const char* const kPicture = "P2 3 2 255  0 127 128  255 129 1";

std::string cells_of(const Map& map) {
  std::string text;
  for (int y = static_cast<int>(map.getSizeY()) - 1; y >= 0; --y)
    for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x)
      text += map.getCell(x, y) > 0.5F ? '.' : '#';
  return text;
}

TEST(ImageMap, DarkPixelsAreObstacles) {
  const MapFolder folder;
  const Map map = read_image_map(folder.write("a.pgm", kPicture), half_meter());
  EXPECT_EQ(cells_of(map), "##...#");
  EXPECT_EQ(map.getXMin(), 0);
  EXPECT_EQ(map.getYMin(), 0);
  EXPECT_FLOAT_EQ(map.getXMax(), 1.5F);
  EXPECT_FLOAT_EQ(map.getYMax(), 1);
}

TEST(ImageMap, TransparentPixelsAreUnknown) {
  const MapFolder folder;
  const std::string image = png(3, 1, 8, kGrayAlpha, std::string("\xff\xff\xff\x00\x00\x7f", 6));
  const Map map = read_image_map(folder.write("a.png", image), half_meter());
  EXPECT_GT(map.getCell(0, 0), 0.9F);
  EXPECT_NEAR(map.getCell(1, 0), 0.5F, 0.01F);
  EXPECT_NEAR(map.getCell(2, 0), 0.5F, 0.01F);
}

TEST(ImageMap, AppliesThresholdAndNegate) {
  const MapFolder folder;
  const std::string path = folder.write("a.pgm", kPicture);
  ImageMapOptions options = half_meter();
  options.negate = true;
  EXPECT_EQ(cells_of(read_image_map(path, options)), "..###.");
  options.threshold = 129;
  EXPECT_EQ(cells_of(read_image_map(path, options)), "...##.");
  options.negate = false;
  EXPECT_EQ(cells_of(read_image_map(path, options)), "###..#");
}

TEST(ImageMap, ReadsCommonImageFormats) {
  const MapFolder folder;
  mrpt::img::CImage image(8, 4, mrpt::img::CH_GRAY);
  image.filledRectangle(0, 0, 7, 3, mrpt::img::TColor(255, 255, 255));
  image.filledRectangle(0, 0, 3, 1, mrpt::img::TColor(0, 0, 0));
  MapImportOptions options;
  options.image = half_meter();
  for (const std::string name : {"a.png", "a.jpg", "a.bmp"}) {
    ASSERT_TRUE(image.saveToFile(folder.path(name))) << name;
    const Map map = load_map(folder.path(name), options);
    EXPECT_EQ(map.getSizeX(), 8U) << name;
    EXPECT_LT(map.getCell(1, 3), 0.5F) << name;  // upper left
    EXPECT_GT(map.getCell(1, 0), 0.5F) << name;
    EXPECT_GT(map.getCell(6, 3), 0.5F) << name;
  }
}

TEST(ImageMap, RequiresTheResolution) {
  const MapFolder folder;
  const std::string path = folder.write("a.pgm", kPicture);
  EXPECT_TRUE(throws_error(ErrorKind::Usage, path + ": ", {"resolution", "--image-resolution"},
                           [&] { load_map(path, {}); }));
  ImageMapOptions options = half_meter();
  options.threshold = 0;
  EXPECT_TRUE(throws_error(ErrorKind::Usage, path + ": ", {"threshold 0", "1 to 255"},
                           [&] { read_image_map(path, options); }));
}

TEST(ImageMap, RejectsImagesThatDeclareTooManyPixels) {
  const std::string size("\x7F\xFF\xFF\xFF", 4), zeros(40, '\0');
  const std::string png = "\x89PNG\r\n\x1A\n" + std::string("\0\0\0\x0DIHDR", 8) + size + size;
  const std::string bmp = "BM" + zeros.substr(0, 16) + std::string("\xFF\xFF\xFF\x7F", 4) +
                          std::string("\x00\x00\xFF\xFF", 4) + zeros;
  // Start of image, a segment of 4 bytes, then the frame: length, bits, height, width.
  const std::string jpeg = std::string("\xFF\xD8\xFF\xE0\x00\x04xx\xFF\xC2\x00\x0B\x08", 13) +
                           "\xFF\xFF\xFF\xFE" + zeros;
  const auto rejects = [](const std::string& bytes, const std::string& kind,
                          const std::string& declared) {
    return throws_error(ErrorKind::File, "a: ", {kind, declared, "at most 400000000"},
                        [&] { check_image_size(bytes, "a"); });
  };
  EXPECT_TRUE(rejects(png, "PNG", " 2147483647 x 2147483647 pixels"));
  EXPECT_TRUE(rejects(bmp, "BMP", " 2147483647 x 65536 pixels"));
  EXPECT_TRUE(rejects(jpeg, "JPEG", " 65534 x 65535 pixels"));
  const MapFolder folder;
  for (const std::string& bytes : {png, bmp, jpeg})
    EXPECT_TRUE(throws_error(ErrorKind::File, folder.path("b"), {"at most 400000000 pixels"},
                             [&] { read_gray_image(folder.write("b", bytes)); }));
}

TEST(ImageMap, RejectsTruncatedImages) {
  const MapFolder folder;
  mrpt::img::CImage image(64, 64, mrpt::img::CH_GRAY);
  image.filledRectangle(0, 0, 63, 63, mrpt::img::TColor(9, 9, 9));
  ASSERT_TRUE(image.saveToFile(folder.path("a.bmp")));
  const std::string bytes = bytes_of_file(folder.path("a.bmp"));
  for (const std::size_t size : {0U, 1U, 10U, 26U, 40U})
    EXPECT_TRUE(throws_error(ErrorKind::File, folder.path("b.bmp"), {}, [&] {
      read_image_map(folder.write("b.bmp", bytes.substr(0, size)), half_meter());
    })) << size;
}

}  // namespace
}  // namespace slalom
