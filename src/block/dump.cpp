#include "block/block.h"

#include <fmt/format.h>

namespace rb {

namespace {

std::string numbers_text(const Block& block, const Item& item) {
    std::string out;
    const auto width = static_cast<size_t>(item.terms);
    for (size_t i = 0; i < item.count; ++i) {
        if (i > 0) out += ' ';
        const size_t start = item.first + i * width;
        if (width == 1) {
            out += fmt::format("{:.10g}", block.numbers[start]);
            continue;
        }
        out += '<';
        for (size_t k = 0; k < width; ++k)
            out += fmt::format("{}{:.10g}", k ? "," : "", block.numbers[start + k]);
        out += '>';
    }
    return out;
}

std::string color_text(const WrittenColor& color) {
    std::string out = "color";
    if (color.has_base) {
        out +=
            color.bare ? " " : fmt::format(" rgb{}{} ", color.word_terms, color.transmit_fourth ? "t" : "");
        out += '<';
        for (size_t i = 0; i < static_cast<size_t>(color.base.count); ++i) {
            out += fmt::format("{}{:.10g}", i ? "," : "", color.base.v[i]);
        }
        out += '>';
    }
    constexpr std::array<std::string_view, 5> names{"red", "green", "blue", "filter", "transmit"};
    for (size_t i = 0; i < 5; ++i) {
        if (color.set[i]) out += fmt::format(" {} {:.10g}", names[i], *color.set[i]);
    }
    return out;
}

struct ThingName {
    std::string operator()(std::monostate) const { return "undeclared identifier"; }
    std::string operator()(const ObjectPtr&) const { return "object identifier"; }
    std::string operator()(const TexturePtr&) const { return "texture identifier"; }
    std::string operator()(const PigmentPtr&) const { return "pigment identifier"; }
    std::string operator()(const NormalPtr&) const { return "normal identifier"; }
    std::string operator()(const FinishPtr&) const { return "finish identifier"; }
    std::string operator()(const InteriorPtr&) const { return "interior identifier"; }
    std::string operator()(const std::shared_ptr<const Material>&) const { return "material identifier"; }
    std::string operator()(const std::shared_ptr<const Camera>&) const { return "camera identifier"; }
    std::string operator()(const std::shared_ptr<const Transform>&) const { return "transform identifier"; }
    std::string operator()(const std::shared_ptr<const ColorMap>&) const { return "color_map identifier"; }
    std::string operator()(const PigmentMapPtr&) const { return "pigment_map identifier"; }
    std::string operator()(const NormalMapPtr&) const { return "normal_map identifier"; }
    std::string operator()(const TextureMapPtr&) const { return "texture_map identifier"; }
    std::string operator()(const SlopeMapPtr&) const { return "slope_map identifier"; }
    std::string operator()(const std::shared_ptr<const Fog>&) const { return "fog identifier"; }
    std::string operator()(const std::shared_ptr<const SkySphere>&) const { return "sky_sphere identifier"; }
    std::string operator()(const std::shared_ptr<const Rainbow>&) const { return "rainbow identifier"; }
    std::string operator()(const FunctionPtr& f) const {
        return f && f->result_count() > 1 ? "vector function identifier" : "float function identifier";
    }
    std::string operator()(const MediaPtr&) const { return "media identifier"; }
    std::string operator()(const DensityPtr&) const { return "density identifier"; }
    std::string operator()(const DensityMapPtr&) const { return "density_map identifier"; }
};

}  // namespace

std::string kind_name(const Thing& thing) { return std::visit(ThingName{}, thing); }

std::string dump(const Block& block, int indent) {
    const std::string pad(static_cast<size_t>(indent) * 2, ' ');
    std::string out = fmt::format("{}{} {{\n", pad, block.keyword);
    for (const Item& item : block.items) {
        switch (item.kind) {
            case Item::Kind::word:
                out += fmt::format("{}  word {}\n", pad, item.text);
                break;
            case Item::Kind::numbers:
                out += fmt::format("{}  numbers {}\n", pad, numbers_text(block, item));
                break;
            case Item::Kind::color:
                out += fmt::format("{}  {}\n", pad, color_text(*item.color));
                break;
            case Item::Kind::text:
                out += fmt::format("{}  text \"{}\"\n", pad, item.text);
                break;
            case Item::Kind::thing:
                out += fmt::format("{}  identifier {}\n", pad, item.text);
                break;
            case Item::Kind::block:
                out += dump(*item.block, indent + 1);
                break;
            case Item::Kind::bad:
                out += fmt::format("{}  unexpected {}\n", pad, item.text);
                break;
        }
    }
    return out + pad + "}\n";
}

}  // namespace rb
