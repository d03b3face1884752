"""Licences of Debian's packages, from their copyright files, as SPDX expressions.

A file in Debian's machine-readable form names a licence for each group of the source's files: the package is declared under
all of them together. Names that SPDX does not have, and files in no such form, become references (LicenseRef-...) with the
text that stands there.
"""

import re
from typing import NamedTuple

MACHINE_READABLE = re.compile(r"(?i)^format: *\S*copyright-format/1")
# Debian's short names, in lower case -> SPDX's. Where only a version is said, as in GPL-2, it is that version alone.
SHORT = {
    "expat": "MIT", "mit": "MIT", "x11": "X11", "isc": "ISC", "zlib": "Zlib", "libpng": "Libpng", "ftl": "FTL",
    "apache-2": "Apache-2.0", "apache-2.0": "Apache-2.0", "apache-2-llvm-exceptions": "Apache-2.0 WITH LLVM-exception",
    "bsd-1-clause": "BSD-1-Clause", "bsd-2-clause": "BSD-2-Clause", "bsd-3-clause": "BSD-3-Clause",
    "bsd-4-clause": "BSD-4-Clause", "bsl-1.0": "BSL-1.0", "cc0": "CC0-1.0", "cc0-1.0": "CC0-1.0", "ms-pl": "MS-PL",
    "lpgl-2.1+": "LGPL-2.1-or-later",  # As the file of ALSA's library spells it.
    "mpl-1.1": "MPL-1.1", "ntp": "NTP", "fsfap": "FSFAP", "sleepycat": "Sleepycat", "beerware": "Beerware",
    "gpl-2 with linux-syscall-note exception": "GPL-2.0-only WITH Linux-syscall-note",
    "gpl-2+ with libtool exception": "GPL-2.0-or-later WITH Libtool-exception",
    "gpl-2.0+ with libtool exception": "GPL-2.0-or-later WITH Libtool-exception",
    "gpl-2+ with autoconf exception": "GPL-2.0-or-later WITH Autoconf-exception-generic",
    "gpl-2.0+ with autoconf exception": "GPL-2.0-or-later WITH Autoconf-exception-generic",
    "gpl-3+ with bison exception": "GPL-3.0-or-later WITH Bison-exception-2.2",
    "gpl-3.0+ with autoconf exception": "GPL-3.0-or-later WITH Autoconf-exception-generic-3.0",
}
GNU = re.compile(r"(l?gpl)-(1|2|2\.1|3)(?:\.0)?(\+?)")
GNU_NAMES = {"gpl": ("1", "2", "3"), "lgpl": ("2", "2.1", "3")}


class Licences(NamedTuple):
    """What a package is declared under, and the texts of its references."""

    expression: str
    texts: dict


def spdx_name(name):
    """SPDX's name of one licence, or None where it has none."""
    short = " ".join(name.lower().split())
    if short in SHORT:
        return SHORT[short]
    match = GNU.fullmatch(short)
    if not match or match[2] not in GNU_NAMES[match[1]]:
        return None
    version = match[2] if "." in match[2] else f"{match[2]}.0"
    return f"{match[1].upper()}-{version}-{'or-later' if match[3] else 'only'}"


def reference(source, name):
    return "LicenseRef-" + re.sub(r"[^A-Za-z0-9.]+", "-", f"{source}-{name}").strip("-")


def paragraphs(text):
    """(first line, text) of each License field of a file in the machine-readable form."""
    for match in re.finditer(r"(?mi)^license:[ \t]*(.*)\n((?:[ \t].*\n?)*)", text):
        yield match[1].strip(), re.sub(r"(?m)^[ \t](\.$)?", "", match[2]).strip()


def alternatives(name):
    """The licences in one field's first line, joined there by `or`, `and` or a comma: [[all of these], or all of these]."""
    name = re.sub(r"(?i)\s+with\s+", " with ", name)
    return [[one.strip() for one in re.split(r"(?i)\s*,\s+and\s+|\s+and\s+|\s*,\s*", choice) if one.strip()]
            for choice in re.split(r"(?i)\s*,?\s+or\s+", name)]


def of_field(source, name, texts, needed):
    """The expression of one field's first line; references that it needs are laid into `needed`."""
    choices = []
    for choice in alternatives(name):
        names = []
        for one in choice:
            spdx = spdx_name(one)
            if not spdx:
                spdx = reference(source, one)
                needed[spdx] = texts.get(one.lower()) or texts.get(name.lower()) or f"{one}: see the copyright file of {source}"
            names.append(spdx)
        choices.append(names[0] if len(names) == 1 else f"({' AND '.join(names)})")
    return choices[0] if len(choices) == 1 else f"({' OR '.join(choices)})"


def of_copyright(source, text):
    """What the copyright file of a package says, which was built of `source`."""
    fields = [(name, words) for name, words in paragraphs(text) if name] if MACHINE_READABLE.match(text) else []
    if not fields:
        whole = reference(source, "copyright")
        return Licences(whole, {whole: text.strip()})
    texts = {name.lower(): words for name, words in fields if words}
    needed = {}
    found = sorted({of_field(source, name, texts, needed) for name, _ in fields})
    return Licences(" AND ".join(found), dict(sorted(needed.items())))
