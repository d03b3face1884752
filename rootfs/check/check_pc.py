#!/usr/bin/env python3
"""Says whether this computer will do as a Kaori box, before anybody writes a disk: check_pc.py [--root FOLDER] [--json]

Run it on the computer itself under any Linux (a live system will do); it needs Python 3 and nothing else, changes nothing,
and is best run as root: without, the cameras' modes and the state of Secure Boot may stay unknown.

Each line begins with "ok", "note" (the box plays, with a limit that the line names) or "NO" (it will not do). Ends with 0
where no line says NO, else with 1.
"""

import argparse
import json
import platform
import re
import sys
from pathlib import Path

import graphics_cards
import video_modes

LEAST_MEMORY_MB = 256  # What the image's page asks for.
LEAST_DISK_MB = 1898  # The image's default size, 1810 MiB.
LEAST_CORES = 2  # What draws 960x540 smoothly without a graphics card.
SECURE_BOOT = "sys/firmware/efi/efivars/SecureBoot-8be4df61-93ca-11d2-aa0d-00e098032b8c"
SETUP_MODE = "sys/firmware/efi/efivars/SetupMode-8be4df61-93ca-11d2-aa0d-00e098032b8c"

STARTS = ("SATA", "NVMe", "virtio", "SD or eMMC", "USB")  # Ways to a disk from which the box starts.
# Drivers of wired cards in the image's kernel, by the settings that put them there.
WIRED = {"e1000e": "CONFIG_E1000E", "igb": "CONFIG_IGB", "igc": "CONFIG_IGC", "r8169": "CONFIG_R8169"}
# Cards that Realtek's own drivers (r8168, r8125) take as well: r8169 drives them.
REALTEK, R8169 = "0x10ec", ("0x8125", "0x8126", "0x8136", "0x8161", "0x8162", "0x8167", "0x8168", "0x8169")
VENDORS = {"0x8086": "Intel", "0x1002": "AMD", "0x10de": "NVIDIA", "0x1af4": "virtio", "0x1234": "Bochs", "0x1a03": "ASPEED",
           REALTEK: "Realtek"}


class Findings:
    """What was found, in the order in which it was looked for: (verdict, thing, sentence)."""

    def __init__(self):
        self.lines = []

    def add(self, verdict, thing, sentence):
        self.lines.append((verdict, thing, sentence))


def read(path):
    """The text of a file of the kernel, or nothing where it cannot be read."""
    try:
        return path.read_text(errors="replace").strip()
    except OSError:
        return ""


def check_processor(root, findings):
    cpu = read(root / "proc/cpuinfo")
    name = re.search(r"^model name\s*: (.*)$", cpu, re.MULTILINE)
    cores = len(re.findall(r"^processor\s*:", cpu, re.MULTILINE))
    flags = re.search(r"^flags\s*: (.*)$", cpu, re.MULTILINE)
    what = f"{name[1] if name else 'a processor without a name'}, {cores} processors"
    if not flags or "lm" not in flags[1].split():
        findings.add("NO", "processor", f"{what}: the image is for x86 of 64 bits")
    elif cores < LEAST_CORES:
        findings.add("note", "processor", f"{what}: two draw 960x540 smoothly without a graphics card, one does not")
    else:
        findings.add("ok", "processor", what)


def check_memory(root, findings):
    total = re.search(r"^MemTotal:\s*(\d+) kB", read(root / "proc/meminfo"), re.MULTILINE)
    megabytes = int(total[1]) // 1024 if total else 0
    verdict = "ok" if megabytes >= LEAST_MEMORY_MB * 0.85 else "NO"  # The kernel keeps some for itself.
    findings.add(verdict, "memory", f"{megabytes} MiB" + ("" if verdict == "ok" else f": {LEAST_MEMORY_MB} MiB are needed"))


def check_firmware(root, findings):
    if not (root / "sys/firmware/efi").is_dir():
        findings.add("NO", "firmware", "this system was not started by UEFI: choose UEFI in the firmware's setup, and switch legacy "
                     "boot (CSM) off")
        return
    bits = read(root / "sys/firmware/efi/fw_platform_size")
    if bits == "32":
        findings.add("NO", "firmware", "its UEFI has 32 bits; the image's loader has 64")
        return
    findings.add("ok", "firmware", "UEFI of 64 bits")
    try:
        on = (root / SECURE_BOOT).read_bytes()[-1:] == b"\1"  # As is_set, but that nothing is not "off".
    except OSError:
        findings.add("note", "Secure Boot", "its state cannot be read; it must be off for an image that is not signed")
        return
    if on:
        findings.add("NO", "Secure Boot", "on: switch it off in the firmware's setup, or sign the image with keys of your own and give this PC "
                     "those keys (./box keys)")
    else:
        findings.add("ok", "Secure Boot", "off" + (", and this PC takes the keys of a signed image" if is_set(root / SETUP_MODE) else ""))


def is_set(variable):
    """Whether a variable of the firmware of one byte is 1; not where it cannot be read."""
    try:
        return variable.read_bytes()[-1:] == b"\1"
    except OSError:
        return False


def graphics_words(family, name):
    """The verdict on a card, and what is said of it: what draws on it, by Mesa's driver of its kind."""
    smoothly = "the processor draws, smoothly at 960x540 with two cores"
    if family is None:
        return "note", f"{name}: a card that this program does not know; where the image has no driver for it {smoothly}"
    what = f"{name} ({family.name}" + (f", Mesa's {family.mesa})" if family.mesa else ")")
    why = f": {family.why}" if family.why else ""
    if family.draws == graphics_cards.NOT_AT_ALL:
        return "NO", f"{what}{why}"
    if family.draws == graphics_cards.NEVER:
        return "note", f"{what}{why}; {smoothly}, and the card with no image: --graphics does not help"
    if family.draws == graphics_cards.AS_IT_IS:
        return "ok", f"{what}: the image as it is drives it; {family.why}"
    also = f"; {family.why}" if family.why else ""
    return "note", f"{what}: {smoothly}; the card draws with ./box image --graphics {family.draws} or all, and files of its maker " \
        f"(docs/image.md){also}"


def pci_cards(root, kind):
    """(vendor, device, name, folder) of the PCI devices whose class begins so."""
    for card in sorted((root / "sys/bus/pci/devices").glob("*")):
        if read(card / "class").startswith(kind):
            vendor, device = read(card / "vendor"), read(card / "device")
            name = f"{VENDORS.get(vendor, 'vendor ' + vendor)} {vendor.removeprefix('0x')}:{device.removeprefix('0x')}"
            yield vendor, device, name, card


def check_graphics(root, findings):
    cards = list(pci_cards(root, "0x03"))
    if not cards:
        findings.add("note", "graphics", "no PCI graphics card was found: the processor draws on whatever the firmware has lit")
    for vendor, device, name, _ in cards:
        verdict, said = graphics_words(graphics_cards.family_of(vendor, device), name)
        findings.add(verdict, "graphics", said)


def check_network(root, findings):
    """Wired cards, which the desk alone needs; one that the running system drives by a driver of the image's kernel serves."""
    cards = []
    for vendor, device, name, folder in pci_cards(root, "0x0200"):
        driver = (folder / "driver").resolve().name if (folder / "driver").exists() else ""
        driver = "r8169" if vendor == REALTEK and device in R8169 else driver
        cards.append((driver in WIRED, f"{name}" + (f" ({driver})" if driver else "")))
    for serves, what in cards:
        findings.add("ok" if serves else "note", "network", f"{what}: " + ("its driver is in the image" if serves else
                     f"the image has no driver for it; it has {', '.join(WIRED)}"))
    if not any(serves for serves, _ in cards):
        findings.add("note", "network", "no wired card that the image drives: the box plays without, and the desk cannot be reached")


def check_screens(root, findings):
    lit = []
    for connector in sorted((root / "sys/class/drm").glob("card*-*")):
        if read(connector / "status") == "connected":
            modes = read(connector / "modes").split()
            lit.append(f"{connector.name.split('-', 1)[1]} {modes[0] if modes else 'without a mode'}")
    findings.add("ok" if lit else "note", "screens", ", ".join(lit) or "none is connected, or no driver of this system tells")


def disk_way(device):
    """How a disk is connected, by the path of its device."""
    path = str(device.resolve())
    return next((way for way, part in (("USB", "/usb"), ("NVMe", "/nvme"), ("virtio", "/virtio"), ("SATA", "/ata"),
                                       ("SD or eMMC", "/mmc")) if part in path), "an unknown way")


def check_disks(root, findings):
    usable = 0
    for block in sorted((root / "sys/block").glob("*")):
        size = read(block / "size")
        if not (block / "device").exists() or not size.isdigit() or int(size) == 0:
            continue
        megabytes, way = int(size) * 512 // 10**6, disk_way(block / "device")
        what = f"{block.name}, {megabytes / 1000:.1f} GB by {way}"
        if way not in STARTS:
            findings.add("note", "disk", f"{what}: the box does not start from it")
        elif megabytes < LEAST_DISK_MB:
            findings.add("note", "disk", f"{what}: too small, the image has {LEAST_DISK_MB} MB")
        else:
            usable += 1
            image = " by ./box image --medium usb" if way == "USB" else ""
            findings.add("note" if image else "ok", "disk", f"{what}. Everything on it is lost when the image is written there{image}")
    if not usable:
        findings.add("NO", "disk", f"none of {LEAST_DISK_MB} MB or more by {', '.join(STARTS)} was found")


def check_sound(root, findings):
    cards = re.findall(r"^\s*\d+ \[.*?\]: (\S+) - (.*)$", read(root / "proc/asound/cards"), re.MULTILINE)
    for driver, name in cards:
        if driver.startswith(("HDA-Intel", "USB-Audio", "USB")):
            findings.add("ok", "sound", name)
        else:
            findings.add("note", "sound", f"{name} ({driver}): the image has no driver for it; a USB sound card serves")
    if not cards:
        findings.add("note", "sound", "none: no voice is heard and no sound played; a USB sound card serves")


def modes_told(modes):
    """"YUYV 640x480 at 30 15, 320x240 at 30; MJPG 1280x720 at 30": by pixel format and size, pictures a second as the camera gives them."""
    formats = {}
    for pixels, width, height, rate in modes:
        formats.setdefault(pixels, {}).setdefault(f"{width}x{height}", []).append(f"{rate:g}" if rate == int(rate) else f"{rate:.1f}")
    return "; ".join(f"{pixels} " + ", ".join(f"{size} at {' '.join(rates)}" for size, rates in sizes.items())
                     for pixels, sizes in formats.items())


def check_cameras(root, findings):
    cameras = 0
    for node in sorted((root / "sys/class/video4linux").glob("video*")):
        modes = video_modes.modes_of(root / "dev" / node.name)
        if modes == []:  # A node for metadata, or one that takes no pictures.
            continue
        cameras += 1
        name = f"{read(node / 'name')} ({node.name})"
        told = f"; its modes: {modes_told(modes or [])}"
        if modes is None:
            findings.add("note", "camera", f"{name}: its modes cannot be read; run this as root")
        elif any(f == "YUYV" and (w, h) == (640, 480) and rate >= 29.9 for f, w, h, rate in modes):
            findings.add("ok", "camera", f"{name}: 640x480 at 30 pictures a second in YUYV{told}")
        else:
            findings.add("note", "camera", f"{name}: has no 640x480 at 30 pictures a second in YUYV; the lips want one that has{told}")
    if not cameras:
        findings.add("note", "camera", "none: the lips want a USB camera (video class) with 640x480 at 30 pictures a second in YUYV")


def check_input(root, findings):
    names = {match[1] for match in (re.search(r"^HID_NAME=(.*)$", read(d / "device/uevent"), re.MULTILINE)
                                    for d in sorted((root / "sys/class/hidraw").glob("*"))) if match}
    findings.add("ok" if names else "note", "input", ", ".join(sorted(names)) or "no HID device is plugged in")


def check_watchdog(root, findings):
    names = [read(d / "identity") for d in sorted((root / "sys/class/watchdog").glob("*"))]
    known = [name for name in names if re.search(r"iTCO|i6300|SP5100", name)]
    if known:
        findings.add("ok", "watchdog", f"{known[0]}: a box whose first program hangs starts again by itself")
    else:
        findings.add("note", "watchdog", "none that the image drives: a box whose first program hangs must be switched off and on")


CHECKS = (check_processor, check_memory, check_firmware, check_graphics, check_screens, check_disks, check_network, check_sound,
          check_cameras, check_input, check_watchdog)


def verdict_of(lines):
    reasons = [thing for verdict, thing, _ in lines if verdict == "NO"]
    if reasons:
        return f"This computer will not do yet: {', '.join(dict.fromkeys(reasons))}."
    limits = [thing for verdict, thing, _ in lines if verdict == "note"]
    return f"This computer will do, with limits: {', '.join(dict.fromkeys(limits))}." if limits else "This computer will do."


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--root", type=Path, default=Path("/"), help="where sys, proc and dev lie (for tests)")
    parser.add_argument("--json", action="store_true", help="for programs")
    args = parser.parse_args()
    if platform.system() != "Linux":
        sys.exit("check_pc: this computer must run Linux while it is looked at; a live system on a stick will do")
    findings = Findings()
    for check in CHECKS:
        check(args.root, findings)
    verdict = verdict_of(findings.lines)
    if args.json:
        print(json.dumps({"verdict": verdict, "findings": [dict(zip(("verdict", "thing", "said"), line)) for line in findings.lines]},
                         ensure_ascii=False, indent=1))
    else:
        for line in findings.lines:
            print(f"{line[0]:<5} {line[1]:<12} {line[2]}")
        print(verdict)
    sys.exit(any(line[0] == "NO" for line in findings.lines))


if __name__ == "__main__":
    main()
