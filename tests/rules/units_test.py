#!/usr/bin/env python3
"""What the box's units say to systemd: units_test.py REPOSITORY"""

import re
import sys
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop(1))
ROOTFS = ROOT / "rootfs"
UNITS = ROOTFS / "overlay/usr/lib/systemd/system"
# Longer ones are no bound that anybody would wait for: of a program that runs, and of work that is done once.
MOST_SILENT_S, MOST_WORK_S = 120, 3600
SPANS = {"": 1, "s": 1, "sec": 1, "min": 60, "h": 3600, "ms": 0.001}


def starts_again_at_once(unit):
    """Whether the text of a unit says so; systemd's own pause is 100 ms where it says nothing (systemd.service(5))."""
    return re.search(r"^RestartSec=0+(\.0*)?(us|ms|s|sec|min)?\s*$", unit, re.M) is not None


def value(unit, name):
    """The last value of this name in the text of a unit, as systemd takes it; None where there is none."""
    found = re.findall(rf"^{name}=(.*)$", unit, re.M)
    return found[-1].strip() if found else None


def seconds(span):
    """A time span of systemd.time(7) as our units write them; None where it is no bound, as `infinity` and 0 are none."""
    match = re.fullmatch(r"(\d+(?:\.\d+)?)\s*([a-z]*)", span or "")
    return (float(match[1]) * SPANS[match[2]] or None) if match and match[2] in SPANS else None


def folder_of(unit):
    """Where the sources of a unit's program lie: kaori-NAME is appliance/programs/NAME."""
    program = re.search(r"^ExecStart=[-+]?/usr/bin/kaori-(\w+)", unit, re.M)
    return ROOT / "appliance/programs" / program[1] if program else None


def beats(folder):
    """Whether some source there feeds the watchdog of the service manager."""
    return folder is not None and any("FeedWatchdog" in source.read_text() for source in folder.rglob("*.cpp"))


def unwatched(name, unit, comes_back=()):
    """What keeps a hang of this unit from being noticed and ended; empty: nothing. `comes_back`: units that start it by themselves."""
    if name.endswith(".mount"):
        return [] if seconds(value(unit, "TimeoutSec")) else [f"{name}: TimeoutSec= is no bound"]
    if value(unit, "Type") == "oneshot":
        bound = seconds(value(unit, "TimeoutStartSec"))
        return [] if bound and bound <= MOST_WORK_S else [f"{name}: TimeoutStartSec= is no bound"]
    faults = []
    silent = seconds(value(unit, "WatchdogSec"))
    if not silent or not 1 <= silent <= MOST_SILENT_S:
        faults.append(f"{name}: WatchdogSec= is no bound")
    if value(unit, "NotifyAccess") != "main":
        faults.append(f"{name}: NotifyAccess= is not main")
    if value(unit, "Type") == "notify" and not seconds(value(unit, "TimeoutStartSec")):
        faults.append(f"{name}: TimeoutStartSec= is no bound")
    if not beats(folder_of(unit)):
        faults.append(f"{name}: its program never beats, and would be ended again and again")
    if value(unit, "Restart") not in ("always", "on-failure", "on-watchdog") and not comes_back:
        faults.append(f"{name}: nobody starts it again")
    return faults


def starters(name):
    """The socket that starts a unit at each call."""
    return [file.name for file in UNITS.glob("*.socket") if file.stem == Path(name).stem]


class Hangs(unittest.TestCase):
    """A program of the box that hangs is ended and comes back, whichever it is."""

    def test_every_unit_is_watched_or_has_a_time_in_which_it_is_done(self):
        units = sorted([*UNITS.glob("*.service"), *UNITS.glob("*.mount")])
        self.assertGreater(len(units), 15)
        for unit in units:
            self.assertEqual(unwatched(unit.name, unit.read_text(), starters(unit.name)), [])

    def test_no_dropin_changes_what_the_units_say(self):
        for file in UNITS.glob("*.d/*.conf"):
            self.assertNotRegex(file.read_text(), r"(?m)^(WatchdogSec|WatchdogSignal|Timeout\w*Sec|NotifyAccess|Restart)=")

    def test_whatever_is_missing_is_named(self):
        good = "[Service]\nExecStart=/usr/bin/kaori-power\nRestart=always\nWatchdogSec=20\nNotifyAccess=main\n"
        self.assertEqual(unwatched("a.service", good), [])
        for old, new in (("WatchdogSec=20", ""), ("WatchdogSec=20", "WatchdogSec=0"), ("WatchdogSec=20", "WatchdogSec=infinity"),
                         ("WatchdogSec=20", "WatchdogSec=10min"), ("NotifyAccess=main", ""), ("Restart=always", ""),
                         ("Restart=always", "Restart=no"), ("kaori-power", "kaori-status"), ("/usr/bin/kaori-power", "/bin/true"),
                         ("[Service]", "[Service]\nType=notify"), ("[Service]", "[Service]\nType=oneshot"),
                         ("[Service]", "[Service]\nType=oneshot\nTimeoutStartSec=infinity")):
            self.assertNotEqual(unwatched("a.service", good.replace(old, new)), [], (old, new))
        self.assertEqual(unwatched("a.service", good.replace("Restart=always", ""), ["a.socket"]), [])
        self.assertEqual(unwatched("a.service", "[Service]\nType=oneshot\nTimeoutStartSec=2min\n"), [])
        self.assertNotEqual(unwatched("a.mount", "[Mount]\n"), [])

    def test_hands_and_lips_and_the_face_are_ended_at_once(self):
        for name in ("stage", "input", "lips"):
            unit = (UNITS / f"kaori-{name}.service").read_text()
            self.assertEqual(value(unit, "WatchdogSignal"), "SIGKILL", name)
            self.assertEqual(value(unit, "Restart"), "always", name)
            self.assertLessEqual(seconds(value(unit, "RestartSec")), 0.02, name)

    def test_a_stage_that_hangs_in_its_start_is_not_asked_to_end_and_has_a_minute_at_most(self):
        unit = (UNITS / "kaori-stage.service").read_text()
        self.assertEqual(value(unit, "TimeoutStartFailureMode"), "kill")
        self.assertLessEqual(seconds(value(unit, "TimeoutStartSec")), 60)


class Restarts(unittest.TestCase):
    """Without a pause the next start of a program that fails at each start is queued before systemd starts anything that is
    ordered after it: a stage that could read no show once kept udev and the try of the other system from starting at all."""

    def test_no_unit_starts_again_without_a_pause(self):
        units = sorted(UNITS.glob("*.service"))
        self.assertGreater(len(units), 10)
        self.assertEqual([unit.name for unit in units if starts_again_at_once(unit.read_text())], [])

    def test_a_unit_without_a_pause_is_seen(self):
        for pause in ("0", "0s", "0ms", "0.0"):
            self.assertTrue(starts_again_at_once(f"[Service]\nRestart=always\nRestartSec={pause}\n"))
        for pause in ("20ms", "0.5", "10"):
            self.assertFalse(starts_again_at_once(f"[Service]\nRestart=always\nRestartSec={pause}\n"))


class Programs(unittest.TestCase):
    """What units and udev's rules start is in the image: a rule whose program is missing keeps every device out."""

    @staticmethod
    def started():
        texts = [file.read_text() for file in (ROOTFS / "overlay").rglob("*") if file.is_file() and file.suffix in (".service", ".rules")]
        return {name for text in texts for name in re.findall(r"/usr/bin/kaori-([a-z]+)", text)}

    def test_all_that_are_started_are_in_the_image(self):
        there = re.search(r"^readonly ON_BOX=.*kaori-\{([a-z,]+)\}", (ROOTFS / "image/build").read_text(), re.M)[1].split(",")
        self.assertGreater(len(self.started()), 10)
        self.assertEqual(self.started() - set(there), set())


class Waiting(unittest.TestCase):
    """systemd starts what is ordered after a unit when that has started, or its job is given up, and no sooner."""

    def test_nobody_waits_long_for_a_stage_that_hangs_in_its_start(self):
        waits = [unit.name for unit in UNITS.glob("*.service") if re.search(r"^After=.*kaori-stage", unit.read_text(), re.M)]
        self.assertIn("kaori-input.service", waits)
        given_up = re.search(r"^JobRunningTimeoutSec=(\d+)s$", (UNITS / "kaori-stage.service").read_text(), re.M)
        self.assertIsNotNone(given_up)
        self.assertLessEqual(int(given_up[1]), 30)

    def test_whether_a_face_comes_is_looked_at_once_after_each_start(self):
        timer, unit = ((UNITS / f"kaori-other.{kind}").read_text() for kind in ("timer", "service"))
        self.assertEqual(seconds(value(timer, "OnActiveSec")), 180)
        self.assertTrue((UNITS / "kaori.target.wants/kaori-other.timer").exists())
        self.assertEqual(value(unit, "ExecCondition"), value(unit, "ExecStart").replace("-/usr/bin/kaori-update", "/usr/bin/kaori-update --look"))

    def test_a_trial_without_a_verdict_ends_by_nothing_of_the_version_that_is_tried(self):
        timer, unit, confirm = ((UNITS / name).read_text() for name in ("kaori-trial.timer", "kaori-trial.service", "kaori-confirm.service"))
        self.assertTrue((UNITS / "kaori.target.wants/kaori-trial.timer").exists())
        self.assertEqual(value(unit, "ExecStart"), "/bin/systemctl reboot --force")
        self.assertEqual(value(timer, "ConditionPathExists"), "/run/kaori-profile/trial")
        self.assertIn("ConditionPathExists=!/run/kaori-update/settled", unit)
        self.assertIn('Mark(places, "settled")', (ROOT / "appliance/programs/update/confirm.cpp").read_text())
        # A look takes three minutes, and what it does before and after them.
        self.assertGreaterEqual(seconds(value(timer, "OnActiveSec")), 6 * 60)
        self.assertEqual(value(confirm, "RuntimeDirectory"), "kaori-update")

    def test_a_version_that_is_tried_keeps_no_last_face_by_which_it_would_be_judged(self):
        trial = (UNITS / "kaori-trial.service").read_text()
        on_trial, settled = re.findall(r"^ConditionPathExists=!?(.+)$", trial, re.M)
        stage = value((UNITS / "kaori-stage.service").read_text(), "ExecStart")
        self.assertIn(f" --trial {on_trial} --settled {settled} ", stage)

    def test_what_is_kept_lies_beside_the_root_whatever_a_stick_calls_its_own(self):
        link = value((UNITS / "var-lib-kaori.mount").read_text(), "What")
        rules = (ROOTFS / "overlay/usr/lib/udev/rules.d/70-kaori.rules").read_text()
        made = re.search(r'^SUBSYSTEM=="block", TEST=="/run/kaori-profile/data-%k", SYMLINK\+="(.+)"$', rules, re.M)
        self.assertEqual(link, "/dev/" + made[1])
        self.assertIn('WriteSetting("data-" + data.name', (ROOT / "appliance/programs/boot/main.cpp").read_text())

    def test_a_path_unit_does_not_start_what_fails_without_end(self):
        for path in UNITS.glob("*.path"):
            text = (UNITS / f"{path.stem}.service").read_text()
            ends = "RemainAfterExit=yes" in text and "ExecStart=-" in text and not re.search(r"^(Requires|BindsTo|RequiresMountsFor)=", text, re.M)
            restarts = re.search(r"^Restart=", text, re.M) is not None
            self.assertTrue(ends or restarts, f"{path.name} starts {path.stem}.service again as long as its file is there")


if __name__ == "__main__":
    unittest.main()
