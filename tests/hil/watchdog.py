#!/usr/bin/env -S python3 -B
"""A stage that is slow is left alone, and one that hangs is not: watchdog.py PROGRAMS PACK [HANGS]

Plays the service manager for kaori-stage on the simulator's screen, without a virtual machine. Four programs that do
nothing but compute come and go beside it: its silence must never be longer than it asked for. Then it is frozen, killed
as soon as it was silent for longer, and started again at once.
"""

import os
import re
import signal
import socket
import statistics
import subprocess
import sys
import tempfile
import time
from pathlib import Path

LONGEST_US = 120_000_000  # As in the stage's unit.
SIZE, RATE_HZ = "320x180", "30"
CALM_S, BUSY_S, BURNERS, TURNS = 4, 8, 4, 3
LATE_S = 0.5  # This program too waits for a processor.
BURN = "while True: pass"


class Manager:
    """What systemd does for one program."""

    def __init__(self, folder, words):
        self.words, self.process = words, None
        self.socket = socket.socket(socket.AF_UNIX, socket.SOCK_DGRAM)
        self.socket.bind(f"{folder}/notify")
        self.told = dict(os.environ, NOTIFY_SOCKET=f"{folder}/notify", WATCHDOG_USEC=str(LONGEST_US))
        self.limit_s, self.last, self.ready, self.worst = LONGEST_US / 1e6, 0, False, 0

    def start(self):
        self.limit_s, self.ready, self.last = LONGEST_US / 1e6, False, time.monotonic()
        self.process = subprocess.Popen(self.words, env=self.told, stderr=subprocess.DEVNULL)

    def listen(self, longest_s):
        """Takes one message, if one comes. The longest silence, as a share of what was asked for, is kept."""
        self.socket.settimeout(max(0.001, longest_s))
        try:
            said = self.socket.recv(4096).decode()
        except TimeoutError:
            return
        now = time.monotonic()
        if "WATCHDOG=1" in said:
            self.worst = max(self.worst, (now - self.last) / self.limit_s)
            self.last = now
        asked = re.search(r"WATCHDOG_USEC=(\d+)", said)
        if asked:
            self.limit_s = int(asked.group(1)) / 1e6
        self.ready = self.ready or "READY=1" in said

    def play(self, length_s):
        until = time.monotonic() + length_s
        while time.monotonic() < until:
            self.listen(until - time.monotonic())

    def await_ready(self):
        while not self.ready:
            self.listen(1)

    def await_silence(self):
        while time.monotonic() - self.last < self.limit_s:
            self.listen(self.limit_s - (time.monotonic() - self.last))


def play_busy(manager):
    """The longest silence while neighbours come and go, of what it asked for."""
    for _ in range(TURNS):
        manager.play(CALM_S)
        burners = [subprocess.Popen([sys.executable, "-c", BURN]) for _ in range(BURNERS)]
        manager.play(BUSY_S)
        for burner in burners:
            burner.kill()
            burner.wait()
    return manager.worst


def hang(manager):
    """Seconds from the freeze to the death, what the stage had asked for, and from the death to the next picture."""
    while manager.limit_s * 1e6 >= LONGEST_US:  # Until it knows its own pace.
        manager.listen(1)
    manager.play(CALM_S)
    asked_s, frozen = manager.limit_s, time.monotonic()
    manager.process.send_signal(signal.SIGSTOP)
    manager.await_silence()
    manager.process.kill()
    manager.process.wait()
    died = time.monotonic()
    manager.start()
    manager.await_ready()
    return died - frozen, asked_s, time.monotonic() - died


def main():
    programs, pack = Path(sys.argv[1]), sys.argv[2]
    hangs = int(sys.argv[3]) if len(sys.argv) > 3 else 5
    with tempfile.TemporaryDirectory() as folder:
        with subprocess.Popen([programs / "kaori-sim", "--links", folder, "--size", SIZE, "--hz", RATE_HZ]) as simulator:
            while not (Path(folder) / "screen.screen").exists() and simulator.poll() is None:
                time.sleep(0.05)
            manager = Manager(folder, [programs / "kaori-stage", "--links", folder, "--board", f"{folder}/board",
                                       "--pack", pack])
            try:
                manager.start()
                manager.await_ready()
                worst = play_busy(manager)
                seen = [hang(manager) for _ in range(hangs)]
            finally:
                manager.process.kill()
                simulator.terminate()
    late = [died_s - asked_s for died_s, asked_s, _ in seen]
    good = worst < 1 and max(late) < LATE_S
    print(f"{'ok  ' if good else 'FAIL'}  beside {BURNERS} busy programs the longest silence was {100 * worst:.0f} % of what the "
          f"stage asked for; frozen, it was dead after {statistics.median(s[0] for s in seen) * 1e3:.0f} ms "
          f"(asked {statistics.median(s[1] for s in seen) * 1e3:.0f} ms), and the next picture was there "
          f"{statistics.median(s[2] for s in seen) * 1e3:.0f} ms after its death (at most {max(s[2] for s in seen) * 1e3:.0f})")
    sys.exit(not good)


if __name__ == "__main__":
    main()
