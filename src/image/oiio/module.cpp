// The home of OpenImageIO: a module that the program loads only when a picture needs it.
#include "image/oiio/module.h"

#include <OpenImageIO/imageio.h>

namespace rb {

namespace {

std::string_view format_name(FileType type) {
    switch (type) {
        case FileType::png:
            return "png";
        case FileType::ppm:
            return "pnm";
        case FileType::tga:
        case FileType::tga_uncompressed:
            return "targa";
        case FileType::jpeg:
            return "jpeg";
        case FileType::bmp:
            return "bmp";
        case FileType::exr:
            return "openexr";
        case FileType::hdr:
            return "hdr";
        case FileType::tiff:
            return "tiff";
    }
    return "png";
}

OIIO::ImageSpec spec_for(const Samples& samples, const OutputFormat& format) {
    const OIIO::TypeDesc type = !samples.floats.empty()  ? OIIO::TypeFloat
                                : !samples.words.empty() ? OIIO::TypeUInt16
                                                         : OIIO::TypeUInt8;
    OIIO::ImageSpec spec(samples.width, samples.height, samples.channels, type);
    spec.attribute("Software", "RenderBoy");
    if (format.type == FileType::tga) spec.attribute("compression", "rle");
    if (format.type == FileType::tga_uncompressed) spec.attribute("compression", "none");
    if (format.type == FileType::exr) spec.attribute("compression", "zip");
    if (format.type == FileType::ppm) spec.attribute("pnm:binary", 1);
    if (format.type == FileType::jpeg && format.compression > 0) {
        spec.attribute("CompressionQuality", format.compression);
    }
    // Only these hold premultiplied colours; for the others the values are straight already.
    if (samples.channels == 4 && !is_linear(format.type)) spec.attribute("oiio:UnassociatedAlpha", 1);
    if (format.curve) {
        switch (format.curve->kind()) {
            case Curve::Kind::srgb:
                spec.attribute("oiio:ColorSpace", "sRGB");
                break;
            case Curve::Kind::linear:
                spec.attribute("oiio:ColorSpace", "linear");
                break;
            case Curve::Kind::power:
                spec.attribute("oiio:ColorSpace", "GammaCorrected");
                spec.attribute("oiio:Gamma", format.curve->power());
                break;
        }
    }
    return spec;
}

std::string write(const Samples& samples, const OutputFormat& format, const std::string& path) {
    const std::string name(format_name(format.type));
    const auto out = OIIO::ImageOutput::create(name);
    if (!out) return "OpenImageIO cannot write " + name + ": " + OIIO::geterror();
    const OIIO::ImageSpec spec = spec_for(samples, format);
    if (!out->open(path, spec)) return out->geterror();
    const void* data = !samples.floats.empty()  ? static_cast<const void*>(samples.floats.data())
                       : !samples.words.empty() ? static_cast<const void*>(samples.words.data())
                                                : static_cast<const void*>(samples.bytes.data());
    if (!out->write_image(spec.format, data) || !out->close()) return out->geterror();
    return {};
}

bool is_reasonable(const OIIO::ImageSpec& spec) {
    constexpr int most_pixels = 1 << 28;
    return spec.width > 0 && spec.height > 0 && spec.nchannels > 0 && spec.width <= most_pixels / spec.height;
}

std::string read(const std::string& path, Pixels& pixels) {
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);
    const auto in = OIIO::ImageInput::open(path, &wish);
    if (!in) return OIIO::geterror();
    const OIIO::ImageSpec& spec = in->spec();
    if (!is_reasonable(spec)) return "the picture's size is not reasonable";
    std::vector<float> raw(static_cast<size_t>(spec.width) * static_cast<size_t>(spec.height) *
                           static_cast<size_t>(spec.nchannels));
    if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeFloat, raw.data())) return in->geterror();
    const bool has_alpha = spec.nchannels == 2 || spec.nchannels >= 4;
    pixels = Pixels(spec.width, spec.height, has_alpha ? 4 : 3);
    const auto stride = static_cast<size_t>(spec.nchannels);
    const auto channels = static_cast<size_t>(pixels.channels);
    for (size_t i = 0; i * channels < pixels.values.size(); ++i) {
        const float* from = raw.data() + i * stride;
        float* to = pixels.values.data() + i * channels;
        const bool grey = stride < 3;
        for (size_t c = 0; c < 3; ++c) to[c] = from[grey ? 0 : c];
        if (has_alpha) to[3] = from[grey ? 1 : 3];
    }
    return {};
}

/// Grey, or the first three channels and alpha.
int kept_channels(const OIIO::ImageSpec& spec) {
    if (spec.nchannels < 3) return spec.nchannels;
    return spec.alpha_channel == 3 ? 4 : 3;
}

std::string read_samples(const std::string& path, ImageType type, Image& image) {
    OIIO::ImageSpec wish;
    wish.attribute("oiio:UnassociatedAlpha", 1);
    const auto in = OIIO::ImageInput::create(std::string(type == ImageType::tiff  ? "tiff"
                                                         : type == ImageType::exr ? "openexr"
                                                                                  : "hdr"));
    OIIO::ImageSpec spec;
    if (!in) return OIIO::geterror();
    if (!in->open(path, spec, wish)) return in->geterror();
    if (!is_reasonable(spec)) return "the picture's size is not reasonable";
    image.width = spec.width;
    image.height = spec.height;
    image.channels = kept_channels(spec);
    const size_t count = image.index(0, image.height);
    if (type == ImageType::exr || type == ImageType::hdr) {
        image.floats.resize(count);
        image.curve = 1.0;
        if (!in->read_image(0, 0, 0, image.channels, OIIO::TypeFloat, image.floats.data()))
            return in->geterror();
        return {};
    }
    std::vector<uint8_t> bytes(count);
    if (!in->read_image(0, 0, 0, image.channels, OIIO::TypeUInt8, bytes.data())) return in->geterror();
    image.samples.assign(bytes.begin(), bytes.end());
    return {};
}

}  // namespace

}  // namespace rb

extern "C" __attribute__((visibility("default"))) const rb::OiioModule* renderboy_oiio_module() {
    static const rb::OiioModule module{rb::write, rb::read, rb::read_samples};
    return &module;
}
