"""A report that is one figure for each of some names, and whether each lies within its bounds."""

import json
import sys


def is_outside(value, least, most):
    return value is not None and not least <= value <= most


def misses(found, names, runs):
    """A line for each of these figures that nobody measured, with the run that does, of {name: run}."""
    for name in names:
        if found.get(name) is None:
            yield f"{name} was not measured" + (f"; {runs[name]} does" if name in runs else "")


def faults(found, bounds, runs=None, is_whole=True):
    """A line for each figure that is out of its bounds, which are {name: (least, most)}, or missing. In a run that is not
    whole those are not missing that another one measures, which `runs` names."""
    runs = runs or {}
    yield from misses(found, (name for name in bounds if is_whole or name not in runs), runs)
    for name, (least, most) in bounds.items():
        if is_outside(found.get(name), least, most):
            yield f"{name} is {found[name]:g}, and {least:g} to {most:g} is wanted"


def short_of_goals(found, goals):
    """A line for each figure that is above its goal, of {name: most}: it is said, and is no fault."""
    for name, most in goals.items():
        if is_outside(found.get(name), -float("inf"), most):
            yield f"{name} is {found[name]:g}: its goal of {most:g} is not reached"


def read(file):
    """The figures of a JSON file; none where there is no such file."""
    return json.loads(file.read_text()) if file.is_file() else {}


def write(program, found, bounds, file, *, runs=None, goals=None, is_whole=True):
    """Writes the figures, says them, and gives the exit status: 1 where one is missing or out of its bounds, as faults() says.
    What is missing without a fault, and what is above its goal, is said too."""
    file.parent.mkdir(parents=True, exist_ok=True)
    file.write_text(json.dumps(found, indent=2) + "\n")
    print("\n".join(f"{name:26} {value}" for name, value in found.items()))
    wrong = list(faults(found, bounds, runs, is_whole))
    elsewhere = [] if is_whole else [name for name in bounds if name in (runs or {})]
    for line in [*misses(found, elsewhere, runs or {}), *short_of_goals(found, goals or {}), *wrong]:
        print(f"{program}: {line}", file=sys.stderr)
    return 1 if wrong else 0
