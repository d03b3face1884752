#!/usr/bin/env python3
"""A port without a contract suite, and an implementation that no suite tries, are named."""

import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import contracts  # noqa: E402  The folder must be on the path first.

PORT = "class Lamp {\n public:\n  // It goes out.\n  virtual ~Lamp() = default;\n};\n\nclass Colour {\n public:\n  int red = 0;\n};\n"
IMPLEMENTATION = "class KernelsLamp final : public ports::Lamp {\n};\n"


class Contracts(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)
        self.write("drivers/ports/lamp.h", PORT)
        self.write("drivers/gpio/kernels_lamp.h", IMPLEMENTATION)
        self.write("tests/contracts/lamp_contract.h", "// The contract of ports::Lamp. It is lit.\n")
        self.write("tests/contracts/lamp_implementations.cpp", "KernelsLamp lamp;\n")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text, encoding="utf-8")

    def found(self, ports_without=(), unnamed=()):
        return list(contracts.offences(self.root, dict.fromkeys(ports_without, "why"), dict.fromkeys(unnamed, "why")))

    def test_pass_where_all_is_tried_and_values_want_no_suite(self):
        self.assertEqual(self.found(), [])

    def test_are_missed_for_a_port(self):
        (self.root / "tests/contracts/lamp_contract.h").unlink()
        self.assertEqual(self.found(), ["ports::Lamp: has no suite in tests/contracts"])
        self.assertEqual(self.found(ports_without=["Lamp"]), [])

    def test_are_missed_for_an_implementation(self):
        self.write("hw-sim/devices/lamp.cpp", IMPLEMENTATION.replace("KernelsLamp", "Panel::Lamp"))
        self.write("tests/drivers/fake.cpp", IMPLEMENTATION.replace("KernelsLamp", "FakeLamp"))
        self.assertEqual(self.found(), ["hw-sim/devices/lamp.cpp: Panel::Lamp: no suite of tests/contracts tries this ports::Lamp"])
        self.assertEqual(self.found(unnamed=["Panel::Lamp"]), [])

    def test_are_not_left_out_for_a_reason_that_is_over(self):
        self.assertEqual(self.found(["Lamp"], ["KernelsLamp"]),
                         [f"tests/rules/contracts.py: {name}: needs no reason" for name in ("Lamp", "KernelsLamp")])


if __name__ == "__main__":
    unittest.main()
