#include "app/scene_input.h"

#include "app/write_access.h"
#include "image/image_store.h"

#include <filesystem>
#include <iostream>
#include <iterator>

namespace rb {

LoadOptions load_options(const Settings& settings, const AnimationFrame& frame, Console& console,
                         GeometryOracle& oracle) {
    LoadOptions options;
    options.input_file = settings.input_file;
    if (settings.input_file == "-") {
        options.input_text = std::string(std::istreambuf_iterator<char>(std::cin), {});
        options.input_file = "stdin";
    }
    options.library_paths = settings.library_paths;
    // The reference does not look beside the scene file; here it is the last place.
    const auto folder = std::filesystem::path(settings.input_file).parent_path();
    if (!folder.empty()) options.library_paths.push_back(folder.string());
    options.declares = settings.declares;
    options.include_header = settings.include_header;
    options.image_width = settings.width;
    options.image_height = settings.height;
    options.clock = frame.clock;
    options.clock_on = settings.clock_given || frame.digits > 0;
    options.frame_number = frame.number;
    options.initial_frame = frame.initial_frame;
    options.final_frame = frame.final_frame;
    options.initial_clock = frame.initial_clock;
    options.final_clock = frame.final_clock;
    options.clock_delta = frame.clock_delta;
    options.version = settings.version;
    options.oracle = &oracle;
    options.images = std::make_shared<ImageStore>();
    options.max_tokens = settings.max_parse_steps;
    options.strict = settings.strict;
    options.may_write = [access = WriteAccess(settings)](const std::string& path) {
        return access.allows(path);
    };
    options.message = [&console, &settings](std::string_view stream, std::string_view text) {
        const bool shown = stream == "render"       ? settings.render_console
                           : stream == "statistics" ? settings.statistic_console
                                                    : settings.debug_console;
        console.message(text, shown);
    };
    return options;
}

}  // namespace rb
