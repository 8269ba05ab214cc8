#pragma once
#include "language/load.h"
#include "language/random.h"
#include "language/symbols.h"
#include "language/token_stream.h"
#include "language/words.h"

#include <map>
#include <set>
#include <string>

namespace rb {

enum class Charset { ascii, utf8, sys };

/// Camera numbers before they are resolved; `#default{camera{...}}` edits a set of them.
struct CameraDraft {
    Camera camera;
    Vec3 sky{0.0, 1.0, 0.0};
    Vec3 look_at{0.0, 0.0, 1.0};
    bool has_look_at = false;
    bool has_angle = false;
    bool angle_was_given = false;  ///< even as 0 or a bare word
    bool has_vertical_angle = false;
    bool has_right_or_up = false;
    bool has_focal_point = false;
    Vec3 focal_point{0.0};
    bool resolved = false;
};

/// Everything that reading one scene shares.
struct Session {
    Session(const LoadOptions& o, SourceMap& s, Diagnostics& d, Scene& out)
        : options(o), sources(s), diagnostics(d), scene(out), stream(*this) {}

    const LoadOptions& options;
    SourceMap& sources;
    Diagnostics& diagnostics;
    Scene& scene;

    Words words;
    Symbols symbols;
    RandomStreams random;
    TokenStream stream;

    int language_version = 370;
    bool version_seen = false;
    bool noise_generator_set = false;
    /// Shared with functions that look at it when they are called.
    std::shared_ptr<int> noise_generator = std::make_shared<int>(2);
    void set_noise_generator(int generator) {
        scene.settings.noise_generator = generator;
        *noise_generator = generator;
    }
    Charset charset = Charset::ascii;
    TexturePtr default_texture;
    CameraDraft default_camera;
    double default_importance = 1;
    int cameras = 0;
    std::set<std::string, std::less<>> experimental;
    std::string debug_line;
    int nesting = 0;  ///< of the grammar, over all nested parses

    int effective_version() const { return version_seen ? language_version : 362; }
    ReadContext context();

    /// Lexes each file once, and again where the scene has written another text into it.
    TokenFilePtr tokens_of(const std::string& path);
    std::map<std::string, TokenFilePtr> files;
    /// #fopen is about to write a file: what was read of any may soon be out of date.
    void note_writing();
    bool has_written = false;
    /// The bytes of a file of density_file by its path, read once as long as somebody holds them; null: it
    /// cannot be read.
    std::shared_ptr<const std::string> density_bytes(const std::string& path);
    std::map<std::string, std::weak_ptr<const std::string>> density_files;
    const FontFile& font_file(const std::string& name, SourceRange where);
    std::map<std::string, FontFile> font_files;
    /// Names for which another file was taken, and said so.
    std::set<std::string> replaced_files;

    [[noreturn]] void fail(SourceRange where, std::string message) const {
        throw SceneError(where, std::move(message));
    }
    void warn(SourceRange where, std::string message) { diagnostics.warning(where, std::move(message)); }
    void message(std::string_view stream_name, std::string_view text) const {
        if (options.message) options.message(stream_name, text);
    }
    /// " Did you mean 'x'?" if a visible name or reserved word is close.
    std::string hint(std::string_view word) const;
    std::string_view text_of(SourceRange where) const {
        return sources.text(where.file).substr(where.begin, where.end - where.begin);
    }
};

/// "undeclared identifier 'foo'", "float function 'sin'", ...: a token in an error message.
std::string found_text(const Session& session, const Produced& token);

}  // namespace rb
