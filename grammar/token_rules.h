#pragma once
// Building blocks for grammars over tokens. The input hands out kinds of tokens (`in.kind()`), produces a
// token when it is looked at, and knows two things that the language needs: directives are not executed while
// it is locked, and nesting is limited.
#include "grammar/token.h"

#include <tao/pegtl.hpp>

namespace rb::grammar {

using tao::pegtl::apply_mode;
using tao::pegtl::empty_list;
using tao::pegtl::if_must;
using tao::pegtl::must;
using tao::pegtl::opt;
using tao::pegtl::plus;
using tao::pegtl::rewind_mode;
using tao::pegtl::seq;
using tao::pegtl::sor;
using tao::pegtl::star;
using tao::pegtl::success;
using tao::pegtl::type_list;

/// One token of the kind.
template <Tok... kinds>
struct is {
    using rule_t = is;
    using subs_t = empty_list;
    template <class Input>
    static bool match(Input& in) {
        const Tok kind = in.kind();
        if (!((kind == kinds) || ...)) return false;
        in.bump();
        return true;
    }
};

/// Any token except these; never the end.
template <Tok... kinds>
struct is_not {
    using rule_t = is_not;
    using subs_t = empty_list;
    template <class Input>
    static bool match(Input& in) {
        const Tok kind = in.kind();
        if (kind == Tok::end || ((kind == kinds) || ...)) return false;
        in.bump();
        return true;
    }
};

/// One reserved word.
template <Keyword keyword>
struct word_is {
    using rule_t = word_is;
    using subs_t = empty_list;
    template <class Input>
    static bool match(Input& in) {
        if (!in.at_keyword(keyword)) return false;
        in.bump();
        return true;
    }
};

/// "<" of a vector; a packed list of vectors is taken apart here.
struct vector_open {
    using rule_t = vector_open;
    using subs_t = empty_list;
    template <class Input>
    static bool match(Input& in) {
        if (in.kind() == Tok::run) in.open_run();
        if (in.kind() != Tok::langle) return false;
        in.bump();
        return true;
    }
};

/// The token that follows is produced without the lock: every operand may begin with a directive.
struct open_next {
    using rule_t = open_next;
    using subs_t = empty_list;
    template <class Input>
    static bool match(Input& in) {
        in.produce_unlocked();
        return true;
    }
};

/// Looks at tokens without calling macros.
template <class... Rules>
struct quiet {
    using rule_t = quiet;
    using subs_t = type_list<Rules...>;
    template <apply_mode A, rewind_mode M, template <class...> class Action,
              template <class...> class Control, class Input, class... States>
    static bool match(Input& in, States&&... st) {
        const auto guard = in.be_quiet();
        return tao::pegtl::internal::seq<Rules...>::template match<A, M, Action, Control>(in, st...);
    }
};

/// Between brackets nothing is locked; brackets may nest only so deep.
template <class... Rules>
struct nested {
    using rule_t = nested;
    using subs_t = type_list<Rules...>;
    template <apply_mode A, rewind_mode M, template <class...> class Action,
              template <class...> class Control, class Input, class... States>
    static bool match(Input& in, States&&... st) {
        const auto guard = in.enter();
        return tao::pegtl::internal::seq<Rules...>::template match<A, M, Action, Control>(in, st...);
    }
};

/// A plain expression that the input can read by itself (TokenInput::take_quick); the rules beside it read
/// any.
template <bool full>
struct quick_expression {
    using rule_t = quick_expression;
    using subs_t = empty_list;
    template <apply_mode, rewind_mode, template <class...> class, template <class...> class, class Input,
              class State>
    static bool match(Input& in, State& state) {
        return in.take_quick(full, state);
    }
};

/// The rest of a block whose opening brace was taken: `Plain` items, other `Items`, then the brace that the
/// rule `Close` stands for.
template <class Plain, class Items, class Close>
struct block_rest {
    using rule_t = block_rest;
    using subs_t = type_list<Plain, Items, must<Close>>;
    template <apply_mode A, rewind_mode M, template <class...> class Action,
              template <class...> class Control, class Input, class... States>
    static bool match(Input& in, States&&... st) {
        const auto guard = in.enter();
        if (!Control<Plain>::template match<A, M, Action, Control>(in, st...)) return false;
        if (in.take_quick_close(st...)) return true;
        if (!Control<Items>::template match<A, M, Action, Control>(in, st...)) return false;
        if (in.take_quick_close(st...)) return true;
        return tao::pegtl::internal::must<Close>::template match<A, M, Action, Control>(in, st...);
    }
};

/// Items that the input can read by itself, and blocks that it can open, each with the comma behind it; there
/// may be none.
template <class Rest>
struct quick_items {
    using rule_t = quick_items;
    using subs_t = type_list<Rest>;
    template <apply_mode A, rewind_mode M, template <class...> class Action,
              template <class...> class Control, class Input, class... States>
    static bool match(Input& in, States&&... st) {
        while (true) {
            if (in.take_quick_item(st...)) continue;
            if (!in.take_quick_open(st...)) return true;
            if (!Control<Rest>::template match<A, M, Action, Control>(in, st...)) return false;
            in.take_quick_comma();
        }
    }
};

/// A question to the state, by name: `Question::ask(state)`.
template <class Question>
struct ask {
    using rule_t = ask;
    using subs_t = empty_list;
    template <apply_mode, rewind_mode, template <class...> class, template <class...> class, class Input,
              class State>
    static bool match(Input&, State& state) {
        return Question::ask(state);
    }
};

}  // namespace rb::grammar
