#!/usr/bin/env python3
"""Measures how long the window keeps a person waiting.

./dev bench loop [N…] [PART…] [WORD…]

Starts the window, does what a person does with N sites (2 000, 10 000 and
100 000), and prints of each deed the longest time during which the main loop
did not ask for the next event: by the clock, and what it worked in that time.
All deeds, or those of the parts that are named, or with one of the words in
their names; loop_deeds.py has them all.

HULL2VD=PROGRAM HULL2VD_LOOP_MODULE=loop-watch.so tests/headless.sh \\
  python3 tests/bench/loop.py [N…] [PART…] [WORD…]
"""
import mmap
import os
import pathlib
import random
import struct
import sys
import tempfile
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "app"))

from program import Atspi, GLib, Program, wait  # noqa: E402
import loop_deeds  # noqa: E402

FOLDER = tempfile.mkdtemp(prefix="hull2vd-")
WATCH = struct.Struct("dd")
TICKS = os.sysconf("SC_CLK_TCK")
QUIET_S = 0.5


def points(n):
    """A file of n sites."""
    chance = random.Random(n)
    path = os.path.join(FOLDER, f"{n}.txt")
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(f"{chance.random()} {chance.random()}\n"
                        for _ in range(n))
    return path


class Watch:
    """What loop-watch.c tells of the program."""

    def __init__(self):
        path = os.path.join(FOLDER, "watch")
        with open(path, "wb") as file:
            file.write(bytes(mmap.PAGESIZE))
        with open(path, "r+b") as file:
            self.map = mmap.mmap(file.fileno(), mmap.PAGESIZE)
        os.environ["HULL2VD_LOOP_WATCH"] = path
        os.environ["GTK_MODULES"] = os.environ["HULL2VD_LOOP_MODULE"]

    def clear(self):
        self.map[:WATCH.size] = WATCH.pack(0, 0)

    def read(self):
        return WATCH.unpack(self.map[:WATCH.size])


def processor_s(pid):
    with open(f"/proc/{pid}/stat", encoding="ascii") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / TICKS


def settle(p):
    """Waits until the program has nothing to do."""
    quiet, before = 0, processor_s(p.process.pid)
    while quiet < QUIET_S:
        time.sleep(0.05)
        now = processor_s(p.process.pid)
        quiet = quiet + 0.05 if now == before else 0
        before = now


class Bench:
    """What is asked of the deeds, and what they ask for."""

    def __init__(self, p, watch, n, words):
        self.p, self.watch, self.n, self.words = p, watch, n, words
        self.folder = FOLDER
        self.is_all = True  # of this part
        # While there are few sites: to find them walks through all.
        self.plane, self.space = p.canvas("Plane"), p.canvas("Space")

    def wants(self, name):
        return self.is_all or any(word in name for word in self.words)

    def time(self, name, deed, before=None):
        """Each deed stands alone, after @before."""
        if not self.wants(name):
            return
        try:
            if before is not None:
                before()
            settle(self.p)
            self.watch.clear()
            deed()
            settle(self.p)
        except Exception as failure:  # the others are measured all the same
            print("#", name, repr(failure), file=sys.stderr, flush=True)
        clock_ms, worked_ms = self.watch.read()
        print(f"{self.n:7} {name:34} {clock_ms:7.0f} ms {worked_ms:7.0f} ms",
              flush=True)

    def do(self, name, action, parameter=None, before=None):
        self.time(name, lambda: self.p.activate(action, parameter), before)

    def keep(self, name, action, state, before=None):
        self.time(name, lambda: self.p.set_state(action, state), before)

    def save(self):
        """So that nobody is asked about what is not saved."""
        if self.p.state("n-sites") > 8:
            self.p.activate("save")
            settle(self.p)

    def load(self):
        self.p.activate("open-file", GLib.Variant("s", points(self.n)))
        wait(lambda: self.p.state("n-sites") == self.n, "the sites")


def measure(n, parts, words):
    watch = Watch()
    start = os.path.join(FOLDER, "eight.txt")
    with open(start, "w", encoding="utf-8") as file:
        file.write("0 0\n1 0\n0 1\n2 2\n3 1\n1 3\n2 -1\n-1 2\n")
    p = Program(start)
    try:
        bench = Bench(p, watch, n, words)
        for part in loop_deeds.PARTS:
            bench.is_all = (not words if not parts
                            else part.__name__ in parts)
            part(bench, p, n)
    finally:
        p.process.kill()
        errors = p.process.communicate()[1]
        if os.environ.get("HULL2VD_LOOP_ERRORS"):
            sys.stderr.write(errors)


def main():
    names = {part.__name__ for part in loop_deeds.PARTS}
    words = [w for w in sys.argv[1:] if not w.isdigit()]
    sizes = [int(w) for w in sys.argv[1:] if w.isdigit()]
    Atspi.init()
    for n in sizes or [2000, 10000, 100000]:
        measure(n, names.intersection(words),
                [w for w in words if w not in names])


if __name__ == "__main__":
    main()
