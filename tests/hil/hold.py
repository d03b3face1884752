#!/usr/bin/env -S python3 -B
"""The last face stays on the screen while the stage dies and starts again: hold.py IMAGE_FOLDER PACKAGES [KILLS [STOPS [HANGS]]]

A copy of the image gets one unit more, which kills the stage each time it is ready; another, which stops and starts it;
and one that freezes it, upon which the watchdog must kill it. Kernel, programs and everything else are the image's. The screen is read all the while, many times a second. A picture is wrong
if it differs from the face before the death by more than a face moves; a black picture, and the face upside down, must
be found wrong, or the test is. Results go into boot.json beside the image.
"""

import re
import sys
import tempfile
import time
from pathlib import Path

from machine import FACE, Machine
from proof import difference, with_units, write_report

ALLOWED = 0.06  # Of the range of a byte, on average over a picture: breath, a blink and the hair's sway stay below.
LOOKED_S = 0.02
BOOT_S = 300
# A stage that hangs before it knows its pace has two minutes, as its unit says.
DEATH_S = {"killer": 60, "stopper": 60, "hanger": 180}
SCREEN = ("-device", "virtio-gpu-pci,id=card,xres=480,yres=270")  # Small: the stage is back sooner.
READY = r"kaori-stage: the first picture is drawn"
KILLED = r"kaori-stage.service: Main process exited, code=killed, status=9"
# Under emulation a frame may take longer than a stop may: systemd then kills.
STOPPED = r"kaori-stage.service: (?:Deactivated successfully|Failed with result 'timeout')"
HUNG = r"kaori-stage.service: Watchdog timeout"
# `start` returns when the stage is ready. What an operator does between is the pause before a restart.
UNIT = """[Unit]
StartLimitIntervalSec=0
DefaultDependencies=no
[Service]
ExecStartPre=/usr/bin/systemctl start kaori-stage.service
ExecStart=/usr/bin/systemctl {verb} kaori-stage.service
Restart=always
RestartSec=500ms
"""
VERBS = {"killer": ("kill --signal=KILL --kill-who=main", KILLED), "stopper": ("stop", STOPPED),
         "hanger": ("kill --signal=STOP --kill-who=main", HUNG)}


def watch(box, pattern, deaths, death_s):
    """Reads the screen until so many deaths; the first face, and each picture's difference from it."""
    _, _, face = box.screen()
    found = []
    until = time.monotonic() + deaths * death_s
    while time.monotonic() < until and len(re.findall(pattern, box.said())) < deaths:
        found.append(difference(face, box.screen()[2]))
        time.sleep(LOOKED_S)
    return face, found


def play(image, packages, kind, deaths):
    """One machine whose stage dies so; what was seen."""
    verb, pattern = VERBS[kind]
    with tempfile.TemporaryDirectory(dir=image) as folder:
        copy = with_units(image, packages, folder, {f"bench-{kind}.service": UNIT.format(verb=verb)})
        with Machine(copy, screen=SCREEN) as box:
            if not box.wait_for(FACE, BOOT_S):
                sys.exit("hold: the face did not come")
            face, found = watch(box, pattern, deaths, DEATH_S[kind])
            died = len(re.findall(pattern, box.said()))
            ready = len(re.findall(READY, box.said()))
    control = min(difference(face, bytes(len(face))), difference(face, face[::-1]))
    wrong = sum(d > ALLOWED for d in found)
    good = died >= deaths and found and not wrong and control > ALLOWED
    print(f"{'ok  ' if good else 'FAIL'}  {kind}: {died} deaths, {ready} times ready, {len(found)} pictures, {wrong} wrong; "
          f"largest difference {max(found, default=1):.3f}, of the controls {control:.3f}, allowed {ALLOWED}", flush=True)
    return good, wrong, died, len(found)


def main():
    image, packages = Path(sys.argv[1]), Path(sys.argv[2])
    wanted = [int(count) for count in sys.argv[3:6]] + [40, 20, 2][len(sys.argv[3:6]):]
    results = [play(image, packages, kind, count) if count else (True, 0, 0, 0) for kind, count in zip(VERBS, wanted)]
    died = {name: result[2] for name, result in zip(("kills", "stops", "hangs"), results)}
    write_report(image, held_frames_wrong=sum(r[1] for r in results), held_deaths=died,
                 held_pictures=sum(r[3] for r in results))
    sys.exit(not all(r[0] for r in results))


main()
