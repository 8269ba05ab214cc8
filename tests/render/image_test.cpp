#include "base/diagnostics.h"
#include "image/codec.h"
#include "image/compare.h"
#include "image/decode.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

namespace rb {
namespace {

namespace fs = std::filesystem;

Pixels gradient(int width, int height, int channels) {
    Pixels p(width, height, channels);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (int c = 0; c < channels; ++c) {
                p.at(x, y)[c] = static_cast<float>(x * 4 + y * 2 + c * 10) / 255.0f;
            }
        }
    }
    return p;
}

std::string temporary(const std::string& name) { return (fs::path(testing::TempDir()) / name).string(); }

struct FormatCase {
    const char* name;
    FileType type;
    int bits;
    int channels;
    float tolerance;
};

class Formats : public testing::TestWithParam<FormatCase> {};

TEST_P(Formats, RoundTrip) {
    const FormatCase& c = GetParam();
    const Pixels written = gradient(37, 21, c.channels);
    OutputFormat format;
    format.type = c.type;
    format.bits = c.bits;
    format.curve = Curve(GammaCurve{SrgbCurve{}});
    if (is_linear(c.type)) format.curve = Curve(GammaCurve{1.0});
    const std::string path = temporary(std::string("roundtrip_") + c.name);
    write_image(rows_of(written), format, path);
    const Pixels read = read_image(path);
    ASSERT_EQ(read.width, written.width);
    ASSERT_EQ(read.height, written.height);
    float largest = 0;
    for (int y = 0; y < read.height; ++y) {
        for (int x = 0; x < read.width; ++x) {
            for (int k = 0; k < 3; ++k) {
                const float want = written.at(x, y)[c.channels == 1 ? 0 : k];
                largest = std::max(largest, std::abs(read.at(x, y)[k] - want));
            }
            if (c.channels == 4)
                largest = std::max(largest, std::abs(read.at(x, y)[3] - written.at(x, y)[3]));
        }
    }
    EXPECT_LE(largest, c.tolerance);
}

INSTANTIATE_TEST_SUITE_P(
    All, Formats,
    testing::Values(
        FormatCase{"rgb8.png", FileType::png, 8, 3, 1e-6f},
        FormatCase{"rgba8.png", FileType::png, 8, 4, 1e-6f},
        FormatCase{"grey16.png", FileType::png, 16, 1, 1e-6f},
        FormatCase{"rgb16.png", FileType::png, 16, 3, 1e-6f}, FormatCase{"a.ppm", FileType::ppm, 8, 3, 1e-6f},
        // OpenImageIO 2.4 reads 65535 as 65534; Netpbm below looks at the bytes.
        FormatCase{"b.ppm", FileType::ppm, 16, 3, 1.6e-5f}, FormatCase{"a.tga", FileType::tga, 8, 3, 1e-6f},
        FormatCase{"b.tga", FileType::tga_uncompressed, 8, 4, 1e-6f},
        FormatCase{"a.bmp", FileType::bmp, 8, 3, 1e-6f}, FormatCase{"a.jpg", FileType::jpeg, 8, 3, 0.03f},
        FormatCase{"a.exr", FileType::exr, 8, 3, 1e-3f}, FormatCase{"a.hdr", FileType::hdr, 8, 3, 0.02f},
        FormatCase{"a.tif", FileType::tiff, 16, 3, 1e-6f}),
    [](const auto& i) {
        std::string name = i.param.name;
        std::ranges::replace(name, '.', '_');
        return name;
    });

// The PNG writer is the fast twin of OpenImageIO's.
TEST(Png, EqualsTheSlowTwin) {
    for (const int channels : {1, 3, 4}) {
        for (const int bits : {8, 16}) {
            OutputFormat format;
            format.bits = bits;
            const Pixels pixels = gradient(33, 17, channels);
            write_png(rows_of(pixels), format, temporary("fast.png"));
            write_with_oiio(samples_of(rows_of(pixels), format), format, temporary("slow.png"));
            EXPECT_EQ(read_image(temporary("fast.png")).values, read_image(temporary("slow.png")).values);
        }
    }
}

TEST(Netpbm, HoldsAsManyBitsAsAreAskedFor) {
    Pixels one(1, 1, 3);
    std::ranges::copy(std::array{0.36f, 1.0f, -1.0f}, one.at(0, 0));
    const auto written = [&](int bits) {
        OutputFormat format;
        format.type = FileType::ppm;
        format.bits = bits;
        write_image(rows_of(one), format, temporary("bits.ppm"));
        std::ifstream in(temporary("bits.ppm"), std::ios::binary);
        return std::string(std::istreambuf_iterator<char>(in), {});
    };
    using namespace std::string_literals;
    EXPECT_EQ(written(5), "P6\n1 1\n31\n\x0b\x1f\0"s);
    EXPECT_EQ(written(8), "P6\n1 1\n255\n\x5c\xff\0"s);
    EXPECT_EQ(written(10), "P6\n1 1\n1023\n\x01\x70\x03\xff\0\0"s);
    EXPECT_EQ(written(16), "P6\n1 1\n65535\n\x5c\x29\xff\xff\0\0"s);
}

TEST(WriteImage, FailureLeavesTheOldFileAndNothingElse) {
    const fs::path folder = fs::path(testing::TempDir()) / "write_image";
    fs::remove_all(folder);
    fs::create_directories(folder / "taken.png");  // a folder in the way: renaming onto it fails
    const Pixels small = gradient(4, 4, 3);
    EXPECT_THROW(write_image(rows_of(small), {}, (folder / "taken.png").string()), IoError);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator{}), 1);
    EXPECT_THROW(write_image(rows_of(small), {}, (folder / "no/such/folder.png").string()), IoError);
}

TEST(ReadImage, TypesOfOpenImageIoKeepTheirNumbers) {
    const Samples bytes{2, 2, 3, {3, 1, 2, 128, 7, 9, 64, 200, 32, 255, 254, 253}, {}, {}};
    OutputFormat tiff;
    tiff.type = FileType::tiff;
    write_with_oiio(bytes, tiff, temporary("bytes.tif"));
    EXPECT_EQ(decode_image(temporary("bytes.tif"), ImageType::tiff).samples,
              (std::vector<uint16_t>{3, 1, 2, 128, 7, 9, 64, 200, 32, 255, 254, 253}));
    const Samples floats{1, 1, 3, {}, {}, {0.5f, 2.0f, -1.0f}};
    OutputFormat exr;
    exr.type = FileType::exr;
    write_with_oiio(floats, exr, temporary("floats.exr"));
    EXPECT_EQ(decode_image(temporary("floats.exr"), ImageType::exr).floats, floats.floats);
    EXPECT_THROW(decode_image(temporary("bytes.tif"), ImageType::jpeg), IoError);
}

TEST(ReadImage, JpegHasTheNumbersThatOpenImageIoReads) {
    for (const int channels : {1, 3}) {
        const std::string path = temporary("numbers.jpg");
        OutputFormat format;
        format.type = FileType::jpeg;
        write_image(rows_of(gradient(37, 21, channels)), format, path);
        const Image ours = decode_image(path, ImageType::jpeg);
        const Pixels theirs = read_with_oiio(path);
        ASSERT_EQ(ours.width, theirs.width);
        ASSERT_EQ(ours.height, theirs.height);
        for (int y = 0; y < ours.height; ++y) {
            for (int x = 0; x < ours.width; ++x) {
                for (int c = 0; c < 3; ++c) {
                    const uint16_t sample =
                        ours.samples[ours.index(x, y) + static_cast<size_t>(std::min(c, ours.channels - 1))];
                    ASSERT_EQ(sample, std::lround(255.0f * theirs.at(x, y)[static_cast<size_t>(c)]))
                        << x << ' ' << y;
                }
            }
        }
    }
}

TEST(ReadImage, TruncatedJpegsAreErrors) {
    const std::string path = temporary("whole.jpg");
    OutputFormat format;
    format.type = FileType::jpeg;
    write_image(rows_of(gradient(64, 64, 3)), format, path);
    std::ifstream in(path, std::ios::binary);
    const std::string all(std::istreambuf_iterator<char>(in), {});
    for (const size_t length : {size_t{0}, size_t{3}, size_t{100}, all.size() - 20}) {
        std::ofstream(temporary("cut.jpg"), std::ios::binary) << all.substr(0, length);
        EXPECT_THROW(decode_image(temporary("cut.jpg"), ImageType::jpeg), IoError) << length;
    }
}

TEST(ReadImage, TruncatedFilesAreErrors) {
    const std::string path = temporary("whole.png");
    const Pixels tall = gradient(24, 64, 3);
    write_image(rows_of(tall), {}, path);
    std::ifstream in(path, std::ios::binary);
    const std::string all(std::istreambuf_iterator<char>(in), {});
    for (const size_t length : {size_t{0}, size_t{7}, size_t{30}, all.size() / 2}) {
        std::ofstream(temporary("cut.png"), std::ios::binary) << all.substr(0, length);
        EXPECT_THROW(read_image(temporary("cut.png")), IoError) << length;
    }
    EXPECT_THROW(read_image(temporary("absent.png")), IoError);
}

TEST(Gamma, MeasuredPixels) {
    // Language spec 6: flat colour <.5,.2,.1> and the 8-bit result.
    const auto byte = [](const OutputEncoding& e, float v) {
        return static_cast<int>(std::floor(e.encode(v) * 255 + 0.5f));
    };
    const OutputEncoding linear(GammaCurve{1.0}, GammaCurve{SrgbCurve{}});
    EXPECT_EQ(byte(linear, .5f), 188);
    EXPECT_EQ(byte(linear, .2f), 124);
    EXPECT_EQ(byte(linear, .1f), 89);
    const OutputEncoding none(std::nullopt, GammaCurve{SrgbCurve{}});
    EXPECT_EQ(byte(none, .5f), 128);
    EXPECT_EQ(byte(none, .2f), 51);
    const OutputEncoding power(GammaCurve{2.2}, GammaCurve{SrgbCurve{}});
    EXPECT_EQ(byte(power, .5f), 128);
    EXPECT_EQ(byte(power, .2f), 48);
    EXPECT_EQ(byte(power, .1f), 19);
    const OutputEncoding file22(GammaCurve{1.0}, GammaCurve{2.2});
    EXPECT_EQ(byte(file22, .5f), 186);
    EXPECT_EQ(byte(file22, .2f), 123);
    EXPECT_EQ(byte(file22, .1f), 90);
}

TEST(Gamma, CodeTableEqualsTheSlowTwin) {
    for (const OutputEncoding& encoding : {OutputEncoding(GammaCurve{1.0}, GammaCurve{SrgbCurve{}}),
                                           OutputEncoding(GammaCurve{2.2}, GammaCurve{SrgbCurve{}}),
                                           OutputEncoding(GammaCurve{SrgbCurve{}}, GammaCurve{1.8})}) {
        const CodeTable table(encoding);
        const auto slow = [&](float v) {
            const float encoded = encoding.encode(v);
            return encoded > 0.0f ? static_cast<int>(std::min(encoded, 1.0f) * 255.0f + 0.5f) : 0;
        };
        for (int i = -1000; i < 200000; ++i) {
            const float v = static_cast<float>(i) * 7.3e-6f;
            ASSERT_EQ(table.code(v), slow(v)) << v;
        }
        for (const float v :
             {0.0f, -0.0f, 1e-38f, 1e-45f, 1.0f, 2.0f, 1e30f, std::numeric_limits<float>::infinity()}) {
            EXPECT_EQ(table.code(v), slow(v)) << v;
        }
        EXPECT_EQ(table.code(std::numeric_limits<float>::quiet_NaN()), 0);
    }
}

TEST(Compare, CountsAndRmse) {
    Pixels a(20, 20, 3);
    Pixels b = a;
    b.at(3, 4)[1] = 9.0f / 255.0f;
    b.at(5, 6)[2] = 8.0f / 255.0f;
    const ImageDifference d = compare(a, b);
    EXPECT_DOUBLE_EQ(d.share_off, 1.0 / 400);
    EXPECT_NEAR(d.rmse, std::sqrt((81.0 + 64.0) / 1200), 1e-6);
    EXPECT_NEAR(d.max_error, 9.0, 1e-5);
    EXPECT_LT(d.ssim, 1.0);
    EXPECT_DOUBLE_EQ(compare(a, a).ssim, 1.0);
    EXPECT_THROW(compare(a, Pixels(3, 3, 3)), IoError);
}

}  // namespace
}  // namespace rb
