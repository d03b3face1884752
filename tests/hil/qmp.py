"""A client of QMP, the monitor of QEMU, for the checks that are still in Python; kaori-bench has its own."""

import json
import socket


class Qmp:
    """Waits for QEMU to listen at `path`, which it does before its machine starts."""

    def __init__(self, path):
        self.socket = socket.socket(socket.AF_UNIX)
        self.socket.connect(str(path))
        self.lines = self.socket.makefile("rw")
        self.lines.readline()
        self.ask("qmp_capabilities")

    def ask(self, command, **arguments):
        self.lines.write(json.dumps({"execute": command, "arguments": arguments}) + "\n")
        self.lines.flush()
        while True:
            answer = json.loads(self.lines.readline())
            if "error" in answer:
                raise RuntimeError(f"{command}: {answer['error']['desc']}")
            if "return" in answer:
                return answer["return"]

    def screendump(self, picture):
        """Writes a PPM, or a PNG where the file is called so."""
        png = {"format": "png"} if str(picture).endswith(".png") else {}
        self.ask("screendump", filename=str(picture), **png)
