#!/usr/bin/env python3
"""What udev does with a USB device by the box's rules, which ask kaori-usb: usb_rules_test.py REPOSITORY KAORI-USB

The rules are followed by a reader of the few keys of udev(7) that they use; another key fails the test. Devices are folders, as in sysfs.
"""

import fnmatch
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

REPOSITORY, KAORI_USB = Path(sys.argv.pop(1)), sys.argv.pop(1)
RULES = REPOSITORY / "rootfs/overlay/usr/lib/udev/rules.d/60-kaori-usb.rules"
TOKEN = re.compile(r'([A-Z]+)(?:\{(\w+)\})?(==|!=|\+=|=)"([^"]*)"(?:, *|$)')
INPUT, STORAGE, MOUSE, KEYBOARD = b"\x03\x00\x00", b"\x08\x06\x50", b"\x03\x01\x02", b"\x03\x01\x01"
PROGRAM = "/usr/bin/kaori-usb look %S%p"


def rules(text):
    """Each line as its tokens: (key, attribute, operator, value)."""
    lines = re.sub(r"\\\n\s*", "", text).splitlines()
    for line in filter(None, (line.strip() for line in lines if not line.startswith("#"))):
        tokens, at = [], 0
        while at < len(line):
            match = TOKEN.match(line, at)
            if match is None:
                raise ValueError(f"no rule of udev: {line[at:]}")
            tokens.append(match.groups())
            at = match.end()
        yield tokens


def interface(triple, number=0, setting=0):
    return bytes((9, 4, number, setting, 0)) + triple + b"\0"


def descriptors(*parts, vendor=0x1209):
    """The file of sysfs of a device with one configuration."""
    body = b"".join(parts)
    device = bytes((18, 1, 0, 2, 0, 0, 0, 64)) + vendor.to_bytes(2, "little") + bytes((1, 0, 0, 1, 1, 2, 0, 1))
    return device + bytes((9, 2)) + (9 + len(body)).to_bytes(2, "little") + bytes((1, 1, 0, 0x80, 50)) + body


class Rules(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = Path(folder.name)
        self.program = KAORI_USB
        self.text = RULES.read_text(encoding="utf-8")
        self.asked = []
        for part in ("run/kaori-profile", "run/kaori-service", "sys"):
            (self.root / part).mkdir(parents=True)
        (self.root / "log").touch()

    # The box.
    def turn_key(self, on):
        key = self.root / "run/kaori-service/open"
        key.touch() if on else key.unlink()

    def profile(self, name):
        (self.root / "run/kaori-profile" / name).touch()

    # The device.
    def plug(self, content, port="1-2", authorised=0):
        self.device = self.root / "sys/devices/usb1" / port
        self.device.mkdir(parents=True)
        (self.device / "descriptors").write_bytes(content)
        (self.device / "authorized").write_text(f"{authorised}\n")
        return self.event("add")

    def is_authorised(self):
        return (self.device / "authorized").read_text().strip() == "1"

    # udev.
    def run_program(self, words):
        self.asked.append(words.split()[1])
        words = words.replace("%S%p", str(self.device)).replace("%k", self.device.name).split()
        more = [self.root / "run"] + ([self.root / "log"] if words[1] == "look" else [])
        if not Path(self.program).exists():
            return False
        return subprocess.run([self.program, *words[1:], *more], stdout=subprocess.DEVNULL, check=False).returncode == 0

    def holds(self, key, attribute, value):
        """Whether a key matches, as with the operator "=="."""
        if key == "TEST":
            return (self.root / value.replace("%k", self.device.name).lstrip("/")).exists()
        if key == "PROGRAM":
            return self.run_program(value)
        found = {("ACTION", None): self.action, ("SUBSYSTEM", None): "usb", ("KERNEL", None): self.device.name,
                 ("ENV", "DEVTYPE"): self.kind, ("ATTR", "authorized"): (self.device / "authorized").read_text().strip()}[key, attribute]
        return fnmatch.fnmatchcase(found, value)

    def event(self, action, kind="usb_device"):
        self.action, self.kind, wanted, later = action, kind, None, []
        for tokens in rules(self.text):
            labels = [value for key, _, _, value in tokens if key == "LABEL"]
            if wanted and wanted not in labels:
                continue
            wanted = None
            if not all(self.holds(key, attribute, value) == (operator == "==")
                       for key, attribute, operator, value in tokens if operator in ("==", "!=")):
                continue
            for key, attribute, operator, value in tokens:
                if (key, operator) == ("ATTR", "="):
                    (self.device / attribute).write_text(value + "\n")
                elif (key, operator) == ("RUN", "+="):
                    later.append(value)
                elif (key, operator) == ("GOTO", "="):
                    wanted = value
                elif operator in ("=", "+=") and key != "LABEL":
                    raise ValueError(f"the reader does not know {key}{operator}")
        for words in later:
            self.run_program(words)
        return self.is_authorised()

    def test_what_operators_bring_is_authorised(self):
        self.assertTrue(self.plug(descriptors(interface(MOUSE), interface(KEYBOARD, 1))))
        self.assertEqual(self.asked, ["look"], "one program for one device")

    def test_each_liar_stays_out_and_its_reason_goes_with_it(self):
        settings = b"".join(interface(bytes((1, n, 0)), 0, n) for n in range(80))
        for number, liar in enumerate(([interface(MOUSE), b"\x02\xff", interface(STORAGE, 1)], [settings, interface(STORAGE, 1)],
                                       [interface(MOUSE), interface(STORAGE, 1)], [interface(INPUT), b"\x01\xff"], [])):
            self.assertFalse(self.plug(descriptors(*liar), f"1-{number + 1}"))
            said = self.root / "run/kaori-usb" / self.device.name
            self.assertIn("stays out", said.read_text(encoding="utf-8"))
            self.event("remove")
            self.assertFalse(said.exists())

    def test_a_stick_comes_and_goes_with_the_service_key(self):
        self.assertFalse(self.plug(descriptors(interface(STORAGE))))
        self.turn_key(True)
        self.assertTrue(self.event("add"))
        self.assertTrue(self.event("change"))
        self.turn_key(False)
        self.assertFalse(self.event("change"))
        self.assertFalse(self.event("add"))

    def test_turning_the_key_back_leaves_operators_devices_alone(self):
        self.turn_key(True)
        self.assertTrue(self.plug(descriptors(interface(KEYBOARD))))
        self.turn_key(False)
        self.assertTrue(self.event("change"))

    def test_what_a_kernel_let_in_before_is_looked_at_too(self):
        self.assertFalse(self.plug(descriptors(interface(MOUSE), b"\x02\xff", interface(STORAGE, 1)), authorised=1))
        self.assertTrue(self.plug(descriptors(interface(MOUSE)), "1-3", authorised=1))

    def test_the_medium_and_the_root_of_a_bus_are_never_cut_off(self):
        self.profile("medium-1-2")
        self.assertTrue(self.plug(descriptors(interface(STORAGE)), authorised=1))
        self.assertTrue(self.plug(b"", "usb1", authorised=1))
        self.assertTrue(self.event("change"))
        self.assertEqual(self.asked, [])

    def test_in_a_kiosk_keyboards_stay_out(self):
        self.profile("kiosk")
        self.assertFalse(self.plug(descriptors(interface(KEYBOARD))))
        self.assertTrue(self.plug(descriptors(interface(MOUSE)), "1-3"))

    def test_the_bench_authorises_whatever_comes(self):
        self.profile("bench")
        self.assertTrue(self.plug(descriptors()))
        self.assertTrue(self.event("change"))
        self.assertEqual(self.asked, [])

    def test_without_the_program_everything_stays_out(self):
        self.program = str(self.root / "nowhere")
        self.assertFalse(self.plug(descriptors(interface(MOUSE))))
        self.assertFalse(self.plug(descriptors(interface(MOUSE)), "1-3", authorised=1))
        self.program = "/bin/false"
        self.assertFalse(self.plug(descriptors(interface(MOUSE)), "1-4"))

    def test_interfaces_are_no_devices(self):
        self.plug(descriptors(interface(STORAGE)))
        self.asked.clear()
        self.event("add", "usb_interface")
        self.assertEqual(self.asked, [])

    def test_udevs_own_reader_is_not_asked(self):
        lines = "".join(line for line in self.text.splitlines() if not line.startswith("#"))
        for name in ("ID_USB_INTERFACES", "usb_id"):
            self.assertNotIn(name, lines)

    def test_rules_that_do_not_ask_are_found_wrong(self):
        self.text = self.text.replace(f'PROGRAM!="{PROGRAM}", GOTO="kaori_usb_end"', "")
        self.assertTrue(self.plug(descriptors(interface(STORAGE))), "the reader of this test sees no difference")


if __name__ == "__main__":
    unittest.main()
