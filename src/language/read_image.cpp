// Pictures that statements name or make. Language spec 18.8, textures spec 6.4.
#include "language/find_file.h"
#include "language/read.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

namespace rb {

namespace {

struct ImageWord {
    std::string_view word;
    ImageType type;
    SoughtFile sought;
};

/// The words of the language, and behind them what only extensions say.
constexpr std::array<ImageWord, 14> image_words{{{"gif", ImageType::gif, SoughtFile::gif},
                                                 {"tga", ImageType::tga, SoughtFile::tga},
                                                 {"iff", ImageType::iff, SoughtFile::iff},
                                                 {"ppm", ImageType::ppm, SoughtFile::ppm},
                                                 {"pgm", ImageType::pgm, SoughtFile::pgm},
                                                 {"png", ImageType::png, SoughtFile::png},
                                                 {"jpeg", ImageType::jpeg, SoughtFile::jpeg},
                                                 {"tiff", ImageType::tiff, SoughtFile::tiff},
                                                 {"bmp", ImageType::bmp, SoughtFile::bmp},
                                                 {"exr", ImageType::exr, SoughtFile::exr},
                                                 {"hdr", ImageType::hdr, SoughtFile::hdr},
                                                 {"pot", ImageType::pot, SoughtFile::gif},
                                                 {"jpg", ImageType::jpeg, SoughtFile::jpeg},
                                                 {"tif", ImageType::tiff, SoughtFile::tiff}}};

const ImageWord* find_word(std::string_view word) {
    const auto* at = std::ranges::find(image_words, word, &ImageWord::word);
    return at == image_words.end() ? nullptr : at;
}

/// By the name's extension; without one the type of the pictures that are written by default.
const ImageWord& word_of_name(BlockReader& in, const std::string& name, SourceRange where) {
    std::string extension = std::filesystem::path(name).extension().string();
    if (extension.empty()) return *find_word("png");
    std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
    if (const ImageWord* known = find_word(extension.substr(1))) return *known;
    in.fail_at(where, "Could not determine valid image file type from extension.");
}

ImagePtr take_file(BlockReader& in) {
    Session& session = *in.context().session;
    const SourceRange at = in.where();
    if (in.take_word("sys")) in.fail_at(at, "Pictures of type 'sys' are not known here.");
    const ImageWord* word = in.at_word() ? find_word(in.peek_word()) : nullptr;
    if (word) in.skip_item();
    if (!in.at_text()) in.fail(fmt::format("Expected 'map file spec', {} found instead", in.found()));
    const SourceRange where = in.where();
    const std::string name = in.file_name();
    const ImageWord& kind = word ? *word : word_of_name(in, name, where);
    if (kind.type == ImageType::iff) in.fail_at(at, "IFF pictures are not read.");
    const auto path = find_file(session, name, kind.sought, where);
    if (!path) throw missing_file(session, name, kind.sought, where, "Cannot open image file.");
    if (!session.options.images) in.fail_at(where, "No picture files can be read here.");
    try {
        return session.options.images->read(*path, kind.type);
    } catch (const IoError& error) {
        throw SceneError(where, fmt::format("Cannot read image: {}.", error.what()));
    }
}

/// As the reference stores what a function makes: truncated, and beyond 0..1 by the lower 16 bits.
uint16_t stored(double value) {
    constexpr double white = 65535.0;
    constexpr double period = 65536.0;
    const double v = std::fmod(std::trunc(value * white), period);
    return std::isfinite(v) ? static_cast<uint16_t>(static_cast<int32_t>(v)) : uint16_t{0};
}

int image_side(BlockReader& in) {
    const SourceRange at = in.where();
    const double side = in.number();
    constexpr double most = 32768.0;
    if (!(side >= 1.0 && side <= most)) in.fail_at(at, "The size of an image must be 1 to 32768.");
    return static_cast<int>(side);
}

void fill_row(const Function& function, Image& image, int y) {
    const auto width = static_cast<size_t>(image.width);
    const auto share = [](int i, int count) {
        return count > 1 ? static_cast<double>(i) / (count - 1) : 0.0;
    };
    std::vector<double> place(3 * width, 0.0);
    for (int x = 0; x < image.width; ++x) {
        place[static_cast<size_t>(x)] = share(x, image.width);
        place[width + static_cast<size_t>(x)] = share(y, image.height);
    }
    const std::array<const double*, 3> columns{place.data(), place.data() + width, place.data() + 2 * width};
    const std::span arguments(columns.data(), static_cast<size_t>(function.parameter_count()));
    uint16_t* to = image.samples.data() + image.index(0, y);
    if (image.channels == 1) {
        std::vector<double> values(width);
        function.evaluate_rows(arguments, values);
        std::ranges::transform(values, to, stored);
        return;
    }
    std::vector<double> colors(5 * width);
    function.evaluate_all_rows(arguments, colors);
    for (size_t i = 0; i < colors.size(); i += 5) {
        for (size_t c = 0; c < 3; ++c) *to++ = stored(colors[i + c]);
        *to++ = stored(1.0 - colors[i + 4]);
    }
}

/// `function W, H { ... }`: top row first, the function's (0, 0) at its left end.
ImagePtr take_function(BlockReader& in) {
    in.skip_item();
    auto image = std::make_shared<Image>();
    image->type = ImageType::ppm;  // numbers that mean what they are
    image->width = image_side(in);
    image->height = image_side(in);
    const SourceRange at = in.where();
    if (!in.at_thing<FunctionPtr>())
        in.fail(fmt::format("Expected 'function', {} found instead", in.found()));
    const auto function = in.thing<FunctionPtr>();
    const bool is_color = function->result_count() == 5;
    if (function->parameter_count() > 3 || (!is_color && function->result_count() != 1)) {
        in.fail_at(at, "An image needs a function of three parameters with a float or a color.");
    }
    image->channels = is_color ? 4 : 1;
    image->white = 65535;
    image->samples.resize(image->index(0, image->height));
    for (int y = 0; y < image->height; ++y) fill_row(*function, *image, y);
    return image;
}

GammaCurve take_gamma(BlockReader& in) {
    if (in.take_word("srgb")) return SrgbCurve{};
    const SourceRange at = in.where();
    const double gamma = in.number();
    if (!(gamma > 0)) in.fail_at(at, "gamma value must be positive.");
    if (gamma < 1) {
        in.diagnostics().warning(at,
                                 fmt::format("Suspicious value {} specified for gamma: it is the exponent "
                                             "that decodes the file.",
                                             gamma));
    }
    return gamma;
}

}  // namespace

ImageSource take_image(BlockReader& in) {
    ImageSource source;
    if (in.at_word("function")) {
        source.image = take_function(in);
        return source;
    }
    source.image = take_file(in);
    for (;;) {
        if (in.take_word("gamma")) {
            source.gamma = take_gamma(in);
        } else if (in.take_word("premultiplied")) {
            source.premultiplied = in.optional_switch();
        } else {
            return source;
        }
    }
}

}  // namespace rb
