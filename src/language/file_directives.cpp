// #fopen, #fclose, #read, #write.
#include "base/whole_file.h"
#include "language/find_file.h"
#include "language/open_file.h"
#include "language/parser.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace rb {

void TokenStream::do_fopen(SourceRange) {
    const SourceRange where = range(raw_peek());
    const uint32_t word = raw_name("undeclared identifier");
    std::string name;
    auto file = std::make_shared<OpenFile>();
    const std::string handle(session_.words.spelling(word));
    {
        Parser parser(session_);
        name = parser.file_name();
        if (parser.at_word(Keyword::read)) {
            file->mode = OpenFile::Mode::read;
        } else if (parser.at_word(Keyword::write)) {
            file->mode = OpenFile::Mode::write;
        } else if (parser.at_word(Keyword::append)) {
            file->mode = OpenFile::Mode::append;
        } else {
            parser.fail_expected("read or write");
        }
        parser.take();
    }
    if (file->mode == OpenFile::Mode::read) {
        const auto path = find_file(session_, name, SoughtFile::data, where);
        std::optional<std::string> text = path ? read_whole_file(*path) : std::nullopt;
        if (!text) {
            throw missing_file(session_, name, SoughtFile::data, where,
                               fmt::format("Cannot open user file {} (read).", name));
        }
        const uint32_t number = session_.sources.add(*path, std::move(*text));
        LexOptions options;
        options.runs = false;
        file->tokens = lex(number, session_.sources.text(number), session_.words, options);
    } else {
        check_may_write(session_, name, where);
        session_.note_writing();
        if (session_.options.file_access)
            file->out = std::fopen(name.c_str(), file->mode == OpenFile::Mode::write ? "wb" : "ab");
        if (!file->out) {
            session_.fail(where, fmt::format("Cannot open user file {} ({}).", name,
                                             file->mode == OpenFile::Mode::write ? "write" : "append"));
        }
    }
    const Value value = OpenFilePtr(std::move(file));
    const Place place = declared_place(word, session_.symbols.depth() - 1, false, where, value);
    store(place, where, value);
}

void TokenStream::do_fclose() {
    const uint32_t word = raw_name("file identifier");
    const Place place = session_.symbols.find_place(word);
    if (!place.known() || !std::holds_alternative<OpenFilePtr>(place.value())) return;
    std::get<OpenFilePtr>(place.value())->close();
    session_.symbols.remove(word);
}

namespace {

/// One datum of a text file: number, vector or string. Nothing at the end of the file.
std::optional<Value> take_datum(Session& session, OpenFile& file) {
    const TokenFile& data = *file.tokens;
    const auto number = [&]() -> double {
        double sign = 1;
        while (data.tokens[file.at].kind == Tok::minus || data.tokens[file.at].kind == Tok::plus) {
            if (data.tokens[file.at++].kind == Tok::minus) sign = -sign;
        }
        const Token& token = data.tokens[file.at];
        if (token.kind != Tok::number) {
            session.fail(data.range(token), "Expected 'numeric expression' in a data file");
        }
        ++file.at;
        return sign * data.numbers[token.aux];
    };
    const Token& first = data.tokens[file.at];
    if (first.kind == Tok::end) return std::nullopt;
    if (first.kind == Tok::text) {
        ++file.at;
        return Value(unescape(session, data.spelling(first), data.range(first)));
    }
    Terms terms;
    if (first.kind != Tok::langle) {
        terms.v[0] = number();
        return Value(terms);
    }
    ++file.at;
    terms.count = 0;
    while (data.tokens[file.at].kind != Tok::rangle) {
        if (terms.count == 5) session.fail(data.range(first), "Expected '>' in a data file");
        terms.v[static_cast<size_t>(terms.count++)] = number();
        if (data.tokens[file.at].kind == Tok::comma) ++file.at;
    }
    ++file.at;
    if (terms.count == 0) session.fail(data.range(first), "Expected 'numeric expression' in a data file");
    return Value(terms);
}

}  // namespace

TokenStream::NamedFile TokenStream::raw_open_file() {
    raw_expect(Tok::lparen, "(");
    const SourceRange where = range(raw_peek());
    const uint32_t word = raw_name("file identifier");
    const Place handle = session_.symbols.find_place(word);
    if (!handle.known() || !std::holds_alternative<OpenFilePtr>(handle.value())) {
        const std::string_view name = session_.words.spelling(word);
        session_.fail(where, fmt::format("Expected 'file identifier', {} found instead{}",
                                         handle.known() ? kind_name(handle.value())
                                                        : fmt::format("undeclared identifier '{}'", name),
                                         handle.known() ? "" : session_.hint(name)));
    }
    return {std::get<OpenFilePtr>(handle.value()), word, where};
}

void TokenStream::do_read(SourceRange) {
    const auto [file, word, where] = raw_open_file();
    if (file->mode != OpenFile::Mode::read) {
        session_.fail(where,
                      fmt::format("Cannot read from file {} because the file is open for writing only.",
                                  session_.words.spelling(word)));
    }
    bool at_end = false;
    while (raw_peek().kind != Tok::rparen) {
        if (raw_peek().kind == Tok::comma) raw_next();
        const SourceRange target = range(raw_peek());
        const uint32_t variable = raw_name("identifier");
        Place place = session_.symbols.find_place(variable);
        if (raw_peek().kind == Tok::lbracket && place.known() &&
            std::holds_alternative<ArrayPtr>(place.value())) {
            place = raw_element(place, target);
        }
        if (at_end) continue;
        std::optional<Value> value = take_datum(session_, *file);
        if (!value) {
            at_end = true;
            continue;
        }
        // The token behind an item is taken, whatever it is.
        if (file->tokens->tokens[file->at].kind != Tok::end)
            ++file->at;
        else
            at_end = true;
        if (!place.known()) place.slot = session_.symbols.create_global(variable);
        store(place, target, std::move(*value));
    }
    raw_expect(Tok::rparen, ")");
    if (at_end) {
        file->close();
        session_.symbols.remove(word);
    }
}

namespace {

struct Binary {
    int bytes = 0;
    bool is_signed = false;
    bool big_endian = false;
};

std::optional<Binary> binary_of(const Produced& token) {
    if (token.kind != Tok::keyword) return std::nullopt;
    switch (static_cast<Keyword>(token.word)) {
        case Keyword::sint8:
            return Binary{1, true, false};
        case Keyword::uint8:
            return Binary{1, false, false};
        case Keyword::sint16be:
            return Binary{2, true, true};
        case Keyword::sint16le:
            return Binary{2, true, false};
        case Keyword::uint16be:
            return Binary{2, false, true};
        case Keyword::uint16le:
            return Binary{2, false, false};
        case Keyword::sint32be:
            return Binary{4, true, true};
        case Keyword::sint32le:
            return Binary{4, true, false};
        default:
            return std::nullopt;
    }
}

void write_binary(std::FILE* out, const Binary& type, double value) {
    const int bits = 8 * type.bytes;
    const double low = type.is_signed ? -std::ldexp(1.0, bits - 1) : 0.0;
    const double high = std::ldexp(1.0, type.is_signed ? bits - 1 : bits) - 1;
    const auto whole = static_cast<int64_t>(std::clamp(std::floor(value + 0.5), low, high));
    for (int i = 0; i < type.bytes; ++i) {
        const int shift = 8 * (type.big_endian ? type.bytes - 1 - i : i);
        std::fputc(static_cast<int>((whole >> shift) & 0xff), out);
    }
}

std::string written(const Operand& operand) {
    if (const auto* text = std::get_if<std::string>(&operand.value)) return *text;
    const auto* terms = operand.terms();
    if (!terms) throw SceneError(operand.where, "Expected 'string or numeric expression' in #write");
    if (terms->count == 1) return fmt::format("{:g}", terms->v[0]);
    std::string out = "<";
    for (size_t i = 0; i < static_cast<size_t>(terms->count); ++i) {
        out += fmt::format("{}{:g}", i ? "," : "", terms->v[i]);
    }
    return out + "> ";
}

}  // namespace

void TokenStream::do_write(SourceRange) {
    const auto [file, word, where] = raw_open_file();
    if (file->mode == OpenFile::Mode::read) {
        session_.fail(where, fmt::format("Cannot write to file {} because the file is open for reading only.",
                                         session_.words.spelling(word)));
    }
    Parser parser(session_);
    std::optional<Binary> binary;
    while (true) {
        // A type holds up to the next comma.
        if (parser.take_if(Tok::comma)) binary.reset();
        if (parser.peek().kind == Tok::rparen) break;
        if (const auto type = binary_of(parser.peek())) {
            binary = type;
            parser.take();
            continue;
        }
        const Operand item = parser.sum();
        const auto* terms = item.terms();
        if (binary && terms) {
            for (size_t i = 0; i < static_cast<size_t>(terms->count); ++i) {
                write_binary(file->out, *binary, terms->v[i]);
            }
        } else {
            const std::string text = written(item);
            std::fwrite(text.data(), 1, text.size(), file->out);
        }
    }
    parser.expect(Tok::rparen, ")");
}

}  // namespace rb
