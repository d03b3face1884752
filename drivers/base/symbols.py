#!/usr/bin/env python3
"""Turns the addresses of crash reports (crash_report.h) into functions and lines of the sources.

Usage: symbols.py --in FOLDER [--in FOLDER ...] REPORT     REPORT is any text that holds such reports, such as a journal

Symbols are looked for by a module's build id: in FOLDER/.build-id, as image/build keeps them, and in files of the module's name
that lie in a FOLDER. Of other builds nothing is said but their addresses. Exits 1 where the text holds no report.
"""

import argparse
import pathlib
import re
import subprocess
import sys

HEAD = re.compile(r"(\S+): crash: (signal \d+ after .*)")
FRAME = re.compile(r"crash: #(\d+) (\S+)\+0x([0-9a-f]+) ([0-9a-f]+|-)$")


def tool(*words):
    return subprocess.run(words, capture_output=True, text=True, check=False).stdout


def build_id(file):
    found = re.search(r"Build ID: ([0-9a-f]+)", tool("readelf", "-n", file))
    return found and found[1]


def symbols_of(module, wanted, folders):
    """The file with the symbols of a module, or None."""
    for folder in folders:
        kept = folder / ".build-id" / wanted[:2] / (wanted[2:] + ".debug")
        if kept.is_file():
            return kept
        built = folder / module
        if built.is_file() and build_id(built) == wanted:
            return built
    return None


def lines_of(number, address, symbols):
    """Functions with their places, those that were compiled into another one first."""
    # A return address may be that of the next line: the call lies before it.
    at = address - (1 if number > 0 else 0)
    told = tool("addr2line", "-f", "-C", "-i", "-e", symbols, hex(at)).splitlines()
    return [f"{name} at {place}" for name, place in zip(told[::2], told[1::2])]


def explained(text, folders):
    """Each line of the reports in the text, for people."""
    known = {}
    for line in text.splitlines():
        if head := HEAD.search(line):
            yield f"{head[1]}: {head[2]}"
        if frame := FRAME.search(line.rstrip()):
            number, module, address, wanted = int(frame[1]), frame[2], int(frame[3], 16), frame[4]
            if (module, wanted) not in known:
                known[module, wanted] = symbols_of(module, wanted, folders) if wanted != "-" else None
            symbols = known[module, wanted]
            told = lines_of(number, address, symbols) if symbols else [f"no symbols of this build ({wanted})"]
            yield from (f"  #{number} {module}+{address:#x}  {what}" for what in told)


def main():
    parser = argparse.ArgumentParser(usage=__doc__.split("\n")[2][len("Usage: "):])
    parser.add_argument("--in", dest="folders", type=pathlib.Path, action="append", required=True)
    parser.add_argument("report", type=pathlib.Path)
    words = parser.parse_args()
    try:
        text = words.report.read_text(encoding="utf-8", errors="replace")
    except OSError as error:
        sys.exit(f"{words.report} cannot be read: {error.strerror}")
    told = list(explained(text, words.folders))
    if not told:
        sys.exit(f"{words.report} holds no crash report")
    print("\n".join(told))


main()
