#!/usr/bin/env python3
"""How much the programs of the box could do if they wanted to: sandbox.py REPOSITORY

`systemd-analyze security` looks at each unit as it ships and sums up what is open, 0 to 10. The stage may have 1.0,
kaori-shows, which mounts sticks, reads what stage and lips keep for a backup, and keeps both rights from what it starts, 2.1,
kaori-desk, which has a port, 1.7, every other 1.5. That the measure sees anything is tried on a unit without a sandbox.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

UNITS = "rootfs/overlay/usr/lib/systemd/system"
ALLOWED = {"kaori-stage.service": 1.0, "kaori-shows.service": 2.1, "kaori-desk.service": 1.7}
ALLOWED_ELSE = 1.5
BARE = "[Service]\nExecStart=/usr/bin/kaori-stage\n"


def security(unit):
    return subprocess.run(["systemd-analyze", "security", "--offline=true", "--no-pager", unit], capture_output=True, text=True,
                          check=True).stdout


def may_mount(unit):
    """Whether the right to mount is left to it by all of its drop-ins."""
    return re.search(r"CapabilityBoundingSet=~CAP_SYS_ADMIN +Service has administrator privileges", security(unit)) is not None


def exposure(unit):
    shown = security(unit)
    return float(re.search(r"Overall exposure level for \S+: ([0-9.]+)", shown)[1])


def main():
    repository = Path(sys.argv[1])
    faults = [] if may_mount((repository / UNITS).resolve() / "kaori-shows.service") else ["kaori-shows.service cannot mount a stick"]
    for unit in sorted((repository / UNITS).glob("*.service")):
        open_to, allowed = exposure(unit.resolve()), ALLOWED.get(unit.name, ALLOWED_ELSE)
        print(f"{open_to:4.1f} of {allowed:.1f}  {unit.name}")
        if open_to > allowed:
            faults.append(unit.name)
    with tempfile.TemporaryDirectory() as folder:
        bare = Path(folder) / "bare.service"
        bare.write_text(BARE)
        if exposure(bare) < 9:
            faults.append("the measure itself: a unit without a sandbox passes")
    if faults:
        sys.exit("not as open as it should be: " + ", ".join(faults))


main()
