#!/usr/bin/env python3
"""Runs clang-tidy, with the checks of .clang-tidy, over every source that a build compiles.

Usage: tidy.py ROOT BUILD [--analyze]     BUILD has been built. Prints each warning once, and exits 1 when there is one.
                                          --analyze adds the checks of the path-sensitive analyzer (clang-analyzer-*).

Most of the time goes to headers: to parsing them and to matching the checks against them. The sources of a part of the tree
(PARTS) are therefore read together, as one file that includes them all, so that this is done once for all of them. What was
found in each source is kept in BUILD/tidy; a source is read again when it, a header, its command, a check or this file changed.
"""

import concurrent.futures
import hashlib
import itertools
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import threading
import time

TIDY = "clang-tidy"
# The sources that are read together; the first that begins the path counts.
PARTS = ("appliance/authoring/", "appliance/", "drivers/", "hw-sim/", "render/", "tests/appliance/", "tests/", "")
# Sizes in tests are small numbers that stand there; that their products fit into an int is plain.
NOT_IN_TESTS = re.compile(r"/tests/.*\[bugprone-(implicit-widening-of-multiplication-result|misplaced-widening-cast)\]$")
PROGRESS_S = 10
WARNING = re.compile(r"^(\S+?):\d+:\d+: (?:warning|(?P<error>(?:fatal )?error)): .*$", re.MULTILINE)
INCLUDE = re.compile(r'^#include [<"].*[">]', re.MULTILINE)
MAIN = re.compile(r"^int main\(", re.MULTILINE)
# A declaration at the edge of a line.
DECLARED = re.compile(
    r"(?:struct|class|union|enum class|enum) (?P<type>\w+)|(?P<alias>using (?:(?P<alias_name>\w+) =|[\w:]*::(?P<using>\w+);).*)"
    r"|(?!using|template|namespace)[\w:<][\w:*&<>\[\], ]*?[ *&](?P<name>\w+)(?P<parameters>\(.*)?(?:\{| =|;|\[|$)")
ALSO_DECLARED = re.compile(r", (k[A-Z]\w*) =")
FUZZ_ENTRY = "LLVMFuzzerTestOneInput"  # Each fuzz target defines it; they are one program each.


class Source:
    """One source file, and what the compiler is told for it."""

    def __init__(self, path, entry):
        self.path, self.object = path, re.search(r"-o (\S+)", entry["command"])[1]
        self.text = path.read_text(encoding="utf-8")
        self.macros, self.folders, self.machine = {}, [], []
        words = shlex.split(entry["command"])
        for word, after in zip(words, words[1:] + [""]):
            if word.startswith("-D"):
                name, _, value = word[2:].partition("=")
                self.macros[name] = value or "1"
            elif word == "-isystem":
                self.folders.append(f"-isystem{after}")
            elif word.startswith("-I"):
                self.folders.append(word)
            elif word.startswith("-m"):
                self.machine.append(word)

    def part(self, root):
        """The part of the tree that it belongs to. Sources with other instructions of the processor are apart."""
        path = str(self.path.relative_to(root))
        return next(part for part in PARTS if path.startswith(part)), *self.machine

    def is_program(self):
        return MAIN.search(self.text) and "namespace kaori" not in self.text

    def unnamed(self):
        """What it declares in unnamed namespaces: name -> ways in which that is said."""
        inside, found = [], {}
        for line in () if self.is_program() else self.text.splitlines():
            if match := re.match(r"namespace ?([\w:]*) ?\{$", line):
                inside.append(match[1])
            elif line.startswith("}  // namespace") and inside:
                inside.pop()
            elif inside and inside[-1] == "" and (match := DECLARED.match(line)):
                # An alias may be said again; functions may differ in the types of their parameters.
                types = re.sub(r"(?<=[ *&])\w+(?=[,)])", "", match["parameters"] or "")
                way = ("alias", match["alias"]) if match["alias"] else ("function", types) if types else ("one", None)
                name = match["type"] or match["alias_name"] or match["using"] or match["name"]
                for name in (name, *ALSO_DECLARED.findall(line)):
                    found.setdefault((*inside, name), set()).add(way)
        return found

    def included(self, number):
        """The lines by which a file includes this source among others."""
        lines = [f"#undef {name}\n#define {name} {value}" for name, value in self.macros.items()]
        include = f'#include "{self.path}"'
        if self.is_program():
            # What several programs define outside of all namespaces is kept apart; their headers are not.
            lines += [*INCLUDE.findall(self.text), f"namespace program_{number} {{", include, "}"]
        elif name := next((name for name in ("main", FUZZ_ENTRY) if re.search(rf"\bint {name}\(", self.text)), None):
            lines += [f"#define {name} {name}_{number}", include, f"#undef {name}"]
        else:
            lines.append(include)
        return "".join(f"{line}\n" for line in lines)


def sources(root, build):
    """Every source of the tree that the build compiles, alone or together with others, once."""
    found = {}
    for entry in json.loads((build / "compile_commands.json").read_text()):
        file = pathlib.Path(entry["file"])
        together = re.findall(r'^#include "(.*)"$', file.read_text(), re.MULTILINE) if "/Unity/unity_" in str(file) else [file]
        for path in map(pathlib.Path, together):
            if path.is_relative_to(root) and not path.is_relative_to(build):
                found.setdefault(path, Source(path, entry))
    return [found[path] for path in sorted(found)]


def are_apart(ways, others):
    """Whether a name can be declared in these ways, and by another source in others."""
    kinds = {kind for kind, _ in ways | others}
    return ways == others if kinds == {"alias"} else kinds == {"function"} and not ways & others


def readings(root, unread):
    """The sources, in lists that can be read together: those of a part, but for names that two of them declare for themselves."""
    lists, declared = {}, {}
    for source in unread:
        names = source.unnamed()
        for name in itertools.chain((source.part(root),), (("rest", number, *source.machine) for number in itertools.count())):
            before = declared.setdefault(name, {})
            if all(key not in before or are_apart(ways, before[key]) for key, ways in names.items()):
                break
        for key, ways in names.items():
            before.setdefault(key, set()).update(ways)
        lists.setdefault(name, []).append(source)
    return sorted(lists.values(), key=len, reverse=True)


def dependencies(build):
    """Object -> the files that it was made of, as ninja noted them."""
    listed = subprocess.run(["ninja", "-C", str(build), "-t", "deps"], capture_output=True, text=True, check=True).stdout
    found, now = {}, None
    for line in listed.splitlines():
        if line and not line.startswith(" "):
            now = found.setdefault(line.split(":")[0], set())
        elif line.strip():
            now.add(str(build / line.strip()))
    return found


class Checker:
    def __init__(self, root, build, analyze):
        self.root, self.build, self.folder = root, build, build / "tidy"
        self.folder.mkdir(exist_ok=True)
        self.options = [] if analyze else ["--checks=-clang-analyzer-*"]
        # Without the option it follows no path through a file that another includes, as all are here.
        self.arguments = ["-std=c++20", *(("-Xclang", "-analyzer-opt-analyze-headers") if analyze else ())]
        self.store = self.folder / ("analyzed.json" if analyze else "checked.json")
        self.known = json.loads(self.store.read_text()) if self.store.is_file() else {}
        self.deps, self.hashes, self.lock = dependencies(build), {}, threading.Lock()
        version = subprocess.run([TIDY, "--version"], capture_output=True, text=True, check=True).stdout
        self.common = version + (root / ".clang-tidy").read_text() + pathlib.Path(__file__).read_text(encoding="utf-8")

    def hash_of(self, path):
        if path not in self.hashes:
            file = pathlib.Path(path)
            self.hashes[path] = hashlib.sha256(file.read_bytes()).hexdigest() if file.is_file() else "none"
        return self.hashes[path]

    def headers(self, source):
        """What the source includes, perhaps with headers of sources that are compiled together with it."""
        return {path for path in self.deps.get(source.object, ()) if path.endswith(".h") and not path.startswith("/usr/")}

    def key(self, source):
        told = hashlib.sha256(f"{self.common}{source.macros}{source.folders}{source.machine}".encode())
        for path in sorted(self.headers(source) | {str(source.path)}):
            told.update(self.hash_of(path).encode())
        return told.hexdigest()

    def look_up(self, source):
        """What is known of a source, or None."""
        known = self.known.get(str(source.path))
        return known["found"] if known and known["key"] == self.key(source) else None

    def read(self, together):
        """Reads sources together, and keeps what was found in each. Returns all of it."""
        number = hashlib.sha256("".join(str(source.path) for source in together).encode()).hexdigest()[:12]
        file = self.folder / f"{number}.cpp"
        file.write_text("".join(source.included(count) for count, source in enumerate(together)))
        folders = list(dict.fromkeys(folder for source in together for folder in source.folders))
        done = subprocess.run([TIDY, "--quiet", *self.options, str(file), "--", *self.arguments, *folders, *together[0].machine],
                              capture_output=True, text=True, check=False, cwd=self.root)
        file.unlink()
        found = {match[0]: match for match in WARNING.finditer(done.stdout) if not NOT_IN_TESTS.search(match[0])}
        wrong = {match[1]: line for line, match in found.items() if match["error"]}
        if wrong and len(together) > 1:
            # Names of theirs may stand in each other's way: those with errors are read alone, or halves where none is at fault.
            print("clang-tidy: these do not compile together:", *wrong.values(), sep="\n  ", file=sys.stderr, flush=True)
            alone = [source for source in together if str(source.path) in wrong]
            others = [source for source in together if source not in alone]
            half = 0 if alone else len(others) // 2
            return sum((self.read(some) for some in [others[:half], others[half:], *([source] for source in alone)] if some), [])
        if done.returncode != 0 and not WARNING.search(done.stdout):
            return [f"clang-tidy failed: {done.stderr.strip()[-400:]}"]
        of_tree = {line: match[1] for line, match in found.items() if not match[1].startswith(f"{self.build}/")}
        named = {source: self.headers(source) | {str(source.path)} for source in together}
        unnamed = set(of_tree.values()) - set().union(*named.values())
        with self.lock:
            for source in together:
                theirs = sorted(line for line, path in of_tree.items() if path in named[source] | unnamed)
                self.known[str(source.path)] = {"key": self.key(source), "found": theirs}
            self.store.write_text(json.dumps(self.known))
        return sorted(of_tree)


def remembered(checker):
    """What was found in sources that are as they were then, and the other sources."""
    found, unread = set(), []
    for source in sources(checker.root, checker.build):
        known = checker.look_up(source)
        found.update(known or ())
        if known is None:
            unread.append(source)
    return found, unread


def count(root, build):
    """The number of warnings, or None where a source was not read since it changed."""
    found, unread = remembered(Checker(root, build, analyze=False))
    return None if unread else len(found)


def offences(root, build, analyze=False):
    """Every warning once."""
    checker, told = Checker(root, build, analyze), time.monotonic()
    found, unread = remembered(checker)
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        running = [pool.submit(checker.read, together) for together in readings(root, unread)]
        for number, done in enumerate(concurrent.futures.as_completed(running), 1):
            found.update(done.result())
            if time.monotonic() - told > PROGRESS_S:
                told = time.monotonic()
                print(f"clang-tidy: {number} of {len(running)} parts", file=sys.stderr, flush=True)
    return sorted(line.replace(f"{root}/", "") for line in found)


def main():
    root, build = (pathlib.Path(word).resolve() for word in sys.argv[1:3])
    found = offences(root, build, "--analyze" in sys.argv)
    print("\n".join(found) or "clang-tidy finds nothing")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
