#pragma once
#include "base/source.h"
#include "render/render.h"

#include <chrono>
#include <cstdio>
#include <map>
#include <memory>
#include <string>

namespace rb {

/// Finished blocks in a file beside the picture (`picture.state` for picture.png), so that an interrupted
/// picture can be continued (+C). The file is begun when rendering takes some seconds or is stopped, grows
/// block by block, and is removed when the picture is complete. Trouble with it never stops a picture.
class PictureState final : public BlockLog {
public:
    explicit PictureState(const std::string& picture_path);

    bool exists() const;
    void remove();
    /// Reads what an earlier run left. False, and nothing is used, if that run's `identity` (what decides the
    /// picture) was another.
    bool load(uint64_t identity);
    void begin(uint64_t identity) { identity_ = identity; }
    /// Writes down what is only remembered so far.
    void keep(const Film& film);

    bool restore(const PixelBlock& block, Film& film) override;
    void finished(const PixelBlock& block, const Film& film) override;

private:
    void write(const PixelBlock& block, const Film& film);

    std::string path_;
    uint64_t identity_ = 0;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
    std::vector<PixelBlock> remembered_;
    std::map<std::pair<int, int>, std::pair<PixelBlock, std::vector<Radiance>>> known_;  ///< by corner
    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_{nullptr, std::fclose};
};

/// A number that changes when anything does that decides the picture: the texts read and the words given.
uint64_t identity_of(const SourceMap& sources, const std::string& words);

}  // namespace rb
