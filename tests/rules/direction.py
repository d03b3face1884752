#!/usr/bin/env python3
"""Reads every #include and names those that run against the direction.

Usage: direction.py ROOT     prints "file:line: include: rule" for each, and exits 1 when there is one.
"""

import dataclasses
import pathlib
import re
import sys

import table

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')


@dataclasses.dataclass(frozen=True)
class Include:
    path: str  # Of the file that includes, from the root.
    line: int
    target: str
    quoted: bool


def sources(root):
    """Every source file, as (path from the root, Path)."""
    found = [file for room in table.SOURCE_ROOMS for file in sorted((root / room).rglob("*"))
             if file.suffix in table.SOURCE_SUFFIXES and "node_modules" not in file.parts]
    if not found:
        sys.exit(f"{root} holds no sources: is it the root?")
    return [(file.relative_to(root).as_posix(), file) for file in found]


def includes(path, file):
    for number, text in enumerate(file.read_text(encoding="utf-8", errors="replace").splitlines(), 1):
        if match := INCLUDE.match(text):
            yield Include(path, number, match[2], match[1] == '"')


def room_of(path):
    """The folder that a rule speaks of, and what it may include; None outside every room."""
    return next(((room, allowed) for room, allowed in table.MAY_INCLUDE if path.startswith(room)), None)


def check_quoted(include):
    """The rule that a "quoted" include breaks, or None."""
    if not include.target.startswith(table.EVERYTHING) or ".." in include.target.split("/"):
        return "a quoted include starts at the root with one of its folders"
    room, allowed = room_of(include.path) or (None, ())
    if room is None:
        return "this folder is no room of tests/rules/table.py"
    if include.target.startswith((room, *allowed)):
        return None
    if include.target.startswith("hw-sim/") and not include.path.startswith("hw-sim/"):
        return "nothing of the product includes hw-sim"
    if include.path.startswith("appliance/") and include.target.startswith(table.CONCRETE_DRIVERS):
        return None if include.path.endswith("/" + table.MAIN_FILE) else "only a program's main.cpp names a driver"
    return f"{room} may include only itself and {', '.join(allowed) or 'nothing else'}"


def check_angled(include):
    """The rule that an <angled> include breaks, or None."""
    if include.path.startswith("tests/"):
        return None
    if include.path.startswith(table.FREESTANDING_ROOMS) and include.target not in table.FREESTANDING:
        return "firmware without a chip is freestanding: no operating system, no heap, no streams"
    if include.path.startswith(table.PURE_ROOMS) and include.target.startswith(table.SYSTEM_HEADERS):
        return "bytes to values, and nothing else: no call of the system"
    for beginnings, rooms in table.LIBRARIES:
        if include.target.startswith(beginnings) and not include.path.startswith(rooms):
            return f"only {', '.join(rooms)} includes <{beginnings[0]}...>"
    return None


def offences(root):
    """Lines "file:line: include: rule", one for each include against the direction."""
    for path, file in sources(root):
        for include in includes(path, file):
            rule = check_quoted(include) if include.quoted else check_angled(include)
            if rule:
                yield f'{path}:{include.line}: {include.target}: {rule}'


def main():
    found = list(offences(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "every include runs with the direction")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
