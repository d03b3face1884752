#!/usr/bin/env python3
"""A library that links against the direction is named, and one that calls what it does not declare: links_test.py ROOT BUILD COMPILER"""

import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import links  # noqa: E402  The folder must be on the path first.
import symbols  # noqa: E402

ROOT, BUILD, COMPILER = (pathlib.Path(word) for word in (sys.argv[1:4] if len(sys.argv) > 3 else (".", ".", "c++")))

# Of a room that is further up: the decoders know nothing of the board.
CALLS_THE_BOARD = """
#include "appliance/core/board/board.h"
bool SeeTheBoard() { return kaori::board::Board::Open("/nothing").has_value(); }
"""


def offences(**files):
    with tempfile.TemporaryDirectory() as folder:
        for room, text in files.items():
            file = pathlib.Path(folder, *room.split("_"), "CMakeLists.txt")
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        return list(links.offences(pathlib.Path(folder)))


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
        self.assertEqual(offences(drivers_gpio="kaori_library(drivers_gpio SOURCES a.cpp DEPS drivers_ports PkgConfig::GPIOD)",
                                  drivers_ports="kaori_library(drivers_ports DEPS drivers_base)",
                                  drivers_base="kaori_library(drivers_base SOURCES a.cpp)"), [])

    def test_of_the_system_are_refused_in_a_pure_room_but_for_those_that_the_table_names(self):
        for linked in ("DEPS PkgConfig::TURBOJPEG", "DEPS drivers_ports PRIVATE_DEPS PkgConfig::TURBOJPEG", "PRIVATE_DEPS turbojpeg"):
            found = offences(drivers_decode=f"kaori_library(drivers_decode SOURCES a.cpp {linked})",
                             drivers_ports="kaori_library(drivers_ports)")
            self.assertEqual(len(found), 1, found)
            self.assertIn("drivers/decode/ links no library of the system", found[0])
        planes = "kaori_library(drivers_decode_planes SOURCES planes.cpp PRIVATE_DEPS {})"
        self.assertEqual(offences(drivers_decode=planes.format("PkgConfig::TURBOJPEG")), [])
        self.assertEqual(len(offences(drivers_decode=planes.format("PkgConfig::LIBUSB"))), 1)

    def test_of_the_project_run_with_the_direction(self):
        self.assertEqual(list(links.offences(ROOT)), [])


class Symbols(unittest.TestCase):
    def with_source(self, library, text):
        """What is said of the built archives when one more source is in that library's."""
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        found, missing = symbols.archives(ROOT, BUILD)
        self.assertEqual(missing, [])
        seeded = pathlib.Path(folder.name, "seeded.cpp")
        seeded.write_text(text, encoding="utf-8")
        subprocess.run([COMPILER, "-std=c++20", f"-I{ROOT}", "-c", seeded, "-o", seeded.with_suffix(".o")], check=True)
        archive = pathlib.Path(folder.name, found[library].name)
        shutil.copyfile(found[library], archive)
        subprocess.run(["ar", "r", archive, seeded.with_suffix(".o")], check=True, capture_output=True)
        return list(symbols.undeclared(ROOT, found | {library: archive}))

    def test_that_a_library_calls_and_does_not_declare_are_named(self):
        found = self.with_source("drivers_decode", CALLS_THE_BOARD)
        self.assertTrue(any("drivers_decode: kaori::board::Board::Open(" in line and line.endswith("of appliance_core_board, which it does not declare")
                            for line in found), found)
        self.assertEqual([line for line in found if not line.startswith("drivers_decode: ")], [])

    def test_of_what_is_declared_at_any_depth_pass(self):
        self.assertEqual(self.with_source("appliance_programs_stage", CALLS_THE_BOARD), [])

    def test_of_the_built_project_are_all_declared(self):
        self.assertEqual(list(symbols.offences(ROOT, BUILD)), [])

    def test_of_an_archive_that_is_not_built_are_missed(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertIn("drivers/decode/CMakeLists.txt: drivers_decode: its archive libdrivers_decode.a is not built",
                          list(symbols.offences(ROOT, pathlib.Path(folder))))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
