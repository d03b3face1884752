#!/usr/bin/env -S python3 -B
"""The latency from input to scan-out, without a virtual machine: latency_desk.py IMAGE_FOLDER PROGRAMS PACK [EVENTS [RATE]]

As latency.py, with the programs as they are built for a desk, the simulator's screen, and a dial written to the board: what
differs from the box is the kernel's part on both ends. IMAGE_FOLDER is only where results go: boot.json beside it.
"""

import subprocess
import sys
import tempfile
import time
from pathlib import Path

from latency import judge

LONGEST_S = 1800
SIZE, RATE_HZ = "320x180", 4


def main():
    image, programs, pack = map(Path, sys.argv[1:4])
    events, rate_hz = (sys.argv[4:6] + ["70", str(RATE_HZ)][len(sys.argv[4:6]):])
    with tempfile.TemporaryDirectory() as folder:
        with subprocess.Popen([programs / "kaori-sim", "--links", folder, "--size", SIZE, "--hz", rate_hz]) as simulator:
            while not (Path(folder) / "screen.screen").exists() and simulator.poll() is None:
                time.sleep(0.05)
            try:
                said = subprocess.run([programs / "kaori-input-latency", "--links", folder, "--stage", programs / "kaori-stage",
                                       "--board", f"{folder}/board", "--pack", pack, "--events", events, "--first",
                                       "--mode", f"{SIZE}@{rate_hz}"],
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=LONGEST_S,
                                      check=False).stdout
            finally:
                simulator.terminate()
    sys.exit(not judge(image, said, f"the simulator's screen, {SIZE} at {rate_hz} Hz"))


main()
