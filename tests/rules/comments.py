#!/usr/bin/env python3
"""Says how much of the product's C++ is comments, and names the folders that lack most.

Usage: comments.py ROOT     exits 1 where they are less than WANTED_PERCENT of all lines.
"""

import collections
import pathlib
import sys

import unused
import words

WANTED_PERCENT = 15
NAMED = 10


def is_comment(line):
    return line.lstrip().startswith(("//", "/*", "*"))


def of_folders(root):
    """{folder: [lines, comments]} of the product's sources."""
    counts = collections.defaultdict(lambda: [0, 0])
    for path, file in words.files(root):
        if path.startswith(unused.PRODUCT) and file.suffix in (".h", ".cpp"):
            lines = file.read_text(encoding="utf-8").splitlines()
            count = counts[str(pathlib.PurePosixPath(path).parent)]
            count[0] += len(lines)
            count[1] += sum(map(is_comment, lines))
    return counts


def percent(root):
    counts = of_folders(root).values()
    return 100 * sum(comments for _, comments in counts) / max(1, sum(lines for lines, _ in counts))


def missing(count):
    """Lines of comment that a folder lacks."""
    lines, comments = count
    return round(lines * WANTED_PERCENT / 100 - comments)


def main():
    root = pathlib.Path(sys.argv[1])
    found = percent(root)
    print(f"{found:.1f} of a hundred lines are comments; {WANTED_PERCENT} at least are wanted")
    if found >= WANTED_PERCENT:
        return 0
    folders = sorted(of_folders(root).items(), key=lambda item: -missing(item[1]))
    print("\n".join(f"{folder}: {missing(count)} lines of comment are missing" for folder, count in folders[:NAMED]))
    return 1


if __name__ == "__main__":
    sys.exit(main())
