#include "base/diagnostics.h"
#include "image/codec.h"
#include "image/oiio/module.h"

#include <array>
#include <dlfcn.h>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>

namespace rb {

namespace {

/// Beside the program (build tree, portable folder), then where `cmake --install` puts it.
void* open_module() {
    std::error_code ignored;
    const auto program = std::filesystem::read_symlink("/proc/self/exe", ignored);
    const auto folder = program.parent_path();
    const std::array candidates{folder / "renderboy_oiio.so",
                                folder.parent_path() / "lib/renderboy/renderboy_oiio.so",
                                std::filesystem::path(RB_OIIO_MODULE)};
    for (const auto& candidate : candidates) {
        if (!std::filesystem::exists(candidate, ignored)) continue;
        if (void* handle = dlopen(candidate.c_str(), RTLD_LAZY | RTLD_LOCAL)) return handle;
        throw IoError(fmt::format("cannot load the image module: {}", dlerror()));
    }
    throw IoError(fmt::format("the image module renderboy_oiio.so is missing (looked in {} and {})",
                              folder.string(), candidates[1].parent_path().string()));
}

const OiioModule& oiio() {
    static const OiioModule* const module = [] {
        using Entry = const OiioModule* (*)();
        const auto entry = reinterpret_cast<Entry>(dlsym(open_module(), "renderboy_oiio_module"));
        if (!entry) throw IoError("the image module renderboy_oiio.so is not ours");
        return entry();
    }();
    return *module;
}

}  // namespace

void write_with_oiio(const Samples& samples, const OutputFormat& format, const std::string& path) {
    const std::string error = oiio().write(samples, format, path);
    if (!error.empty()) throw IoError(fmt::format("cannot write '{}': {}", path, error));
}

Pixels read_with_oiio(const std::string& path) {
    Pixels pixels;
    const std::string error = oiio().read(path, pixels);
    if (!error.empty()) throw IoError(fmt::format("cannot read '{}': {}", path, error));
    return pixels;
}

Image read_samples_with_oiio(const std::string& path, ImageType type) {
    Image image;
    const std::string error = oiio().read_samples(path, type, image);
    if (!error.empty()) throw IoError(fmt::format("cannot read '{}': {}", path, error));
    return image;
}

}  // namespace rb
