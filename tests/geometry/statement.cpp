#include "statement.h"

#include "image/image_store.h"
#include "language/load.h"

namespace rb {

Scene scene_from(std::string_view text) {
    LoadOptions options;
    options.input_file = "statement";
    options.input_text = "#version 3.7; global_settings { assumed_gamma 1.0 }\n" + std::string(text);
    options.library_paths = {RB_SOURCE_DIR "/scenes/textures"};
    options.images = std::make_shared<ImageStore>();
    SourceMap sources;
    Diagnostics diagnostics;
    Scene scene;
    if (load_scene(options, sources, diagnostics, scene)) return scene;
    for (const Diagnostic& diagnostic : diagnostics.all()) {
        if (diagnostic.severity == Severity::error) throw SceneError(diagnostic);
    }
    throw SceneError({}, "no reason given");
}

ObjectPtr object_from(std::string_view text) { return scene_from(text).objects.at(0); }

}  // namespace rb
