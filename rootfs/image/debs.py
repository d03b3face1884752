"""Debian's packages as keep_control wrote them down: names, versions, sources, and whose each file is."""

import re
import subprocess
from pathlib import Path
from typing import NamedTuple

MERGED = ("bin", "sbin", "lib", "lib64")  # Folders of the root that are names of folders in usr.
DATABASE = "var/lib/dpkg"


class Package(NamedTuple):
    """One binary package; `source` and `source_version` name what it was built from."""

    name: str
    version: str
    architecture: str
    source: str
    source_version: str


def merged(path):
    """The path of a package's file in a root whose programs all lie in usr."""
    return f"usr/{path}" if path.split("/", 1)[0] in MERGED else path


def of_fields(fields):
    """A package of its control data, {field: value}. Source stands there only where name or version differ."""
    source, _, version = fields.get("Source", fields["Package"]).partition(" ")
    return Package(fields["Package"], fields["Version"], fields["Architecture"], source,
                   version.strip("()") or fields["Version"])


def stanzas(text):
    """{field: value} of each package in a text in the form of dpkg's `status`; of a field of many lines, the first."""
    for stanza in text.split("\n\n"):
        fields = dict(re.findall(r"(?m)^([A-Za-z-]+): *(.*)$", stanza))
        if "Package" in fields:
            yield fields


def unpacked(folder):
    """Name -> package, of all that was unpacked into a folder; none where nobody wrote them down."""
    status = Path(folder) / DATABASE / "status"
    if not status.is_file():
        return {}
    return {fields["Package"]: of_fields(fields) for fields in stanzas(status.read_text())}


def owners(folder, names):
    """Path in the box -> name of the package that brought it."""
    found = {}
    for name in names:
        for path in (Path(folder) / DATABASE / "info" / f"{name}.list").read_text().splitlines():
            found[merged(path)] = name
    return found


SHOWN = "".join(f"{field}: ${{{variable}}}\n" for field, variable in (
    ("Package", "Package"), ("Version", "Version"), ("Architecture", "Architecture"), ("Status", "db:Status-Status"))) + \
    "Source: ${source:Package} (${source:Version})\n\n"


def installed(names):
    """Name -> package, of those of the names that are installed on this machine."""
    shown = subprocess.run(["dpkg-query", "-W", "-f", SHOWN, *names], capture_output=True, text=True, check=False).stdout
    return {fields["Package"]: of_fields(fields) for fields in stanzas(shown) if fields["Status"] == "installed"}


def is_newer(version, other):
    """Whether the first version is the newer one, by Debian's rules."""
    compared = ["dpkg", "--compare-versions", version, "gt", other]
    return version != other and subprocess.run(compared, check=False).returncode == 0
