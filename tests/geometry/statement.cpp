#include "tests/geometry/statement.h"

#include "block/reader.h"
#include "shapes/registry.h"

#include <cctype>
#include <cstdlib>
#include <stdexcept>

namespace rb {

namespace {

class Parser {
public:
    explicit Parser(std::string_view text) : text_(text) {}

    std::shared_ptr<const Block> block() {
        auto out = std::make_shared<Block>();
        out->keyword = word();
        expect('{');
        while (!take('}')) item(*out);
        return out;
    }

private:
    void skip() {
        while (at_ < text_.size() &&
               (std::isspace(static_cast<unsigned char>(text_[at_])) || text_[at_] == ','))
            ++at_;
    }
    char peek() {
        skip();
        return at_ < text_.size() ? text_[at_] : '\0';
    }
    bool take(char c) {
        if (peek() != c) return false;
        ++at_;
        return true;
    }
    void expect(char c) {
        if (!take(c)) throw std::runtime_error("expected " + std::string(1, c) + " in " + std::string(text_));
    }
    std::string word() {
        skip();
        std::string out;
        while (at_ < text_.size() &&
               (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_')) {
            out += text_[at_++];
        }
        if (out.empty()) throw std::runtime_error("expected a word in " + std::string(text_));
        return out;
    }
    double number() {
        skip();
        const std::string rest(text_.substr(at_, 64));
        char* end = nullptr;
        const double value = std::strtod(rest.c_str(), &end);
        if (end == rest.c_str()) throw std::runtime_error("expected a number in " + std::string(text_));
        at_ += static_cast<size_t>(end - rest.c_str());
        return value;
    }
    void add(Block& block, const std::vector<double>& terms) {
        const int n = static_cast<int>(terms.size());
        const bool joins = !block.items.empty() && block.items.back().kind == Item::Kind::numbers &&
                           block.items.back().terms == n;
        if (!joins) {
            Item item;
            item.kind = Item::Kind::numbers;
            item.first = static_cast<uint32_t>(block.numbers.size());
            item.terms = n;
            block.items.push_back(item);
        }
        ++block.items.back().count;
        block.numbers.insert(block.numbers.end(), terms.begin(), terms.end());
    }
    void item(Block& block) {
        const char c = peek();
        if (c == '\0') throw std::runtime_error("unfinished " + std::string(text_));
        if (std::isalpha(static_cast<unsigned char>(c))) return word_item(block);
        std::vector<double> terms;
        if (take('<')) {
            while (!take('>')) terms.push_back(number());
        } else {
            terms.push_back(number());
        }
        add(block, terms);
    }
    void word_item(Block& block) {
        const size_t start = at_;
        Item item;
        item.text = word();
        if (item.text == "x" || item.text == "y" || item.text == "z") {
            return add(block, {item.text == "x" ? 1.0 : 0.0, item.text == "y" ? 1.0 : 0.0,
                               item.text == "z" ? 1.0 : 0.0});
        }
        if (peek() == '{') {
            at_ = start;
            item.kind = Item::Kind::block;
            item.block = this->block();
        }
        block.items.push_back(std::move(item));
    }

    std::string_view text_;
    size_t at_ = 0;
};

ObjectPtr read_object(const Block& block);

void read_list(const Block& block, std::vector<ObjectPtr>& out) {
    for (const Item& item : block.items) out.push_back(read_object(*item.block));
}

void read_modifiers(BlockReader& in, Object& object) {
    while (!in.at_end()) {
        if (in.at_any_block()) {
            const std::string keyword(in.peek_word());
            const Block& inner = in.block(keyword);
            read_list(inner, keyword == "clipped_by" ? object.clipped_by : object.bounded_by);
            continue;
        }
        const std::string_view word = in.word();
        if (word == "translate") {
            transform_object(object, Transform::translation(in.vec3()));
        } else if (word == "rotate") {
            transform_object(object, Transform::rotation_deg(in.vec3()));
        } else if (word == "scale") {
            transform_object(object, Transform::scaling(in.vec3()));
        } else if (word == "matrix") {
            const Vec3 a = in.vec3(), b = in.vec3(), c = in.vec3(), d = in.vec3();
            transform_object(object, *Transform::from_matrix({{a, b, c, d}}));
        } else if (word == "inverse") {
            object.inverse = !object.inverse;
        } else if (word == "no_shadow") {
            object.no_shadow = true;
        } else if (word == "no_image") {
            object.no_image = true;
        } else if (word == "no_split") {
            std::get<Csg>(object.geometry).split_union = false;
        } else {
            in.fail("unknown modifier " + std::string(word));
        }
    }
}

ObjectPtr read_object(const Block& block) {
    Diagnostics diagnostics;
    ReadContext context;
    context.diagnostics = &diagnostics;
    BlockReader in(block, context);
    auto object = std::make_shared<Object>();
    if (const ShapeKind* kind = find_shape(block.keyword)) {
        object->geometry = kind->read(in);
    } else {
        Csg csg;
        csg.kind = block.keyword == "merge"          ? CsgKind::merge
                   : block.keyword == "intersection" ? CsgKind::intersection
                   : block.keyword == "difference"   ? CsgKind::difference
                                                     : CsgKind::union_;
        std::vector<ObjectPtr> children;
        while (in.at_any_block() && !in.at_block("clipped_by") && !in.at_block("bounded_by")) {
            children.push_back(read_object(in.block(in.peek_word())));
        }
        csg.children = std::make_shared<std::vector<ObjectPtr>>(std::move(children));
        object->geometry = std::move(csg);
    }
    read_modifiers(in, *object);
    return object;
}

}  // namespace

std::shared_ptr<const Block> block_from(std::string_view text) { return Parser(text).block(); }

ObjectPtr object_from(std::string_view text) { return read_object(*block_from(text)); }

TexturePtr plain_texture() {
    auto pigment = std::make_shared<Pigment>();
    Texture layer;
    layer.pigment = std::move(pigment);
    layer.finish = std::make_shared<Finish>();
    return std::make_shared<TextureLayers>(TextureLayers{std::move(layer)});
}

}  // namespace rb
