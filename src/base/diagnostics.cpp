#include "base/diagnostics.h"

#include <algorithm>
#include <numeric>

#include <fmt/format.h>

namespace rb {

namespace {

std::string_view name_of(Severity severity) {
    switch (severity) {
        case Severity::note:
            return "note";
        case Severity::warning:
        case Severity::possible_error:
            return "warning";
        case Severity::error:
            return "error";
    }
    return "error";
}

/// Letters put in, left out or changed, and neighbours swapped (Damerau and Levenshtein).
size_t edit_distance(std::string_view a, std::string_view b) {
    std::vector<size_t> before(b.size() + 1);
    std::vector<size_t> above(b.size() + 1);
    std::vector<size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), size_t{0});
    for (size_t i = 1; i <= a.size(); ++i) {
        before.swap(above);
        above.swap(row);
        row[0] = i;
        for (size_t j = 1; j <= b.size(); ++j) {
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            const bool swapped = i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1];
            if (swapped) row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

}  // namespace

void Diagnostics::report(Diagnostic diagnostic) {
    if (diagnostic.severity == Severity::error) ++errors_;
    all_.push_back(std::move(diagnostic));
}

void Diagnostics::warning(SourceRange where, std::string message) {
    report({Severity::warning, where, std::move(message), {}});
}

void Diagnostics::error(SourceRange where, std::string message) {
    report({Severity::error, where, std::move(message), {}});
}

void Diagnostics::unsupported(SourceRange where, std::string_view feature, std::string_view instead) {
    for (Unsupported& known : unsupported_) {
        if (known.feature == feature) {
            ++known.count;
            return;
        }
    }
    unsupported_.push_back({where, std::string(feature), std::string(instead), 1});
    report(
        {Severity::warning, where, fmt::format("{} is not supported yet: {}", feature, instead), {}, true});
}

std::string format(const Diagnostic& diagnostic, const SourceMap& sources) {
    std::string out;
    const SourceRange& at = diagnostic.where;
    if (at.known()) {
        const LineColumn place = sources.position(at.file, at.begin);
        const std::string_view line = sources.line_at(at.file, at.begin);
        out += fmt::format("{}:{}:{}: {}: {}\n", sources.name(at.file), place.line, place.column,
                           name_of(diagnostic.severity), diagnostic.message);
        const size_t start = place.column - 1;
        // A line of generated data can be megabytes long; show a window around the place.
        const size_t first = start > 120 ? start - 60 : 0;
        const std::string shown(line.substr(std::min(first, line.size()), 160));
        std::string caret;
        for (size_t i = first; i < start; ++i) caret += i < line.size() && line[i] == '\t' ? '\t' : ' ';
        const size_t room = shown.size() > caret.size() ? shown.size() - caret.size() : 1;
        const size_t width = std::clamp<size_t>(at.end > at.begin ? at.end - at.begin : 1, 1, room);
        caret += '^' + std::string(width - 1, '~');
        out += fmt::format("{:>5} | {}\n      | {}\n", place.line, shown, caret);
    } else {
        out += fmt::format("{}: {}\n", name_of(diagnostic.severity), diagnostic.message);
    }
    for (const Diagnostic& note : diagnostic.notes) out += format(note, sources);
    return out;
}

std::string_view closest_word(std::string_view word, const std::vector<std::string_view>& candidates) {
    std::string_view best;
    size_t best_distance = std::max<size_t>(1, word.size() / 3) + 1;
    for (std::string_view candidate : candidates) {
        if (candidate.size() + best_distance <= word.size() ||
            word.size() + best_distance <= candidate.size()) {
            continue;
        }
        const size_t distance = edit_distance(word, candidate);
        if (distance < best_distance) {
            best_distance = distance;
            best = candidate;
        }
    }
    return best;
}

}  // namespace rb
