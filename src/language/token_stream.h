#pragma once
#include "language/symbols.h"
#include "language/token_file.h"

#include <initializer_list>
#include <optional>
#include <string>
#include <vector>

namespace rb {

struct Operand;
struct Session;

/// A token as the grammar sees it: words are looked up at this moment, so a macro's local that is its last
/// token survives the macro.
struct Produced {
    Tok kind = Tok::end;
    uint32_t word = 0;  ///< word's number; index of a `#` in its file; terms of a run
    double number = 0;
    SourceRange where;
    Place place;           ///< what a `name` stands for
    bool waiting = false;  ///< a `#` or macro name that was handed on as a token: it runs when that is over
};

/// The tokens of a scene in the order of execution: a stack of frames (files, macro calls, expanded lists),
/// each a range of an already lexed vector. Directives run when a token behind them is asked for.
class TokenStream {
public:
    explicit TokenStream(Session& session) : session_(session) {}

    /// The next token after running the directives before it; `Tok::end` at the end of the scene.
    Produced next();
    /// Gives back tokens that were looked at but not used (last one first).
    void give_back(Produced token) {
        if (!unread(token)) pushback_.push_back(std::move(token));
    }
    /// Steps back over the token if it is the last one read and reading it again gives the same; false: it is
    /// not.
    bool unread(const Produced& token);

    /// Reads a plain numeric expression that comes next (see QuickExpression) and that one of `ends` follows,
    /// if any are given; false: nothing was read.
    bool quick_sum(Operand& out, std::initializer_list<Tok> ends = {}) {
        return quick_operand(Level::sum, ends, out);
    }
    bool quick_full(Operand& out, std::initializer_list<Tok> ends = {}) {
        return quick_operand(Level::full, ends, out);
    }
    /// The same as `quick_sum` where the place that it names does not matter.
    bool quick_terms(Terms& out, SourceRange& where);
    /// `keyword {`, and the `}` of a block.
    bool quick_open(Produced& word);
    bool quick_at_statement() const;
    bool quick_brace();
    bool quick_close(SourceRange& where);
    /// The same for an item of a block: a word that stands alone, and [ "color" ] "rgb..." full without
    /// channels.
    bool quick_word(Produced& out);
    bool quick_color(Produced& first, Produced& word, Operand& base);
    bool quick_take(Tok kind);
    /// Kind of the next token in the file, as far as nothing comes before it.
    Tok quick_peek() const;

    /// True for a `#` or macro name that was handed on as a token but would run now.
    bool is_pending(const Produced& token) const;

    /// While locked, a `#` and a macro's name are handed on as tokens instead of being executed.
    bool locked = false;
    /// While quiet, macro names are handed on as names instead of being called.
    bool quiet = false;

    /// Whether the next token as written, before any look-up, is an arithmetic operator.
    bool operator_follows();

    void open_file(TokenFilePtr tokens, SourceRange included_at, bool own_table);
    /// Reads the vectors of a run as ordinary tokens.
    void open_run(const SourceRange& run);
    /// Executes the directive `word` written without its `#`.
    void run_directive(uint32_t word, SourceRange where) { execute(word, where, 0); }

    /// Notes that lead from `where` to the main file: macro expansions and includes.
    std::vector<Diagnostic> trail() const;
    /// After an error: drops macro calls and goes on behind the statement that began with the last mark().
    void mark();
    void recover();

    uint64_t produced() const { return produced_; }
    size_t include_depth() const;

private:
    enum class Level { sum, full, color };
    struct Cond {
        enum class Kind { if_, while_, for_, switch_ };
        Kind kind = Kind::if_;
        uint32_t hash = 0;  ///< index of the `#` of the branch being read
        bool taken = false;
        bool before_first_case = false;
        double value = 0;       // switch
        uint32_t resume = 0;    // loops: token after the keyword, or the start of the body
        uint32_t variable = 0;  // for
        SlotPtr slot;
        double end = 0;
        double step = 1;
    };
    struct Frame {
        enum class Kind { file, macro, list };
        Kind kind = Kind::file;
        TokenFilePtr tokens;
        uint32_t begin = 0;
        uint32_t at = 0;
        uint32_t end = 0;
        size_t conds = 0;
        bool own_table = false;
        SourceRange called;
        std::string name;
        int braces = 0;  ///< open when the macro was called
    };

    Frame& top() { return frames_.back(); }
    const Frame& top() const { return frames_.back(); }
    const Token& token_at(uint32_t index) { return top().tokens->tokens[index]; }
    void close_frame();
    void rewind_pushback();
    void run_hash(const Produced& hash);
    /// Without looking further, so that no directive runs.
    bool take_semicolon();
    /// True if the next token comes from the frame on top, with nothing that waits before it.
    bool reads_plainly() const;
    template <class Take>
    bool quick(Level level, std::initializer_list<Tok> ends, Take&& take);
    bool quick_operand(Level level, std::initializer_list<Tok> ends, Operand& out);
    bool is_plain(const Token& token) const;
    bool quick_argument(Operand& out);
    bool quick_arguments(const Macro& macro, std::vector<Operand>& arguments);
    /// "(" full ")"
    double condition();
    bool resolve(const Token& token, Produced& out);
    void warn_deprecated(Slot& slot, const Produced& at);
    void call(const MacroPtr& macro, SourceRange where);
    std::vector<Operand> read_arguments(const Macro& macro);
    [[noreturn]] void fail_arguments(const Macro& macro, size_t found, SourceRange where);

    // Raw reading, for directives: no look-up, no execution.
    Token raw_next();
    Token raw_peek();
    SourceRange range(const Token& token) { return top().tokens->range(token); }
    uint32_t raw_name(std::string_view expected);
    void raw_expect(Tok kind, std::string_view spelling);
    /// `( NAME`: the identifier of an open file.
    struct NamedFile {
        OpenFilePtr file;
        uint32_t word = 0;
        SourceRange where;
    };
    NamedFile raw_open_file();
    std::string found(const Token& token);
    /// The array element whose subscripts follow.
    Place raw_element(const Place& array, SourceRange where);

    // Directives (directives.cpp, loops.cpp, declare.cpp, files.cpp).
    class Executing;
    void execute(uint32_t word, SourceRange where, uint32_t hash);
    void dispatch(uint32_t word, SourceRange where, uint32_t hash);
    void execute_message(uint32_t word, SourceRange where);
    void do_include(SourceRange where);
    void do_declare(bool local, SourceRange where);
    /// What `word` stands for in the table `level`, made if need be; `before` if that table is closed.
    Place declared_place(uint32_t word, size_t level, bool local, SourceRange where, const Value& value,
                         const Place& before = {});
    void store(const Place& place, SourceRange where, Value value);
    void do_undef();
    void do_default(SourceRange where);
    void do_version(SourceRange where);
    void do_if(uint32_t hash, SourceRange where);
    void do_ifdef(bool wanted, uint32_t hash, SourceRange where);
    void do_else(uint32_t hash, SourceRange where);
    void do_elseif(uint32_t hash, SourceRange where);
    void do_switch(uint32_t hash, SourceRange where);
    void do_case(bool range, uint32_t hash, SourceRange where);
    void do_while(uint32_t hash, SourceRange where);
    void do_for(uint32_t hash, SourceRange where);
    void do_end(SourceRange where);
    void do_break(SourceRange where);
    void read_macro_head(Macro& macro);
    void do_macro(uint32_t hash, SourceRange where);
    void do_fopen(SourceRange where);
    void do_fclose();
    void do_read(SourceRange where);
    void do_write(SourceRange where);
    void pass_while(const Cond& cond);
    bool defined_in_parentheses();
    void check_cond(Cond::Kind kind, SourceRange where, std::string_view what);
    bool has_cond() { return conds_.size() > top().conds; }
    /// Goes on at the next branch (or the end) of the conditional whose branch began at `hash`.
    uint32_t skip_from(uint32_t hash, SourceRange where);
    uint32_t end_of(uint32_t hash, SourceRange where);
    void jump(uint32_t to);
    void skip_branches(Cond cond, SourceRange where);
    friend bool defined_name(Session& session);

    Session& session_;
    std::vector<Frame> frames_;
    std::vector<Cond> conds_;
    std::vector<Produced> pushback_;
    bool before_first_case_ = false;
    int executing_ = 0;  ///< directives, one within the other
    uint64_t produced_ = 0;
    int open_braces_ = 0;  ///< since mark()
};

}  // namespace rb
