#include "app/commands.h"
#include "app/console.h"
#include "image/compare.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace rb {

int run_diff(const DiffSettings& settings) {
    const Pixels first = read_image(settings.first);
    const Pixels second = read_image(settings.second);
    const ImageDifference d = compare(first, second);
    if (settings.heat_map) {
        OutputFormat format;
        format.type = file_type_for(*settings.heat_map).value_or(FileType::png);
        const Pixels heat = heat_map(first, second);
        write_image(rows_of(heat), format, *settings.heat_map);
    }
    std::string text;
    if (settings.json) {
        text =
            nlohmann::ordered_json{
                {"rmse", d.rmse}, {"share_off", d.share_off}, {"ssim", d.ssim}, {"max_error", d.max_error}}
                .dump() +
            "\n";
    } else {
        text = fmt::format(
            "rmse {:.4f}/255  off by more than 8/255: {:.4f} %  ssim {:.5f}  largest {:.0f}/255\n", d.rmse,
            100 * d.share_off, d.ssim, d.max_error);
    }
    print(text);
    return settings.limits.hold(d) ? exit_done : exit_error;
}

}  // namespace rb
