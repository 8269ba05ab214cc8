#include "app/settings.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

namespace rb {

namespace {

/// First pixel of a start side (0-based). A value in [0, 1) is a fraction, from 1 on a 1-based pixel.
int first_pixel(const RegionSide& side, int size) {
    if (!side) return 0;
    if (*side >= 0.0 && *side < 1.0) return static_cast<int>(*side * size);
    return static_cast<int>(std::clamp(*side, -1e9, 1e9)) - 1;
}

/// One past the last pixel of an end side. (0, 1] is a fraction, above a 1-based inclusive pixel.
int end_pixel(const RegionSide& side, int size) {
    if (!side) return size;
    if (*side > 0.0 && *side <= 1.0) return static_cast<int>(*side * size);
    return static_cast<int>(std::clamp(*side, -1e9, 1e9));
}

}  // namespace

PixelBlock region_of(const Settings& settings) {
    PixelBlock region{
        first_pixel(settings.start_column, settings.width), first_pixel(settings.start_row, settings.height),
        end_pixel(settings.end_column, settings.width), end_pixel(settings.end_row, settings.height)};
    if (region.x0 >= settings.width || region.y0 >= settings.height)
        throw UsageError("Invalid start column or row");
    if (region.x1 > settings.width || region.y1 > settings.height)
        throw UsageError("Invalid end column or row");
    region.x0 = std::max(region.x0, 0);
    region.y0 = std::max(region.y0, 0);
    region.x1 = std::max(region.x1, region.x0);
    region.y1 = std::max(region.y1, region.y0);
    return region;
}

int output_bits(const Settings& settings) {
    return settings.grayscale && settings.file_type == FileType::png ? 16 : settings.bits_per_color;
}

std::string output_path(const Settings& settings, const std::string& number) {
    namespace fs = std::filesystem;
    const std::string ending = number + std::string(extension_of(settings.file_type));
    const fs::path scene(settings.input_file == "-" ? "stdin" : settings.input_file);
    const std::string& name = settings.output_file;
    if (name.empty()) return (scene.parent_path() / scene.stem()).string() + ending;
    if (name == "-" || name == "stdout") return "-";
    if (name.back() == '/') return (fs::path(name) / scene.stem()).string() + ending;
    // An extension of the chosen type stays; any other is taken as part of the name.
    const auto own = file_type_for(name);
    const bool keeps = own && extension_of(*own) == extension_of(settings.file_type);
    if (!keeps) return name + ending;
    return number.empty() ? name : (fs::path(name).parent_path() / fs::path(name).stem()).string() + ending;
}

}  // namespace rb
