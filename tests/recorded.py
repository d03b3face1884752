"""What tests of GoogleTest record of what they measure (RecordProperty), for the reports that are made of it."""

import json
import subprocess
import sys
import tempfile
from pathlib import Path


def cases(program, tests):
    """(the tests of a program that match the filter, each as a dictionary with what it recorded as texts; whether all of them
    passed). What they said goes to standard error where one did not."""
    with tempfile.TemporaryDirectory() as folder:
        said = Path(folder) / "said.json"
        done = subprocess.run([program, f"--gtest_filter={tests}", f"--gtest_output=json:{said}"],
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        if done.returncode != 0:
            print(done.stdout, file=sys.stderr)
        found = [case for suite in json.loads(said.read_text())["testsuites"] for case in suite["testsuite"]]
    return found, done.returncode == 0
