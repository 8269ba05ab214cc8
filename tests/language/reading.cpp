#include "reading.h"

#include <sstream>

#include <fmt/format.h>

namespace rb {

Reading read_scene(std::string_view text, LoadOptions options) {
    Reading out;
    options.input_text = std::string(text);
    if (options.input_file.empty()) options.input_file = "scene.pov";
    options.message = [&](std::string_view stream, std::string_view said) {
        if (stream == "debug") out.debug += said;
    };
    SourceMap sources;
    Diagnostics diagnostics;
    out.done = load_scene(options, sources, diagnostics, out.scene);
    for (const Diagnostic& d : diagnostics.all()) {
        out.report += format(d, sources);
        if (d.severity == Severity::warning) out.warnings.push_back(d.message);
        if (d.severity != Severity::error) continue;
        const uint32_t line = sources.position(d.where.file, d.where.begin).line;
        out.errors.push_back(fmt::format("{}: {}", line, d.message));
    }
    return out;
}

Reading read_probe(std::string_view text) {
    return read_scene(
        fmt::format("#version 3.7; global_settings {{ assumed_gamma 1.0 }} {} sphere {{ 0, 1 }}", text));
}

std::string first_error(std::string_view text) {
    const Reading reading = read_probe(text);
    return reading.errors.empty() ? "" : reading.errors.front().substr(3);
}

std::vector<double> values_of(std::string_view declarations, std::string_view expressions) {
    std::string text(declarations);
    // Each value on its own line, so that commas inside calls need no care: the caller separates by ';'.
    size_t start = 0;
    while (start <= expressions.size()) {
        const size_t end = std::min(expressions.find(';', start), expressions.size());
        text += fmt::format("\n#debug concat(str({},0,12),\"\\n\")", expressions.substr(start, end - start));
        start = end + 1;
    }
    const Reading reading = read_probe(text);
    std::vector<double> out;
    if (!reading.done) return out;
    std::istringstream lines(reading.debug);
    for (double value = 0; lines >> value;) out.push_back(value);
    return out;
}

}  // namespace rb
