"""Who writes and who reads each section of the board, as the code does it and as the comments of the sections say.

A program reads what its folder reads with Read<T>, and what it calls of others: functions of core/board that read, snapshots, and the
status (status::Look). Of a snapshot the stage uses everything, others the fields that they name. Programs have no "kaori-" here; DEMO is
the page of the demo (hw-sim/monitor).
"""

import re

BOARD = "appliance/core/board"
PROGRAMS = "appliance/programs"
DEMO, DEMO_ROOM, DEMO_WORDS = "demo", "hw-sim/monitor", "in the demo its page"
READ = re.compile(r"\bRead<(?:kaori::)?(?:board::)?([A-Z]\w+)>")
ACQUIRE = re.compile(r"\bAcquireWriter<(?:kaori::)?(?:board::)?([A-Z]\w+)>")
PROGRAM = re.compile(r"kaori_(?:installed_)?program\(\s*kaori-([\w-]+)")
# A function at the edge of a line, with its body.
FUNCTION = re.compile(r"^[\w:<>() ]* (\w+)\([^\n]*\) \{\n(.*?)^\}", re.MULTILINE | re.DOTALL)
FIELD_NAMES = {"sticks": "stick"}


def text_of(room):
    return "\n".join(file.read_text(encoding="utf-8") for file in sorted(room.rglob("*")) if file.suffix in (".h", ".cpp"))


def sections(root):
    """Struct -> its section's name and the comment above it."""
    found = {}
    for file in sorted((root / BOARD).glob("*.h")):
        for comment, struct, name in re.findall(r'((?:^//.*\n)+)struct (\w+) \{\n  static constexpr const char\* kName = "(\w+)"',
                                                file.read_text(encoding="utf-8"), re.MULTILINE):
            found[struct] = (name, comment)
    return found


def helpers(root):
    """Function of core/board -> the structs that it reads; SnapshotReader is that of all fields."""
    found = {name: set(READ.findall(body)) for name, body in FUNCTION.findall(text_of(root / BOARD))}
    found = {name: structs for name, structs in found.items() if structs and name != "Acquire"}  # A caller's own section.
    return found | {"SnapshotReader": found.get("ReadAll", set())}


def snapshot_fields(text, names):
    """Sections of a snapshot that a folder names: board.lips, state.board.line_check, b.sticks[0]."""
    fields = {FIELD_NAMES.get(field, field) for field in re.findall(r"\b(?:b|board)\.(\w+)\b(?!\()", text)}
    return fields & set(names.values())


def users(root):
    """Section -> (its writers, its readers), as sets of programs."""
    names = {struct: name for struct, (name, _) in sections(root).items()}
    of_board = helpers(root)

    def read_in(text):
        read = {names[struct] for struct in READ.findall(text) if struct in names}
        for name, structs in of_board.items():
            if name == "ReadAll":
                read |= snapshot_fields(text, names) if re.search(r"\bReadAll\((?:\*|\w+::)*board", text) else set()
            elif re.search(rf"\b{name}\b", text):
                read |= {names[struct] for struct in structs}
        return read

    status = read_in(text_of(root / PROGRAMS / "status"))
    rooms = {PROGRAM.search(file.read_text(encoding="utf-8")): file.parent for file in sorted((root / PROGRAMS).glob("*/CMakeLists.txt"))}
    rooms = {match[1]: room for match, room in rooms.items() if match} | {DEMO: root / DEMO_ROOM}
    found = {name: (set(), set()) for name in names.values()}
    for program, room in rooms.items():
        text = text_of(room)
        written = {names[struct] for struct in ACQUIRE.findall(text)}
        read = read_in(text) | (status if "status::Look(" in text else set())
        if "Caller::Acquire(" in text and "CallWriter::" in text:
            written.add(names["Calls"])
            read.add(names["Calls"])  # A caller goes on where the last one ended.
        for name in written:
            found[name][0].add(program)
        for name in read:
            found[name][1].add(program)
    return found


def said_of(comment, key):
    """What a section's comment says behind "writer" or "readers", in one line."""
    match = re.search(rf"^//   {key} +(.*(?:\n//      +.*)*)", comment, re.MULTILINE)
    return " ".join(line.lstrip("/ ") for line in match[1].split("\n")) if match else ""


def named(text, programs, prefix="(?:kaori-)?"):
    """The programs that a text names, and the demo's page."""
    found = {program for program in programs if re.search(rf"(?<![\w-]){prefix}{re.escape(program)}(?![\w-])", text)}
    return found | ({DEMO} if DEMO_WORDS in text else set())


def commented(root, programs):
    """Section -> (writers, readers) as its comment names them, and what it says of how often it is written."""
    found = {}
    for name, comment in sections(root).values():
        writer, readers = said_of(comment, "writer"), said_of(comment, "readers")
        found[name] = (named(writer, programs, "kaori-"), named(readers, programs, "kaori-"), writer)
    return found
