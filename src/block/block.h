#pragma once
#include "scene/function.h"
#include "scene/image.h"
#include "scene/object.h"
#include "scene/scene.h"

#include <array>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace rb {

/// A numeric value of the language: 1 (float) to 5 (colour) terms.
struct Terms {
    std::array<double, 5> v{};
    int count = 1;
};

/// A colour as it was written: which word stood before it and how many terms it had decide what a context
/// makes of it (language spec 10), so nothing is promoted yet.
struct WrittenColor {
    bool has_base = false;         ///< `rgb ...`, an identifier or a bare expression stood first
    bool bare = false;             ///< the base had no colour word (`<1,1,0>`, `0.5`, an identifier)
    int word_terms = 0;            ///< 3, 4, 5 for rgb/rgbf/rgbft…; 0 for a bare base
    bool transmit_fourth = false;  ///< rgbt / srgbt: the fourth term is transmit
    bool color_word = false;       ///< `color` stood first
    Terms base;                    ///< already decoded if the word was one of the srgb family
    std::array<std::optional<double>, 5>
        set;  ///< red, green, blue, filter, transmit given by their own words
};

struct Material {
    SourceRange where;
    TexturePtr texture;
    TexturePtr interior_texture;
    InteriorPtr interior;
};

/// What an identifier that is not a number, string or array can hold.
using PigmentMapPtr = std::shared_ptr<const BlendMap<PigmentPtr>>;
using NormalMapPtr = std::shared_ptr<const BlendMap<NormalPtr>>;
using TextureMapPtr = std::shared_ptr<const BlendMap<TexturePtr>>;
using SlopeMapPtr = std::shared_ptr<const BlendMap<HeightSlope>>;
using Thing = std::variant<std::monostate, ObjectPtr, TexturePtr, PigmentPtr, NormalPtr, FinishPtr,
                           InteriorPtr, std::shared_ptr<const Material>, std::shared_ptr<const Camera>,
                           std::shared_ptr<const Transform>, std::shared_ptr<const ColorMap>, PigmentMapPtr,
                           NormalMapPtr, TextureMapPtr, SlopeMapPtr, std::shared_ptr<const Fog>,
                           std::shared_ptr<const SkySphere>, std::shared_ptr<const Rainbow>, FunctionPtr,
                           MediaPtr, DensityPtr, DensityMapPtr>;

/// "object identifier", "texture identifier", ...: the language's name of the kind.
std::string kind_name(const Thing& thing);

struct Block;

/// One item of a block, in written order.
///   word     `open`, `translate`, `gradient`: a keyword that is not part of an expression
///   numbers  `count` values of `terms` terms each, packed in Block::numbers from `first` on (long lists are
///   one item) color    an expression with colour words: `color rgb <1,0,0> transmit .5` text     a string
///   thing    an identifier that holds an object, a texture, ...
///   block    `pigment { ... }`; a map entry `[0.5 rgb 1]` is a block with keyword "["
///   bad      a token that fits nowhere (kept so that the reader can name it)
struct Item {
    enum class Kind { word, numbers, color, text, thing, block, bad };
    Kind kind = Kind::word;
    SourceRange where;
    std::string text;  ///< the word, the string, the identifier's name, or the bad token
    uint32_t first = 0;
    uint32_t count = 0;
    int terms = 0;
    bool bracketed = false;  ///< numbers: one `<...>` of more than five values (matrix, quartic), terms is 1
    std::shared_ptr<const WrittenColor> color;
    std::shared_ptr<const std::string> raw;  ///< text: the literal with its escapes, for file names; null if
                                             ///< equal bad: a hint to add to the message
    Thing thing;
    std::shared_ptr<const Block> block;
};

/// `keyword { items }` after all directives, macros and expressions have been carried out.
struct Block {
    SourceRange where;  ///< from the keyword to the closing brace
    std::string keyword;
    std::vector<Item> items;
    std::vector<double> numbers;
};

/// Text of a block for `--dump blocks`.
std::string dump(const Block& block, int indent = 0);

struct Session;
class BlockReader;

struct FontFile {
    std::string path;
    std::shared_ptr<const std::string> bytes;
};

/// Defaults that `#default` edits, and the facts that readers depend on at one place of the scene.
struct ReadContext {
    Diagnostics* diagnostics = nullptr;
    TexturePtr default_texture;  ///< one plain layer
    const GlobalSettings* settings = nullptr;
    int language_version = 370;
    int effective_version = 362;
    /// Reads `texture { ... }` where a shape carries textures of its own (mesh2); set by the language.
    TexturePtr (*read_texture)(const Block& block, const ReadContext& context) = nullptr;
    /// The same for what a pattern or shape holds besides: pigments, objects.
    PigmentPtr (*read_pigment)(const Block& block, const ReadContext& context) = nullptr;
    ObjectPtr (*read_object)(const Block& block, const ReadContext& context) = nullptr;
    /// Takes a picture, as a file or a function, with its gamma: `png "file" gamma 2.2`. A file that is
    /// missing or damaged is an error at its name.
    ImageSource (*take_image)(BlockReader& in) = nullptr;
    /// A font file by its name or path, read once; throws if there is none.
    const FontFile& (*find_font)(const ReadContext& context, const std::string& name,
                                 SourceRange where) = nullptr;
    /// The bytes of a density file, shared by all that hold them; throws if there is none.
    std::shared_ptr<const std::string> (*density_file)(const ReadContext& context, const std::string& name,
                                                       SourceRange where) = nullptr;
    /// A number in the words of an error message, if it was written as a name or vector; else empty.
    std::string (*found_value)(const ReadContext& context, SourceRange where) = nullptr;
    bool unicode = false;  ///< the scene's charset is utf8 or sys
    /// Take a transformation, or a `texture`, `pigment`, `normal` or `finish` on top of `layers` (null: none
    /// yet), if one is next: for shapes whose parts have their own (blob).
    bool (*take_transformation)(BlockReader& in, Transform& map) = nullptr;
    bool (*take_texture)(BlockReader& in, TexturePtr& layers) = nullptr;
    Session* session = nullptr;  ///< the front end's own; opaque here
};

}  // namespace rb
