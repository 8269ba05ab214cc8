#include "language/load.h"

#include "base/whole_file.h"
#include "language/find_file.h"
#include "language/open_file.h"
#include "language/parser.h"
#include "language/read.h"
#include "language/unsupported.h"

#include <algorithm>
#include <cstdlib>

#include <fmt/format.h>

namespace rb {

namespace {

constexpr int most_errors = 20;

/// Numbers from outside reach a scene as text of six digits (language spec 23.5).
double as_declared(double value) {
    return std::strtod(fmt::format("{:.6g}", static_cast<float>(value)).c_str(), nullptr);
}

void declare_numbers(Session& session) {
    const LoadOptions& o = session.options;
    const auto number = [&](std::string_view name, double value) {
        session.symbols.create_global(session.words.number(name))->value = Terms{{as_declared(value)}, 1};
    };
    number("image_width", o.image_width);
    number("image_height", o.image_height);
    number("clock_delta", o.clock_delta);
    number("final_clock", o.final_clock);
    number("final_frame", o.final_frame);
    number("frame_number", o.frame_number);
    number("initial_clock", o.initial_clock);
    number("initial_frame", o.initial_frame);
    const size_t slash = o.input_file.find_last_of('/');
    session.symbols.create_global(session.words.number("input_file_name"))->value =
        slash == std::string::npos ? o.input_file : o.input_file.substr(slash + 1);
    // The first declaration of a name counts.
    for (auto at = o.declares.rbegin(); at != o.declares.rend(); ++at) {
        const SlotPtr slot = session.symbols.create_global(session.words.number(at->first));
        if (const auto* text = std::get_if<std::string>(&at->second)) {
            slot->value = *text;
        } else {
            slot->value = Terms{{as_declared(std::get<double>(at->second))}, 1};
        }
    }
}

/// Opens the scene and the file that goes before it.
void open_input(Session& session) {
    const LoadOptions& o = session.options;
    std::string name = o.input_file;
    std::string text;
    if (o.input_text) {
        text = *o.input_text;
    } else {
        const auto path = find_file(session, o.input_file, SoughtFile::scene, {});
        std::optional<std::string> read = path ? read_whole_file(*path) : std::nullopt;
        if (!read)
            throw missing_file(session, o.input_file, SoughtFile::scene, {}, "Cannot open input file.");
        name = *path;
        text = std::move(*read);
    }
    const uint32_t number = session.sources.add(std::move(name), std::move(text));
    LexOptions lexing;
    lexing.is_main = true;
    lexing.runs = o.number_runs;
    lexing.quick = o.quick_expressions;
    const std::string_view source = session.sources.text(number);
    // A byte order mark says how strings are coded.
    if (!source.empty() && static_cast<unsigned char>(source[0]) >= 128) session.charset = Charset::utf8;
    session.stream.open_file(lex(number, source, session.words, lexing), {}, false);
    if (o.include_header) {
        const auto path = find_file(session, *o.include_header, SoughtFile::include, {});
        if (!path) {
            throw missing_file(session, *o.include_header, SoughtFile::include, {},
                               fmt::format("Cannot open include file {}.", *o.include_header));
        }
        session.stream.open_file(session.tokens_of(*path), {}, true);
    }
}

void start(Session& session) {
    session.default_texture = plain_texture();
    if (session.options.version) {
        session.language_version = static_cast<int>(100 * *session.options.version + 0.5);
        session.version_seen = true;
    }
    declare_numbers(session);
}

bool is_directive(const Produced& token) {
    if (token.kind != Tok::keyword) return false;
    const auto word = static_cast<Keyword>(token.word);
    return word == Keyword::declare || word == Keyword::include || word == Keyword::default_;
}

bool is_obsolete(const Produced& token) {
    const auto word = static_cast<Keyword>(token.word);
    return token.kind == Tok::keyword &&
           (word == Keyword::max_trace_level || word == Keyword::max_intersections);
}

void read_obsolete(Session& session, Parser& parser, const Produced& token) {
    const double value = parser.number();
    session.warn(token.where, fmt::format("'{}' should be in the 'global_settings' statement.",
                                          session.words.spelling(token.word)));
    if (static_cast<Keyword>(token.word) == Keyword::max_trace_level) {
        session.scene.settings.max_trace_level = std::clamp(static_cast<int>(value), 1, 256);
    }
}

[[noreturn]] void fail_statement(Session& session, const Produced& token) {
    std::string message =
        fmt::format("Expected 'object or directive', {} found instead", found_text(session, token));
    if (token.kind == Tok::undeclared) message += session.hint(session.words.spelling(token.word));
    session.fail(token.where, std::move(message));
}

using BlockSink = std::function<void(const Block&)>;

/// One statement; false at the end of the scene.
bool read_one(Session& session, Parser& parser, const BlockSink& sink) {
    parser.lock(false);
    if (std::shared_ptr<const Block> block = parser.plain_statement()) {
        sink(*block);
        parser.recycle(std::move(block));
        return true;
    }
    const Produced token = parser.peek();
    if (token.kind == Tok::end) return false;
    // Without `#` at scene level.
    if (is_directive(token) || (token.kind == Tok::constant && token.word == word_of(Keyword::version))) {
        parser.take();
        session.warn(token.where,
                     fmt::format("'{}' should begin with '#'.", session.words.spelling(token.word)));
        session.stream.run_directive(token.word, token.where);
        return true;
    }
    if (is_obsolete(token)) {
        parser.take();
        read_obsolete(session, parser, token);
        return true;
    }
    if (token.kind == Tok::name) {
        const Operand operand = parser.rvalue();
        const auto* thing = std::get_if<Thing>(&operand.value);
        const auto* object = thing ? std::get_if<ObjectPtr>(thing) : nullptr;
        if (!object) fail_statement(session, token);
        auto copy = make_object(**object);
        if (!std::holds_alternative<LightPtr>(copy->geometry))
            copy->fallback_texture = session.default_texture;
        session.scene.objects.push_back(std::move(copy));
        return true;
    }
    const bool known = token.kind == Tok::keyword && begins_statement(session.words.spelling(token.word));
    if (!known) {
        parser.take();
        fail_statement(session, token);
    }
    parser.take();
    std::shared_ptr<const Block> block = parser.block(token);
    sink(*block);
    parser.recycle(std::move(block));
    return true;
}

void report(Session& session, const SceneError& error) {
    // What follows from an error that was reported says nothing.
    if (error.diagnostic().message.empty()) return;
    Diagnostic diagnostic = error.diagnostic();
    for (const Diagnostic& before : session.diagnostics.all()) {
        if (before.where == diagnostic.where && before.message == diagnostic.message) return;
    }
    for (Diagnostic& note : session.stream.trail()) diagnostic.notes.push_back(std::move(note));
    session.diagnostics.report(std::move(diagnostic));
}

void read_all(Session& session, const BlockSink& sink) {
    int failures = 0;
    while (true) {
        try {
            Parser parser(session);
            do {
                session.stream.mark();
            } while (read_one(session, parser, sink));
            return;
        } catch (const SceneError& error) {
            report(session, error);
            if (++failures >= 100 || session.diagnostics.error_count() >= most_errors) {
                session.diagnostics.report(
                    {Severity::note, {}, "Too many errors: the rest is not read.", {}});
                return;
            }
            session.stream.recover();
        }
    }
}

void warn_at_end(Session& session) {
    Scene& scene = session.scene;
    scene.language_version = std::max(session.language_version, 350);
    scene.effective_version = session.effective_version();
    scene.default_texture = session.default_texture;
    const bool has_object = std::any_of(
        scene.objects.begin(), scene.objects.end(),
        [](const ObjectPtr& object) { return !std::holds_alternative<LightPtr>(object->geometry); });
    if (!has_object) session.warn({}, "No objects in scene.");
    if (!session.version_seen) {
        session.warn(
            {}, "This scene did not contain a #version directive: it is read as a scene of version 3.62.");
    }
    if (!scene.settings.assumed_gamma) {
        if (session.effective_version() < 370) {
            session.warn({}, "assumed_gamma not specified: no gamma handling.");
        } else {
            session.warn({}, "assumed_gamma not specified in a scene of version 3.7: 1.0 is used.");
            scene.settings.assumed_gamma = 1.0;
        }
    }
    if (session.language_version < 350) {
        session.warn({}, "The scene ends with a language version below 3.5: 3.5 is used.");
    }
}

/// Reads the whole scene into the session's; false if errors were reported.
bool run(Session& session, const BlockSink& sink) {
    try {
        start(session);
        open_input(session);
        read_all(session, sink);
    } catch (const SceneError& error) {
        session.diagnostics.report(error.diagnostic());
    } catch (const IoError& error) {
        session.diagnostics.error({}, error.what());
    }
    return session.diagnostics.error_count() == 0;
}

}  // namespace

bool load_scene(const LoadOptions& options, SourceMap& sources, Diagnostics& diagnostics, Scene& out) {
    Session session(options, sources, diagnostics, out);
    const bool done = run(session, [&](const Block& block) { read_statement(session, block); });
    if (!done) return false;
    warn_at_end(session);
    report_unsupported(out, diagnostics);
    return diagnostics.error_count() == 0;
}

std::string dump_blocks(const LoadOptions& options, SourceMap& sources, Diagnostics& diagnostics) {
    Scene scene;
    Session session(options, sources, diagnostics, scene);
    std::string out;
    run(session, [&](const Block& block) {
        out += dump(block);
        read_statement(session, block);
    });
    return out;
}

std::string dump_tokens(const LoadOptions& options, SourceMap& sources, Diagnostics& diagnostics) {
    Scene scene;
    Session session(options, sources, diagnostics, scene);
    std::string out;
    try {
        start(session);
        open_input(session);
        while (true) {
            const Produced token = session.stream.next();
            if (token.kind == Tok::end) break;
            const LineColumn place = sources.position(token.where.file, token.where.begin);
            out += fmt::format("{}:{}:{} {}\n", sources.name(token.where.file), place.line, place.column,
                               session.text_of(token.where));
        }
    } catch (const SceneError& error) {
        report(session, error);
    } catch (const IoError& error) {
        diagnostics.error({}, error.what());
    }
    return out;
}

std::vector<std::string_view> reserved_words() {
    return {std::begin(keyword_spellings), std::end(keyword_spellings)};
}

}  // namespace rb
