#!/usr/bin/env python3
"""Makes tests/language/expressions.txt: random expressions of the scene language and the text that povray gives for them.

usage: scripts/remake_expressions.py [povray]

Everything is drawn from a fixed seed, so that the same povray gives the same file. An expression that povray refuses
is kept with "refused: message". Left out on purpose: what is undefined in the reference (comparisons with fewer terms on the right, vstr of a
float).
"""
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path

OUT = Path(__file__).resolve().parent.parent / "tests" / "language" / "expressions.txt"
rng = random.Random(20)

DECLARATIONS = """
#declare One = 1; #declare Two = 2; #declare Half = 0.5; #declare Neg = -3.25; #declare Big = 123456.789;
#declare P2 = <0.25, -1.5>; #declare P3 = <1, -2, 3.5>; #declare Q3 = <-0.5, 4, 2>; #declare P4 = <1, 2, 3, 4>;
#declare C5 = rgbft <0.1, 0.2, 0.3, 0.4, 0.5>; #declare D5 = color rgb <1, 0.5, 0.25>; #declare E5 = srgb <0.5, 0.25, 1>;
#declare T1 = "abc"; #declare T2 = "Hello, World"; #declare T3 = ""; #declare T4 = "12.5e1 apples";
#declare A1 = array[4] {1.5, -2, 3, 10}; #declare A2 = array[2][3] {{1, 2, 3}, {4, 5, 6}};
#declare AV = array[3] {<1, 2, 3>, <4, 5, 6>, <-1, 0, 1>}; #declare AT = array[2] {"first", "second"};
#declare AC = array[2] {rgb <0.1, 0.2, 0.3>, rgbt <0.4, 0.5, 0.6, 0.7>};
#declare SL = spline {linear_spline 0, <0, 0, 0>, 1, <1, 2, 0>, 3, <2, -1, 1>, 4, <5, 0, 2>};
#declare SQ = spline {quadratic_spline -1, <0, 1>, 0.5, <2, 3>, 2, <-1, 4>, 3, <0, 0>};
#declare SC = spline {cubic_spline -1, <1, 0, 0>, 0, <0, 1, 0>, 1, <0, 0, 1>, 2, <1, 1, 0>, 3, <0, 1, 1>};
#declare SN = spline {natural_spline 0, <0, 0, 1, 2, 3>, 1, <1, 2, 3, 4, 5>, 2.5, <2, 0, 1, 1, 0>, 4, <0, 4, 2, 0, 1>};
#macro Plus(A, B) A + B #end
#macro Times(A, B) (A * B) #end
#macro Square(X) X * X #end
#macro Swapped(V) <V.y, V.x> #end
#macro Twice(V) #local R = V * 2; R #end
#macro Fact(N) #if (N <= 1) 1 #else (N * Fact(N - 1)) #end #end
#macro Pick(N) #switch (N) #case (1) 10 #break #range (2, 4) 20 #break #else 30 #end #end
#macro Total(N) #local S = 0; #for (I, 1, N) #local S = S + I; #end S #end
#macro Bang(S) concat(S, "!") #end
""".strip()

NUMBERS = ["0", "1", "2", "3", "0.5", ".25", "1.5", "10", "7.", "1e-3", "2.5e2", "100", "0.1", "3.7", "1e1", "4"]
FLOATS = ["One", "Two", "Half", "Neg", "Big", "pi", "true", "false", "yes", "no", "on", "off", "clock",
          "A1[0]", "A1[1]", "A1[2.7]", "A2[1][0]", "A2[0][2]", "A1[Two]", "P3.x", "P3.y", "Q3.z", "P2.u", "P2.v", "P4.t",
          "C5.red", "C5.filter", "C5.transmit", "D5.gray", "P3.gray", "E5.green", "E5.red", "AV[1].z", "AV[2].x", "AC[1].transmit",
          "AC[0].blue", "clock_on", "version", "C5.x", "D5.y"]
VECTORS = {2: ["P2", "u", "v", "SQ(1)"], 3: ["P3", "Q3", "x", "y", "z", "AV[0]", "AV[2]", "SL(0.3)", "SL(2)", "SC(0.25)"],
           4: ["P4"], 5: ["C5", "D5", "E5", "AC[0]", "AC[1]", "SN(0.7)"]}
COMPONENTS = {2: "x y u v red green", 3: "x y z u v red green blue gray", 4: "x y z t red filter gray", 5: "x y z t red green blue filter transmit gray"}
SEPARATORS = ['","', '" / "', '""']
DATES = ["", ', "%Y"', ', "%H:%M:%S"', ', "%j %d.%m.%y"']
UNARY = "abs ceil floor int sin cos tan sinh cosh tanh atan asinh degrees radians exp".split()


def join(parts, sign):
    return f" {sign} ".join(parts) if rng.random() < 0.7 else sign.join(parts)


def number():
    return rng.choice(NUMBERS)


def call1(depth):
    name = rng.choice(UNARY + "sqrt ln log asin acos acosh atanh".split())
    arg = full(depth) if rng.random() < 0.3 else sum_(depth)
    if name == "sqrt":
        arg = f"abs({arg})"
    elif name in ("ln", "log"):
        arg = f"abs({arg}) + 0.5"
    elif name in ("asin", "acos", "atanh", "sin", "exp", "sinh", "cosh") or rng.random() < 0.3:
        arg = f"mod({sum_(depth)}, 1)" if rng.random() < 0.9 else arg
    elif name == "acosh":
        arg = f"1 + abs({arg})"
    return f"{name}({arg})"


def call(depth):
    kind = rng.randrange(16)
    if kind < 5:
        return call1(depth - 1)
    a, b = sum_(depth - 1), sum_(depth - 1)
    if kind == 5:
        return rng.choice([f"atan2({a}, {b} + 0.125)", f"mod({a}, {b})", f"div({a}, {b})", f"pow(abs({a}) + 0.1, {rng.choice(NUMBERS)})",
                           f"pow({number()}, {number()} + 0.5)"])
    if kind == 6:
        return f"{rng.choice(['min', 'max'])}({', '.join(sum_(depth - 1) for _ in range(rng.randint(1, 4)))})"
    if kind == 7:
        return f"select({', '.join(sum_(depth - 1) for _ in range(rng.choice([3, 4])))})"
    if kind == 8:
        return f"bitwise_{rng.choice(['and', 'or', 'xor'])}({', '.join(sum_(depth - 1) for _ in range(rng.choice([2, 3])))})"
    if kind == 9:
        return f"vdot({vector(3, depth - 1)}, {vector(3, depth - 1)})"
    if kind == 10:
        return f"vlength({vector(3, depth - 1)})"
    if kind == 11:
        s, t = string(depth - 1), string(depth - 1)
        return rng.choice([f"strlen({s})", f"strcmp({s}, {t})", f"asc({s})", f"val({s})", f"({s} {rng.choice('< <= = != >= >'.split())} {t})"])
    if kind == 12:
        return rng.choice([f"Plus({a}, {b})", f"Times({a}, {b})", f"Square({a})", f"Twice({a})", f"Fact({rng.randint(0, 7)})",
                           f"Pick({rng.randint(0, 5)})", f"Total({rng.randint(0, 9)})", f"2*Plus({a}, {b})", f"Square({number()}+{number()})"])
    if kind == 13:
        return rng.choice(["dimensions(A1)", "dimensions(A2)", "dimension_size(A2, 1)", "dimension_size(A2, 2)", "dimension_size(A2, 3)",
                           "defined(One)", "defined(Nothing)", "defined(A1)", "defined(A1[0])", "defined(sin)"])
    if kind == 14:
        stream = rng.randint(-5, 100000)
        return f"rand(seed({stream}))"
    n = rng.choice([2, 3, 4, 5])
    return f"({vector(n, depth - 1)}).{rng.choice(COMPONENTS[n].split())}"


def factor(depth):
    if rng.random() < 0.12:
        return rng.choice(["-", "- ", "+", "!", "- -"]) + factor(depth)
    if depth <= 0 or rng.random() < 0.3:
        return number() if rng.random() < 0.5 else rng.choice(FLOATS)
    if rng.random() < 0.3:
        return f"({full(depth - 1)})"
    return call(depth)


def term(depth):
    out = factor(depth)
    while rng.random() < 0.35:
        out += rng.choice([" * ", "*", " / ", "/"]) + factor(depth)
    return out


def sum_(depth):
    out = term(depth)
    while rng.random() < 0.35:
        out += rng.choice([" + ", "+", " - ", "-"]) + term(depth)
    return out


def relation(depth):
    out = sum_(depth)
    while rng.random() < 0.3:
        out += f" {rng.choice('< <= = != >= >'.split())} " + sum_(depth)
    return out


def full(depth):
    out = relation(depth)
    while rng.random() < 0.3:
        out += rng.choice([" & ", " | "]) + relation(depth)
    if rng.random() < 0.2:
        out += f" ? {full(depth - 1)} : {full(depth - 1)}" if depth > 0 else " ? 1 : 2"
    return out


def vector(n, depth):
    if depth <= 0 or rng.random() < 0.25:
        return rng.choice(VECTORS[n]) if rng.random() < 0.6 else "<" + ", ".join(number() for _ in range(n)) + ">"
    kind = rng.randrange(10)
    if kind < 3:
        return "<" + rng.choice([", ", ","]).join(sum_(depth - 1) for _ in range(n)) + ">"
    if kind < 5:
        return f"({vector(n, depth - 1)} {rng.choice('+-*/')} {vector(rng.randint(2, n), depth - 1)})"
    if kind == 5:
        return f"({rng.choice([number(), vector(2, 0)])} {rng.choice('+-*/')} {vector(n, depth - 1)})"
    if kind == 6:
        return f"(-{vector(n, depth - 1)})"
    if kind == 7:
        return f"({vector(n, depth - 1)} {rng.choice('= != < > <= >= & |'.split())} {vector(n, depth - 1)})"
    if kind == 8:
        return f"({full(0)} ? {vector(n, depth - 1)} : {vector(n, depth - 1)})"
    if n != 3:
        return f"({vector(n, depth - 1)} * {number()})" if n > 2 else f"Swapped({rng.choice(VECTORS[2][:3])})"
    a = vector(3, depth - 1)
    b = vector(rng.choice([2, 3]), depth - 1)
    return rng.choice([f"vcross({a}, {b})", f"vnormalize({a} + <0.1, 0.2, 0.3>)", f"vrotate({a}, {b})", f"vaxis_rotate({a}, <1, 2, 3>, {sum_(0)})",
                       f"vturbulence({rng.choice(['2', '1.5', '3'])}, 0.5, {rng.randint(1, 8)}, {vector(3, 0)})", f"vrotate({a}, {number()} * 90)"])


def string(depth):
    kind = rng.randrange(11) if depth > 0 else 0
    if kind < 3:
        return rng.choice(["T1", "T2", "T3", "T4", "AT[0]", "AT[1]", '"x"', '"a\\"b"', '"tab\\\\"', '"3.5"', '"-7e2x"', '" 4"', '"Zz"'])
    if kind == 3:
        return f"concat({', '.join(string(depth - 1) for _ in range(rng.randint(1, 4)))})"
    if kind == 4:
        return f"str({sum_(depth - 1)}, {rng.randint(-12, 12)}, {rng.randint(-2, 9)})"
    if kind == 5:
        n = rng.choice([2, 3, 4, 5])
        return f"vstr({rng.randint(1, 5)}, {vector(n, depth - 1)}, {rng.choice(SEPARATORS)}, {rng.randint(-8, 8)}, {rng.randint(-1, 5)})"
    if kind == 6:
        return f"chr({rng.randint(33, 126)})"
    if kind == 7:
        return f"substr(T2, {rng.randint(0, 8)}, {rng.randint(0, 6)})"
    if kind == 8:
        return f"{rng.choice(['strupr', 'strlwr'])}({string(depth - 1)})"
    if kind == 9:
        return f"datetime({rng.choice(['0', '1', '5000.25', '-100.5', '366.999', '7000.123456'])}{rng.choice(DATES)})"
    return f"Bang({string(depth - 1)})"


def function_body(names, depth):
    """What function { } takes: other levels than a scene's, exact comparisons, constants folded in povray's own way."""
    def fsum(d):
        return join_chain(lambda: fterm(d), [" + ", " - ", "+", "-"], 0.4)

    def fterm(d):
        return join_chain(lambda: funary(d), [" * ", " / ", "*", "/"], 0.3)

    def join_chain(part, signs, chance):
        out = part()
        while rng.random() < chance:
            out += rng.choice(signs) + part()
        return out

    def funary(d):
        return ("-" if rng.random() < 0.1 else "") + fprimary(d)

    def fprimary(d):
        if d <= 0 or rng.random() < 0.45:
            return rng.choice(names) if rng.random() < 0.5 else rng.choice(["1", "2", "0.5", "3", "10", "0.25", "pi", "Two", "Half", "Neg", "7"])
        kind = rng.randrange(8)
        if kind < 3:
            return f"({frel(d - 1)})"
        if kind < 6:
            return f"{rng.choice(['sin', 'cos', 'abs', 'floor', 'ceil', 'int', 'atan', 'tanh', 'exp', 'radians', 'degrees', 'sqrt', 'ln'])}({fsum(d - 1)})"
        if kind == 6:
            return rng.choice([f"min({fsum(d - 1)}, {fsum(d - 1)})", f"max({fsum(d - 1)}, {fsum(d - 1)}, {fsum(0)})", f"mod({fsum(d - 1)}, {fsum(0)})",
                               f"pow({fsum(0)}, {rng.randint(1, 9)})", f"atan2({fsum(0)}, {fsum(0)})", f"div({fsum(0)}, 2)", f"pow(abs({fsum(0)}), 1.5)"])
        return rng.choice([f"select({fsum(d - 1)}, {fsum(0)}, {fsum(0)})", f"select({fsum(d - 1)}, {fsum(0)}, {fsum(0)}, {fsum(0)})",
                           f"sum(i, 1, 4, i * {fsum(0)})", f"prod(j, 1, 3, j + {fsum(0)})"])

    def frel(d):
        return join_chain(lambda: fsum(d), [" < ", " > ", " <= ", " >= ", " = ", " != ", " & ", " | "], 0.12)

    return frel(depth)


def cases():
    declarations = DECLARATIONS.split("\n")
    lines = []
    for i in range(500):
        lines.append(f"str({sum_(rng.choice([1, 2, 2, 3]))}, 0, 9)")
    for i in range(200):
        lines.append(f"str(({full(2)}), 0, 9)")
    for i in range(350):
        n = rng.choice([2, 3, 3, 4, 5])
        lines.append(f'vstr({n}, {vector(n, 2)}, " ", 0, 6)')
    for i in range(250):
        lines.append(string(3))
    for i in range(80):
        name = rng.choice(["SL", "SQ", "SC", "SN"])
        kind = rng.choice(["", ", linear_spline", ", quadratic_spline", ", cubic_spline", ", natural_spline"])
        lines.append(f'vstr({dict(SL=3, SQ=2, SC=3, SN=5)[name]}, {name}({rng.choice(["-2", "0", "0.5", "1", "1.75", "2.25", "3", "3.9", "5"])}{kind}), " ", 0, 6)')
    for i in range(300):
        names = rng.choice([["x", "y", "z"], ["a", "b"], ["r", "y"]])
        head = "" if names == ["x", "y", "z"] else "(" + ", ".join(names) + ")"
        declarations.append(f"#declare F{i} = function {head} {{ {function_body(names, rng.choice([1, 1, 2]))} }}")
        for _ in range(2):
            args = ", ".join(rng.choice(["0.3", "-1.25", "2", "10", "0", "-0.75", "1.5"]) for _ in names)
            lines.append(f"str(F{i}({args}), 0, 9)")
    return declarations, [line for line in lines if len(line) < 230]


def run(povray, text):
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "e.pov").write_text(text)
        done = subprocess.run([povray, "+Ie.pov", "-D", "+W1", "+H1", "-F", "+GDdebug.txt", "+GFfatal.txt"], cwd=folder, capture_output=True, text=True, timeout=120)
        debug = Path(folder, "debug.txt")
        return done.returncode, debug.read_text() if debug.exists() else "", done.stderr


def measured(povray, declarations, lines):
    """What povray says to each line; a refused line is taken out and the rest asked again."""
    declarations = list(declarations)
    answers = {}
    while True:
        asked = [i for i in range(len(lines)) if i not in answers]
        head = ["#version 3.7;", "global_settings { assumed_gamma 1 }"] + declarations
        text = head + [f'#debug concat("{i}:", {lines[i]}, "\\n")' for i in asked] + ["sphere { 0, 1 }"]
        code, debug, errors = run(povray, "\n".join(text) + "\n")
        if code == 0:
            break
        at = re.search(r"line\s+(\d+):\s+Parse\s+Error:\s+(.*?)\s*Fatal", errors, re.S)
        if not at:
            sys.exit(errors)
        place = int(at[1]) - 1
        if 2 <= place < len(head) and head[place].startswith("#declare F"):
            name = re.search(r"#declare (\w+)", declarations.pop(place - 2))[1]
            lines = [line for line in lines if f"{name}(" not in line]
            continue
        # Other errors may have their place in a macro: the refused line is the first one without an answer.
        said = {int(n) for n in re.findall(r"^(\d+):", debug, re.M)}
        answers[min(i for i in asked if i not in said)] = "refused: " + " ".join(at[2].split())
    for line in re.findall(r"^\d+:.*$", debug, re.M):
        number, _, text = line.partition(":")
        # povray breaks longer lines.
        if len(line) < 75:
            answers[int(number)] = text
    return declarations, lines, answers


def main():
    povray = sys.argv[1] if len(sys.argv) > 1 else "povray"
    declarations, lines, answers = measured(povray, *cases())
    out = declarations + [f"{line}\t{answers[i]}" for i, line in enumerate(lines) if i in answers]
    OUT.write_text("\n".join(out) + "\n")
    print(f"{len(lines)} expressions, {sum(a.startswith('refused: ') for a in answers.values())} refused")


main()
