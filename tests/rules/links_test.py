#!/usr/bin/env python3
"""A library that links against the direction is named, and what it would call there really is not found: links_test.py ROOT BUILD COMPILER"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import links  # noqa: E402  The folder must be on the path first.

ROOT, BUILD, COMPILER = (pathlib.Path(word) for word in (sys.argv[1:4] if len(sys.argv) > 3 else (".", ".", "c++")))

# Of a room that is further up: the decoders know nothing of the board.
CALLS_THE_BOARD = """
#include "appliance/core/board/board.h"
int main() { return kaori::board::Board::Open("/nothing").has_value() ? 0 : 1; }
"""


def offences(**files):
    with tempfile.TemporaryDirectory() as folder:
        for room, text in files.items():
            file = pathlib.Path(folder, *room.split("_"), "CMakeLists.txt")
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        return list(links.offences(pathlib.Path(folder)))


def archives(*rooms):
    """Twice, since libraries of the product call each other in one direction, whatever their order here."""
    found = [file for room in rooms for file in sorted((BUILD / room).rglob("*.a"))]
    return [*map(str, found)] * 2


def link(libraries):
    with tempfile.TemporaryDirectory() as folder:
        source = pathlib.Path(folder, "calls.cpp")
        source.write_text(CALLS_THE_BOARD, encoding="utf-8")
        return subprocess.run([COMPILER, "-std=c++20", f"-I{ROOT}", "-DFMT_SHARED", source, *libraries, "-lfmt", "-o", pathlib.Path(folder, "calls")],
                              capture_output=True, text=True, check=False)


class Links(unittest.TestCase):
    def test_against_the_direction_are_named(self):
        found = offences(drivers_decode="kaori_library(drivers_decode SOURCES a.cpp DEPS render_image)",
                         render_image="kaori_library(render_image SOURCES a.cpp DEPS drivers_base)",
                         drivers_base="kaori_library(drivers_base SOURCES a.cpp)")
        self.assertEqual(len(found), 1, found)
        self.assertIn("drivers/decode/CMakeLists.txt: drivers_decode: render_image: drivers/decode/ may link only", found[0])

    def test_that_nobody_else_sees_are_named_too(self):
        found = offences(drivers_base="kaori_library(drivers_base SOURCES a.cpp PRIVATE_DEPS drivers_ports)",
                         drivers_ports="kaori_library(drivers_ports DEPS drivers_base)")
        self.assertEqual(len(found), 1, found)

    def test_with_the_direction_and_of_the_system_pass(self):
        self.assertEqual(offences(drivers_decode="kaori_library(drivers_decode SOURCES a.cpp DEPS drivers_ports PkgConfig::GPIOD)",
                                  drivers_ports="kaori_library(drivers_ports DEPS drivers_base)",
                                  drivers_base="kaori_library(drivers_base SOURCES a.cpp)"), [])

    def test_of_the_project_run_with_the_direction(self):
        self.assertEqual(list(links.offences(ROOT)), [])

    def test_without_the_room_that_is_called_fail(self):
        built = link(archives("drivers/decode", "drivers/base"))
        self.assertNotEqual(built.returncode, 0)
        self.assertIn("undefined reference to `kaori::board::Board::Open", built.stderr)

    def test_with_that_room_succeed(self):
        built = link(archives("appliance/core/board", "drivers/decode", "drivers/ports", "drivers/base"))
        self.assertEqual(built.returncode, 0, built.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
