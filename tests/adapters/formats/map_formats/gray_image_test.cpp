// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"
#include "map_readers.h"

#include <slalom/core/random.h>

#include <gtest/gtest.h>
#include <mrpt/img/CImage.h>

namespace slalom {
namespace {

using namespace std::string_literals;
using Pixels = std::vector<std::uint16_t>;

testing::AssertionResult rejects_pgm(const std::string& bytes,
                                     std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::File, "a.pgm: ", words, [&] { parse_pgm(bytes, "a.pgm"); });
}

testing::AssertionResult rejects_image(const std::string& path,
                                       std::initializer_list<std::string> words) {
  return throws_error(ErrorKind::File, path + ": ", words, [&] { read_gray_image(path); });
}

std::string random_bytes(std::size_t count) {
  RandomEngine random(count);
  std::string bytes;
  for (std::size_t i = 0; i < count; ++i) bytes += static_cast<char>(uniform_int(random, 0, 255));
  return bytes;
}

/// The gray values that OpenCV reads.
Pixels pixels_of_opencv(const std::string& path) {
  mrpt::img::CImage image;
  EXPECT_TRUE(image.loadFromFile(path, 0));
  Pixels pixels;
  for (std::size_t y = 0; y < image.getHeight(); ++y)
    for (std::size_t x = 0; x < image.getWidth(); ++x)
      pixels.push_back(*image(static_cast<unsigned>(x), static_cast<unsigned>(y), 0));
  return pixels;
}

/// A PNG of the gray values 10 x + 100 y, 3 wide and 2 high.
std::string write_png(const MapFolder& folder) {
  mrpt::img::CImage image(3, 2, mrpt::img::CH_GRAY);
  for (int y = 0; y < 2; ++y)
    for (int x = 0; x < 3; ++x)
      *image.ptr<std::uint8_t>(x, y) = static_cast<std::uint8_t>(10 * x + 100 * y);
  const std::string path = folder.path("image.png");
  EXPECT_TRUE(image.saveToFile(path));
  return path;
}

TEST(ParsePgm, ReadsTextWithCommentsTopRowFirst) {
  const GrayImage image = parse_pgm("P2 # text\n3 2 # size\n255\n0 1 2\n# row\n253 254 255", "a");
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.pixels, (Pixels{0, 1, 2, 253, 254, 255}));
}

TEST(ParsePgm, ReadsBinaryPixelsThatLookLikeBlanksAndComments) {
  const GrayImage image = parse_pgm("P5\n#CREATOR: a tool\n2 2\n255\n\n#\0 "s, "a");
  EXPECT_EQ(image.pixels, (Pixels{'\n', '#', 0, ' '}));
}

TEST(ParsePgm, IgnoresTrailingData) {
  EXPECT_EQ(parse_pgm("P5 1 1 255\nAand more", "a").pixels, (Pixels{'A'}));
}

TEST(ParsePgm, KeepsTheMaximumOfTheFile) {
  const GrayImage image = parse_pgm("P2 3 1 15 0 1 15", "a");
  EXPECT_EQ(image.white, 15);
  EXPECT_EQ(image.pixels, (Pixels{0, 1, 15}));
  EXPECT_EQ(parse_pgm("P5 1 1 15\n\x10", "a").pixels, (Pixels{15}))
      << "values above the maximum are clamped";
}

TEST(ParsePgm, ReadsTwoBytesPerPixelAbove255) {
  const GrayImage image = parse_pgm("P5 3 1 65535\n\xff\xff\x01\x02\x00\x03"s, "a");
  EXPECT_EQ(image.white, 65535);
  EXPECT_EQ(image.pixels, (Pixels{65535, 0x0102, 3}));
  EXPECT_EQ(parse_pgm("P5 2 1 256\n\x01\x00\x02\x00"s, "a").pixels, (Pixels{256, 256}));
  EXPECT_EQ(parse_pgm("P2 2 1 1000 1000 999", "a").pixels, (Pixels{1000, 999}));
  EXPECT_TRUE(rejects_pgm("P5 2 1 65535\nabc", {"truncated"}));
}

TEST(ParsePgm, ReportsWhereItIsTruncated) {
  EXPECT_TRUE(rejects_pgm("P5 2 2 255\nabc", {"truncated", "at byte 10;", "P5 or P2"}));
  EXPECT_TRUE(rejects_pgm("P5 2 2 255", {"truncated", "at byte 10;", "P5 or P2"}));
  EXPECT_TRUE(rejects_pgm("P2 2 2 255 1 2 3 ", {"no gray value", "at byte 17;", "P5 or P2"}));
  EXPECT_TRUE(rejects_pgm("P5 2", {"no height", "at byte 4;", "P5 or P2"}));
}

TEST(ParsePgm, RejectsInvalidHeaders) {
  EXPECT_TRUE(rejects_pgm("", {"does not start with P5 or P2 at byte 0"}));
  EXPECT_TRUE(rejects_pgm("P6 1 1 255\nabc", {"does not start with P5 or P2 at byte 0"}));
  EXPECT_TRUE(rejects_pgm("P5 x 1 255\na", {"no width at byte 3"}));
  EXPECT_TRUE(rejects_pgm("P5 -1 1 255\na", {"no width at byte 3"}));
  EXPECT_TRUE(rejects_pgm("P5 0 1 255\na", {"invalid size"}));
  EXPECT_TRUE(rejects_pgm("P5 1 1 0\na", {"invalid size"}));
  EXPECT_TRUE(rejects_pgm("P5 1 1 65536\naa", {"maximum gray value that is too large"}));
  EXPECT_TRUE(rejects_pgm("P2 1 1 15 16", {"gray value that is too large"}));
}

TEST(ParsePgm, RejectsHugeSizesBeforeAllocatingMemory) {
  EXPECT_TRUE(rejects_pgm("P5 1000000 1000000 255\na", {"invalid size"}));
  EXPECT_TRUE(rejects_pgm("P5 99999999999999999999 1 255\na", {"width that is too large"}));
  // 400 million cells are allowed, but the file has only 20 bytes.
  EXPECT_TRUE(rejects_pgm("P5 20000 20000 255\na", {"truncated"}));
  EXPECT_TRUE(rejects_pgm("P2 20000 20000 255\n1", {"truncated"}));
}

TEST(ReadGrayImage, ReadsPngTopRowFirst) {
  const MapFolder folder;
  const GrayImage image = read_gray_image(write_png(folder));
  EXPECT_EQ(image.width, 3);
  EXPECT_EQ(image.height, 2);
  EXPECT_EQ(image.pixels, (Pixels{0, 10, 20, 100, 110, 120}));
}

TEST(ReadGrayImage, ReadsTheGrayOfEveryKindOfPngAsOpenCvDoes) {
  const MapFolder folder;
  const std::string palette = png_chunk("PLTE", random_bytes(48));
  const std::string gamma = png_chunk("gAMA", four_bytes(100000));
  for (const std::string& content :
       {png(8, 5, 1, kGray, random_bytes(5)), png(8, 5, 4, kGray, random_bytes(20)),
        png(8, 5, 8, kGray, random_bytes(40)), png(8, 5, 16, kGray, random_bytes(80)),
        png(8, 5, 8, kRgb, random_bytes(120)), png(8, 5, 8, kRgb, random_bytes(120), gamma),
        png(8, 5, 16, kRgb, random_bytes(240)), png(8, 5, 4, kPalette, random_bytes(20), palette),
        png(8, 5, 8, kGrayAlpha, random_bytes(80)), png(8, 5, 8, kRgbAlpha, random_bytes(160)),
        png(8, 5, 16, kRgbAlpha, random_bytes(320))}) {
    const std::string path = folder.write("a.png", content);
    EXPECT_EQ(read_gray_image(path).pixels, pixels_of_opencv(path))
        << "bits " << int{content[24]} << ", color type " << int{content[25]};
  }
}

TEST(ReadGrayImage, PixelsOfAPngAreTransparentUnlessTheyAreOpaque) {
  const MapFolder folder;
  const std::vector<bool> expected{false, true, true};
  const std::string palette = png_chunk("PLTE", "\0\0\0aaaccc"s);
  for (const std::string& content :
       {png(3, 1, 8, kGrayAlpha, "\x10\xff\x20\xfe\x30\x00"s),
        png(3, 1, 8, kRgbAlpha,
            "aaa\xff"
            "bbb\x80"
            "ccc\x00"s),
        png(3, 1, 8, kPalette, "\2\0\1"s, palette + png_chunk("tRNS", "\0\x80"s)),
        png(3, 1, 8, kGray, "abb", png_chunk("tRNS", "\0b"s)),
        png(3, 1, 8, kRgb, "aaabcdbcd", png_chunk("tRNS", "\0b\0c\0d"s))})
    EXPECT_EQ(read_gray_image(folder.write("a.png", content)).transparent, expected)
        << "color type " << int{content[25]};
  EXPECT_TRUE(
      read_gray_image(folder.write("a.png", png(3, 1, 8, kGray, "abc"))).transparent.empty());
}

TEST(ReadGrayImage, WritesNoWarningsOfLibpng) {
  const MapFolder folder;
  const std::string chromaticities = png_chunk("cHRM", std::string(32, '\xff'));
  testing::internal::CaptureStderr();
  const GrayImage image =
      read_gray_image(folder.write("a.png", png(3, 1, 8, kGray, "abc", chromaticities)));
  EXPECT_TRUE(rejects_image(folder.write("b.png", png(3, 1, 8, kPalette, "abc")), {"PNG"}));
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(image.pixels, (Pixels{'a', 'b', 'c'}));
}

TEST(ReadGrayImage, WritesNoErrorsOfOpenCv) {
  const MapFolder folder;
  mrpt::img::CImage image(64, 64, mrpt::img::CH_GRAY);
  image.filledRectangle(0, 0, 63, 63, mrpt::img::TColor(9, 9, 9));
  ASSERT_TRUE(image.saveToFile(folder.path("a.bmp")) && image.saveToFile(folder.path("a.jpg")));
  const std::string bmp = bytes_of_file(folder.path("a.bmp")),
                    jpeg = bytes_of_file(folder.path("a.jpg"));
  const std::string tiff("II*\0\x08\0\0\0\x01\0\0\x01\x04\0\x01\0\0\0\xff\xff\xff\x7f", 22);
  testing::internal::CaptureStderr();
  for (const std::string& bytes :
       {"P6 40000 40000 255\n"s, "P4 40000 40000\n"s, tiff, bmp.substr(0, 20), bmp.substr(0, 100)})
    EXPECT_TRUE(rejects_image(folder.write("b", bytes), {"unsupported image"}));
  read_gray_image(folder.write("c", jpeg.substr(0, jpeg.size() - 40)));  // libjpeg warns
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
}

TEST(ReadGrayImage, RecognizesAPgmByItsContent) {
  const MapFolder folder;
  EXPECT_EQ(read_gray_image(folder.write("map.png", "P2 1 1 255 7")).pixels, (Pixels{7}));
}

TEST(ReadGrayImage, RejectsAMissingFileAndAFolder) {
  const MapFolder folder;
  for (const std::string& path : {folder.path("absent.pgm"), folder.path("")})
    EXPECT_TRUE(rejects_image(path, {"cannot be read"}));
}

TEST(ReadGrayImage, RejectsOtherFiles) {
  const MapFolder folder;
  for (const std::string bytes : {"", "P", "hello"}) {
    const std::string path = folder.write("map.png", bytes);
    EXPECT_TRUE(rejects_image(path, {"unsupported image", "PGM, PNG, JPEG or BMP"}));
  }
}

TEST(ReadGrayImage, RejectsATruncatedPng) {
  const MapFolder folder;
  const std::string content = bytes_of_file(write_png(folder));
  for (std::size_t size = 0; size + 12 < content.size(); ++size) {  // 12: the empty last chunk
    const std::string path = folder.write("cut.png", content.substr(0, size));
    EXPECT_TRUE(rejects_image(path, {size < 8 ? "unsupported image" : "malformed PNG", "PNG"}))
        << size;
  }
}

TEST(ReadGrayImage, RejectsAPngOfHugeDeclaredSize) {
  const MapFolder folder;
  std::string bytes = bytes_of_file(write_png(folder));
  // Signature 8, chunk length 4, "IHDR" 4, then width and height.
  bytes.replace(16, 8, four_bytes(100000) + four_bytes(100000));
  const std::string path = folder.write("huge.png", bytes);
  EXPECT_TRUE(rejects_image(path, {"PNG", "100000 x 100000 pixels", "at most 400000000"}));
}

}  // namespace
}  // namespace slalom
