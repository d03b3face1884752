#!/usr/bin/env python3
"""Names tests that were skipped and are on no list of those that this project skips on a build machine.

Usage: skips.py RESULTS     RESULTS is what `ctest --output-junit` wrote; prints a line for each, and exits 1 when there is one.

A person who lacks a tool may skip its tests. A build machine has them all, so that a test that is skipped there, since its
tool was forgotten, would never run anywhere and be missed by nobody: `./box test` asks here where CI is set.
"""

import re
import sys
import xml.etree.ElementTree as xml

# (pattern of whole names, why they may be skipped there).
ALLOWED = (
    (r"contracts:(Microphones|Loudspeakers)/.*/Alsa(File)?", "the library's own plug-ins have no cable, no end of frames and no fault"),
    (r"contracts:(Cameras|Screens)/.*\.IsReadableWhenThereIsA(Frame|Flip)/.*", "the fake device has no descriptor that becomes readable"),
    (r"contracts:Cameras/.*\.AStreamThatStallsIsBrokenEverAfter/Local", "the simulator's link ends with its camera, and never stalls"),
    (r"contracts:HidBuses/.*/Dials", "dials on GPIO lines are soldered in"),
    (r"files:.*/gadget_play_empty", "there is no USB device controller to play a scenario that is empty"),
    (r"import:RealHeads\..*|import_head:RealHeads\..*", "heads of other people's licences are not in this repository"),
    (r"lips:.*KeyOfBlocks\.IsTheSameWithEveryProcessorsInstructions.*", "a processor has the instructions that it has"),
    (r"stage:QualityChoiceTest\..*", "they are of a drawing by the processor, or of one by a card"),
    (r"system-alone:.*", "sound and picture are compared only where the machine was not too busy"),
    (r"shows:Trial\..*|shows:SupportTest\.ThatDoesNotFitLeavesTheStickAsItWas|boot:BootProgram\..*|usb-policy:UsbProgram\.HasNoRights.*",
     "a container may give nobody the right to mount, to be another user or to watch a program"),
    (r"drivers-scanout:ScreenHotplugMonitor\.NeverWaits", "a container may have no netlink of udev"),
)


def skipped(results):
    """The names of tests that did not run, in the order of the file, without what GoogleTest adds of their parameter."""
    for case in xml.parse(results).getroot().iter("testcase"):
        if case.find("skipped") is not None and case.get("status") != "disabled":
            yield case.get("name").split("  # ")[0]


def offences(results, allowed=ALLOWED):
    for name in skipped(results):
        if not any(re.fullmatch(pattern, name) for pattern, _ in allowed):
            yield f"{name}: was skipped, and tests/skips.py has no reason for it"


def main():
    found = list(offences(sys.argv[1]))
    print("\n".join(found) or "no test was skipped without a reason")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
