#!/usr/bin/env -S python3 -B
"""Screens are plugged and pulled while the face plays: outputs.py IMAGE_FOLDER [TURNS]

A card with two heads; which of them has a screen, and of what size, is said to QEMU as a viewer says it (VNC's
SetDesktopSize). With two the face spans both; whichever is pulled, the other plays on; with none the stage waits; all
come back. Results go into boot.json beside the image.
"""

import random
import re
import socket
import struct
import sys
import time
from pathlib import Path

from machine import FACE, Machine
from pictures import is_lit
from proof import write_report

HEADS = 2
SIZES = ((320, 240), (400, 300))
SCREEN = ("-device", f"virtio-gpu-pci,id=card,max_outputs={HEADS},xres={SIZES[0][0]},yres={SIZES[0][1]}",
          *(word for head in range(HEADS)
            for word in ("-vnc", f"unix:{{folder}}/vnc{head},id=vnc{head},display=card,head={head}")))
BOOT_S, LONGEST_S = 300, 60
LEFT_S = 1.0  # How long a head is left as it is before the next one moves.


class Viewer:
    """Looks at one head, and is as large as the screen on it; 0 x 0 is no screen."""

    def __init__(self, path):
        self.link = socket.socket(socket.AF_UNIX)
        wait_until(lambda: Path(path).exists())  # QEMU is about to begin.
        self.link.connect(str(path))
        self._take(12)
        self.link.sendall(b"RFB 003.008\n")
        self._take(self._take(1)[0])
        self.link.sendall(b"\x01")  # No password.
        self._take(4)
        self.link.sendall(b"\x01")  # Others may look too.
        *_, named = struct.unpack(">HH16sI", self._take(24))
        self._take(named)
        self.link.sendall(struct.pack(">BxHiii", 2, 3, 0, -308, -223))

    def _take(self, count):
        data = b""
        while len(data) < count:
            data += self.link.recv(count - len(data))
        return data

    def resize(self, width, height):
        self.link.sendall(struct.pack(">BxHHBxIHHHHI", 251, width, height, 1, 0, 0, 0, width, height, 0))


def wait_until(condition):
    """The seconds it took; None when it did not come."""
    began = time.monotonic()
    while time.monotonic() - began < LONGEST_S:
        if condition():
            return time.monotonic() - began
        time.sleep(0.05)
    return None


class Wall:
    """The machine's two screens, and what must be true of them."""

    def __init__(self, box):
        self.box = box
        self.viewers = [Viewer(box.path(f"vnc{head}")) for head in range(HEADS)]
        self.plugged = [True, False]
        self.faults = []
        self.took_s = []

    def turn(self, head):
        """Plugs it, or pulls it."""
        self.plugged[head] = not self.plugged[head]
        before = self.box.said()
        self.viewers[head].resize(*(SIZES[head] if self.plugged[head] else (0, 0)))
        if self.plugged[head]:
            self.expect(f"screen {head + 1} shows after it was plugged in", lambda: self.changes(head))
        else:
            time.sleep(LEFT_S)
        for other in range(HEADS):
            if self.plugged[other]:
                self.expect(f"screen {other + 1} plays on", lambda o=other: self.changes(o))
        if re.search(r"kaori-stage.service: Main process exited", self.box.said()[len(before):]):
            self.faults.append("the stage ended")

    def changes(self, head):
        """It shows a face, and the face moves."""
        one = self.box.screen(head)
        if one[:2] != SIZES[head] or not is_lit(one[2]):
            return False
        return wait_until(lambda: self.box.screen(head)[2] != one[2]) is not None

    def expect(self, what, condition):
        took_s = wait_until(condition)
        if took_s is None:
            self.faults.append(f"not so: {what}; screens {self.plugged}")
            print(f"FAIL  {self.faults[-1]}", flush=True)
        else:
            self.took_s.append(took_s)


def main():
    image, turns = Path(sys.argv[1]), int(sys.argv[2]) if len(sys.argv) > 2 else 20
    chance = random.Random(5)
    with Machine(image, screen=SCREEN) as box:
        if not box.wait_for(FACE, BOOT_S):
            sys.exit("outputs: the face did not come")
        wall = Wall(box)
        wall.turn(1)
        for _ in range(turns - 1):
            wall.turn(chance.randrange(HEADS))
        (image / "outputs.log").write_text(box.said())
    worst_s = max(wall.took_s, default=0)
    print(f"{'FAIL' if wall.faults else 'ok  '}  {turns} times a screen was plugged or pulled; {len(wall.faults)} faults; the "
          f"longest wait for a moving picture {worst_s:.1f} s, under emulation", flush=True)
    write_report(image, output_turns=turns, output_faults=len(wall.faults), output_longest_s=round(worst_s, 1))
    sys.exit(bool(wall.faults))


if __name__ == "__main__":
    main()
