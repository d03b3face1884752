"""The box's image in QEMU, as a test holds it: its serial line, and its screen. The command line is that of kaori-bench."""

import os
import re
import subprocess
import tempfile
import time
from pathlib import Path

from qmp import Qmp

BENCH = Path(os.environ.get("KAORI_BENCH", Path(__file__).resolve().parents[2] / "out/build/release/bin/kaori-bench"))
FAST = ()
# Each instruction takes a nanosecond of the machine's own time, whatever else this computer does meanwhile; waiting
# takes none of ours.
STEADY = ("--count-instructions",)
SCREEN = ("-device", "virtio-gpu-pci,id=card,xres=960,yres=540")
FACE = r"Started .*kaori-stage"


class Machine:
    """Runs from construction to the end of a `with` statement. `disk` may be another than the image's; nothing is
    written to it, unless the machine `keeps` what it writes.
    `screen` is QEMU's arguments for the graphics card; those may name {folder}, where sockets lie. `pace` is FAST, or
    STEADY where times in the machine are measured."""

    def __init__(self, image, disk=None, screen=SCREEN, keeps=False, pace=FAST):
        self.folder = tempfile.TemporaryDirectory()
        self.serial = Path(self.folder.name) / "console.log"
        asked = [BENCH, "--image", image, "--command", self.folder.name, *pace,
                 *(("--disk", disk) if disk else ()), *(("--keep-disk",) if keeps else ())]
        command = subprocess.run(asked, check=True, capture_output=True, text=True).stdout.splitlines()
        self.process = subprocess.Popen([*command, *(word.format(folder=self.folder.name) for word in screen)])
        self.link = None

    def __enter__(self):
        return self

    def __exit__(self, *_):
        self.process.terminate()
        self.process.wait()
        self.folder.cleanup()

    def path(self, name):
        """Where a socket lies that `screen` named."""
        return Path(self.folder.name) / name

    def said(self):
        return self.serial.read_text(errors="replace") if self.serial.exists() else ""

    def wait_for(self, words, longest_s):
        """Whether the serial line said it in time, and before the machine ended."""
        until = time.monotonic() + longest_s
        while time.monotonic() < until:
            if re.search(words, self.said()):
                return True
            if self.process.poll() is not None:
                return bool(re.search(words, self.said()))
            time.sleep(0.1)
        return False

    def ask(self, command, **arguments):
        while self.link is None and not self.path("qmp").exists() and self.process.poll() is None:
            time.sleep(0.02)  # QEMU is about to begin.
        if self.link is None:
            self.link = Qmp(f"{self.folder.name}/qmp")
        return self.link.ask(command, **arguments)

    def strike(self, key):
        """Of a keyboard that was plugged in with the screen; QEMU's name."""
        self.ask("send-key", keys=[{"type": "qcode", "data": key}], **{"hold-time": 300})

    def screen(self, head=0):
        """The picture on its screen, or on another of its card: width, height, and the bytes of its pixels (RGB)."""
        picture = Path(self.folder.name) / "screen.ppm"
        self.ask("screendump", filename=str(picture), **({"device": "card", "head": head} if head else {}))
        kind, size, _, pixels = picture.read_bytes().split(b"\n", 3)
        assert kind == b"P6", kind
        width, height = map(int, size.split())
        return width, height, pixels
