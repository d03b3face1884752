#!/usr/bin/env -S python3 -B
"""The latency from input to scan-out: latency.py IMAGE_FOLDER PACKAGES KERNEL PROGRAMS [EVENTS [MODE [LOADED_MODE]]]

PROGRAMS is the folder with kaori-input-latency, which runs instead of the stage in a copy of the image, and with kaori-atelier.
KERNEL is the box's kernel with one more driver, vkms: a screen whose vertical blanks come by a timer, which QEMU's
own graphics cards do not have. A dial box on uhid reports a turn at random moments; kaori-input and kaori-stage are
the image's. Compared are the stage that samples input as late as drawing allows, and the same stage with --early,
which reads them right after each flip, in three rounds that take turns, and a third arm in which another program
keeps the processor busy: measured from 30 frames after that began, until when the stage must have adapted. The
machine's time is that of its instructions, so neighbours on this computer change nothing but how long it takes. The
screen is small and slow, and the face a plain one drawn flat, so that drawing takes a part of its period, as it does
on a box. Results go into boot.json beside the image.
"""

import re
import shutil
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from machine import STEADY, Machine
from proof import with_units, write_report

UNIT = """[Unit]
After=basic.target
[Service]
Group=kaori
UMask=0007
RuntimeDirectory=kaori
RuntimeDirectoryMode=0770
Environment=LP_NUM_THREADS=0 MESA_DISK_CACHE_SINGLE_FILE=1 MESA_SHADER_CACHE_DIR=/run/kaori MESA_DISK_CACHE_READ_ONLY_FOZ_DBS=../../../../../../../usr/share/kaori/shaders
ExecStart=/usr/bin/kaori-input-latency --mode {mode} --loaded {loaded} --events {events} --pack /usr/share/kaori/latency.kaori
"""
SHOW = Path(__file__).resolve().parents[2] / "appliance/shows/kaori"
FIRST = {"face": "mask", "style": "flat", "backdrop": '{ kind = "gradient", top = "#5a6c8c", bottom = "#2c3448" }'}
# QEMU lets one processor run until the next timer of any, and only then the other: beside a busy one the stage would have
# next to nothing. On one processor the machine's own scheduler shares.
ALONE = ("-smp", "1")
LONGEST_S = 3600
WANTED_GAIN, WANTED_MISSED, WANTED_MISSED_LOADED = 1.6, 0.5, 2.0


def pack_plain_show(programs, folder, into):
    """The show, but that its first scene, which opens it, is cheap to draw."""
    shutil.copytree(SHOW, folder)
    script = folder / "show.toml"
    before, first, rest = script.read_text().split("[[scene]]", 2)
    for name, value in FIRST.items():
        value = value if value.startswith("{") else f'"{value}"'
        first, found = re.subn(rf"^{name} = .*$", f"{name} = {value}", first, flags=re.MULTILINE)
        assert found == 1, name
    script.write_text("[[scene]]".join((before, first, rest)))
    subprocess.run([programs / "kaori-atelier", "pack", folder, into], check=True, stdout=subprocess.DEVNULL)


def rounds_of(said):
    """arm -> the figures of its rounds."""
    found = {}
    for line in re.findall(r"round (arm=.*)", said):
        figures = dict(pair.split("=") for pair in line.split())
        found.setdefault(figures.pop("arm"), []).append({name: float(value) for name, value in figures.items()})
    return found


def missed_percent(rounds):
    return 100 * sum(r["missed"] for r in rounds) / max(1, sum(r["frames"] for r in rounds))


def judge(image, said, where):
    """Prints and reports the figures; whether they are good."""
    rounds = rounds_of(said)
    for arm, figures in rounds.items():
        print(arm, *figures, sep="\n    ")
    if {"early", "late", "loaded"} - rounds.keys():
        sys.exit(f"latency: the rounds did not end; see {image}/latency.log")
    mean = {arm: statistics.median(r["mean_ms"] for r in figures) for arm, figures in rounds.items()}
    gain, missed, loaded = mean["early"] / mean["late"], missed_percent(rounds["late"]), missed_percent(rounds["loaded"])
    good = gain >= WANTED_GAIN and missed <= WANTED_MISSED and loaded <= WANTED_MISSED_LOADED
    print(f"{'ok  ' if good else 'FAIL'}  {where}: {mean['early']:.1f} ms read early, {mean['late']:.1f} ms read late: "
          f"{gain:.2f} times less (wanted {WANTED_GAIN}); missed flips {missed:.2f} % (at most {WANTED_MISSED}), with a busy "
          f"processor {loaded:.2f} % (at most {WANTED_MISSED_LOADED})")
    write_report(image, latency_gain_over_naive=round(gain, 3), missed_flips_percent=round(missed, 3),
                 missed_flips_percent_loaded=round(loaded, 3),
                 frames_to_adapt=max(r["settled"] for r in rounds["loaded"]), latency_measured_on=where,
                 latency_ms={arm: round(value, 2) for arm, value in mean.items()})
    return good


def main():
    image, packages, kernel, programs = map(Path, sys.argv[1:5])
    events, mode, loaded = sys.argv[5:8] + ["70", "160x90@3", "160x90@3"][len(sys.argv[5:8]):]
    with tempfile.TemporaryDirectory(dir=image) as folder:
        plain = Path(folder) / "latency.kaori"
        pack_plain_show(programs, Path(folder) / "show", plain)
        copy = with_units(image, packages, folder, {"bench-latency.service": UNIT.format(mode=mode, loaded=loaded, events=events)},
                          programs=[programs / "kaori-input-latency"], shows=[plain], without=["kaori-stage.service", "kaori-lips.service"])
        shutil.copy(kernel, copy / "bzImage")
        with Machine(copy, screen=ALONE, pace=STEADY) as box:
            box.wait_for(r"all rounds are played|bench-latency.service: Main process exited", LONGEST_S)
            said = box.said()
    (image / "latency.log").write_text(said)
    sys.exit(not judge(image, said, f"the image in QEMU, {mode}"))


if __name__ == "__main__":
    main()
