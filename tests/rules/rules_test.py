#!/usr/bin/env python3
"""Seeds each wrong include in a house of its own, and sees the checkers name it."""

import contextlib
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import direction  # noqa: E402  The folder must be on the path first.
import shape  # noqa: E402
import table  # noqa: E402

HEADER = "// A header that says what it is for.\n#pragma once\n"

# (file, what it includes, a part of the rule that must be named)
AGAINST = (
    ("firmware/wire/a.h", '"drivers/base/result.h"', "firmware/wire/ may include only"),
    ("firmware/surface/a.cpp", '"drivers/base/clock.h"', "firmware/surface/ may include only"),
    ("firmware/wire/a.h", "<vector>", "freestanding"),
    ("firmware/surface/a.cpp", "<unistd.h>", "freestanding"),
    ("drivers/base/a.h", '"drivers/ports/camera.h"', "drivers/base/ may include only"),
    ("drivers/ports/a.h", '"drivers/hid/keyboard.h"', "drivers/ports/ may include only"),
    ("drivers/hid/a.cpp", '"drivers/gpio/lines.h"', "drivers/hid/ may include only"),
    ("drivers/gpio/a.cpp", '"drivers/hid/keyboard.h"', "drivers/gpio/ may include only"),
    ("drivers/camera/a.cpp", '"drivers/scanout/kms.h"', "drivers/camera/ may include only"),
    ("drivers/audio/a.cpp", '"drivers/camera/v4l2.h"', "drivers/audio/ may include only"),
    ("drivers/scanout/a.cpp", '"render/scene/scene.h"', "drivers/scanout/ may include only"),
    ("drivers/hid/a.cpp", '"appliance/board/board.h"', "drivers/hid/ may include only"),
    ("drivers/hid/a.cpp", '"hw-sim/devices/dial_box.h"', "nothing of the product includes hw-sim"),
    ("render/face/a.h", '"render/scene/scene.h"', "render/face/ may include only"),
    ("render/scene/a.h", '"render/gl/shader.h"', "render/scene/ may include only"),
    ("render/image/a.h", '"render/scene/scene.h"', "render/image/ may include only"),
    ("render/gl/a.cpp", '"render/passes/body.h"', "render/gl/ may include only"),
    ("render/passes/a.cpp", '"drivers/ports/scanout.h"', "render/passes/ may include only"),
    ("drivers/web/a.cpp", '"drivers/ports/camera.h"', "drivers/web/ may include only"),
    ("appliance/desk/a.cpp", '"appliance/lips/lip_reader.h"', "appliance/desk/ may include only"),
    ("render/passes/a.cpp", '"drivers/scanout/kms.h"', "render/passes/ may include only"),
    ("render/passes/a.cpp", '"appliance/show/show.h"', "render/passes/ may include only"),
    ("render/wall/a.cpp", '"render/passes/body.h"', "render/wall/ may include only"),
    ("appliance/board/a.h", '"render/scene/scene.h"', "appliance/board/ may include only"),
    ("appliance/show/a.h", '"appliance/board/board.h"', "appliance/show/ may include only"),
    ("appliance/performance/a.h", '"drivers/ports/hid_channel.h"', "appliance/performance/ may include only"),
    ("appliance/atelier/a.h", '"appliance/input/input.h"', "appliance/atelier/ may include only"),
    ("appliance/input/a.h", '"drivers/hid/local_bus.h"', "only a program's main.cpp names a driver"),
    ("render/passes/a.h", '"drivers/hid/dial_box.h"', "render/passes/ may include only"),
    ("appliance/stage/a.cpp", '"appliance/input/input.h"', "appliance/stage/ may include only"),
    ("appliance/stage/a.cpp", '"drivers/scanout/kms.h"', "only a program's main.cpp names a driver"),
    ("appliance/stage/main.cpp", '"hw-sim/devices/screen.h"', "nothing of the product includes hw-sim"),
    ("hw-sim/devices/a.cpp", '"drivers/hid/dial_box.h"', "hw-sim/ may include only"),
    ("hw-sim/console/a.cpp", '"appliance/show/show.h"', "hw-sim/ may include only"),
    ("hw-sim/devices/a.cpp", '"hw-sim/rehearsal/film.h"', "hw-sim/ may include only"),
    ("appliance/stage/a.cpp", '"stage.h"', "starts at the root"),
    ("appliance/stage/a.cpp", '"appliance/stage/../../hw-sim/devices/screen.h"', "starts at the root"),
    ("render/passes/a.cpp", "<GLES3/gl3.h>", "only render/gl/ includes"),
    ("appliance/stage/a.cpp", "<EGL/egl.h>", "only render/gl/ includes"),
    ("appliance/input/a.cpp", "<gpiod.h>", "only drivers/gpio/ includes"),
    ("appliance/input/a.cpp", "<libusb-1.0/libusb.h>", "only drivers/hid/ includes"),
    ("appliance/lips/a.cpp", "<linux/videodev2.h>", "only drivers/camera/ includes"),
    ("appliance/stage/a.cpp", "<xf86drmMode.h>", "only drivers/scanout/, render/gl/, firmware/boot/ includes"),
    ("appliance/input/a.cpp", "<alsa/asoundlib.h>", "only drivers/audio/, appliance/desk/ includes"),
    ("appliance/show/a.cpp", "<toml++/toml.h>", "includes <toml++/"),
    ("render/face/a.cpp", "<libqhull_r/libqhull_r.h>", "only appliance/atelier/, tools/ includes"),
    ("render/gl/a.cpp", "<meshoptimizer.h>", "only appliance/atelier/, tools/ includes"),
    ("appliance/stage/a.cpp", "<microhttpd.h>", "only drivers/web/ includes"),
    ("appliance/lips/a.cpp", "<gnutls/x509.h>", "only appliance/desk/ includes"),
    ("appliance/stage/a.cpp", "<nlohmann/json.hpp>", "includes <nlohmann/"),
    ("hw-sim/devices/a.cpp", "<usbredirparser.h>", "only hw-sim/links/ includes"),
    ("firmware/boot/a.c", "<pico/stdlib.h>", "only firmware/rp2040/ includes"),
)

ALONG = (
    ("firmware/surface/a.cpp", '"firmware/wire/surface.h"'),
    ("drivers/hid/a.cpp", '"firmware/wire/link.h"'),
    ("drivers/hid/a.cpp", '"drivers/hid/descriptor.h"'),
    ("render/gl/a.cpp", "<EGL/egl.h>"),
    ("appliance/stage/main.cpp", '"drivers/scanout/local.h"'),
    ("appliance/atelier/a.cpp", "<toml++/toml.h>"),
    ("appliance/input/a.h", '"drivers/hid/dial_box.h"'),
    ("hw-sim/rehearsal/a.cpp", '"appliance/stage/stage.h"'),
    ("tests/system/a.cpp", '"hw-sim/rehearsal/film.h"'),
)


@contextlib.contextmanager
def house(path, text):
    """A house of one file, in a folder that goes away."""
    with tempfile.TemporaryDirectory() as folder:
        file = pathlib.Path(folder) / path
        file.parent.mkdir(parents=True)
        file.write_text(text, encoding="utf-8")
        yield pathlib.Path(folder)


def against_direction(path, text):
    with house(path, text) as root:
        return list(direction.offences(root))


def against_shape(path, text):
    with house(path, text) as root:
        return list(shape.offences(root))


class Direction(unittest.TestCase):
    def test_names_file_line_include_and_rule_of_each_wrong_include(self):
        for path, target, rule in AGAINST:
            with self.subTest(path=path, target=target):
                found = against_direction(path, f"{HEADER}\n#include {target}\n")
                self.assertEqual(len(found), 1, found)
                self.assertTrue(found[0].startswith(f"{path}:4: {target[1:-1]}: "), found)
                self.assertIn(rule, found[0])

    def test_lets_pass_what_runs_with_the_direction(self):
        for path, target in ALONG:
            with self.subTest(path=path, target=target):
                self.assertEqual(against_direction(path, f"#include {target}\n"), [])

    def test_sees_an_include_written_with_spaces(self):
        found = against_direction("drivers/base/a.h", '  #  include  "render/gl/x.h"\n')
        self.assertEqual(len(found), 1)

    def test_has_a_seeded_include_for_every_row_of_libraries(self):
        seeded = [target[1:-1] for _, target, _ in AGAINST]
        for beginnings, _ in table.LIBRARIES:
            self.assertTrue(any(target.startswith(beginnings) for target in seeded), beginnings)

    def test_has_a_seeded_include_for_every_room_with_a_limit(self):
        limited = [room for room, allowed in table.MAY_INCLUDE if allowed is not table.EVERYTHING]
        for room in limited:
            self.assertTrue(any(path.startswith(room) for path, _, _ in AGAINST), room)


    def test_does_not_pass_a_folder_without_sources(self):
        with tempfile.TemporaryDirectory() as folder:
            self.assertRaises(SystemExit, lambda: list(direction.sources(pathlib.Path(folder))))


class PureDecoders(unittest.TestCase):
    def test_make_no_system_call(self):
        root = pathlib.Path(__file__).parents[2]
        for header in table.PURE_DECODERS:
            for path in (header, header.replace(".h", ".cpp")):
                if not (root / path).exists():
                    self.assertTrue(path.endswith(".cpp"), f"{path} is not there")
                    continue
                found = [i.target for i in direction.includes(path, root / path)]
                self.assertFalse([t for t in found if t.startswith(table.SYSTEM_HEADERS)], path)


class Shape(unittest.TestCase):
    def test_lets_a_good_header_pass(self):
        self.assertEqual(against_shape("drivers/base/a.h", HEADER), [])

    def test_names_a_header_that_does_not_say_what_it_is_for(self):
        found = against_shape("drivers/base/a.h", "#pragma once\n")
        self.assertEqual(len(found), 1)
        self.assertIn("drivers/base/a.h: a header says on its first line", found[0])

    def test_lets_a_purpose_run_over_into_the_second_line(self):
        self.assertEqual(against_shape("drivers/base/a.h", "// A header\n// in two lines.\n#pragma once\n"), [])
        self.assertEqual(len(against_shape("drivers/base/a.h", "// A header\n// without\n// end.\n#pragma once\n")), 1)

    def test_names_a_header_without_pragma_once(self):
        found = against_shape("drivers/base/a.h", "// A header.\n#ifndef A\n#endif\n")
        self.assertEqual(found, ["drivers/base/a.h: a header has #pragma once"])

    def test_names_a_file_that_is_too_long(self):
        found = against_shape("render/gl/a.cpp", "\n" * 301)
        self.assertEqual(len(found), 1)
        self.assertIn("301 lines", found[0])
        self.assertEqual(against_shape("render/gl/a.cpp", "\n" * 300), [])


if __name__ == "__main__":
    unittest.main()
