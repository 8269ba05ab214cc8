#include "photons/photon_file.h"

#include "base/temporary_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <fstream>

#include <fmt/format.h>

namespace rb {

namespace {

static_assert(std::endian::native == std::endian::little);

constexpr double angle_steps = 127.0;
constexpr int exponent_bias = 6;

struct Record {
    std::array<float, 3> place{};
    std::array<uint8_t, 3> color{};
    int8_t exponent = 0;
    int8_t axis = 0;
    int8_t latitude = 0;   ///< above the plane of x and z
    int8_t longitude = 0;  ///< from x to z
    int8_t unused = 0;
};
static_assert(sizeof(Record) == 20);

Record packed(const Photon& photon) {
    Record record;
    record.place = photon.place;
    const float brightest = std::max({photon.color.x, photon.color.y, photon.color.z});
    int exponent = 0;
    std::frexp(brightest, &exponent);
    exponent = std::clamp(exponent, exponent_bias - 128, exponent_bias + 127);
    record.exponent = static_cast<int8_t>(exponent - exponent_bias);
    for (size_t i = 0; i < 3; ++i) {
        const double share = std::ldexp(static_cast<double>(photon.color[static_cast<int>(i)]), 8 - exponent);
        record.color[i] = static_cast<uint8_t>(std::clamp(share, 0.0, 255.0));
    }
    const Vec3 d = photon.origin.unpacked();
    record.latitude = static_cast<int8_t>(std::asin(std::clamp(d.y, -1.0, 1.0)) / pi * angle_steps);
    record.longitude = static_cast<int8_t>(std::atan2(d.z, d.x) / pi * angle_steps);
    return record;
}

Photon unpacked(const Record& record) {
    Photon photon;
    photon.place = record.place;
    for (size_t i = 0; i < 3; ++i) {
        photon.color[static_cast<int>(i)] =
            std::ldexp(static_cast<float>(record.color[i]), record.exponent + exponent_bias - 8);
    }
    const double latitude = record.latitude * pi / angle_steps;
    const double longitude = record.longitude * pi / angle_steps;
    photon.origin = PackedDirection({std::cos(latitude) * std::cos(longitude), std::sin(latitude),
                                     std::cos(latitude) * std::sin(longitude)});
    return photon;
}

void write_map(std::ostream& out, const std::vector<Photon>& photons) {
    const auto count = static_cast<int32_t>(photons.size());
    out.write(reinterpret_cast<const char*>(&count), sizeof count);
    for (const Photon& photon : photons) {
        const Record record = packed(photon);
        out.write(reinterpret_cast<const char*>(&record), sizeof record);
    }
}

bool is_sound(const Record& record) {
    return std::ranges::all_of(record.place, [](float x) { return std::isfinite(x); });
}

/// False if the file ends before the map does, or holds what is no photon.
bool read_map(std::istream& in, std::vector<Photon>& photons) {
    int32_t count = 0;
    if (!in.read(reinterpret_cast<char*>(&count), sizeof count) || count < 0) return false;
    for (int32_t i = 0; i < count; ++i) {
        Record record;
        if (!in.read(reinterpret_cast<char*>(&record), sizeof record) || !is_sound(record)) return false;
        photons.push_back(unpacked(record));
    }
    return true;
}

}  // namespace

std::string write_photons(const std::string& path, const StoredPhotons& photons) {
    TemporaryFile file(path);
    std::ofstream out(file.name(), std::ios::binary);
    write_map(out, photons.on_surfaces);
    write_map(out, photons.in_media);
    out.close();
    if (out && file.put_in_place(path)) return {};
    return fmt::format("Could not write the photon map {}: {}", path, std::strerror(errno));
}

std::string read_photons(const std::string& path, StoredPhotons& photons) {
    std::ifstream in(path, std::ios::binary);
    if (!in) return fmt::format("Could not load the photon map {}: {}", path, std::strerror(errno));
    if (!read_map(in, photons.on_surfaces) || !read_map(in, photons.in_media)) {
        return fmt::format("{} is no photon map, or only a part of one.", path);
    }
    return {};
}

}  // namespace rb
