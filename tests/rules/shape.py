#!/usr/bin/env python3
"""Names headers without a purpose line or #pragma once, files that are too long, errors that are read from errno after streams, and
comments with a line torn in mid-sentence.

Usage: shape.py ROOT     prints "file: rule" for each, and exits 1 when there is one.
"""

import pathlib
import re
import sys

import direction
import table

# Where a test has its files, up to the end of the statement. Tests run beside each other, each a process of its own.
SHARED_FOLDER = re.compile(r"(?:TempDir|temp_directory_path)\(\)[^;]*;")
OF_ONE_TEST = re.compile(r"getpid|XXXXXX")

# One sentence from the first line on; it may run over into the second.
PURPOSE = re.compile(r"^// [A-Z0-9][^\n]*[.](?: [^\n]*)?(?:\n|$)|^// [A-Z0-9][^\n]*\n// [^\n]*[.]")


# Streams do not say that they set errno, and what they do afterwards may change it: no cause is left to read.
STREAM = re.compile(r"\b(?:std::)?[io]?fstream\b(?!>)|\bstd::getline\b|\bstream_\b")


# A comment's line with its indentation, an end of a sentence or of what announces a list, and lengths in columns.
COMMENT = re.compile(r"^(\s*//\s*)(\S.*?)\s*$")
ENDS_SENTENCE = re.compile(r"[.:!?][\"')]*$")
FULL_LINE = 90
SHORT_LINE = 40


def check_errno(lines):
    """A function ends at a closing brace on the edge of a line; what a stream did in another one is over."""
    has_stream = False
    for number, line in enumerate(lines, 1):
        code = line.split("//")[0]
        has_stream = has_stream or bool(STREAM.search(code))
        if has_stream and "FailErrno(" in code:
            yield f"line {number}: FailErrno after a stream, which leaves no cause in errno; use Fail, or open(2)"
        has_stream = has_stream and not code.startswith("}")


def check_header(lines):
    if not PURPOSE.match("\n".join(lines[:2])):
        yield "a header says on its first line, in one sentence with a full stop, what it is for"
    if "#pragma once" not in lines:
        yield "a header has #pragma once"


def check_length(path, lines):
    if len(lines) > table.LINES_WANTED and path not in table.LONG_FILES:
        yield f"{len(lines)} lines; {table.LINES_WANTED} at most, or a reason in tests/rules/table.py"


def check_comments(lines):
    """A comment is reflowed whole: no few words stand between a full line and the rest of their sentence. Rows of tables and ends of
    entries are short for another reason: they have gaps, or another indentation than the line before."""
    for number in range(1, len(lines) - 1):
        block = [COMMENT.match(line) for line in lines[number - 1:number + 2]]
        if not all(block):
            continue
        (before, before_text), (here, text), (after, _) = ((len(part[1]), part[2]) for part in block)
        is_short = len(lines[number - 1]) > FULL_LINE and len(lines[number]) < SHORT_LINE and text[:1].isalnum()
        goes_on = not ENDS_SENTENCE.search(before_text) and not ENDS_SENTENCE.search(text)
        is_prose = before == here and "  " not in before_text + text and (after == here or after > here and " " not in text)
        if is_short and goes_on and is_prose:
            yield f"line {number + 1}: a short line in mid-sentence of a comment; let the comment's lines fill anew"


def check_test_files(text):
    if any(not OF_ONE_TEST.search(use) for use in SHARED_FOLDER.findall(text)):
        yield "a test's files have its process id in their names, or are in a folder that mkdtemp made"


def offences(root):
    """Lines "file: rule", one for each fault of shape."""
    for path, file in direction.sources(root):
        text = file.read_text(encoding="utf-8", errors="replace")
        lines = text.splitlines()
        faults = [*check_length(path, lines), *check_errno(lines), *check_comments(lines), *(check_header(lines) if file.suffix in (".h", ".hpp") else ())]
        if path.startswith("tests/"):
            faults += check_test_files(text)
        yield from (f"{path}: {fault}" for fault in faults)
    for path in table.LONG_FILES:
        if not (root / path).exists():
            yield f"{path}: is allowed to be long, and is not there"


def main():
    found = list(offences(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "every file has its shape")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
