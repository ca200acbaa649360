#include "map_files.h"
#include "map_readers.h"

#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>

namespace slalom {
namespace {

using Map = mrpt::maps::COccupancyGridMap2D;

ImageMapOptions half_metre() {
  ImageMapOptions options;
  options.resolution = 0.5;
  return options;
}

/// Grey values of two rows, the upper one first.
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
  const Map map = read_image_map(folder.write("a.pgm", kPicture), half_metre());
  EXPECT_EQ(cells_of(map), "##...#");
  EXPECT_EQ(map.getXMin(), 0);
  EXPECT_EQ(map.getYMin(), 0);
  EXPECT_FLOAT_EQ(map.getXMax(), 1.5F);
  EXPECT_FLOAT_EQ(map.getYMax(), 1);
}

TEST(ImageMap, ThresholdAndNegateDecideWhatIsDark) {
  const MapFolder folder;
  const std::string path = folder.write("a.pgm", kPicture);
  ImageMapOptions options = half_metre();
  options.negate = true;
  EXPECT_EQ(cells_of(read_image_map(path, options)), "..###.");
  options.threshold = 129;
  EXPECT_EQ(cells_of(read_image_map(path, options)), "...##.");
  options.negate = false;
  EXPECT_EQ(cells_of(read_image_map(path, options)), "###..#");
}

TEST(ImageMap, ReadsTheUsualKindsOfImages) {
  const MapFolder folder;
  mrpt::img::CImage image(8, 4, mrpt::img::CH_GRAY);
  image.filledRectangle(0, 0, 7, 3, mrpt::img::TColor(255, 255, 255));
  image.filledRectangle(0, 0, 3, 1, mrpt::img::TColor(0, 0, 0));
  MapImportOptions options;
  options.image = half_metre();
  for (const std::string name : {"a.png", "a.jpg", "a.bmp"}) {
    ASSERT_TRUE(image.saveToFile(folder.path(name))) << name;
    const Map map = load_map(folder.path(name), options);
    EXPECT_EQ(map.getSizeX(), 8U) << name;
    EXPECT_LT(map.getCell(1, 3), 0.5F) << name;  // upper left
    EXPECT_GT(map.getCell(1, 0), 0.5F) << name;
    EXPECT_GT(map.getCell(6, 3), 0.5F) << name;
  }
}

TEST(ImageMap, AsksForTheSizeOfPixels) {
  const MapFolder folder;
  const std::string path = folder.write("a.pgm", kPicture);
  EXPECT_EQ(error_text(Culprit::Usage, [&] { load_map(path, {}); }),
            path +
                ": an image does not say how large its pixels are; expected --image-resolution in "
                "m a pixel");
  ImageMapOptions options = half_metre();
  options.threshold = 0;
  EXPECT_NE(error_text(Culprit::Usage, [&] { read_image_map(path, options); }), "");
}

TEST(ImageMap, RefusesImagesThatAnnounceTooManyPixels) {
  const std::string size("\x7F\xFF\xFF\xFF", 4), zeros(40, '\0');
  const std::string png = "\x89PNG\r\n\x1A\n" + std::string("\0\0\0\x0DIHDR", 8) + size + size;
  const std::string bmp = "BM" + zeros.substr(0, 16) + std::string("\xFF\xFF\xFF\x7F", 4) +
                          std::string("\x00\x00\xFF\xFF", 4) + zeros;
  // Start of image, a segment of 4 bytes, then the frame: length, bits, height, width.
  const std::string jpeg = std::string("\xFF\xD8\xFF\xE0\x00\x04xx\xFF\xC2\x00\x0B\x08", 13) +
                           "\xFF\xFF\xFF\xFE" + zeros;
  const auto refusal = [](const std::string& bytes) {
    return error_text(Culprit::File, [&] { expect_possible_image(bytes, "a"); });
  };
  EXPECT_EQ(refusal(png),
            "a: is a PNG of 2147483647 x 2147483647 pixels; expected at most 400000000 pixels");
  EXPECT_EQ(refusal(bmp),
            "a: is a BMP of 2147483647 x 65536 pixels; expected at most 400000000 pixels");
  EXPECT_EQ(refusal(jpeg),
            "a: is a JPEG of 65534 x 65535 pixels; expected at most 400000000 pixels");
  const MapFolder folder;
  for (const std::string& bytes : {png, bmp, jpeg})
    EXPECT_TRUE(has(error_text(Culprit::File, [&] { read_grey_image(folder.write("b", bytes)); }),
                    "at most 400000000 pixels"));
}

TEST(ImageMap, RefusesTruncatedImages) {
  const MapFolder folder;
  mrpt::img::CImage image(64, 64, mrpt::img::CH_GRAY);
  image.filledRectangle(0, 0, 63, 63, mrpt::img::TColor(9, 9, 9));
  ASSERT_TRUE(image.saveToFile(folder.path("a.bmp")));
  const std::string bytes = bytes_of_file(folder.path("a.bmp"));
  for (const std::size_t size : {0U, 1U, 10U, 26U, 40U})
    EXPECT_NE(
        error_text(
            Culprit::File,
            [&] { read_image_map(folder.write("b.bmp", bytes.substr(0, size)), half_metre()); }),
        "")
        << size;
}

}  // namespace
}  // namespace slalom
