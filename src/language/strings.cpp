// Strings: literals, functions, order. Strings are kept as UTF-8 and counted in 16-bit units.
#include "language/builtins.h"
#include "language/find_file.h"
#include "language/session.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>

#include <fmt/format.h>

namespace rb {

namespace {

void append_utf8(std::string& out, uint32_t code) {
    if (code < 0x80) {
        out += static_cast<char>(code);
    } else if (code < 0x800) {
        out += static_cast<char>(0xc0 | (code >> 6));
        out += static_cast<char>(0x80 | (code & 0x3f));
    } else {
        out += static_cast<char>(0xe0 | (code >> 12));
        out += static_cast<char>(0x80 | ((code >> 6) & 0x3f));
        out += static_cast<char>(0x80 | (code & 0x3f));
    }
}

/// A byte >= 128 of a literal, by the scene's charset.
void append_high_byte(Session& session, std::string& out, char byte, SourceRange where, bool& warned) {
    if (session.charset == Charset::utf8) {
        out += byte;
    } else if (session.language_version < 350) {
        append_utf8(out, static_cast<unsigned char>(byte));
    } else {
        if (!warned)
            session.warn(where, "Non-ASCII character in a string is replaced by a space (charset ascii).");
        warned = true;
        out += ' ';
    }
}

bool is_ascii(const std::string& text) {
    return std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 128; });
}

}  // namespace

std::string unescape(Session& session, std::string_view literal, SourceRange where) {
    std::string out;
    bool warned = false;
    for (size_t i = 1; i + 1 < literal.size(); ++i) {
        const char c = literal[i];
        if (static_cast<unsigned char>(c) >= 128) {
            append_high_byte(session, out, c, where, warned);
            continue;
        }
        if (c != '\\') {
            out += c;
            continue;
        }
        const char next = literal[++i];
        constexpr std::string_view letters = "abfnrtv\\'\"";
        constexpr std::string_view meanings = "\a\b\f\n\r\t\v\\'\"";
        const size_t known = letters.find(next);
        if (known != std::string_view::npos) {
            out += meanings[known];
        } else if (next == 'u' && i + 4 < literal.size() - 1) {
            const std::string digits(literal.substr(i + 1, 4));
            if (digits.find_first_not_of("0123456789abcdefABCDEF") != std::string::npos) {
                session.fail(where, "Illegal escape sequence in string.");
            }
            append_utf8(out, static_cast<uint32_t>(std::strtoul(digits.c_str(), nullptr, 16)));
            i += 4;
        } else if (next == '\n' || next == '\r') {
            session.fail(where, "Unterminated string literal.");
        } else {
            session.fail(where, "Illegal escape sequence in string.");
        }
    }
    return out;
}

std::string raw_literal(std::string_view literal) {
    std::string out;
    for (size_t i = 1; i + 1 < literal.size(); ++i) {
        if (literal[i] == '\\' && literal[i + 1] == '"') continue;
        out += literal[i];
    }
    return out;
}

std::u16string units_of(const std::string& text) {
    std::u16string out;
    for (size_t i = 0; i < text.size();) {
        const auto byte = static_cast<unsigned char>(text[i]);
        const auto follow = [&](size_t k) -> uint32_t {
            return i + k < text.size() ? static_cast<unsigned char>(text[i + k]) & 0x3fu : 0u;
        };
        if (byte < 0x80) {
            out += static_cast<char16_t>(byte);
            i += 1;
        } else if (byte < 0xe0) {
            out += static_cast<char16_t>(((byte & 0x1fu) << 6) | follow(1));
            i += 2;
        } else if (byte < 0xf0) {
            out += static_cast<char16_t>(((byte & 0x0fu) << 12) | (follow(1) << 6) | follow(2));
            i += 3;
        } else {
            out += static_cast<char16_t>(0xfffd);
            i += 4;
        }
    }
    return out;
}

std::string text_of_units(std::u16string_view units) {
    std::string out;
    for (char16_t unit : units) append_utf8(out, unit);
    return out;
}

int compare_texts(const std::string& a, const std::string& b) {
    const std::u16string left = units_of(a);
    const std::u16string right = units_of(b);
    for (size_t i = 0; i < std::max(left.size(), right.size()); ++i) {
        const int l = i < left.size() ? left[i] : 0;
        const int r = i < right.size() ? right[i] : 0;
        if (l != r) return l - r;
    }
    return 0;
}

namespace {

std::string format_number(double value, double width_given, double digits_given) {
    const int digits = digits_given < 0 ? -1 : static_cast<int>(std::min(digits_given, 1000.0));
    const int width = static_cast<int>(std::clamp(width_given, -1000.0, 1000.0));
    std::string pattern = "%";
    if (width < 0) pattern += '0';
    if (width != 0) pattern += std::to_string(std::abs(width));
    const std::string start = pattern;
    if (digits >= 0) pattern += '.' + std::to_string(digits);
    const auto print = [&](const std::string& p, char kind) {
        std::string out(2000, '\0');
        const int size = std::snprintf(out.data(), out.size(), (p + kind).c_str(), value);
        out.resize(static_cast<size_t>(std::clamp(size, 0, 1999)));
        return out;
    };
    std::string out = print(pattern, 'f');
    if (out.size() < 255) return out;
    out = print(start, 'g');
    return out.size() < 255 ? out : "<invalid>";
}

const std::string& text_at(std::span<const Operand> a, size_t i, SourceRange where) {
    if (i >= a.size()) {
        throw SceneError({where.file, where.end - 1, where.end},
                         "Expected 'string expression', ) found instead");
    }
    return to_text(a[i]);
}

double float_at(std::span<const Operand> a, size_t i, SourceRange where) {
    if (i >= a.size()) {
        throw SceneError({where.file, where.end - 1, where.end},
                         "Expected 'numeric expression', ) found instead");
    }
    return to_float(a[i]);
}

Value real(double value) { return Terms{{value}, 1}; }

Value substring(std::span<const Operand> a, SourceRange where) {
    const std::u16string units = units_of(text_at(a, 0, where));
    const double from = std::trunc(float_at(a, 1, where));
    const double count = std::trunc(float_at(a, 2, where));
    if (from < 0 || count < 0 || from + count - 1 > static_cast<double>(units.size())) {
        throw SceneError(where, "Illegal parameters in substr.",
                         fmt::format("the string has {} characters; the first is number 1", units.size()));
    }
    if (from == 0) return std::string{};
    return text_of_units(
        std::u16string_view(units).substr(static_cast<size_t>(from) - 1, static_cast<size_t>(count)));
}

Value vector_text(std::span<const Operand> a, SourceRange where) {
    const auto count = static_cast<size_t>(std::clamp(std::trunc(float_at(a, 0, where)), 2.0, 5.0));
    const Terms* terms = a.size() > 1 ? a[1].terms() : nullptr;
    if (!terms) {
        throw SceneError(
            a.size() > 1 ? a[1].where : where,
            fmt::format("Expected 'vector', {} found instead", a.size() > 1 ? kind_name(a[1].value) : ")"));
    }
    const std::string& separator = text_at(a, 2, where);
    std::string out;
    for (size_t i = 0; i < count; ++i) {
        if (i > 0) out += separator;
        const double value = i < static_cast<size_t>(terms->count) ? terms->v[i] : 0.0;
        out += format_number(value, float_at(a, 3, where), float_at(a, 4, where));
    }
    return out;
}

Value date_text(std::span<const Operand> a, SourceRange where) {
    const double days = float_at(a, 0, where);
    const std::string pattern = a.size() > 1 ? text_at(a, 1, where) : "%Y-%m-%d %H:%M:%SZ";
    if (pattern.empty()) throw SceneError(where, "Empty format string in datetime.");
    const auto seconds = static_cast<std::time_t>(std::floor(days * 86400.0 + 0.5)) + 946684800;
    std::tm parts{};
    gmtime_r(&seconds, &parts);
    std::string out(1024, '\0');
    out.resize(std::strftime(out.data(), out.size(), pattern.c_str(), &parts));
    return out;
}

std::string changed_case(std::string text, bool upper) {
    for (char& c : text) {
        if (upper && c >= 'a' && c <= 'z') c = static_cast<char>(c - 32);
        if (!upper && c >= 'A' && c <= 'Z') c = static_cast<char>(c + 32);
    }
    return text;
}

}  // namespace

Value call_text(Session& session, Keyword word, std::span<const Operand> a, SourceRange where) {
    switch (word) {
        case Keyword::asc: {
            const std::u16string units = units_of(text_at(a, 0, where));
            return real(units.empty() ? 0 : units[0]);
        }
        case Keyword::val:
            return real(std::atof(text_at(a, 0, where).c_str()));
        case Keyword::strlen: {
            const std::string& text = text_at(a, 0, where);
            return real(static_cast<double>(is_ascii(text) ? text.size() : units_of(text).size()));
        }
        case Keyword::strcmp:
            return real(compare_texts(text_at(a, 0, where), text_at(a, 1, where)));
        case Keyword::file_exists:
            return real(file_exists(session, text_at(a, 0, where)) ? 1 : 0);
        case Keyword::chr: {
            const double code = float_at(a, 0, where);
            if (!(code >= 0 && code < 65536)) throw SceneError(where, "Value of chr() must be in 0..65535.");
            std::string out;
            append_utf8(out, static_cast<uint32_t>(code));
            return out;
        }
        case Keyword::concat: {
            std::string out;
            for (size_t i = 0; i < a.size(); ++i) out += text_at(a, i, where);
            return out;
        }
        case Keyword::str:
            return format_number(float_at(a, 0, where), float_at(a, 1, where), float_at(a, 2, where));
        case Keyword::vstr:
            return vector_text(a, where);
        case Keyword::substr:
            return substring(a, where);
        case Keyword::strupr:
        case Keyword::strlwr:
            return changed_case(text_at(a, 0, where), word == Keyword::strupr);
        default:
            return date_text(a, where);
    }
}

}  // namespace rb
