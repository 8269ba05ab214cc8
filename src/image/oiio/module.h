#pragma once
#include "image/codec.h"

namespace rb {

/// What the OpenImageIO module offers; errors come back as text, since exceptions do not cross its border.
struct OiioModule {
    /// Empty on success.
    std::string (*write)(const Samples& samples, const OutputFormat& format, const std::string& path);
    std::string (*read)(const std::string& path, Pixels& out);
    std::string (*read_samples)(const std::string& path, ImageType type, Image& out);
};

}  // namespace rb

/// The module's only symbol.
extern "C" const rb::OiioModule* renderboy_oiio_module();
