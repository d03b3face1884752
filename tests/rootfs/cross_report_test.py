#!/usr/bin/env -S python3 -B
"""The report on builds for other processors: what nobody measured is null and never 0, a failure is one, and all programs of the
tree count."""

import re
import tempfile
from pathlib import Path

import cross_report

CASES = """<testsuites><testsuite>
<testcase name="face: The face is on the screen"><system-out/></testcase>
<testcase name="uefi: The disk starts"><failure message="no still"/></testcase>
<testcase name="gadget: The same devices"><skipped message="no kernel"/></testcase>
</testsuite></testsuites>"""


ROOT = Path(__file__).resolve().parents[2]
GOOD = {"programs_arm64": 25, "programs_all": 25, "tests_arm64": 900, "tests_arm64_failed": 0, "sdk_cases": 12, "sdk_cases_failed": 0,
        "recipe_errors": 0, "boots_arm64": 1, "face_arm64": 1, "first_face_arm64_s": 31.2, "dial_edges_arm64": 19, "checks_arm64": 17, "checks_arm64_failed": 0,
        "image_no_llvm_mb": 20}


def faults(is_whole=True, **changed):
    figures = GOOD | changed
    bounds = cross_report.bounds_of(figures)
    return list(cross_report.bounded_report.faults(figures, bounds, cross_report.RUNS, is_whole))


def bounds_hold():
    assert faults() == [], faults()
    for wrong in ({"programs_arm64": 24}, {"tests_arm64_failed": 1}, {"sdk_cases_failed": 1}, {"recipe_errors": 1}, {"boots_arm64": 0},
                  {"face_arm64": 0}, {"checks_arm64_failed": 1}, {"tests_arm64": None}):
        assert len(faults(is_whole=False, **wrong)) == 1, wrong
    unseen = {"boots_arm64": None, "image_no_llvm_mb": None}
    assert faults(is_whole=False, **unseen) == [], "other runs measure them"
    assert faults(**unseen) == ["boots_arm64 was not measured; ./box test --bench --arch arm64 does",
                                "image_no_llvm_mb was not measured; ./box image --arch arm64 --board rpi4 --board-firmware FOLDER does"]
    assert cross_report.RUNS["image_no_llvm_mb"] in (ROOT / "docs/boards.md").read_text(), "a command that is not refused"
    large = {"image_no_llvm_mb": 35.2}
    assert faults(**large) == [], "a goal is no bound"
    assert list(cross_report.bounded_report.short_of_goals(large, cross_report.GOALS)) == [
        "image_no_llvm_mb is 35.2: its goal of 20 is not reached"]


def all_programs_count():
    names = cross_report.programs(ROOT)
    assert {"kaori-stage", "kaori-bundle", "kaori-benchmark", "kaori-hil-agent", "kaori-input-latency", "kaori-packer"} <= set(names), names
    assert not [name for name in names if not name.startswith("kaori-")], names


def only_what_cannot_run_is_left_out():
    left_out = re.search(r"NOT_EMULATED='(.+)'", (ROOT / "rootfs/toolchains/cross.sh").read_text())[1]
    contract = "contracts:HidChannels/HidChannelContract.SendsWhatItWasGiven/"
    for name, is_run in ((f"{contract}Libusb  # GetParam() = 40-byte object", False), (f"{contract}Hidraw  # GetParam()", True), (f"{contract}Local", True),
                         ("contracts:Loaders/BootChoiceContract.StartsTheOther/Tryboot", True), ("drivers-mock:Hidraw.IsFound", False),
                         ("drivers:Gpio.Line", True), ("golden: every scene", False), ("rules: every file has its shape", False)):
        assert bool(re.search(left_out, name)) != is_run, name


def main():
    bounds_hold()
    all_programs_count()
    only_what_cannot_run_is_left_out()
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder)
        assert set(cross_report.of_the_bench(out).values()) == {None}, "nothing ran"
        assert cross_report.of_tests(out / "tests.xml") == {"tests_arm64": None, "tests_arm64_failed": None}
        (out / "bench-arm64").mkdir()
        (out / "bench-arm64/report.xml").write_text(CASES)
        (out / "boot-arm64.json").write_text('{"first_frames_s": 21.5, "pl061_edges": 19}')
        (out / "tests.xml").write_text('<testsuite tests="12" failures="0"/>')
        found = cross_report.of_the_bench(out)
        assert (found["face_arm64"], found["boots_arm64"], found["first_face_arm64_s"], found["dial_edges_arm64"]) == (1, 0, 21.5, 19), found
        assert (found["checks_arm64"], found["checks_arm64_failed"]) == (1, 1), "a skipped check is neither"
        assert cross_report.of_boards(out) == {"image_no_llvm_mb": None, "image_no_llvm_parts_mb": None}
        (out / "image-rpi4.json").write_text('{"image_no_llvm_mb": 33.1, "compressed_parts_mb": {"show": 11.2}}')
        assert cross_report.of_boards(out) == {"image_no_llvm_mb": 33.1, "image_no_llvm_parts_mb": {"show": 11.2}}
        assert cross_report.of_tests(out / "tests.xml") == {"tests_arm64": 12, "tests_arm64_failed": 0}


if __name__ == "__main__":
    main()
