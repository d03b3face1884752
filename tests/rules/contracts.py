#!/usr/bin/env python3
"""Names ports without a contract suite, and implementations of a port that no suite tries.

Usage: contracts.py ROOT     prints a line for each, and exits 1 when there is one.

A port is a class of drivers/ports with a virtual destructor; its suite is the header of tests/contracts that begins with "The
contract of ports::NAME". An implementation is a class of the product that says ": public ports::NAME"; the suite's sources name
it. Whoever is left out has a reason here, and a reason that is needed no longer is named too.
"""

import pathlib
import re
import sys

import direction
import unused

PORT = re.compile(r"^class (\w+) \{(?:(?!^\};).)*?virtual ~\1\(\)", re.M | re.S)
SUITE = re.compile(r"^// The contract of ports::(\w+)\.")
IMPLEMENTATION = re.compile(r"^class ([\w:]+) (?:final )?: public ports::(\w+)\b", re.M)

# Ports without a suite; their implementations need no reason of their own.
PORTS_WITHOUT = {
    "CameraTuning": "what can be tuned differs from camera to camera; camera_v4l2_test.cpp and camera_requests_test.cpp try each",
}
# Implementations that no suite names.
UNNAMED = {
    "BlockFile": "OpenBlockFile makes it for the suite",
    "SimulatedDisk::Part": "SimulatedDisk makes it for the suite",
    "LibusbChannel": "LibusbBus opens it for the suite",
    "KmsSideDisplay": "KmsScreen makes it for the suite",
    "LocalMonitor": "LocalScreen makes it for the suite",
    "LocalHidChannel": "LocalHidBus opens it for the suite",
    "DialChannel": "its reports are made of edges of lines, and cannot be given byte by byte; input_dials_test.cpp tries it",
    "MidiChannel": "its reports are made of MIDI messages, and cannot be given byte by byte; input_midi_test.cpp tries it",
    "SerialChannel": "its reports are made of a serial box's bytes, and cannot be given byte by byte; input_serial_test.cpp tries it",
    "PictureDisplay": "it keeps pictures of a rehearsal as files, and shows nothing",
}


def ports(root):
    files = sorted((root / "drivers/ports").glob("*.h"))
    return {name for file in files for name in PORT.findall(file.read_text(encoding="utf-8"))}


def suites(root):
    beginnings = (file.read_text(encoding="utf-8") for file in (root / "tests/contracts").glob("*_contract.h"))
    return {match[1] for text in beginnings if (match := SUITE.match(text))}


def implementations(root):
    """(file, class, port) of the product; of tests none."""
    for path, file in direction.sources(root):
        if path.startswith(unused.PRODUCT):
            for name, port in IMPLEMENTATION.findall(file.read_text(encoding="utf-8")):
                yield path, name, port


def offences(root, ports_without=None, unnamed=None):
    ports_without = PORTS_WITHOUT if ports_without is None else ports_without
    unnamed = UNNAMED if unnamed is None else unnamed
    all_ports, its_suites, found = ports(root), suites(root), list(implementations(root))
    tried = "\n".join(file.read_text(encoding="utf-8") for file in (root / "tests/contracts").glob("*.cpp"))
    needed = set()
    for name in sorted(all_ports - its_suites):
        needed.add(name)
        if name not in ports_without:
            yield f"ports::{name}: has no suite in tests/contracts"
    for path, name, port in found:
        if port in ports_without or re.search(rf"\b{re.escape(name)}\b", tried):
            continue
        needed.add(name)
        if name not in unnamed:
            yield f"{path}: {name}: no suite of tests/contracts tries this ports::{port}"
    yield from (f"tests/rules/contracts.py: {name}: needs no reason" for name in (*ports_without, *unnamed) if name not in needed)


def main():
    found = list(offences(pathlib.Path(sys.argv[1])))
    print("\n".join(found) or "every port has its suite, and every implementation is tried")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
