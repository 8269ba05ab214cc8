// Picture files as they are: indices, 16 bits, odd maxima; and damaged ones.
#include "image/decode.h"

#include "base/diagnostics.h"
#include "image/codec.h"
#include "image/image_store.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

std::string from_hex(std::string_view hex) {
    std::string bytes;
    for (size_t i = 0; i + 1 < hex.size(); i += 2)
        bytes += static_cast<char>(std::stoi(std::string(hex.substr(i, 2)), nullptr, 16));
    return bytes;
}

using Samples16 = std::vector<uint16_t>;

const std::string palette_png = from_hex(
    "89504e470d0a1a0a0000000d4948445200000003000000020803000000aaaa96280000000c504c54450a141e28323c46505a0102"
    "0386cb"
    "f20b0000000174524e5307de824dc50000001049444154789c636060646260666204000026000a1b1c09790000000049454e44ae"
    "426082");
const std::string palette_gif = from_hex(
    "474946383761030002008100000a141e28323c46505a0102032c0000000003000200000809000104103040408080003b");
const std::string interlaced_gif = from_hex(
    "4749463837611e001400820000000102030405060708090a0b0c0d0e0f10111213141516172c000000001e00140040086f000104"
    "103080"
    "40010302091a4438b0e0c1840e192a7cd87021448b15294e9418f1a2c68e193372c4b8d1e3c88f244196ac98b225ca972f4fca34"
    "3953a4c9"
    "9b376dea5cb953a54f922b83fefc5853a84b84438bfecc6934a6c0a34c87f684bad3e9d4984d95a6d46ab564d2a82d0302003b");

TEST(Decode, PngPalette) {
    const Image image = decode_png(palette_png);
    EXPECT_EQ(image.samples, (Samples16{0, 1, 2, 3, 2, 1}));
    ASSERT_TRUE(image.has_palette());
    EXPECT_EQ(image.palette[0], (std::array<uint8_t, 4>{10, 20, 30, 7}));
    EXPECT_EQ(image.palette[2], (std::array<uint8_t, 4>{70, 80, 90, 255}));
}

TEST(Decode, Gif) {
    const Image image = decode_gif(palette_gif);
    EXPECT_EQ(image.samples, (Samples16{0, 1, 2, 3, 2, 1}));
    EXPECT_EQ(image.palette[3], (std::array<uint8_t, 4>{1, 2, 3, 255}));
}

TEST(Decode, GifInterlaced) {
    const Image image = decode_gif(interlaced_gif);
    ASSERT_EQ(image.samples.size(), 600u);
    for (size_t i = 0; i < image.samples.size(); ++i) ASSERT_EQ(image.samples[i], i % 7) << i;
}

TEST(Decode, Pot) {
    // Two columns: the right one holds the low bytes. 3 + 2 columns are refused.
    EXPECT_THROW(decode_pot(palette_gif), IoError);
    const Image image = decode_pot(interlaced_gif);
    EXPECT_EQ(image.width, 15);
    EXPECT_EQ(image.samples[0], 0 * 256 + 15 % 7);
    EXPECT_EQ(image.samples[1], 1 * 256 + 16 % 7);
}

TEST(Decode, PngWrittenHere) {
    const std::string path = (std::filesystem::path(testing::TempDir()) / "sixteen.png").string();
    const std::vector<uint16_t> words{1, 2, 300, 65535, 5, 6, 7, 0};
    Pixels pixels(2, 1, 4);
    std::ranges::transform(words, pixels.values.begin(), [](uint16_t w) { return w / 65535.0f; });
    OutputFormat format;
    format.bits = 16;
    write_png(rows_of(pixels), format, path);
    ImageStore store;
    const ImagePtr image = store.read(path, ImageType::png);
    EXPECT_EQ(image->samples, words);
    EXPECT_EQ(image->white, 65535u);
    EXPECT_EQ(image->channels, 4);
    EXPECT_EQ(store.read(path, ImageType::png), image) << "decoded once";
    EXPECT_THROW(store.read(path, ImageType::gif), IoError);
    EXPECT_THROW(store.read(path + ".missing", ImageType::png), IoError);
}

std::string targa(int kind, int bits, int descriptor, const std::string& body, int colors = 0) {
    std::string header(18, '\0');
    header[1] = colors > 0 ? 1 : 0;
    header[2] = static_cast<char>(kind);
    header[5] = static_cast<char>(colors);
    header[7] = colors > 0 ? 24 : 0;
    header[12] = header[14] = 2;
    header[16] = static_cast<char>(bits);
    header[17] = static_cast<char>(descriptor);
    return header + body;
}

TEST(Decode, Targa) {
    EXPECT_EQ(decode_targa(targa(3, 8, 0x20, "abcd")).samples, (Samples16{'a', 'b', 'c', 'd'}));
    EXPECT_EQ(decode_targa(targa(3, 8, 0, "abcd")).samples, (Samples16{'c', 'd', 'a', 'b'}));
    EXPECT_EQ(decode_targa(targa(2, 24, 0x20, "abcdefghijkl")).samples,
              (Samples16{'c', 'b', 'a', 'f', 'e', 'd', 'i', 'h', 'g', 'l', 'k', 'j'}));
    // A run of three, then one as it is.
    EXPECT_EQ(decode_targa(targa(11, 8, 0x20, std::string("\x82z\0q", 4))).samples,
              (Samples16{'z', 'z', 'z', 'q'}));
    const Image indexed =
        decode_targa(targa(1, 8, 0x20, std::string("abcdef") + std::string("\0\1\1\0", 4), 2));
    EXPECT_EQ(indexed.samples, (Samples16{0, 1, 1, 0}));
    EXPECT_EQ(indexed.palette[1], (std::array<uint8_t, 4>{'f', 'e', 'd', 255}));
    EXPECT_EQ(decode_targa(targa(2, 16, 0x20, std::string("\0\x7c\xe0\3\x1f\0\0\0", 8))).samples,
              (Samples16{248, 0, 0, 0, 248, 0, 0, 0, 248, 0, 0, 0}));
}

std::string bitmap(int bits, const std::string& palette, const std::string& rows, int compression = 0) {
    std::string header(54, '\0');
    header[0] = 'B';
    header[1] = 'M';
    header[10] = static_cast<char>(54 + palette.size());
    header[14] = 40;
    header[18] = header[22] = 2;
    header[26] = 1;
    header[28] = static_cast<char>(bits);
    header[30] = static_cast<char>(compression);
    header[46] = static_cast<char>(palette.size() / 4);
    return header + palette + rows;
}

TEST(Decode, Bmp) {
    const Image indexed = decode_bmp(bitmap(8, "abc.def.", std::string("\0\1..\1\0..", 8)));
    EXPECT_EQ(indexed.samples, (Samples16{1, 0, 0, 1}));
    EXPECT_EQ(indexed.palette[1], (std::array<uint8_t, 4>{'f', 'e', 'd', 255}));
    EXPECT_EQ(decode_bmp(bitmap(24, "", "abcdef..ghijkl..")).samples,
              (Samples16{'i', 'h', 'g', 'l', 'k', 'j', 'c', 'b', 'a', 'f', 'e', 'd'}));
    EXPECT_EQ(decode_bmp(bitmap(1, "abc.def.", std::string("\x40...\x80...", 8))).samples,
              (Samples16{1, 0, 0, 1}));
    EXPECT_EQ(decode_bmp(bitmap(8, "abc.def.", std::string("\2\1\0\0\1\0\1\1\0\1", 10), 1)).samples,
              (Samples16{0, 1, 1, 1}));
}

TEST(Decode, Netpbm) {
    EXPECT_EQ(decode_netpbm("P1 3 2 011 100").samples, (Samples16{1, 0, 0, 0, 1, 1}));
    EXPECT_EQ(decode_netpbm(std::string("P4\n3 2\n\x60\x80", 9)).samples, (Samples16{1, 0, 0, 0, 1, 1}));
    EXPECT_THROW(decode_netpbm("P2 2 2 70000 1 2 3 4"), IoError);
    EXPECT_THROW(decode_netpbm("P2 99999999999999 2 255"), IoError);
}

/// Every beginning of a file, and every file with one byte changed, gives a picture or an error.
TEST(Decode, DamagedFilesAreErrors) {
    const std::vector<std::pair<Image (*)(std::string_view), std::string>> files{
        {decode_png, palette_png},
        {decode_gif, palette_gif},
        {decode_gif, interlaced_gif},
        {decode_pot, interlaced_gif},
        {decode_netpbm, "P3 2 1 255 1 2 3 4 5 6"},
        {decode_targa, targa(11, 8, 0x20, std::string("\x82z\0q", 4))},
        {decode_bmp, bitmap(8, "abc.def.", std::string("\2\1\0\0\1\0\1\1\0\1", 10), 1)},
    };
    for (const auto& [decode, file] : files) {
        EXPECT_NO_THROW(decode(file));
        for (size_t size = 0; size < file.size(); ++size) {
            try {
                decode(std::string_view(file).substr(0, size));
            } catch (const IoError&) {
            }
        }
        for (size_t at = 0; at < file.size(); ++at) {
            for (const int change : {1, 0x80, 0xff}) {
                std::string damaged = file;
                damaged[at] = static_cast<char>(damaged[at] ^ change);
                try {
                    decode(damaged);
                } catch (const IoError&) {
                }
            }
        }
    }
    EXPECT_THROW(decode_gif(palette_gif.substr(0, 40)), IoError);
    EXPECT_THROW(decode_png(palette_png.substr(0, 80)), IoError);
}

TEST(ImageStore, DecodesAnewOnceItHasForgotten) {
    const std::string path = (std::filesystem::temp_directory_path() / "rb_image_store_test.pgm").string();
    const auto write = [&](int value) { std::ofstream(path) << "P2\n1 1\n255\n" << value << "\n"; };
    ImageStore store;
    write(255);
    const ImagePtr bright = store.read(path, ImageType::pgm);
    write(0);
    EXPECT_EQ(store.read(path, ImageType::pgm), bright);
    store.forget();
    EXPECT_NE(store.read(path, ImageType::pgm), bright);
}

}  // namespace
}  // namespace rb
