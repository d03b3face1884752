#!/usr/bin/env python3
"""Names functions, types and constants of the product's headers that nothing but tests uses.

Usage: unused.py ROOT     prints "header:line: name" for each, and exits 1 when there is one.

A name counts as used where it stands in the product's code (comments and texts apart) more often than in its declaration and
definition. Names that several headers declare are counted together, so that this finds too little rather than too much. An
exemption of tests/rules/table.py that is needed no longer is named too.
"""

import collections
import pathlib
import re
import sys

import direction
import table
import words

PRODUCT = ("firmware/", "drivers/", "render/", "appliance/", "hw-sim/")
DECLARED = re.compile(
    r"^\s*(?:\[\[nodiscard\]\] )?(?:template <[^>]*>\s*)?(?:inline |static |constexpr |explicit |virtual )*"
    r"(?:(?<![ ])(?:class|struct|enum class|using) (?P<type>[A-Z]\w+)(?=[ ;{:]|$)"
    r"|(?!\s*(?:return|co_return|else|case)\b)\s*\w[\w:<>,&*\s\[\]]*?[\s&*](?P<function>[A-Z]\w+)\("
    # An accessor's parameters and its end are on its line; else it may be a call of many kinds.
    r"|(?!\s*(?:return|co_return|else|case|throw|using)\b)\s*\w[\w:<>,&*\s\[\]]*?[\s&*](?P<accessor>[a-z]\w*)"
    r"\([^()]*\) ?(?:const)?(?: noexcept)?(?: override)? ?(?:\{|;|= 0;)"
    r"|[\w:<>,&*\s]+? (?P<constant>k[A-Z]\w+)\s*(?:=|\{|\[))")
NAME = re.compile(r"[A-Za-z_]\w*")


def code_of(text):
    return words.TEXT.sub(lambda match: re.sub(r"[^\n]", " ", match[0]) if not match[0].startswith("#include") else " ", text)


def offences(root, exempt=table.USED_FROM_OUTSIDE):
    """Lines "header:line: name", one for each name that only tests use, and one for each exemption of one that is used."""
    uses, declared = collections.Counter(), {}
    defined = collections.Counter()
    for path, file in direction.sources(root):
        if not path.startswith(PRODUCT):
            continue
        code = code_of(file.read_text(encoding="utf-8"))
        uses.update(NAME.findall(code))
        for number, line in enumerate(code.split("\n"), 1):
            if path.endswith(".h") and not path.startswith(table.FOR_TESTS_TOO) and (match := DECLARED.match(line)):
                name = match["type"] or match["function"] or match["accessor"] or match["constant"]
                declared.setdefault(name, []).append(f"{path}:{number}")
            # A definition begins at the edge of a line, perhaps of a member.
            for name in re.findall(r"^[A-Za-z][^=;]*?\b(?:\w+::)*([A-Za-z]\w*)\([^;]*\{?$", line):
                if path.endswith(".cpp"):
                    defined[name] += 1
    unused = {name: places for name, places in sorted(declared.items()) if uses[name] <= len(places) + defined[name]}
    for name, places in unused.items():
        if name not in exempt:
            yield from (f"{place}: {name}: only tests use it, or nobody" for place in places)
    yield from (f"tests/rules/table.py: {name}: the product uses it or has it no more: it needs no exemption"
                for name in exempt if name not in unused)


def main():
    found = list(offences(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "the product uses all that it declares")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
