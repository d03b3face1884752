#!/usr/bin/env -S python3 -B
"""A box whose first program hangs is started again by its own watchdog: restart.py IMAGE_FOLDER PACKAGES

The machine has the watchdog of a PC's chip set (Intel TCO). A unit of the bench freezes the system's first program once the
face is there; the machine must then reset by itself, which ends QEMU. The control: where nothing is frozen it goes on.
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

from machine import FACE, Machine
from proof import with_units

FREEZE = """
#include <fcntl.h>
#include <unistd.h>
int main(void) {
  int fd = open("/sys/fs/cgroup/init.scope/cgroup.freeze", O_WRONLY);
  return write(fd, "1", 1) == 1 ? 0 : 1;
}
"""
UNIT = """[Unit]
After=kaori-stage.service
[Service]
Type=oneshot
ExecStart=/usr/bin/freeze
"""
ARMED = r"Watchdog running with a timeout of|Using hardware watchdog"
# QEMU's chip set is strapped so that its watchdog resets nothing, unless it is told.
SMALL = ("-device", "virtio-gpu-pci,id=card,xres=320,yres=180", "-global", "ICH9-LPC.noreboot=off")
LONGEST_S = 400
QUIET_S = 150  # Twice the watchdog's time, and more.


def ends(image, longest_s):
    """Whether the machine showed a face, armed its watchdog, and ended by itself afterwards; seconds from the face on."""
    with Machine(image, screen=SMALL) as box:
        if not box.wait_for(FACE, LONGEST_S):
            raise SystemExit("restart: the face did not come:\n" + box.said()[-2000:])
        began, armed = time.monotonic(), box.wait_for(ARMED, 1)
        while box.process.poll() is None and time.monotonic() - began < longest_s:
            time.sleep(0.5)
        return armed, box.process.poll() is not None, time.monotonic() - began


def main():
    image, packages = Path(sys.argv[1]), Path(sys.argv[2])
    with tempfile.TemporaryDirectory(dir=image) as folder:
        program = Path(folder) / "freeze"
        subprocess.run(["gcc", "-static", "-O1", "-x", "c", "-", "-o", program], input=FREEZE, text=True, check=True)
        copy = Path(folder) / "copy"
        copy.mkdir()
        frozen = with_units(image, packages, copy, {"freeze.service": UNIT}, (program,))
        armed, ended, after_s = ends(frozen, LONGEST_S)
    print(f"{'ok  ' if armed else 'FAIL'}  the watchdog runs")
    print(f"{'ok  ' if ended else 'FAIL'}  one whose first program is frozen resets, after {after_s:.0f} s", flush=True)
    _, reset, _ = ends(image, QUIET_S)
    print(f"{'FAIL' if reset else 'ok  '}  one whose first program runs does not", flush=True)
    sys.exit((not armed) + (not ended) + reset)


main()
