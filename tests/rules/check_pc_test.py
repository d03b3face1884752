#!/usr/bin/env python3
"""./box check on PCs that are folders: what each lacks is said, and nothing else: check_pc_test.py ROOT"""

import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop(1))
sys.path.insert(0, str(ROOT / "rootfs/check"))
import check_pc  # noqa: E402

CPU = "processor\t: {}\nmodel name\t: A Processor\nflags\t\t: fpu lm avx2\n\n"


class Pc:
    """A good PC as /sys and /proc show it; tests take away or change."""

    def __init__(self, root):
        self.root = Path(root)
        self.write("proc/cpuinfo", CPU.format(0) + CPU.format(1))
        self.write("proc/meminfo", "MemTotal:        8000000 kB\n")
        self.write("proc/asound/cards", " 0 [PCH            ]: HDA-Intel - HDA Intel PCH\n                      HDA at 0xf\n")
        self.write("sys/firmware/efi/fw_platform_size", "64\n")
        self.secure_boot(False)
        self.graphics("0x8086", "0x5916")
        self.write("sys/class/drm/card0-HDMI-A-1/status", "connected\n")
        self.write("sys/class/drm/card0-HDMI-A-1/modes", "1920x1080\n1280x720\n")
        self.disk("nvme0n1", "devices/pci0000:00/nvme/nvme0", 500_000_000_000)
        self.write("sys/class/hidraw/hidraw0/device/uevent", "DRIVER=hid-generic\nHID_NAME=A Stick\n")
        self.write("sys/class/watchdog/watchdog0/identity", "iTCO_wdt\n")

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_bytes(text if isinstance(text, bytes) else text.encode())

    def remove(self, path):
        target = self.root / path
        if target.is_dir() and not target.is_symlink():
            for child in target.iterdir():
                self.remove(child.relative_to(self.root))
            target.rmdir()
        else:
            target.unlink()

    def secure_boot(self, on):
        self.write(check_pc.SECURE_BOOT, b"\6\0\0\0" + bytes([on]))

    def graphics(self, vendor, device):
        for name, value in (("class", "0x030000"), ("vendor", vendor), ("device", device)):
            self.write(f"sys/bus/pci/devices/0000:00:02.0/{name}", value + "\n")

    def disk(self, name, device, size):
        self.write(f"sys/block/{name}/size", f"{size // 512}\n")
        folder = self.root / "sys" / device
        folder.mkdir(parents=True, exist_ok=True)
        (self.root / f"sys/block/{name}/device").symlink_to(folder)

    def said(self):
        findings = check_pc.Findings()
        for check in check_pc.CHECKS:
            check(self.root, findings)
        return findings.lines

    def verdicts(self, *of):
        return [(verdict, thing) for verdict, thing, _ in self.said() if verdict in of]


class CheckPc(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.pc = Pc(folder.name)

    def sentence(self, thing):
        return next(said for _, name, said in self.pc.said() if name == thing)

    def test_a_good_pc_lacks_nothing_but_a_camera(self):
        self.assertEqual(self.pc.verdicts("NO", "note"), [("note", "camera")])
        self.assertEqual(check_pc.verdict_of(self.pc.said()), "This computer will do, with limits: camera.")

    def test_a_pc_without_uefi_will_not_do(self):
        self.pc.remove("sys/firmware/efi")
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "firmware")])

    def test_secure_boot_must_be_off(self):
        self.pc.secure_boot(True)
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "Secure Boot")])
        self.assertIn("switch it off", self.sentence("Secure Boot"))

    def test_a_pc_without_keys_takes_those_of_an_image(self):
        self.assertEqual(self.sentence("Secure Boot"), "off")
        self.pc.write(check_pc.SETUP_MODE, b"\6\0\0\0\1")
        self.assertIn("takes the keys", self.sentence("Secure Boot"))

    def test_32_bits_will_not_do(self):
        self.pc.write("proc/cpuinfo", "processor\t: 0\nflags\t: fpu\n")
        self.pc.write("sys/firmware/efi/fw_platform_size", "32\n")
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "processor"), ("NO", "firmware")])

    def test_too_little_memory_will_not_do(self):
        self.pc.write("proc/meminfo", "MemTotal:        120000 kB\n")
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "memory")])

    def test_a_usb_disk_alone_wants_an_image_made_for_it(self):
        self.pc.remove("sys/block/nvme0n1")
        self.pc.disk("sda", "devices/pci0000:00/usb1/1-1/host0", 64_000_000_000)
        self.assertEqual(self.pc.verdicts("NO"), [])
        self.assertIn("--medium usb", self.sentence("disk"))

    def test_emmc_will_do(self):
        self.pc.remove("sys/block/nvme0n1")
        self.pc.disk("mmcblk0", "devices/pci0000:00/0000:00:1c.0/mmc_host/mmc0/mmc0:0001", 32_000_000_000)
        self.assertEqual(self.pc.verdicts("NO", "note"), [("note", "camera")])

    def test_graphics_that_are_too_old_will_not_do(self):
        self.pc.graphics("0x8086", "0x2a42")
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "graphics")])

    def test_a_disk_that_is_too_small_will_not_do(self):
        self.pc.remove("sys/block/nvme0n1")
        self.pc.disk("sda", "devices/pci0000:00/ata1/host0", 500_000_000)
        self.assertEqual(self.pc.verdicts("NO"), [("NO", "disk")])
        self.assertIn("too small", self.sentence("disk"))

    def test_graphics_without_a_driver_in_the_image_are_drawn_by_the_processor(self):
        for vendor, device, name in (("0x1002", "0x1636", "AMD"), ("0x10de", "0x1cb3", "NVIDIA"), ("0x8086", "0x46a6", "Intel")):
            self.pc.graphics(vendor, device)
            self.assertIn(("note", "graphics"), self.pc.verdicts("note"), name)
            self.assertIn(name, self.sentence("graphics"))
            self.assertEqual("--graphics" in self.sentence("graphics"), name != "NVIDIA")
        self.pc.graphics("0x8086", "0x0166")
        self.assertIn("Ivy Bridge", self.sentence("graphics"))

    def test_sound_by_a_processor_of_signals_is_named(self):
        self.pc.write("proc/asound/cards", " 0 [sofhdadsp      ]: sof-hda-dsp - sof-hda-dsp\n")
        self.assertIn("no driver for it", self.sentence("sound"))

    def test_a_camera_is_judged_by_its_modes(self):
        self.pc.write("sys/class/video4linux/video0/name", "A Camera\n")
        real, modes = check_pc.video_modes.modes_of, []
        self.addCleanup(setattr, check_pc.video_modes, "modes_of", real)
        check_pc.video_modes.modes_of = lambda path: modes
        modes += [("MJPG", 1280, 720, 30.0), ("YUYV", 640, 480, 15.0)]
        self.assertIn("has no 640x480 at 30", self.sentence("camera"))
        modes.append(("YUYV", 640, 480, 30.0))
        self.assertEqual(self.pc.verdicts("NO", "note"), [])
        self.assertEqual(check_pc.verdict_of(self.pc.said()), "This computer will do.")

    def test_a_pc_of_which_nothing_can_be_read_is_refused_without_an_exception(self):
        with tempfile.TemporaryDirectory() as nothing:
            self.pc.root = Path(nothing)
            self.assertEqual([thing for _, thing in self.pc.verdicts("NO")], ["processor", "memory", "firmware", "disk"])


if __name__ == "__main__":
    unittest.main()
