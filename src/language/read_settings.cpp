// global_settings. Language spec 21.
#include "language/read.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace rb {

namespace {

void read_assumed_gamma(Session& session, BlockReader& in) {
    const SourceRange at = in.where();
    GammaCurve curve = SrgbCurve{};
    if (!in.take_word("srgb")) {
        const double gamma = in.number();
        if (!(gamma > 0)) in.fail_at(at, "gamma value must be positive.");
        if (gamma < 1) session.warn(at, "Suspicious gamma value: assumed_gamma is less than 1.");
        curve = gamma;
    }
    auto& settings = session.scene.settings;
    if (settings.assumed_gamma) {
        session.warn(at, "A second assumed_gamma is ignored.");
        return;
    }
    settings.assumed_gamma = curve;
}

void read_radiosity(Session& session, const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    constexpr std::array<std::string_view, 17> numbers{"adc_bailout",    "always_sample",  "brightness",
                                                       "error_bound",    "gray_threshold", "low_error_factor",
                                                       "max_sample",     "maximum_reuse",  "minimum_reuse",
                                                       "normal",         "media",          "subsurface",
                                                       "pretrace_start", "pretrace_end",   "recursion_limit",
                                                       "count",          "nearest_count"};
    while (!in.at_end()) {
        const std::string_view word = in.at_word() ? in.peek_word() : std::string_view{};
        if (std::find(numbers.begin(), numbers.end(), word) != numbers.end()) {
            const bool two = word == "count" || word == "nearest_count";
            in.skip_item();
            in.number();
            if (two && in.at_number()) in.number();
        } else if (in.take_word("load_file") || in.take_word("save_file")) {
            in.text();
        } else {
            break;
        }
    }
    in.finish();
    session.scene.settings.wants_radiosity = true;
    context.diagnostics->unsupported(block.where, "radiosity", "surfaces keep their ambient light");
}

void read_global_photons(Session& session, const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    while (!in.at_end()) {
        if (in.take_word("spacing") || in.take_word("count") || in.take_word("autostop") ||
            in.take_word("jitter") || in.take_word("max_trace_level") || in.take_word("adc_bailout")) {
            in.number();
        } else if (in.take_word("gather") || in.take_word("expand_thresholds") || in.take_word("media") ||
                   in.take_word("radius")) {
            while (in.at_number()) in.number();
        } else if (in.take_word("save_file") || in.take_word("load_file")) {
            in.text();
        } else {
            break;
        }
    }
    in.finish();
    session.scene.settings.wants_photons = true;
    context.diagnostics->unsupported(block.where, "photons",
                                     "light goes straight through transparent objects");
}

void read_subsurface(Session& session, const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    while (!in.at_end()) {
        if (in.take_word("samples")) {
            in.integer();
            in.integer();
        } else if (in.take_word("radiosity")) {
            in.optional_switch();
        } else {
            break;
        }
    }
    in.finish();
    session.scene.settings.wants_subsurface = true;
    context.diagnostics->unsupported(block.where, "subsurface", "surfaces are lit at their outside only");
}

void read_charset(Session& session, BlockReader& in) {
    if (in.take_word("ascii")) {
        session.charset = Charset::ascii;
    } else if (in.take_word("utf8")) {
        session.charset = Charset::utf8;
    } else if (in.take_word("sys")) {
        session.charset = Charset::sys;
    } else {
        in.fail(fmt::format("Expected 'charset type', {} found instead", in.found()));
    }
}

bool take_number(Session& session, BlockReader& in) {
    GlobalSettings& settings = session.scene.settings;
    const SourceRange at = in.where();
    if (in.take_word("adc_bailout")) {
        settings.adc_bailout = static_cast<float>(in.number());
    } else if (in.take_word("max_trace_level")) {
        const int level = in.integer();
        if (level > 256) session.warn(at, "Maximum max_trace_level is 256; using 256.");
        settings.max_trace_level = std::clamp(level, 1, 256);
    } else if (in.take_word("max_intersections")) {
        in.number();
        session.warn(at, "'max_intersections' has no effect.");
    } else if (in.take_word("mm_per_unit")) {
        settings.mm_per_unit = in.number();
    } else if (in.take_word("noise_generator")) {
        session.set_noise_generator(in.integer());
        session.noise_generator_set = true;
        if (settings.noise_generator < 1 || settings.noise_generator > 3) {
            in.fail_at(at, "Value for noise_generator in global_settings must be 1, 2, or 3.");
        }
    } else if (in.take_word("number_of_waves")) {
        settings.number_of_waves = in.integer();
        if (settings.number_of_waves <= 0) {
            session.warn(at, "Illegal Value: number_of_waves must be at least 1.");
            settings.number_of_waves = 1;
        }
    } else if (in.take_word("hf_gray_16")) {
        in.optional_switch();
        session.warn(at, "hf_gray_16 is ignored: use the output options.");
    } else {
        return false;
    }
    return true;
}

}  // namespace

void read_global_settings(Session& session, const Block& block) {
    const ReadContext context = session.context();
    BlockReader in(block, context);
    GlobalSettings& settings = session.scene.settings;
    while (!in.at_end()) {
        if (in.take_word("assumed_gamma")) {
            read_assumed_gamma(session, in);
        } else if (in.take_word("ambient_light")) {
            settings.ambient_light = in.rgb_color();
        } else if (in.take_word("irid_wavelength")) {
            settings.irid_wavelength = in.rgb_color();
        } else if (in.take_word("charset")) {
            read_charset(session, in);
        } else if (in.at_block("radiosity")) {
            read_radiosity(session, in.block("radiosity"), context);
        } else if (in.at_block("photons")) {
            read_global_photons(session, in.block("photons"), context);
        } else if (in.at_block("subsurface")) {
            read_subsurface(session, in.block("subsurface"), context);
        } else if (!take_number(session, in)) {
            break;
        }
    }
    in.finish();
}

}  // namespace rb
