#!/usr/bin/env python3
"""Names sources that clang-format would write otherwise, scripts that shellcheck warns of, and Python that pyflakes warns of.

Usage: format.py ROOT [--apply]     prints a line for each fault, and exits 1 when there is one; --apply formats the sources.
"""

import pathlib
import re
import subprocess
import sys

import words

# Kind -> endings, and how the first line of a file without an ending begins.
KINDS = {
    "source": ((".h", ".cpp", ".c"), rb"(?!)"),
    "shell": ((".sh",), rb"#!.*\b(ba|da)?sh\b|# shellcheck shell="),
    "python": ((".py",), rb"#!.*\bpython"),
}
AT_ONCE = 100


class ToolError(Exception):
    """A tool could not work, so that nothing is known of the sources."""


def of_kind(root, kind):
    """Paths of the tree that are sources, shell scripts or Python, by their ending or their first line."""
    for path, file in words.files(root):
        first = b"" if file.suffix else file.read_bytes()[:64].split(b"\n")[0]
        if file.suffix in KINDS[kind][0] or re.match(KINDS[kind][1], first):
            yield path


def run(root, command, paths, may_fail=True):
    """What a tool says of the paths, a few at a time. Shellcheck and pyflakes end with 1 where they find a fault, clang-format only
    where it could not work, as with a configuration that it cannot read: that is a fault of its own."""
    paths = list(paths)
    for begin in range(0, len(paths), AT_ONCE):
        done = subprocess.run([*command, *paths[begin:begin + AT_ONCE]], cwd=root, capture_output=True, text=True, check=False)
        yield from (done.stdout + done.stderr).splitlines()
        if done.returncode != 0 and not may_fail:
            said = (done.stderr.splitlines() or ["it said nothing"])[0]
            raise ToolError(f"{command[0]} ended with {done.returncode}: {said}")


def unformatted(root):
    for line in run(root, ["clang-format", "--dry-run"], of_kind(root, "source"), may_fail=False):
        if match := re.match(r"(\S+):\d+:\d+: warning: code should be clang-formatted", line):
            yield match[1]


def offences(root):
    try:
        yield from (f"{path}: is not formatted; ./box format does it" for path in sorted(set(unformatted(root))))
    except ToolError as error:
        yield str(error)
    yield from run(root, ["shellcheck", "--format=gcc", "--severity=warning", "--external-sources"], of_kind(root, "shell"))
    yield from run(root, ["pyflakes3"], of_kind(root, "python"))


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    if "--apply" in sys.argv:
        try:
            list(run(root, ["clang-format", "-i"], of_kind(root, "source"), may_fail=False))
        except ToolError as error:
            sys.exit(str(error))
        return 0
    found = list(offences(root))
    print("\n".join(found) or "all is formatted; shellcheck and pyflakes find nothing")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
