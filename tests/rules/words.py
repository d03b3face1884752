#!/usr/bin/env python3
"""Names words that this project does not use, each with the one that it uses: docs/glossary.md is the list of the latter.

Usage: words.py ROOT     prints "file:line: word: say ..." for each, and exits 1 when there is one.

All text files of the tree are read. In code, names are taken apart (`SeatLids`, `stick_seat`) and their parts are looked at, in scripts too; comments, texts and pages are
read as English. A word may stand where an exemption says so, with its reason. Words that are common ones elsewhere are refused in the
folders alone where they would mean something of our own.
"""

import pathlib
import re
import subprocess
import sys

# (part of a name, what to say). Looked for in names of code and of files.
NAMES = (
    (r"wardrobes?", "appearance"),
    (r"needles?", "ExpressionEditor, handle"),
    (r"witness(es)?", "agent: the in-guest agent"),
    (r"strangers?", "unauthorised device"),
    (r"latch(es|ed)?", "FramePacer, or late input sampling"),
    (r"holders?", "fd keeper"),
    (r"nameplates?", "device name"),
    (r"lulls?", "pause"),
    (r"felled", "crashed"),
    (r"hands", "input, operator input, actions"),
    (r"seats?|seated", "DeviceSlot, ScreenSession"),
    (r"sights?", "detection, view"),
    (r"deeds?", "actions, commands"),
    (r"riddles?", "the plain name"),
)
# (part of a file's name, what to say): in code these are usual words.
FILES = ((r"words", "protocol, tokenizer, messages, names, by what it holds"),)
# (path's beginning, part of a name, what to say): in other folders the word is a usual one.
WITHIN = (
    ("drivers/scanout/", r"sheets?", "DumbBuffer, framebuffer"),
    ("drivers/scanout/", r"controllers?", "CRTC"),
    ("drivers/ports/", r"sheets?|controllers?", "DumbBuffer, CRTC"),
    ("drivers/ports/", r"signs?", "StatusDisplay"),
    ("drivers/", r"plates?", "descriptors"),
    ("hw-sim/devices/", r"plates?", "descriptors"),
    ("hw-sim/links/", r"plates?", "descriptors"),
    ("appliance/programs/lips/", r"goals?", "target"),
    ("appliance/core/performance/mouth", r"goals?", "target"),
    ("appliance/programs/status/", r"signs?", "StatusDisplay"),
    ("appliance/programs/stage/", r"signs?", "StatusDisplay"),
    ("appliance/programs/boot/", r"lights?", "boot splash"),
    ("appliance/core/roles/", r"channels?", "level"),
)
# Whole names.
WHOLE = ((re.compile(r"\bTake(?:[A-Z]\w*)?(?=\()"), "Handle, Accept, Parse, Acquire, Read, by what it does"),)

# (English words, what to say). Looked for in comments, texts, log lines and pages.
PROSE = (
    (r"wardrobes?", "appearance"),
    (r"(?<!kaori-)ateliers?", "authoring tool"),
    (r"witness(es|ed)?", "in-guest agent"),
    (r"strangers?", "unauthorised device"),
    (r"felled", "crashed"),
    (r"shutest", "minimum opening"),
    (r"nameplates?", "device name"),
    (r"lulls?", "pause"),
    (r"(?:moment|time) of (?:its |their )?light|c[oa]me?s? to light|came to light", "is presented; scan-out time"),
    (r"stays? dead|(?:sticks?|devices?) (?:is|are) (?:\w+ )?dead|dead sticks?", "is unauthorised, stays unauthorised"),
    (r"let(?:s|ting)?(?: (?:all|any|every|everything|no|none|nothing|what|it|them|USB|sticks?|devices?)){0,3} in(?! (?:an?|the|its|order|time)\b)",
     "authorises, is authorised"),
    (r"a hand's wait", "input latency"),
    (r"fell over", "flipped"),
    (r"deeds?", "action, command"),
    (r"holders?", "fd keeper"),
    (r"riddles?", "the plain name"),
    (r"kaori-(?:light|holder|figures)", "kaori-boot, kaori-fdkeeper, kaori-benchmark"),
    (r"microbenchmarks?", "benchmark"),
    # Not the verb ("hands over", "hands it on"), nor those of a clock or of a body.
    (r"(?<!clock )(?<!passing )(?<!clothes, )(?<!in their )hands(?! (?:over|on|out|back|it|them|the|a|what)\b)", "operator input, operators"),
)

# (path's beginning, pattern of NAMES or PROSE, reason).
EXEMPT = (
    ("tests/rules/", None, "the list itself, and what its tests seed"),
    # People call them needles, as the paper does: pages and pictures, and scripts that speak of those.
    *((begin, r"needles?", "the word for people") for begin in (
        "docs/needles.", "docs/guide/pictures", "docs/pictures.", "hw-sim/console/page/", "tests/hw-sim/browser/", "tests/system/browser_")),
    ("docs/glossary.md", None, "the list for people"),
    ("CHANGELOG.md", None, "what things were called before"),
    ("LICENSE", None, "not ours"),
)

SPLIT = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+|\d+")
SCRIPTS = (".py", ".sh", ".js", ".mjs")
# Texts and comments of scripts; a "#" within a word or behind "${" of a shell begins none.
SCRIPT_TEXT = re.compile(r'"""(?:.|\n)*?"""|"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)*\'|`(?:[^`\\]|\\.)*`|//[^\n]*|/\*.*?\*/|(?<![\w&${])#[^\n]*', re.S)
TEXT = re.compile(r'"(?:[^"\\\n]|\\.)*"|//[^\n]*|/\*.*?\*/|(?<![\w&])#[^\n]*' , re.S)


def exempt(path, pattern):
    return any(path.startswith(begin) and wanted in (None, pattern) for begin, wanted, _ in EXEMPT)


def in_name(path, name, more=()):
    """The first refused part of a name, as (part, what to say)."""
    within = tuple((pattern, say) for begin, pattern, say in WITHIN if path.startswith(begin))
    for part in SPLIT.findall(name):
        for pattern, say in (*NAMES, *within, *more):
            if re.fullmatch(pattern, part.lower()) and not exempt(path, pattern):
                return part, say
    return None


def in_prose(path, line):
    for pattern, say in PROSE:
        match = re.search(rf"\b(?:{pattern})\b", line, re.IGNORECASE)
        if match and not exempt(path, pattern):
            yield match[0], say


def in_code(path, line):
    for name in set(re.findall(r"[A-Za-z_]\w+", line)):
        if found := in_name(path, name):
            yield name, found[1]
    for pattern, say in WHOLE:
        for match in pattern.finditer(line):
            yield match[0], say


def files(root):
    listed = subprocess.run(["git", "-C", str(root), "ls-files", "-co", "--exclude-standard"], capture_output=True, text=True,
                            check=True).stdout.split("\n")
    for path in listed:
        file = root / path
        if path and file.is_file() and not file.is_symlink() and "corpus/" not in path and "package-lock" not in path:
            yield path, file


def offences(root):
    """Lines "file:line: word: say ...", one for each refused word."""
    for path, file in files(root):
        if found := in_name(path, path, FILES):
            yield f"{path}: the file's name: {found[0]}: say {found[1]}"
        try:
            text = file.read_text(encoding="utf-8")
        except UnicodeDecodeError:  # A picture or a sound.
            continue
        for number, line in enumerate(text.split("\n"), 1):
            yield from (f"{path}:{number}: {word}: say {say}" for word, say in in_prose(path, line))
        if file.suffix in (".h", ".cpp", ".c", ".fbs", *SCRIPTS):
            texts = SCRIPT_TEXT if file.suffix in SCRIPTS else TEXT
            code = texts.sub(lambda match: re.sub(r"[^\n]", " ", match[0]), text)
            for number, line in enumerate(code.split("\n"), 1):
                yield from (f"{path}:{number}: {word}: say {say}" for word, say in in_code(path, line))


def main():
    found = list(offences(pathlib.Path(sys.argv[1]).resolve()))
    print("\n".join(found) or "no refused words")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
