#!/usr/bin/env python3
"""Names headers without a purpose line or #pragma once, and files that are too long.

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


def check_header(lines):
    if not PURPOSE.match("\n".join(lines[:2])):
        yield "a header says on its first line, in one sentence with a full stop, what it is for"
    if "#pragma once" not in lines:
        yield "a header has #pragma once"


def check_length(path, lines):
    if len(lines) > table.LINES_WANTED and path not in table.LONG_FILES:
        yield f"{len(lines)} lines; {table.LINES_WANTED} at most, or a reason in tests/rules/table.py"


def check_test_files(text):
    if any(not OF_ONE_TEST.search(use) for use in SHARED_FOLDER.findall(text)):
        yield "a test's files have its process id in their names, or are in a folder that mkdtemp made"


def offences(root):
    """Lines "file: rule", one for each fault of shape."""
    for path, file in direction.sources(root):
        text = file.read_text(encoding="utf-8", errors="replace")
        lines = text.splitlines()
        faults = [*check_length(path, lines), *(check_header(lines) if file.suffix in (".h", ".hpp") else ())]
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
