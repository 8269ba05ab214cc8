#include "app/picture_state.h"

#include "math/random.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <filesystem>
#include <fstream>

namespace rb {

namespace {

namespace fs = std::filesystem;

/// Blocks are remembered for so long before a file is begun: most pictures are done by then.
constexpr std::chrono::seconds patience{5};

struct Header {
    char magic[16] = "renderboy state";
    uint64_t identity = 0;
};

template <class T>
bool read(std::ifstream& in, T* to, size_t count) {
    in.read(reinterpret_cast<char*>(to), static_cast<std::streamsize>(count * sizeof(T)));
    return in.good();
}

size_t area(const PixelBlock& block) {
    return static_cast<size_t>(block.width()) * static_cast<size_t>(block.height());
}

bool same(const PixelBlock& a, const PixelBlock& b) {
    return a.x0 == b.x0 && a.y0 == b.y0 && a.x1 == b.x1 && a.y1 == b.y1;
}

}  // namespace

PictureState::PictureState(const std::string& picture_path)
    : path_(fs::path(picture_path).replace_extension(".state").string()) {}

bool PictureState::exists() const {
    std::error_code error;
    return fs::is_regular_file(path_, error);
}

void PictureState::remove() {
    file_.reset();
    std::error_code error;
    fs::remove(path_, error);
}

bool PictureState::load(uint64_t identity) {
    identity_ = identity;
    std::ifstream in(path_, std::ios::binary);
    Header header;
    if (!read(in, &header, 1) || std::strncmp(header.magic, Header{}.magic, sizeof header.magic) != 0 ||
        header.identity != identity) {
        return false;
    }
    constexpr int most = 1 << 16;
    PixelBlock block;
    while (read(in, &block, 1)) {
        const bool sound = block.x0 >= 0 && block.y0 >= 0 && block.width() > 0 && block.width() < most &&
                           block.height() > 0 && block.height() < most;
        if (!sound) break;
        // A run that was killed may have left half a block.
        std::vector<Radiance> pixels(area(block));
        if (!read(in, pixels.data(), pixels.size())) break;
        known_.insert_or_assign({block.x0, block.y0}, std::pair{block, std::move(pixels)});
    }
    return true;
}

bool PictureState::restore(const PixelBlock& block, Film& film) {
    const auto found = known_.find({block.x0, block.y0});
    if (found == known_.end() || !same(found->second.first, block)) return false;
    const std::vector<Radiance>& pixels = found->second.second;
    for (int y = block.y0; y < block.y1; ++y) {
        const auto row = pixels.begin() + static_cast<std::ptrdiff_t>(y - block.y0) * block.width();
        std::copy_n(row, block.width(), &film.at(block.x0, y));
    }
    remembered_.push_back(block);
    return true;
}

void PictureState::finished(const PixelBlock& block, const Film& film) {
    remembered_.push_back(block);
    if (file_ || std::chrono::steady_clock::now() - start_ > patience) keep(film);
}

void PictureState::keep(const Film& film) {
    // Under another name at first, so that what an earlier run left is there until all of it is in the new
    // file.
    const std::string fresh = path_ + "~";
    const bool begins = !file_;
    if (begins) {
        file_.reset(std::fopen(fresh.c_str(), "wb"));
        if (!file_) return;
        Header header;
        header.identity = identity_;
        std::fwrite(&header, sizeof header, 1, file_.get());
    }
    for (const PixelBlock& block : remembered_) write(block, film);
    remembered_.clear();
    std::fflush(file_.get());
    std::error_code error;
    if (begins) fs::rename(fresh, path_, error);
}

void PictureState::write(const PixelBlock& block, const Film& film) {
    std::fwrite(&block, sizeof block, 1, file_.get());
    for (int y = block.y0; y < block.y1; ++y) {
        std::fwrite(&film.at(block.x0, y), sizeof(Radiance), static_cast<size_t>(block.width()), file_.get());
    }
}

uint64_t identity_of(const SourceMap& sources, const std::string& words) {
    uint64_t value = 0;
    const auto take = [&](std::string_view text) {
        value = mixed(value, text.size());
        for (size_t i = 0; i < text.size(); i += sizeof(uint64_t)) {
            uint64_t word = 0;
            std::memcpy(&word, text.data() + i, std::min(sizeof word, text.size() - i));
            value = mixed(value, word);
        }
    };
    take(words);
    for (uint32_t file = 1; file <= sources.file_count(); ++file) take(sources.text(file));
    return value;
}

}  // namespace rb
