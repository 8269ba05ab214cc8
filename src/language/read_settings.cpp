// global_settings. Language spec 21.
#include "language/read.h"

#include <algorithm>
#include <array>
#include <map>

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

/// What a number of radiosity must be. Both ends belong to the range, but for a low end of `above`.
struct RadiosityNumber {
    std::string_view word;
    std::string_view error;
    double low = -infinity;
    double high = infinity;
    bool above = false;
};
constexpr std::array<RadiosityNumber, 15> radiosity_numbers{
    {{"adc_bailout", "ADC Bailout must be a positive number.", 0, infinity, true},
     {"always_sample", ""},
     {"brightness", "Radiosity brightness must be a positive number.", 0, infinity, true},
     {"error_bound", "Radiosity error bound must be a positive number.", 0, infinity, true},
     {"gray_threshold", "Radiosity gray threshold must be from 0.0 to 1.0.", 0, 1},
     {"low_error_factor", "Radiosity low error factor must be a positive number.", 0, infinity, true},
     {"max_sample", ""},
     {"maximum_reuse", "Radiosity maximum reuse must be a positive number.", 0, infinity, true},
     {"minimum_reuse", "Radiosity minimum reuse can not be a negative number.", 0},
     {"normal", ""},
     {"media", ""},
     {"subsurface", ""},
     {"pretrace_start", "Radiosity pretrace start must be greater than 0 and no higher than 1.", 0, 1, true},
     {"pretrace_end", "Radiosity pretrace end must be greater than 0 and no higher than 1.", 0, 1, true},
     {"recursion_limit", "Radiosity recursion limit must be in the range 1 to 20.", 1, 20}}};

double take_radiosity_number(BlockReader& in, const RadiosityNumber& number) {
    in.skip_item();
    const SourceRange at = in.where();
    const double value = in.number();
    const bool low_enough = value <= number.high;
    const bool high_enough = number.above ? value > number.low : value >= number.low;
    if (!low_enough || !high_enough) in.fail_at(at, std::string(number.error));
    return value;
}

int take_radiosity_count(BlockReader& in) {
    const SourceRange at = in.where();
    const int count = in.integer();
    if (count < 1) in.fail_at(at, "Radiosity count must be a positive number.");
    if (!in.at_number()) return count;
    const SourceRange pool = in.where();
    if (in.integer() < count) {
        in.fail_at(pool, "Radiosity count can not be more than direction pool size (count 2nd value).");
    }
    return count;
}

int take_nearest_count(BlockReader& in) {
    const SourceRange at = in.where();
    const int count = in.integer();
    if (count < 1 || count > 20) in.fail_at(at, "Radiosity nearest count must be a value from 1 to 20.");
    if (!in.at_number()) return count;
    const SourceRange second = in.where();
    const int adaptive = in.integer();
    if (adaptive >= 0 && adaptive < count) return count;
    in.fail_at(second,
               "Radiosity nearest count for adaptive pretrace must be non-negative and smaller than general "
               "nearest count.");
}

/// What holds between the numbers of a block (language spec 21).
void check_together(const BlockReader& in, const std::map<std::string_view, double>& given) {
    const auto value = [&given](std::string_view word, double usual) {
        const auto at = given.find(word);
        return at == given.end() ? usual : at->second;
    };
    if (value("pretrace_end", 0.04) > value("pretrace_start", 0.08)) {
        in.fail_at(in.block_where(),
                   "Radiosity pretrace end must be smaller than or equal to pretrace start.");
    }
    const bool both = given.contains("minimum_reuse") && given.contains("maximum_reuse");
    const double least = value("minimum_reuse", 0.015);
    const double most = value("maximum_reuse", 0.2);
    if (both && least >= most) {
        in.fail_at(in.block_where(), "Radiosity maximum_reuse must be larger than minimum_reuse.");
    }
    if (least > most / 2) {
        in.diagnostics().warning(
            in.block_where(), "Radiosity maximum_reuse should be significantly larger than minimum_reuse.");
    }
}

/// Takes over what was given. A reuse that was left out keeps its distance from the other one.
void put_together(const std::map<std::string_view, double>& given, RadiositySettings& settings) {
    const auto put = [&given](std::string_view word, auto& value) {
        const auto at = given.find(word);
        if (at != given.end()) value = static_cast<std::decay_t<decltype(value)>>(at->second);
    };
    put("adc_bailout", settings.adc_bailout);
    put("always_sample", settings.always_sample);
    put("brightness", settings.brightness);
    put("error_bound", settings.error_bound);
    put("gray_threshold", settings.gray_threshold);
    put("low_error_factor", settings.low_error_factor);
    put("max_sample", settings.max_sample);
    put("maximum_reuse", settings.maximum_reuse);
    put("minimum_reuse", settings.minimum_reuse);
    put("normal", settings.normal);
    put("media", settings.media);
    put("subsurface", settings.subsurface);
    put("pretrace_start", settings.pretrace_start);
    put("pretrace_end", settings.pretrace_end);
    put("recursion_limit", settings.recursion_limit);
    if (settings.minimum_reuse <= settings.maximum_reuse / 2) return;
    if (!given.contains("minimum_reuse")) settings.minimum_reuse = settings.maximum_reuse / 2;
    if (!given.contains("maximum_reuse")) settings.maximum_reuse = settings.minimum_reuse * 2;
}

void read_radiosity(Session& session, const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    RadiositySettings settings;
    std::map<std::string_view, double> given;
    while (!in.at_end()) {
        const std::string_view word = in.at_word() ? in.peek_word() : std::string_view{};
        const auto* number = std::ranges::find(radiosity_numbers, word, &RadiosityNumber::word);
        if (number != radiosity_numbers.end()) {
            given[number->word] = take_radiosity_number(in, *number);
        } else if (in.take_word("count")) {
            settings.count = take_radiosity_count(in);
        } else if (in.take_word("nearest_count")) {
            settings.nearest_count = take_nearest_count(in);
        } else if (in.at_word("load_file") || in.at_word("save_file")) {
            session.warn(in.where(), "load_file and save_file of radiosity are ignored.");
            in.skip_item();
            in.text();
        } else {
            break;
        }
    }
    in.finish();
    check_together(in, given);
    put_together(given, settings);
    session.scene.settings.radiosity = settings;
}

void read_subsurface(Session& session, const Block& block, const ReadContext& context) {
    BlockReader in(block, context);
    SubsurfaceSettings& settings = session.scene.settings.subsurface.emplace();
    const auto count = [&] { return std::clamp(in.integer(), 1, 1 << 20); };
    while (!in.at_end()) {
        if (in.take_word("samples")) {
            settings.diffuse_samples = count();
            settings.single_samples = count();
        } else if (in.at_word("radiosity")) {
            const SourceRange where = in.where();
            in.skip_item();
            if (in.optional_switch())
                context.diagnostics->unsupported(where, "radiosity of subsurface",
                                                 "lights alone shine into bodies");
        } else {
            break;
        }
    }
    in.finish();
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
            read_global_photons(session, in.block("photons"));
        } else if (in.at_block("subsurface")) {
            read_subsurface(session, in.block("subsurface"), context);
        } else if (!take_number(session, in)) {
            break;
        }
    }
    in.finish();
}

}  // namespace rb
