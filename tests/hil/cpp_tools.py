"""What programs C++ starts, by the texts in its source; read by tools_test.py.

Seen are lists of words ({"dd", ...}) that a starter gets, at the call or in a variable, and lines for a shell: those of std::system and
popen, of functions of the file that hand theirs on, and what stands behind "sh", "-c" or within sh -c '...'.
"""

import re

STARTERS = r"\b(?:RunToEnd|Process::Start|RunProgram|OutputOf)\("
SHELLS = ("std::system", "popen")
LITERAL = r'"((?:[^"\\\n]|\\.)*)"'
# A function with its indentation, parameters and body, as clang-format lays it out.
FUNCTION = re.compile(r"^( *)[A-Za-z_][\w:<>&* ]* (\w+)\(([^()]*)\)(?: const)?(?: override)? \{\n(.*?)^\1\}", re.MULTILINE | re.DOTALL)
LINE_OF_FUNCTION = re.compile(r"^( *)[A-Za-z_][\w:<>&* ]* (\w+)\(([^()]*)\)(?: const)?(?: override)? \{ (.*) \}$", re.MULTILINE)
WORKS = re.compile(r"fmt::format|std::string|[.]c_str\(\)|[.]string\(\)|\bR\b")  # Of a text they are no part.


def without_comments(source):
    return re.sub(LITERAL + r"|//[^\n]*", lambda found: found[0] if found[0].startswith('"') else "", source)


def arguments(code, begin):
    """What stands between the parentheses of a call; `begin` is behind the opening one."""
    depth, at = 1, begin
    for token in re.finditer(LITERAL + r"|[()]", code[begin:]):
        depth += {"(": 1, ")": -1}.get(token[0], 0)
        at = begin + token.end()
        if depth == 0:
            return code[begin:at - 1]
    return code[begin:at]


def text_of(expression):
    """The shell's line of an expression: its literals in a row, and $x for whatever else is put in."""
    line = ""
    for token in re.finditer(LITERAL + r"|[^\"]+", WORKS.sub("", expression)):
        if token[0].startswith('"'):
            line += re.sub(r"\\(.)", r"\1", token[1])
        elif re.search(r"\w", token[0]):
            line += "$x"
    return line


def shell_lines(source):
    """The lines that a shell gets."""
    code = without_comments(source)
    functions = {name: (parameters, body) for _, name, parameters, body in FUNCTION.findall(code) + LINE_OF_FUNCTION.findall(code)}
    shells = list(SHELLS)
    for shell in shells:  # Grows: a function whose parameter is the line, or begins it, is one too.
        for name, (parameters, body) in functions.items():
            own = re.findall(r"std::string(?:_view)?&? (\w+)", parameters)
            begins = (re.match(r"\W*(\w+)", arguments(body, call.end())) for call in re.finditer(rf"\b{shell}\(", body))
            if name not in shells and any(begin and begin[1] in own for begin in begins):
                shells.append(name)
    for shell in shells:
        for call in re.finditer(rf"\b{shell}\(", code):
            given = arguments(code, call.end())
            yield text_of(given)
            for name in set(re.findall(r"\w+", re.sub(LITERAL, "", given))):
                yield from (text_of(value) for value in re.findall(rf"\b(?:auto|string) {name} =([^;]*);", code))
                if name in functions and name not in shells:  # One that makes the line, and what it makes it of.
                    yield from (text_of(made) for made in re.findall(r"\breturn ([^;]*);", functions[name][1]))
                    yield from (text_of(arguments(given, inner.end())) for inner in re.finditer(rf"\b{name}\(", given))
    for text in re.findall(r'\{\s*"(?:/bin/)?(?:ba)?sh",\s*"-c",([^{}]*(?:\{[^{}]*\}[^{}]*)*)\}', code):
        yield text_of(text)


def words_of(source):
    """The first words of lists that a starter gets."""
    code = without_comments(source)
    yield from re.findall(STARTERS + r'\s*\{\s*"([^"]+)"', code)
    yield from re.findall(r'(?:command\{|[.]qemu = )"([^"]+)"', code)
    for name in set(re.findall(STARTERS + r"\s*(\w+)\s*[,)]", code)):
        yield from re.findall(rf'\bstd::vector<std::string> {name}(?: =)? ?\{{\s*"([^"]+)"', code)


def cpp_tools(source, shell_tools):
    """All names. `shell_tools` gives those of a script."""
    found = {word.rsplit("/", 1)[-1] for word in words_of(source)}
    for line in shell_lines(source):
        for part in (line, *re.findall(r"\bsh -c '([^']*)", line)):
            found |= shell_tools(part)[0]
    return found
