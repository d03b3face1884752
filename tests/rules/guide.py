#!/usr/bin/env python3
"""Tries what the guide and the other pages say: commands are known, links resolve, pictures exist and are small.

Usage: guide.py ROOT BIN     BIN holds kaori-atelier and kaori-stage; prints "file:line: fault" for each, and exits 1
                             when there is one.
"""

import functools
import pathlib
import re
import subprocess
import sys

MOST_PICTURES_BYTES = 3_000_000
LINK = re.compile(r"!?\[[^\]]*\]\(([^)#]+)(?:#[^)]*)?\)")
COMMAND = re.compile(r"(?:^    |`)((?:kaori-\w+|\./box) [^`#\n]+)")


@functools.cache
def help_of(*command):
    """What a program says of itself; empty where it does not know what it was asked."""
    done = subprocess.run([*command], capture_output=True, text=True, check=False)
    return done.stdout if done.returncode == 0 else ""


def check_words(words, usage):
    """Faults of `words` (those behind a verb), by a usage line such as "pack FOLDER FILE [--sign KEYFILE]"."""
    takes_value = dict(re.findall(r"\[(--[\w-]+)( [A-Z_]+)?\]", usage))
    wanted = re.sub(r"\[[^\]]*\]", "", usage).split()
    given, rest = [], list(words)
    while rest:
        word = rest.pop(0)
        if not word.startswith("--"):
            given.append(word)
        elif word not in takes_value:
            yield f"there is no option {word}"
        elif takes_value[word] and not rest:
            yield f"{word} wants a value"
        elif takes_value[word]:
            rest.pop(0)
    open_ended = bool(wanted) and wanted[-1].endswith("...")
    if len(given) < len(wanted) or (len(given) > len(wanted) and not open_ended):
        yield f"{len(given)} words where {len(wanted)} are wanted"


def check_atelier(words, binaries):
    page = help_of(str(binaries / "kaori-atelier"), words[0], "--help")
    first = page.splitlines()[0] if page else ""
    usage = re.match(rf"kaori-atelier {re.escape(words[0])}([^:]*):", first)
    if not usage:
        yield f"kaori-atelier has no verb {words[0]}"
    elif len(words) > 1:  # A verb alone is only named.
        yield from check_words(words[1:], usage[1])


def check_box(words, root):
    page = help_of(str(root / "box"), "help")
    verb = re.findall(rf"^  \./box {re.escape(words[0])}\b.*(?:\n   .*)*", page, re.MULTILINE)
    if not verb:
        yield f"./box knows no {words[0]}"
    yield from (f"./box {words[0]} has no {word}" for word in words[1:]
                if word.startswith("--") and word != "--help" and word not in "\n".join(verb))


def check_program(program, words, binaries):
    page = help_of(str(binaries / program), "--help")
    yield from (f"{program} has no {word}" for word in words if word.startswith("--") and word not in page)


def check_command(command, root, binaries):
    program, *words = command.split()
    if program == "kaori-atelier":
        return check_atelier(words, binaries)
    return check_box(words, root) if program == "./box" else check_program(program, words, binaries)


def check_page(page, root, binaries):
    for number, line in enumerate(page.read_text(encoding="utf-8").splitlines(), 1):
        faults = [fault for command in COMMAND.findall(line) for fault in check_command(command, root, binaries)]
        faults += [f"{target} is not there" for target in LINK.findall(line)
                   if not target.startswith("http") and not (page.parent / target).exists()]
        yield from (f"{page.relative_to(root)}:{number}: {fault}" for fault in faults)


def offences(root, binaries):
    pages = sorted((root / "docs/guide").glob("*.md"))
    if not pages:
        yield "docs/guide: holds no page"
    for page in [*pages, *sorted((root / "docs").glob("*.md")), *sorted(root.glob("*.md"))]:
        yield from check_page(page, root, binaries)
    pictures = list((root / "docs/guide/pictures").iterdir())
    if sum(picture.stat().st_size for picture in pictures) > MOST_PICTURES_BYTES:
        yield f"docs/guide/pictures: more than {MOST_PICTURES_BYTES} bytes"
    text = "".join(page.read_text(encoding="utf-8") for page in pages)
    yield from (f"docs/guide/pictures/{picture.name}: no page shows it" for picture in pictures
                if f"pictures/{picture.name}" not in text)


def main():
    found = list(offences(pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()))
    print("\n".join(found) or "the guide holds")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
