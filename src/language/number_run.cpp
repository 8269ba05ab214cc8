#include "language/number_run.h"

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>

namespace rb {

namespace {

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r') || c == '\0' || c == '\x1a'; }

class Scanner {
public:
    explicit Scanner(std::string_view text) : at_(text.data()), end_(text.data() + text.size()) {}

    const char* at() const { return at_; }
    bool take(char c) {
        if (at_ == end_ || *at_ != c) return false;
        ++at_;
        return true;
    }
    char next() const { return at_ == end_ ? '\0' : *at_; }
    bool at_end() const { return at_ == end_; }
    void skip_blanks() {
        while (at_ != end_ && is_blank(*at_)) ++at_;
    }
    bool take_number() {
        if (at_ != end_ && (*at_ == '-' || *at_ == '+')) ++at_;
        const char* const start = at_;
        while (at_ != end_ && is_digit(*at_)) ++at_;
        bool digits = at_ != start;
        if (take('.')) {
            const char* const fraction = at_;
            while (at_ != end_ && is_digit(*at_)) ++at_;
            digits = digits || at_ != fraction;
        }
        if (!digits) return false;
        if (at_ != end_ && (*at_ == 'e' || *at_ == 'E')) {
            ++at_;
            if (at_ != end_ && (*at_ == '-' || *at_ == '+')) ++at_;
            const char* const exponent = at_;
            while (at_ != end_ && is_digit(*at_)) ++at_;
            if (at_ == exponent) return false;
        }
        return true;
    }
    /// `<n, n, ...>`; returns the number of terms, 0 if it is not a plain vector.
    int take_vector() {
        if (!take('<')) return 0;
        for (int terms = 1; terms <= 5; ++terms) {
            skip_blanks();
            if (!take_number()) return 0;
            skip_blanks();
            if (take('>')) return terms > 1 ? terms : 0;
            if (!take(',')) return 0;
        }
        return 0;
    }

private:
    const char* at_;
    const char* end_;
};

}  // namespace

NumberRun find_number_run(std::string_view text) {
    NumberRun run;
    Scanner scan(text);
    while (true) {
        const int terms = scan.take_vector();
        if (terms == 0 || (run.count > 0 && terms != run.terms)) break;
        const char* const vector_end = scan.at();
        scan.skip_blanks();
        const bool comma = scan.take(',');
        if (comma) scan.skip_blanks();
        const char next = scan.next();
        // Only these can follow a value that is surely complete.
        if (scan.at_end() || !(comma || next == '<' || next == '}')) break;
        run.terms = terms;
        ++run.count;
        run.size = static_cast<size_t>(vector_end - text.data());
        if (next != '<') break;
    }
    run.looked = static_cast<size_t>(scan.at() - text.data());
    return run;
}

double parse_number(std::string_view text) {
    double value = 0;
    const char* const end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data(), end, value);
    if (error == std::errc{}) return value;
    return std::strtod(std::string(text).c_str(), nullptr);
}

void parse_number_run(std::string_view run, std::vector<double>& out) {
    const char* at = run.data();
    const char* const end = at + run.size();
    while (at != end) {
        const char c = *at;
        if (is_digit(c) || c == '-' || c == '.' || c == '+') {
            if (c == '+') ++at;
            // Indices of faces are most of the numbers of a mesh.
            const char* p = at;
            uint64_t whole = 0;
            while (p != end && is_digit(*p) && p - at < 15)
                whole = whole * 10 + static_cast<uint64_t>(*p++ - '0');
            if (p != at && p != end && (*p == ',' || *p == '>' || is_blank(*p))) {
                out.push_back(static_cast<double>(whole));
                at = p;
                continue;
            }
            double value = 0;
            const auto [stop, error] = std::from_chars(at, end, value);
            if (error != std::errc{}) value = std::strtod(std::string(at, stop).c_str(), nullptr);
            out.push_back(value);
            at = stop;
            continue;
        }
        ++at;
    }
}

}  // namespace rb
