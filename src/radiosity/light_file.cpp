#include "radiosity/light_file.h"

#include "base/diagnostics.h"
#include "base/temporary_file.h"
#include "base/whole_file.h"
#include "math/random.h"

#include <bit>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <string_view>

#include <fmt/format.h>

namespace rb {

/// The fields of one thing, in the order of the file; both ways by the same lines.
template <class File>
struct LightFields {
    File& file;

    void pass(Gradient& gradient) { file.value(gradient.per_axis); }
    void pass(IrradianceRecord& record) {
        file.value(record.point);
        file.value(record.normal);
        file.value(record.mean);
        pass(record.rotation);
        pass(record.translation);
        file.value(record.radius);
        file.value(record.wide_radius);
        file.value(record.variance);
    }
    void pass(SurfelGrid::Cell& cell) {
        file.value(cell.key);
        file.value(cell.light);
        file.value(cell.count);
    }
    void pass(Outlook::Spot& spot) {
        file.value(spot.direction);
        file.value(spot.distance);
        file.value(spot.light);
    }
    void pass(Outlook& outlook) {
        file.value(outlook.point_);
        file.value(outlook.normal_);
        file.value(outlook.reach_);
        file.value(outlook.mean_);
        file.value(outlook.brightest_);
        pass(outlook.spots_);
    }
    template <class T>
    void pass(std::vector<T>& list) {
        uint64_t count = list.size();
        file.value(count);
        // One by one: a count is believed no further than the bytes go.
        for (uint64_t i = 0; i < count && file.goes_on(); ++i) {
            if (i == list.size()) list.emplace_back();
            pass(list[i]);
        }
    }
    void pass(StoredLight& light) {
        file.value(light.made_for);
        pass(light.records);
        pass(light.surfels);
        pass(light.outlooks);
    }
};

namespace {

static_assert(std::endian::native == std::endian::little);

struct Header {
    std::array<char, 8> kind{'R', 'B', 'L', 'I', 'G', 'H', 'T', '\0'};
    uint64_t version = 2;
    uint64_t size = 0;
    uint64_t hash = 0;
};

uint64_t hash_of(std::string_view bytes) {
    uint64_t hash = bytes.size();
    for (size_t i = 0; i < bytes.size(); i += 8) {
        uint64_t word = 0;
        std::memcpy(&word, bytes.data() + i, std::min<size_t>(8, bytes.size() - i));
        hash = mixed(hash, word);
    }
    return hash;
}

/// Puts fields after one another.
class Writer {
public:
    template <class T>
    void value(const T& x) {
        bytes_.append(reinterpret_cast<const char*>(&x), sizeof x);
    }
    bool goes_on() const { return true; }
    const std::string& bytes() const { return bytes_; }

private:
    std::string bytes_;
};

/// Takes them off again.
class Reader {
public:
    explicit Reader(std::string_view bytes) : bytes_(bytes) {}

    template <class T>
    void value(T& x) {
        failed_ = failed_ || bytes_.size() < sizeof x;
        if (failed_) return;
        std::memcpy(&x, bytes_.data(), sizeof x);
        bytes_.remove_prefix(sizeof x);
    }
    bool goes_on() const { return !failed_; }
    /// All was there, and nothing more.
    bool is_complete() const { return !failed_ && bytes_.empty(); }

private:
    std::string_view bytes_;
    bool failed_ = false;
};

}  // namespace

void write_light(const std::string& path, StoredLight light) {
    Writer fields;
    LightFields<Writer>{fields}.pass(light);
    Header header;
    header.size = fields.bytes().size();
    header.hash = hash_of(fields.bytes());
    TemporaryFile file(path);
    std::ofstream out(file.name(), std::ios::binary);
    out.write(reinterpret_cast<const char*>(&header), sizeof header);
    out.write(fields.bytes().data(), static_cast<std::streamsize>(fields.bytes().size()));
    out.close();
    if (!out || !file.put_in_place(path))
        throw IoError(fmt::format("Could not write the radiosity file {}: {}.", path, std::strerror(errno)));
}

StoredLight read_light(const std::string& path) {
    const auto bytes = read_whole_file(path);
    if (!bytes) throw IoError(fmt::format("Could not read the radiosity file {}.", path));
    const Header expected;
    Header header;
    std::memcpy(&header, bytes->data(), std::min(bytes->size(), sizeof header));
    if (bytes->size() < sizeof header || header.kind != expected.kind)
        throw IoError(fmt::format("{} is no radiosity file of RenderBoy.", path));
    if (header.version != expected.version)
        throw IoError(fmt::format("The radiosity file {} has version {}, not {}.", path, header.version,
                                  expected.version));
    const std::string_view fields = std::string_view(*bytes).substr(sizeof header);
    if (fields.size() < header.size) throw IoError(fmt::format("The radiosity file {} is cut short.", path));
    StoredLight light;
    Reader reader(fields);
    if (hash_of(fields) == header.hash) LightFields<Reader>{reader}.pass(light);
    if (!reader.is_complete()) throw IoError(fmt::format("The radiosity file {} is damaged.", path));
    return light;
}

}  // namespace rb
