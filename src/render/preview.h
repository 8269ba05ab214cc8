#pragma once
#include "render/render.h"

namespace rb {

/// Coarse full pictures before the real one, each with four times as many rays as the one before, as long as
/// that takes no more than a second or two in all: without antialiasing, radiosity, media and photons. None
/// of mesh cameras. `show` gets each of them in the size of the real one.
void preview(const World& world, const RenderOptions& options, const std::atomic<bool>& stop,
             const std::function<void(const Film&)>& show);

}  // namespace rb
