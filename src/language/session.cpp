#include "language/session.h"

#include "base/whole_file.h"
#include "language/builtins.h"
#include "language/find_file.h"
#include "language/open_file.h"
#include "language/read.h"

#include <filesystem>
#include <fstream>

#include <fmt/format.h>

namespace rb {

ReadContext Session::context() {
    ReadContext context;
    context.diagnostics = &diagnostics;
    context.default_texture = default_texture;
    context.settings = &scene.settings;
    context.language_version = language_version;
    context.effective_version = effective_version();
    context.session = this;
    context.read_pigment = [](const Block& block, const ReadContext& c) {
        return read_pigment(block, c, c.default_texture->front().pigment);
    };
    context.read_texture = [](const Block& block, const ReadContext& c) { return read_texture(block, c); };
    context.read_object = [](const Block& block, const ReadContext& c) { return read_object(block, c); };
    context.take_transformation = take_transformation;
    context.take_texture = take_texture;
    context.take_image = take_image;
    context.find_font = [](const ReadContext& c, const std::string& name,
                           SourceRange where) -> const FontFile& {
        return c.session->font_file(name, where);
    };
    context.density_file = [](const ReadContext& c, const std::string& name, SourceRange where) {
        const auto path = find_file(*c.session, name, SoughtFile::df3, where);
        if (!path)
            throw missing_file(*c.session, name, SoughtFile::df3, where,
                               fmt::format("Cannot open density file {}.", name));
        if (auto bytes = c.session->density_bytes(*path)) return bytes;
        throw SceneError(where, fmt::format("Cannot read density file {}.", *path));
    };
    context.found_value = [](const ReadContext& c, SourceRange where) {
        return found_value(*c.session, where);
    };
    context.unicode = charset != Charset::ascii;
    return context;
}

void Session::note_writing() {
    has_written = true;
    density_files.clear();
    if (options.images) options.images->forget();
}

TokenFilePtr Session::tokens_of(const std::string& path) {
    const auto known = files.find(path);
    if (known != files.end() && !has_written) return known->second;
    std::optional<std::string> text = read_whole_file(path);
    if (!text) throw IoError(fmt::format("Cannot read file {}.", path));
    if (known != files.end() && known->second->text == *text) return known->second;
    const uint32_t number = sources.add(path, std::move(*text));
    LexOptions lexing;
    lexing.runs = options.number_runs;
    lexing.quick = options.quick_expressions;
    TokenFilePtr tokens = lex(number, sources.text(number), words, lexing);
    files.insert_or_assign(path, tokens);
    return tokens;
}

std::shared_ptr<const std::string> Session::density_bytes(const std::string& path) {
    std::weak_ptr<const std::string>& known = density_files[path];
    if (auto bytes = known.lock()) return bytes;
    std::optional<std::string> read = read_whole_file(path);
    if (!read) return nullptr;
    auto bytes = std::make_shared<const std::string>(std::move(*read));
    known = bytes;
    return bytes;
}

const FontFile& Session::font_file(const std::string& name, SourceRange where) {
    if (const auto known = font_files.find(name); known != font_files.end()) return known->second;
    const auto path = find_file(*this, name, SoughtFile::font, where);
    std::optional<std::string> bytes;
    if (path) bytes = read_whole_file(*path);
    if (!bytes) throw missing_file(*this, name, SoughtFile::font, where, "Cannot open font file.");
    FontFile file{*path, std::make_shared<const std::string>(std::move(*bytes))};
    return font_files.emplace(name, std::move(file)).first->second;
}

std::string Session::hint(std::string_view word) const {
    if (word.size() < 3) return {};
    std::vector<std::string_view> candidates;
    for (uint32_t visible : symbols.visible()) candidates.push_back(words.spelling(visible));
    for (std::string_view spelling : keyword_spellings) candidates.push_back(spelling);
    // Every short word is close to another: only swapped letters are a mistake.
    if (word.size() == 3) {
        std::erase_if(candidates, [&](std::string_view candidate) {
            return !std::is_permutation(word.begin(), word.end(), candidate.begin(), candidate.end());
        });
    }
    const std::string_view close = closest_word(word, candidates);
    return close.empty() ? "" : fmt::format(" (did you mean '{}'?)", close);
}

namespace {

bool is_vector_word(Keyword word) {
    switch (word) {
        case Keyword::x:
        case Keyword::y:
        case Keyword::z:
        case Keyword::t:
        case Keyword::u:
        case Keyword::v:
        case Keyword::vcross:
        case Keyword::vnormalize:
        case Keyword::vrotate:
        case Keyword::vaxis_rotate:
        case Keyword::vturbulence:
        case Keyword::trace:
        case Keyword::min_extent:
        case Keyword::max_extent:
            return true;
        default:
            return false;
    }
}

bool is_string_word(Keyword word) {
    switch (word) {
        case Keyword::chr:
        case Keyword::concat:
        case Keyword::str:
        case Keyword::vstr:
        case Keyword::substr:
        case Keyword::strupr:
        case Keyword::strlwr:
        case Keyword::datetime:
            return true;
        default:
            return false;
    }
}

std::string name_text(const Value& value) {
    std::string kind = kind_name(value);
    if (const auto* terms = std::get_if<Terms>(&value)) {
        return fmt::format("{} function '{}'", terms->count == 1 ? "float" : "vector", kind);
    }
    return kind;
}

}  // namespace

std::string found_text(const Session& session, const Produced& token) {
    switch (token.kind) {
        case Tok::end:
            return "End of File";
        case Tok::number:
            return "float function 'float constant'";
        case Tok::text:
            return "string literal";
        case Tok::undeclared:
            return fmt::format("undeclared identifier '{}'", session.words.spelling(token.word));
        case Tok::name:
            return name_text(token.place.value());
        case Tok::constant:
        case Tok::call_one:
        case Tok::call_many:
        case Tok::defined: {
            const auto word = static_cast<Keyword>(token.word);
            if (is_string_word(word)) return std::string(session.words.spelling(token.word));
            return fmt::format("{} function '{}'", is_vector_word(word) ? "vector" : "float",
                               session.words.spelling(token.word));
        }
        case Tok::color:
        case Tok::rgb:
        case Tok::component:
            return fmt::format("color keyword '{}'", session.words.spelling(token.word));
        case Tok::run:
            return "<";
        default: {
            const std::string_view text = session.text_of(token.where);
            return std::string(text.substr(0, 40));
        }
    }
}

std::string found_value(Session& session, SourceRange where) {
    const std::string_view text = session.text_of(where);
    if (text.empty()) return {};
    const char c = text[0];
    if (!(c == '_' || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z')))
        return c == '<' ? "<" : std::string{};
    const size_t size =
        text.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
    const uint32_t word = session.words.number(text.substr(0, size));
    Produced token{Tok::word, word, 0, where, {}};
    if (Words::is_keyword(word)) {
        token.kind = Words::kind(word);
        return token.kind == Tok::keyword ? std::string{} : found_text(session, token);
    }
    token.place = session.symbols.find_place(word);
    return token.place.known() ? name_text(token.place.value()) : std::string{};
}

double to_float(const Operand& operand) {
    const Terms* terms = operand.terms();
    if (!terms) {
        const bool text = std::holds_alternative<std::string>(operand.value);
        throw SceneError(operand.where, fmt::format("Expected 'numeric expression', {} found instead",
                                                    text ? "string" : kind_name(operand.value)));
    }
    if (terms->count != 1)
        throw SceneError(operand.where, "Float expected but vector or color expression found.");
    return terms->v[0];
}

Vec3 to_vec3(const Operand& operand) {
    const Terms* terms = operand.terms();
    if (!terms) {
        throw SceneError(operand.where,
                         fmt::format("Expected 'vector', {} found instead", kind_name(operand.value)));
    }
    if (terms->count > 3) throw SceneError(operand.where, "Vector expected but color expression found.");
    if (terms->count == 1) return Vec3{terms->v[0]};
    return {terms->v[0], terms->v[1], terms->v[2]};
}

const std::string& to_text(const Operand& operand) {
    if (const auto* text = std::get_if<std::string>(&operand.value)) return *text;
    std::string found = kind_name(operand.value);
    if (const Terms* terms = operand.terms()) {
        found = terms->count == 1 ? "float function 'float constant'" : "vector";
    }
    throw SceneError(operand.where, fmt::format("Expected 'string expression', {} found instead", found));
}

}  // namespace rb
