#!/usr/bin/env -S python3 -B
"""The box comes back with its last face after the plug was pulled: last_face.py IMAGE_FOLDER

A copy of the disk, which keeps what is written. A key calls another scene; a minute later the machine is killed. Started
again, its first light must be that face, and so must its first frame by GL, and not the show's first face. Then the file is
spoilt, and the show's first face must come. Results go into boot.json beside the image.
"""

import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from machine import FACE, Machine
from proof import difference, write_report

SCREEN = ("-device", "virtio-gpu-pci,id=card,xres=480,yres=270", "-device", "usb-kbd")
FOUND = r"kaori-input: keyboard: "
BOOT_S, FADE_S, LOOK_S, LIGHT_S = 400, 240, 2, 0.05
KEPT_S = 900    # A change is kept within half a minute; but a frame may take seconds here, and a fade needs ten.
NAMED_S = 5     # From the file's bytes to its name.
DATA_MIB = 130  # At the end of the disk.
KEY = "f2"      # The poster.
SAME = 0.05     # As far as a face moves by itself: breath, a glance, the hair's sway.
OTHER = 0.12    # At least so far are two scenes apart.
COLOURS = 64    # A picture has more; QEMU's words on a dark screen have fewer.
END = b"KAORI LF"
READ, TORN = r"kaori-stage: .* is read", r"last-face: it is torn"


def is_picture(pixels):
    return len({pixels[at:at + 3] for at in range(0, len(pixels), 3 * 17)}) > COLOURS


def first_light(box):
    """The first picture on the screen, and the seconds until then."""
    began = time.monotonic()
    while time.monotonic() - began < BOOT_S:
        try:
            _, _, pixels = box.screen()
            if is_picture(pixels):
                return pixels, time.monotonic() - began
        except (OSError, RuntimeError):
            pass  # Its card is not there yet.
        time.sleep(LIGHT_S)
    sys.exit("last face: no light came")


def first_face(box):
    if not box.wait_for(FACE, BOOT_S):
        sys.exit("last face: the box did not start:\n" + box.said()[-3000:])
    return box.screen()[2]


def kept(disk):
    """The ends of all last faces that were ever written to it."""
    with open(disk, "rb") as file:
        file.seek(-DATA_MIB << 20, 2)
        return set(re.findall(re.escape(END) + b"(.{24})", file.read(), re.DOTALL))


def await_kept(box, disk, before):
    """Until one more face is on the disk, under its name."""
    until = time.monotonic() + KEPT_S
    while time.monotonic() < until:
        now = kept(disk)
        if now - before:
            time.sleep(NAMED_S)
            return now
        time.sleep(LOOK_S)
    sys.exit("last face: the change was not kept\n" + box.said()[-3000:])


def play_evening(image, disk):
    """The show's first face, and the one on the screen when the plug is pulled."""
    with Machine(image, disk, SCREEN, keeps=True) as box:
        opening = first_face(box)
        if not box.wait_for(FOUND, BOOT_S):
            sys.exit("last face: the keyboard was not found")
        before = await_kept(box, disk, set())
        box.strike(KEY)
        until = time.monotonic() + FADE_S
        evening = opening
        while difference(opening, evening) < OTHER and time.monotonic() < until:
            time.sleep(1)
            evening = box.screen()[2]
        if difference(opening, evening) < OTHER:
            sys.exit("last face: the key called no other scene\n" + box.said()[-3000:])
        await_kept(box, disk, before)
        evening = box.screen()[2]
        box.process.kill()
        return opening, evening


def spoil(disk):
    """A byte of the state of every last face on the disk."""
    with open(disk, "r+b") as file:
        begin = file.seek(-DATA_MIB << 20, 2)
        found = [match.start() for match in re.finditer(re.escape(END), file.read())]
        for end in found:
            file.seek(begin + end - 1)
            byte = file.read(1)[0]
            file.seek(begin + end - 1)
            file.write(bytes([byte ^ 0xFF]))


def start_again(image, disk, words=READ):
    """The first light, when it came, the first face, and whether the log says these words."""
    with Machine(image, disk, SCREEN, keeps=True) as box:
        light, light_s = first_light(box)
        face = first_face(box)
        said = box.wait_for(words, NAMED_S * 12)
        box.process.kill()
    return light, light_s, face, said


def main():
    image = Path(sys.argv[1])
    with tempfile.TemporaryDirectory(dir=image) as folder:
        disk = Path(folder) / "kaori.disk"
        subprocess.run(["cp", "--sparse=always", image / "kaori.disk", disk], check=True)
        opening, evening = play_evening(image, disk)
        light, light_s, face, _ = start_again(image, disk)
        found = {"light": difference(light, evening), "face": difference(face, evening),
                 "opening": difference(face, opening)}
        print(f"last face: first light after {light_s:.1f} s; differences from the evening's: the light "
              f"{found['light']:.3f}, the first face {found['face']:.3f}; of that from the show's first {found['opening']:.3f}")
        spoil(disk)
        light, _, face, named = start_again(image, disk, TORN)
        still, torn = difference(light, opening), difference(face, opening)
        print(f"last face: torn, the light differs from the show's first by {still:.3f}, the face by {torn:.3f}")
        shutil.rmtree(folder, ignore_errors=True)
    write_report(image, last_face_light=round(found["light"], 3), last_face_face=round(found["face"], 3))
    if max(found["light"], found["face"]) > SAME or found["opening"] < OTHER:
        sys.exit("last face: the box came back with another one")
    if max(still, torn) > SAME or not named:
        sys.exit("last face: a torn file was believed, or not named")


main()
