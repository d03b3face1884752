"""A report that is one figure for each of some names, and whether each lies within its bounds."""

import json
import sys


def faults(found, bounds):
    """A line for each figure that is missing or out of its bounds, which are {name: (least, most)}."""
    for name, (least, most) in bounds.items():
        value = found.get(name)
        if value is None:
            yield f"{name} was not measured"
        elif not least <= value <= most:
            yield f"{name} is {value:g}, and {least:g} to {most:g} is wanted"


def read(file):
    """The figures of a JSON file; none where there is no such file."""
    return json.loads(file.read_text()) if file.is_file() else {}


def write(program, found, bounds, file):
    """Writes the figures, says them, and gives the exit status: 1 where one is missing or out of its bounds."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(found, indent=2) + "\n")
    print("\n".join(f"{name:26} {value}" for name, value in found.items()))
    wrong = list(faults(found, bounds))
    for line in wrong:
        print(f"{program}: {line}", file=sys.stderr)
    return 1 if wrong else 0
