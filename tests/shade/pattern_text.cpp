#include "pattern_text.h"

#include "patterns/registry.h"

#include <cctype>
#include <cstdlib>

namespace rb {

namespace {

class Lexer {
public:
    explicit Lexer(const std::string& text) : text_(text) {}

    Block block(std::string keyword) {
        Block out;
        out.keyword = std::move(keyword);
        while (skip_blanks() && text_[at_] != '}') add_item(out);
        ++at_;
        return out;
    }

private:
    bool skip_blanks() {
        while (at_ < text_.size() &&
               (std::isspace(static_cast<unsigned char>(text_[at_])) || text_[at_] == ',')) {
            ++at_;
        }
        return at_ < text_.size();
    }
    std::string word() {
        const size_t start = at_;
        while (at_ < text_.size() &&
               (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_')) {
            ++at_;
        }
        return text_.substr(start, at_ - start);
    }
    double number() {
        char* end = nullptr;
        const double value = std::strtod(text_.c_str() + at_, &end);
        at_ = static_cast<size_t>(end - text_.c_str());
        return value;
    }
    void add_numbers(Block& out, const std::vector<double>& values) {
        Item item;
        item.kind = Item::Kind::numbers;
        item.first = static_cast<uint32_t>(out.numbers.size());
        item.count = 1;
        item.terms = static_cast<int>(values.size());
        out.numbers.insert(out.numbers.end(), values.begin(), values.end());
        out.items.push_back(std::move(item));
    }
    void add_item(Block& out) {
        if (text_[at_] == '<') {
            ++at_;
            std::vector<double> values;
            while (skip_blanks() && text_[at_] != '>') values.push_back(number());
            ++at_;
            return add_numbers(out, values);
        }
        if (!std::isalpha(static_cast<unsigned char>(text_[at_]))) return add_factor(out, number());
        const std::string name = word();
        if (name == "x" || name == "y" || name == "z") return add_axis(out, name, 1.0);
        Item item;
        item.text = name;
        if (skip_blanks() && text_[at_] == '{') {
            ++at_;
            item.kind = Item::Kind::block;
            item.block = std::make_shared<Block>(block(name));
        }
        out.items.push_back(std::move(item));
    }
    /// `1.5*x`, `z*45` or a plain number.
    void add_factor(Block& out, double value) {
        if (at_ >= text_.size() || text_[at_] != '*') return add_numbers(out, {value});
        ++at_;
        add_axis(out, word(), value);
    }
    void add_axis(Block& out, const std::string& axis, double value) {
        if (at_ < text_.size() && text_[at_] == '*') {
            ++at_;
            value *= number();
        }
        add_numbers(out, {axis == "x" ? value : 0.0, axis == "y" ? value : 0.0, axis == "z" ? value : 0.0});
    }

    const std::string& text_;
    size_t at_ = 0;
};

void read_turbulence(BlockReader& in, TurbulenceWarp& t) {
    if (in.take_word("octaves")) {
        t.octaves = in.integer();
    } else if (in.take_word("omega")) {
        t.omega = static_cast<float>(in.number());
    } else if (in.take_word("lambda")) {
        t.lambda = static_cast<float>(in.number());
    } else {
        in.finish();
    }
}

Warp read_repeat(BlockReader& in) {
    RepeatWarp warp;
    const Vec3 step = in.vec3();
    while (warp.axis < 2 && step[warp.axis] == 0.0) ++warp.axis;
    warp.width = static_cast<float>(step[warp.axis]);
    while (!in.at_end()) {
        if (in.take_word("offset")) {
            warp.offset = in.vec3();
        } else if (in.take_word("flip")) {
            const Vec3 flip = in.vec3();
            for (int i = 0; i < 3; ++i) warp.flip[i] = flip[i] != 0.0 ? -1.0 : 1.0;
        } else {
            in.finish();
        }
    }
    return warp;
}

Warp read_black_hole(BlockReader& in) {
    BlackHoleWarp hole;
    hole.center = in.vec3();
    hole.radius = in.number();
    while (!in.at_end()) {
        if (in.take_word("strength")) {
            hole.strength = in.number();
        } else if (in.take_word("falloff")) {
            hole.falloff = in.number();
        } else if (in.take_word("inverse")) {
            hole.inverse = true;
        } else if (in.take_word("repeat")) {
            hole.repeat = in.vec3();
        } else if (in.take_word("turbulence")) {
            hole.turbulence = in.vec3();
        } else {
            in.finish();
        }
    }
    for (int i = 0; i < 3; ++i) {
        if (hole.repeat[i] <= 0.0) continue;
        hole.center[i] = std::max(hole.center[i], hole.radius);
        hole.repeat[i] = std::max(hole.repeat[i], hole.center[i] + hole.radius + hole.turbulence[i]);
    }
    return hole;
}

Warp read_mapping(BlockReader& in, Mapping kind) {
    MappingWarp warp;
    warp.kind = kind;
    if (kind == Mapping::planar && in.at_number()) {
        warp.orientation = in.vec3();
        warp.offset = in.number();
    }
    while (!in.at_end()) {
        if (in.take_word("orientation")) {
            warp.orientation = in.vec3();
        } else if (in.take_word("dist_exp")) {
            warp.dist_exp = in.number();
        } else if (in.take_word("major_radius")) {
            warp.major_radius = in.number();
        } else {
            in.finish();
        }
    }
    return warp;
}

Warp read_warp(BlockReader& in) {
    if (in.take_word("repeat")) return read_repeat(in);
    if (in.take_word("black_hole")) return read_black_hole(in);
    if (in.take_word("turbulence")) {
        TurbulenceWarp t;
        t.amount = in.vec3();
        while (!in.at_end()) read_turbulence(in, t);
        return t;
    }
    if (in.take_word("cylindrical")) return read_mapping(in, Mapping::cylindrical);
    if (in.take_word("spherical")) return read_mapping(in, Mapping::spherical);
    if (in.take_word("toroidal")) return read_mapping(in, Mapping::toroidal);
    if (in.take_word("planar")) return read_mapping(in, Mapping::planar);
    if (in.take_word("cubic")) return CubicWarp{};
    in.fail("unknown warp");
}

TurbulenceWarp& classic_of(PatternModifiers& m) {
    if (!m.classic_turbulence()) {
        TurbulenceWarp t;
        t.classic = true;
        m.warps.emplace_back(t);
    }
    return std::get<TurbulenceWarp>(m.warps.back());
}

bool read_wave(BlockReader& in, PatternModifiers& m) {
    constexpr std::pair<const char*, Wave> waves[] = {
        {"ramp_wave", Wave::ramp},       {"triangle_wave", Wave::triangle}, {"sine_wave", Wave::sine},
        {"scallop_wave", Wave::scallop}, {"cubic_wave", Wave::cubic},       {"poly_wave", Wave::poly}};
    for (const auto& [name, wave] : waves) {
        if (!in.take_word(name)) continue;
        m.wave = wave;
        if (wave == Wave::poly && in.at_number()) m.poly_exponent = static_cast<float>(in.number());
        return true;
    }
    return false;
}

void read_modifier(BlockReader& in, WrittenPattern& out) {
    PatternModifiers& m = out.modifiers;
    if (read_wave(in, m)) return;
    if (in.take_word("scale")) {
        m = transformed(m, Transform::scaling(in.vec3()));
    } else if (in.take_word("rotate")) {
        m = transformed(m, Transform::rotation_deg(in.vec3()));
    } else if (in.take_word("translate")) {
        m = transformed(m, Transform::translation(in.vec3()));
    } else if (in.at_block("warp")) {
        BlockReader inner(in.block("warp"), in.context());
        m.warps.insert(m.warps.begin(), read_warp(inner));
    } else if (in.take_word("turbulence")) {
        classic_of(m).amount = in.vec3();
    } else if (in.take_word("frequency")) {
        m.frequency = static_cast<float>(in.number());
    } else if (in.take_word("phase")) {
        m.phase = static_cast<float>(in.number());
    } else if (in.take_word("noise_generator")) {
        m.noise_generator = in.integer();
    } else if (in.take_word("agate_turb")) {
        m.agate_turbulence = static_cast<float>(in.number());
    } else if (in.take_word("accuracy")) {
        out.accuracy = static_cast<float>(in.number());
    } else if (in.take_word("no_bump_scale")) {
        out.no_bump_scale = true;
    } else {
        read_turbulence(in, classic_of(m));
    }
}

}  // namespace

Block block_of(const std::string& text) { return Lexer(text).block("pattern"); }

WrittenPattern pattern_of(const std::string& text) {
    const Block block = block_of(text);
    Diagnostics diagnostics;
    ReadContext context;
    context.diagnostics = &diagnostics;
    BlockReader in(block, context);
    const PatternKind* kind = find_pattern(in.peek_word());
    if (!kind) in.fail("no pattern");
    if (in.at_word()) in.word();
    WrittenPattern out;
    out.pattern = kind->read(in);
    out.modifiers.wave = kind->default_wave;
    out.modifiers.frequency = kind->default_frequency;
    if (in.at_number()) out.amount = static_cast<float>(in.number());
    while (!in.at_end()) {
        PatternPtr changed = kind->read_parameter ? kind->read_parameter(in, out.pattern) : nullptr;
        if (changed) {
            out.pattern = std::move(changed);
        } else {
            read_modifier(in, out);
        }
    }
    return out;
}

}  // namespace rb
