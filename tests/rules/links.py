#!/usr/bin/env python3
"""Names libraries that are linked against the direction: what may not be included may not be linked either.

Usage: links.py ROOT     prints "file: library: dependency: rule" for each, and exits 1 when there is one.

A library of a room is named after its folder, drivers_base of drivers/base, or begins with that name (drivers_base_files).
"""

import pathlib
import re
import sys

import table

LIBRARY = re.compile(r"kaori_library\(\s*(\S+)([^)]*)\)")
WORDS = {"SOURCES", "DEPS", "PRIVATE_DEPS"}


def deps_of(body):
    """What stands behind DEPS and PRIVATE_DEPS."""
    kind, found = None, []
    for word in re.sub(r"#[^\n]*", "", body).split():
        if word in WORDS:
            kind = word
        elif kind in ("DEPS", "PRIVATE_DEPS"):
            found.append(word)
    return found


def declared(root):
    """(file, room, library, all that stands behind its name), of every CMakeLists.txt but those of tests."""
    rooms = (root / room for room in table.SOURCE_ROOMS if room != "tests")
    for file in sorted(file for room in rooms for file in room.rglob("CMakeLists.txt")):
        path = file.relative_to(root)
        for name, body in LIBRARY.findall(file.read_text(encoding="utf-8")):
            yield str(path), f"{path.parent.as_posix()}/", name, body


def libraries(root):
    """(file, room, library, its dependencies), those of the system among them."""
    return ((path, room, name, deps_of(body)) for path, room, name, body in declared(root))


def with_sources(root):
    """(file, room, library, whether it has sources, so that an archive is made of it)."""
    return ((path, room, name, "SOURCES" in body.split()) for path, room, name, body in declared(root))


def offences(root):
    found = list(libraries(root))
    if not found:
        sys.exit(f"{root} has no libraries")
    rooms = {name: room for _, room, name, _ in found}
    for path, room, name, deps in found:
        its_row, allowed = next((row for row in table.MAY_INCLUDE if room.startswith(row[0])), (room, ()))
        for dep in deps:
            its_room = rooms.get(dep)
            if its_room is not None and not its_room.startswith((its_row, *allowed)):
                yield f"{path}: {name}: {dep}: {room} may link only {', '.join(allowed) or 'nothing'}"
            of_system = its_room is None and dep not in table.PURE_ROOMS_LINK.get(name, ())
            if of_system and room.startswith(table.PURE_ROOMS):
                yield f"{path}: {name}: {dep}: {room} links no library of the system, but for PURE_ROOMS_LINK of tests/rules/table.py"


def main():
    found = list(offences(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "every library links with the direction")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
