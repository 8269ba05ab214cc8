#pragma once
#include "scene/scene.h"

#include <string_view>

namespace rb {

/// What the front end makes of the text of a scene (version 3.7). Throws SceneError with the first mistake.
Scene scene_from(std::string_view text);

/// The first object of that scene.
ObjectPtr object_from(std::string_view text);

}  // namespace rb
