#!/usr/bin/env -S python3 -B
"""The box with the screens that it may find: screens.py IMAGE_FOLDER [CASE...]

No graphics card at all; a card whose screen comes later; a screen that says nothing of itself; one of an odd size; two of
which one shows the box's status; a neighbour that takes most of the machine's time; and what stands on the screen from
power on until the face plays.
Each case is a machine of its own. Pictures lie in IMAGE_FOLDER/screens, results go into boot.json beside the image.
"""

import re
import signal
import sys
import tempfile
import time
from pathlib import Path

from machine import FACE, Machine
from outputs import Viewer
from pictures import is_lit, marks
from proof import difference, with_settings, write_report

BOOT_S, LONGEST_S = 600, 180
PAUSE_S = 1.5
QUIET_S = 20        # For so long nothing may change for the worse.
AFTER_S = 10        # How long a screen is looked at after the first face.
SAME = 0.06         # As far as a face moves by itself.
FLAT = 2            # A picture of so few colours is one of none.
AMBER, GREEN = (235, 170, 50), (70, 190, 110)  # What is missing, and what is there, on the status picture.
LEFT_S, TAKEN_S, TURNS = 0.5, 1.5, 30  # A neighbour takes so much of each two seconds.
DRAWN = "the first picture is drawn"
ENDED = r"kaori-stage.service: Main process exited"


def card(words, heads=1):
    """A graphics card, and a viewer's door for each head."""
    doors = (word for head in range(heads)
             for word in ("-vnc", f"unix:{{folder}}/vnc{head},id=vnc{head},display=card,head={head}"))
    return ("-device", f"virtio-gpu-pci,id=card,max_outputs={heads},{words}", *doors)


class Case:
    """What is found wrong, and what is worth keeping."""

    def __init__(self, image, name):
        self.image, self.name, self.faults, self.figures = image, name, [], {}

    def expect(self, what, is_so):
        if not is_so:
            self.faults.append(what)

    def until(self, what, condition, longest_s=LONGEST_S):
        """Waits until it is so; the seconds it took."""
        began = time.monotonic()
        while time.monotonic() - began < longest_s:
            if condition():
                return time.monotonic() - began
            time.sleep(0.2)
        self.faults.append(what)
        return longest_s

    def start(self, box):
        self.until("the stage plays", lambda: box.wait_for(DRAWN, 1), BOOT_S)

    def plays(self, box, head=0):
        """A face stands there, and moves."""
        one = box.screen(head)[2]
        return is_lit(one) and self.until(f"the face moves on screen {head + 1}", lambda: box.screen(head)[2] != one) < LONGEST_S

    def keep(self, box, head=0, name=""):
        width, height, pixels = box.screen(head)
        folder = self.image / "screens"
        folder.mkdir(exist_ok=True)
        (folder / f"{self.name}{name}.ppm").write_bytes(b"P6\n%d %d\n255\n" % (width, height) + pixels)

    def end(self, box):
        folder = self.image / "screens"
        folder.mkdir(exist_ok=True)
        (folder / f"{self.name}.log").write_text(box.said())


def no_card(case, image):
    with Machine(image, screen=()) as box:
        case.start(box)
        case.expect("the log names the missing card", "there is no graphics card" in box.said())
        time.sleep(QUIET_S)
        case.expect("the stage plays on unseen", not re.search(ENDED, box.said()))
        case.end(box)


def late_screen(case, image):
    with Machine(image, screen=card("xres=320,yres=240")) as box:
        viewer = Viewer(box.path("vnc0"))
        viewer.resize(320, 240)  # QEMU takes no heed of a viewer that was never of any size.
        time.sleep(PAUSE_S)
        viewer.resize(0, 0)
        case.start(box)
        case.expect("the stage finds no screen", "a screen is plugged in" not in box.said())
        viewer.resize(320, 240)
        case.until("the face comes with its screen", lambda: box.screen()[:2] == (320, 240) and is_lit(box.screen()[2]))
        case.expect("the face plays", case.plays(box))
        case.expect("the stage did not start anew", not re.search(ENDED, box.said()))
        case.end(box)


def silent_screen(case, image):
    with Machine(image, screen=card("edid=off,xres=320,yres=240")) as box:
        case.start(box)
        case.until("the face comes", lambda: is_lit(box.screen()[2]))
        case.expect("the face plays", case.plays(box))
        case.keep(box)
        case.end(box)


def odd_screen(case, image):
    with Machine(image, screen=card("xres=72,yres=900")) as box:
        case.start(box)
        case.until("the face comes", lambda: is_lit(box.screen()[2]))
        case.expect("the face plays", case.plays(box))
        case.keep(box)
        case.end(box)


def status_screen(case, image):
    with tempfile.TemporaryDirectory(dir=image) as folder:
        disk = with_settings(image, folder, 'profile = "bench"\nstatus_screen = "Virtual-2"\n')
        keyboard = ("-device", "usb-kbd,id=keys")
        with Machine(image, disk, screen=card("xres=320,yres=240", heads=2) + keyboard) as box:
            viewers = [Viewer(box.path(f"vnc{head}")) for head in range(2)]
            viewers[0].resize(320, 240)
            viewers[1].resize(640, 480)
            case.start(box)
            case.until("the face comes", lambda: is_lit(box.screen()[2]))
            case.until("the status names what is missing", lambda: marks(box.screen(1), AMBER) >= 6)
            case.until("it says that there are a show, two screens and a keyboard", lambda: marks(box.screen(1), GREEN) >= 4)
            time.sleep(AFTER_S)
            face, green, amber = box.screen()[2], marks(box.screen(1), GREEN), marks(box.screen(1), AMBER)
            case.keep(box, 1, "-before")
            box.ask("device_del", id="keys")
            gone_s = case.until("it says that the keyboard is gone",
                                lambda: marks(box.screen(1), GREEN) < green and marks(box.screen(1), AMBER) > amber)
            case.figures["status_says_s"] = round(gone_s, 1)
            case.expect("the show's screen says nothing", difference(face, box.screen()[2]) < SAME)
            case.expect("the face plays on", case.plays(box))
            case.keep(box, 1, "-after")
            case.keep(box, 0, "-show")
            case.end(box)


def busy_machine(case, image):
    """Its time is taken away, not its clock: frames are slow, and no hang."""
    with Machine(image, screen=("-device", "virtio-gpu-pci,id=card,xres=320,yres=240")) as box:
        case.start(box)
        case.until("the face comes", lambda: is_lit(box.screen()[2]))
        for _ in range(TURNS):
            box.process.send_signal(signal.SIGSTOP)
            time.sleep(TAKEN_S)
            box.process.send_signal(signal.SIGCONT)
            time.sleep(LEFT_S)
        case.expect("the face plays on", case.plays(box))
        case.expect("nothing is taken for a hang", not re.search(r"Watchdog timeout|" + ENDED, box.said()))
        case.end(box)


def is_one_of(pixels, pictures):
    return any(difference(pixels, picture) < SAME for picture in pictures)


def handover(case, image):
    """Before the first light the screen is dark, or shows what QEMU writes on one that nobody has lit; then the still;
    then the face, which differs little from it. Nothing else, ever."""
    with Machine(image, screen=("-device", "virtio-gpu-pci,id=card,xres=480,yres=270")) as box:
        looks, ends = [], None
        while ends is None or time.monotonic() < ends:
            looks.append(box.screen()[2])
            if ends is None and re.search(FACE, box.said()):
                ends = time.monotonic() + AFTER_S
            if len(looks) > 100000:
                break
        case.end(box)
    light = next((n for n, pixels in enumerate(looks) if is_picture(pixels)), None)
    case.expect("light comes", light is not None)
    if light is None:
        return
    last = looks[-1]
    wrong = sum(not is_one_of(pixels, (looks[light], last)) for pixels in looks[light:])
    early = sum(not is_dark(pixels, looks[0]) for pixels in looks[:light])
    case.figures = {"handover_pictures": len(looks), "handover_wrong": wrong + early}
    case.expect(f"after the first light only still and face ({wrong} of {len(looks) - light} others)", wrong == 0)
    case.expect(f"before it nothing ({early} of {light} others)", early == 0)
    case.expect("a black picture would be found", difference(last, bytes(len(last))) > SAME)


def is_picture(pixels):
    return len({pixels[at:at + 3] for at in range(0, len(pixels), 3 * 17)}) > 64


def is_dark(pixels, unlit):
    """Of one colour, or QEMU's own message for a screen that nobody has lit."""
    return pixels == unlit or len({pixels[at:at + 3] for at in range(0, len(pixels), 3 * 17)}) <= FLAT


CASES = {case.__name__: case for case in (no_card, late_screen, silent_screen, odd_screen, status_screen, busy_machine,
                                           handover)}


def main():
    image, names = Path(sys.argv[1]), sys.argv[2:] or list(CASES)
    failed, figures = [], {}
    for name in names:
        case = Case(image, name)
        CASES[name](case, image)
        print(f"{'FAIL' if case.faults else 'ok  '}  {name}" + "".join(f"\n      not so: {fault}" for fault in case.faults), flush=True)
        failed += [name] if case.faults else []
        figures.update(case.figures)
    write_report(image, screen_cases=len(names), screen_faults=failed, **figures)
    sys.exit(bool(failed))


if __name__ == "__main__":
    main()
