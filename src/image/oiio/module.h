#pragma once
#include "image/codec.h"

namespace rb {

/// What the OpenImageIO module offers; errors come back as text, since exceptions do not cross its border.
struct OiioModule {
    /// Empty on success.
    std::string (*write)(const Samples& samples, const OutputFormat& format, const std::string& path);
    std::string (*read)(const std::string& path, Pixels& out);
};

}  // namespace rb

/// The module's only symbol.
extern "C" const rb::OiioModule* renderboy_oiio_module();
