// photons { } of global_settings, lights and objects. Language spec 20.2, 21, geometry 3.7.
#include "language/find_file.h"
#include "language/read.h"

#include <algorithm>

#include <fmt/format.h>

namespace rb {

namespace {

void take_gather(BlockReader& in, PhotonSettings& photons) {
    const SourceRange at = in.where();
    photons.gather_min = in.integer();
    photons.gather_max = in.integer();
    if (photons.gather_min < 0) in.fail_at(at, "min_gather_count cannot be negative.");
    if (photons.gather_max < 0) in.fail_at(at, "max_gather_count cannot be negative.");
    if (photons.gather_max != 0 && photons.gather_min > photons.gather_max) {
        in.fail_at(at, "min_gather_count must be less than max_gather_count.");
    }
}

void take_media(BlockReader& in, PhotonSettings& photons) {
    const SourceRange at = in.where();
    photons.media_steps = in.integer();
    if (photons.media_steps < 0) in.fail_at(at, "max media steps must be non-negative.");
    if (!in.at_number()) return;
    const SourceRange factor = in.where();
    photons.media_factor = in.number();
    if (!(photons.media_factor > 0)) in.fail_at(factor, "media spacing factor must be greater than zero.");
}

double take_threshold(BlockReader& in, std::string_view which) {
    const SourceRange at = in.where();
    const double value = in.number();
    if (value >= 0) return value;
    in.diagnostics().warning(
        at, fmt::format("The {} number of expand_thresholds is negative: taken as 0.", which));
    return 0;
}

/// Each of the four may be left out, before its comma or at the end.
void take_radius(BlockReader& in, PhotonSettings& photons) {
    for (double* value :
         {&photons.surface_radius.radius, &photons.surface_radius.multiplier, &photons.media_radius.radius}) {
        if (in.at_number()) {
            *value = in.number();
        } else if (!in.take_comma()) {
            return;
        }
    }
    if (in.at_number()) photons.media_radius.multiplier = in.number();
}

bool take_setting(BlockReader& in, PhotonSettings& photons) {
    const SourceRange at = in.where();
    if (in.take_word("spacing")) {
        photons.spacing = in.number();
    } else if (in.take_word("count")) {
        photons.count = in.integer();
    } else if (in.take_word("gather")) {
        take_gather(in, photons);
    } else if (in.take_word("media")) {
        take_media(in, photons);
    } else if (in.take_word("radius")) {
        take_radius(in, photons);
    } else if (in.take_word("jitter")) {
        photons.jitter = in.number();
    } else if (in.take_word("autostop")) {
        photons.autostop = in.number();
    } else if (in.take_word("expand_thresholds")) {
        photons.expand_increase = take_threshold(in, "first");
        photons.expand_count = take_threshold(in, "second");
    } else if (in.take_word("max_trace_level")) {
        photons.max_trace_level = in.integer();
    } else if (in.take_word("adc_bailout")) {
        photons.adc_bailout = in.number();
    } else if (in.take_word("save_file")) {
        photons.save_file = in.file_name();
        check_may_write(*in.context().session, photons.save_file, at);
    } else if (in.take_word("load_file")) {
        const std::string name = in.file_name();
        const auto found = find_file(*in.context().session, name, SoughtFile::data, at);
        if (!found) {
            throw missing_file(*in.context().session, name, SoughtFile::data, at,
                               fmt::format("Could not load photon map ({})", name));
        }
        photons.load_file = *found;
    } else {
        return false;
    }
    return true;
}

PhotonSwitch take_switch(BlockReader& in) { return in.number() > 0 ? PhotonSwitch::on : PhotonSwitch::off; }

bool take_ways(BlockReader& in, PhotonWays& ways) {
    if (in.take_word("refraction")) {
        ways.refraction = take_switch(in);
    } else if (in.take_word("reflection")) {
        ways.reflection = take_switch(in);
    } else {
        return false;
    }
    return true;
}

/// Photons cannot both go straight through a target and be bent by it: the word that was just read decides.
void settle(ObjectPhotons& photons, SourceRange at, bool keeps_refraction, Diagnostics& diagnostics) {
    if (!photons.pass_through || photons.target == 0.0f || photons.ways.refraction == PhotonSwitch::off)
        return;
    diagnostics.warning(
        at, fmt::format("A target cannot both refract photons and let them pass_through: {} is off.",
                        keeps_refraction ? "pass_through" : "refraction"));
    if (keeps_refraction) {
        photons.pass_through = false;
    } else {
        photons.ways.refraction = PhotonSwitch::off;
    }
}

}  // namespace

void read_object_photons(const Block& block, const ReadContext& context, ObjectPhotons& photons) {
    BlockReader in(block, context);
    while (!in.at_end()) {
        const SourceRange at = in.where();
        if (in.take_word("target")) {
            photons.target = std::max(0.0f, in.at_number() ? static_cast<float>(in.number()) : 1.0f);
            settle(photons, at, photons.ways.refraction == PhotonSwitch::on, in.diagnostics());
        } else if (in.take_word("pass_through")) {
            photons.pass_through = in.optional_switch();
            settle(photons, at, false, in.diagnostics());
        } else if (in.take_word("collect")) {
            photons.collect = in.optional_switch();
        } else if (take_ways(in, photons.ways)) {
            if (photons.ways.refraction == PhotonSwitch::on) settle(photons, at, true, in.diagnostics());
        } else {
            break;
        }
    }
    in.finish();
}

void read_light_photons(const Block& block, const ReadContext& context, LightPhotons& photons) {
    BlockReader in(block, context);
    while (!in.at_end()) {
        if (in.take_word("area_light")) {
            photons.from_area = true;
        } else if (!take_ways(in, photons.ways)) {
            break;
        }
    }
    in.finish();
}

void read_global_photons(Session& session, const Block& block) {
    const ReadContext context = session.context();
    BlockReader in(block, context);
    PhotonSettings photons;
    photons.where = block.where;
    while (!in.at_end() && take_setting(in, photons)) {
    }
    in.finish();
    if (!photons.save_file.empty() && !photons.load_file.empty()) {
        session.warn(block.where, "A photon map cannot be both loaded and saved: it is loaded.");
        photons.save_file.clear();
    }
    auto& settings = session.scene.settings;
    settings.photons.reset();
    if (photons.gather_max == 0) {
        session.warn(block.where, "There are no photons, as none are to be gathered.");
        return;
    }
    settings.photons = std::move(photons);
}

}  // namespace rb
