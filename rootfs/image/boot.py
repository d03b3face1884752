#!/usr/bin/env python3
"""Starts the box's image in QEMU, with a simulated screen and no acceleration: boot.py IMAGE_FOLDER [options]

    --shot FILE.png   wait until the first face is on the screen, write a picture of the screen, and end
    --trace           say on the way where the time goes, from the start of QEMU to the first face; then end
    --size 960x540    of the screen
    --memory MIB      of the machine (512)
"""

import argparse
import os
import re
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

from qmp import Qmp

# The guest draws by itself; with newer processors' instructions emulation is many times slower.
MACHINE = ("-M", "q35", "-accel", "tcg,thread=multi", "-cpu", "Nehalem", "-smp", "2", "-no-reboot", "-vga", "none")
# The system speaks to the kernel, the stage to the journal; both pass it on at once.
TOLD = "console=ttyS0 loglevel=7 printk.devkmsg=on systemd.log_target=kmsg systemd.show_status=0 " \
       "systemd.journald.forward_to_console=1"
# What the serial line says -> what it means. In this order.
MARKS = (
    ("the kernel begins", r"Linux version"),
    ("the disk's root is found and believed; the first program lights the screen", r"Run /usr/bin/kaori-boot"),
    ("the system begins", r"systemd 252|systemd\[1\]: "),
    ("the stage's program begins", r"Starting .*kaori-stage"),
    ("Mesa is loaded, the graphics card is open", r"the graphics card is open"),
    ("the show is read", r"kaori-stage: .* is read"),
    ("faces and shaders are ready", r"is (opened|resumed) on"),
    ("the first face is on the screen", r"Started .*kaori-stage"),
)
LONGEST_S = 240
COLOURS_OF_A_PICTURE = 500  # QEMU's own words on a screen that is dark have fewer.


def qemu(args, folder):
    width, height = args.size.split("x")
    images = args.images
    told = (images / "cmdline").read_text().strip()
    # Whatever the box is asked to say, its own words come last: the last one counts.
    told = told.replace(" quiet loglevel=3", "") + " " + TOLD if args.trace or args.shot else told
    return ["qemu-system-x86_64", *MACHINE, "-m", str(args.memory),
            "-display", "gtk" if "DISPLAY" in os.environ and not args.shot else "none",
            "-kernel", images / "bzImage", "-append", told,
            "-drive", f"file={images / 'kaori.disk'},if=virtio,format=raw,snapshot=on",
            "-device", f"virtio-gpu-pci,xres={width},yres={height}", "-device", "qemu-xhci",
            "-serial", "stdio", "-qmp", f"unix:{folder}/qmp,server=on,wait=off"]


def is_lit(picture):
    """Whether a PPM shows more than words."""
    pixels = picture.read_bytes().split(b"\n", 3)[3]
    return len({pixels[at:at + 3] for at in range(0, len(pixels), 3 * 17)}) > COLOURS_OF_A_PICTURE


def say_light(folder, began):
    """Looks at the screen until it shows any picture."""
    while not os.path.exists(f"{folder}/qmp"):
        time.sleep(0.05)
    qmp, picture = Qmp(f"{folder}/qmp"), Path(folder) / "screen.ppm"
    while time.monotonic() - began < LONGEST_S:
        time.sleep(0.1)
        try:
            qmp.screendump(picture)
        except (OSError, ValueError):
            return  # The machine has ended.
        if is_lit(picture):
            print(f"{time.monotonic() - began:7.2f} s               (the screen shows the still)", flush=True)
            return


def follow(machine, began, trace, log):
    """Reads the serial line until the last mark, or the end; the seconds of the marks that came by."""
    seen, before = {}, 0.0
    for line in machine.stdout:
        log.write(line)
        now = time.monotonic() - began
        for name, words in MARKS:
            if name in seen or not re.search(words, line):
                continue
            seen[name] = now
            if trace:
                print(f"{now:7.2f} s  after {now - before:5.2f}  {name}", flush=True)
                before = now
        if MARKS[-1][0] in seen or now > LONGEST_S:
            break
    return seen


def watch(machine, args, folder, log):
    """Until the first face; then the picture that was asked for."""
    began = time.monotonic()
    light = threading.Thread(target=say_light, args=(folder, began), daemon=True)
    if args.trace:
        light.start()
    if MARKS[-1][0] not in follow(machine, began, args.trace, log):
        sys.exit(f"boot: the face did not come; see {args.images}/serial.log")
    if args.trace:
        light.join()
    if args.shot:
        Qmp(f"{folder}/qmp").screendump(args.shot.resolve())


def parse():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("images", type=Path)
    parser.add_argument("--shot", type=Path)
    parser.add_argument("--trace", action="store_true")
    parser.add_argument("--size", default="960x540")
    parser.add_argument("--memory", type=int, default=512)
    args = parser.parse_args()
    if not re.fullmatch(r"[1-9]\d{1,4}x[1-9]\d{1,4}", args.size):
        sys.exit(f"boot: --size {args.size}: expected a width and a height, as in 960x540")
    return args


def main():
    args = parse()
    with tempfile.TemporaryDirectory() as folder, open(args.images / "serial.log", "w", encoding="utf-8") as log:
        with subprocess.Popen([str(c) for c in qemu(args, folder)], stdout=subprocess.PIPE, stderr=log,
                              text=True, errors="replace") as machine:
            try:
                if args.trace or args.shot:
                    watch(machine, args, folder, log)
                else:
                    print("the box runs; Ctrl-C ends it", flush=True)
                    machine.wait()
            except KeyboardInterrupt:
                pass
            finally:
                machine.terminate()


if __name__ == "__main__":
    main()
