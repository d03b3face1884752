#!/usr/bin/env python3
"""Names what a library's objects call of libraries that it does not declare, by the symbols of the built archives.

Usage: symbols.py ROOT BUILD     prints "library: symbol: of library ..." for each, and exits 1 when there is one.

Programs link every archive that any of their libraries wants, so that an undeclared use links in most of them: the linker
alone tells nothing. What links.py says of the declarations is therefore compared with the objects: a symbol that an
archive leaves undefined, and that any library of the product defines, must be defined in the closure of DEPS and
PRIVATE_DEPS. Headers without a source have no symbols, and direction.py reads who includes them.
"""

import collections
import pathlib
import re
import subprocess
import sys

import links

# What the language itself may call anywhere, though hw-sim/rehearsal counts allocations by defining them anew.
REPLACEABLE = re.compile(r"_Z(n[wa]|d[la])")  # operator new and delete
LINE = re.compile(r"(?P<archive>.*?\.a):[^:]*:\s*[0-9a-f]* (?P<kind>[A-Za-z]) (?P<symbol>\S+)$")


def archives(root, build):
    """(library -> its archive; libraries with sources whose archive is missing). Firmware of a chip is built apart."""
    there = {file.name: file for file in build.rglob("lib*.a")}
    found, missing = {}, []
    for path, room, name, has_sources in links.with_sources(root):
        if not has_sources:
            continue
        if file := there.get(f"lib{name}.a"):
            found[name] = file
        else:
            missing.append(f"{path}: {name}: its archive lib{name}.a is not built")
    return found, missing


def symbols(files):
    """Archive -> (symbols that it defines, symbols that it leaves to others)."""
    done = subprocess.run(["nm", "--extern-only", "--print-file-name", *map(str, files)], capture_output=True, text=True, check=True)
    found = collections.defaultdict(lambda: (set(), set()))
    for line in done.stdout.splitlines():
        if match := LINE.match(line):
            found[match["archive"]][match["kind"] in "Uwv"].add(match["symbol"])
    return {archive: (own, wanted - own) for archive, (own, wanted) in found.items()}


def closure(name, deps):
    """The library itself and everything that it declares, at any depth."""
    seen, left = set(), [name]
    while left:
        if (library := left.pop()) not in seen:
            seen.add(library)
            left.extend(dep for dep in deps.get(library, ()) if dep in deps)
    return seen


def readable(symbol):
    return subprocess.run(["c++filt", symbol], capture_output=True, text=True, check=True).stdout.strip()


def undeclared(root, found):
    """Lines "library: symbol: of library ..." of the archives `found` (library -> archive)."""
    deps = {name: its for _, _, name, its in links.libraries(root)}
    of_archive = symbols(found.values())
    of_library = {name: of_archive.get(str(file), (set(), set())) for name, file in found.items()}
    definers = collections.defaultdict(set)
    for name, (own, _) in of_library.items():
        for symbol in own:
            definers[symbol].add(name)
    for name, (_, wanted) in sorted(of_library.items()):
        allowed = closure(name, deps)
        for symbol in sorted(wanted):
            others = definers.get(symbol)
            if others and not others & allowed and not REPLACEABLE.match(symbol):
                yield f"{name}: {readable(symbol)}: of {', '.join(sorted(others))}, which it does not declare"


def offences(root, build):
    found, missing = archives(root, build)
    yield from missing
    if found:
        yield from undeclared(root, found)


def main():
    found = list(offences(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])))
    print("\n".join(found) or "every library calls only what it declares")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
