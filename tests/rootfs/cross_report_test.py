#!/usr/bin/env -S python3 -B
"""The report on builds for other processors: what nobody measured is null and never 0, and a failure is one."""

import tempfile
from pathlib import Path

import cross_report

CASES = """<testsuites><testsuite>
<testcase name="face: The face is on the screen"><system-out/></testcase>
<testcase name="uefi: The disk starts"><failure message="no still"/></testcase>
<testcase name="gadget: The same devices"><skipped message="no kernel"/></testcase>
</testsuite></testsuites>"""


def main():
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder)
        assert set(cross_report.of_the_bench(out).values()) == {None}, "nothing ran"
        assert cross_report.of_tests(out / "tests.xml") == {"tests_arm64": None, "tests_arm64_failed": None}
        (out / "bench-arm64").mkdir()
        (out / "bench-arm64/report.xml").write_text(CASES)
        (out / "boot-arm64.json").write_text('{"first_frames_s": 21.5}')
        (out / "tests.xml").write_text('<testsuite tests="12" failures="0"/>')
        found = cross_report.of_the_bench(out)
        assert (found["face_arm64"], found["boots_arm64"], found["first_face_arm64_s"]) == (1, 0, 21.5), found
        assert (found["checks_arm64"], found["checks_arm64_failed"]) == (1, 1), "a skipped check is neither"
        assert cross_report.of_boards(out) == {"image_no_llvm_mb": None, "image_no_llvm_parts_mb": None}
        (out / "image-rpi4.json").write_text('{"image_no_llvm_mb": 33.1, "compressed_parts_mb": {"show": 11.2}}')
        assert cross_report.of_boards(out) == {"image_no_llvm_mb": 33.1, "image_no_llvm_parts_mb": {"show": 11.2}}
        assert cross_report.of_tests(out / "tests.xml") == {"tests_arm64": 12, "tests_arm64_failed": 0}


if __name__ == "__main__":
    main()
