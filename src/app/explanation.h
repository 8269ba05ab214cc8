#pragma once
#include "render/render.h"

#include <string>

namespace rb {

/// What was left out since the scene does not need it, and how many rays that saved, in lines for people
/// (`--explain`, after statistics_text()).
std::string explanation(const World& world, const RenderResult& result);

}  // namespace rb
