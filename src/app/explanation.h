#pragma once
#include "render/render.h"

#include <string>

namespace rb {

/// What was done for a picture and what was left out since the scene does not need it, in lines for people
/// (`--explain`).
std::string explanation(const World& world, const RenderResult& result);

}  // namespace rb
