#!/usr/bin/env python3
"""Measures how long the window keeps a person waiting: ./dev bench loop [N…]

Starts the window, does what a person does with N sites (2 000, 10 000 and
100 000), and prints of each deed the longest time during which the main loop
did not ask for the next event: by the clock, and what it worked in that time.

HULL2VD=PROGRAM HULL2VD_LOOP_MODULE=loop-watch.so tests/headless.sh \\
  python3 tests/bench/loop.py [--only=PART] [N…]
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

from program import Atspi, GLib, Program, wait, xdotool  # noqa: E402

FOLDER = tempfile.mkdtemp(prefix="hull2vd-")
WATCH = struct.Struct("dd")
TICKS = os.sysconf("SC_CLK_TCK")
QUIET_S = 0.5


def text(value):
    return GLib.Variant("s", value)


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
    def __init__(self, p, watch, n, only):
        self.p, self.watch, self.n, self.only = p, watch, n, only
        self.rows = {}
        # While there are few sites: to find them walks through all.
        self.plane, self.space = p.canvas("Plane"), p.canvas("Space")

    def time(self, name, deed):
        if self.only not in name:
            return
        settle(self.p)
        self.watch.clear()
        try:
            deed()
            settle(self.p)
        except Exception as failure:  # the others are measured all the same
            print("#", name, repr(failure), file=sys.stderr, flush=True)
        self.rows[name] = self.watch.read()
        print(f"{self.n:7} {name:34} {self.rows[name][0]:7.0f} ms"
              f" {self.rows[name][1]:7.0f} ms", flush=True)

    def do(self, name, action, parameter=None):
        self.time(name, lambda: self.p.activate(action, parameter))

    def keep(self, name, action, state):
        self.time(name, lambda: self.p.set_state(action, state))


def open_and_step(bench, p, n):
    def load():
        p.activate("open-file", text(points(n)))
        wait(lambda: p.state("n-sites") == n, "the sites")

    settle(p)
    bench.time("open a file", load)
    p.activate("open-file", text(points(n)))
    bench.do("to the start", "first")
    bench.do("to the end", "last")
    bench.do("back an event", "back-event")
    bench.do("back a phase", "back-phase")
    bench.do("back a round", "back-round")
    bench.do("go to a round", "goto", text(f"round {n // 2} see"))
    bench.do("next event", "next-event")
    bench.do("next phase", "next-phase")
    bench.do("next round", "next-round")

    def race():
        for _ in range(10):
            p.activate("next-round")

    def scrub():
        for i in range(20):
            p.activate("goto-step",
                       GLib.Variant("u", p.state("n-steps") * i // 20))
            time.sleep(0.03)

    bench.time("ten rounds at once", race)
    bench.time("scrub", scrub)


def place(canvas, x, y):
    return (round(canvas.x + x * canvas.width),
            round(canvas.y + y * canvas.height))


def point(bench, p, n):
    plane, space = p.extents(bench.plane), p.extents(bench.space)

    def hover(canvas):
        for i in range(30):
            p.point(*place(canvas, 0.3 + i / 80, 0.4 + i / 90))
            time.sleep(0.02)

    def turn():
        p.drag(place(space, 0.5, 0.9), place(space, 0.8, 0.8))

    p.activate("last")
    bench.time("hover over the plane", lambda: hover(plane))
    bench.time("hover over space", lambda: hover(space))
    bench.time("turn space", turn)
    bench.do("look down", "camera-look-down")
    bench.do("look home", "camera-home")
    bench.time("zoom in", lambda: xdotool(
        "mousemove", *place(plane, 0.5, 0.5), "click", "--repeat", 6, 4))
    bench.time("pan", lambda: p.drag(place(plane, 0.5, 0.5),
                                     place(plane, 0.6, 0.6), button=2))
    bench.do("fit", "fit")


def edit(bench, p, n):
    far = GLib.Variant("(udd)", (5, 0.4001, 0.6001))

    bench.do("add a site", "add-site", GLib.Variant("(dd)", (0.501, 0.502)))
    bench.do("undo", "undo")
    bench.do("redo", "redo")
    bench.do("move a site", "move-site", far)
    settle(p)
    box = p.extents(bench.plane.get_child_at_index(5))
    ends = place(box, 0.5, 0.5), place(p.extents(bench.plane), 0.4, 0.4)
    bench.time("drag a site", lambda: p.drag(*ends))
    bench.do("remove a site", "remove-site", GLib.Variant("u", 7))
    bench.do("nudge", "nudge", text("right"))
    bench.do("select all", "select-all")
    bench.do("copy the sites", "copy")
    bench.do("select none", "select-none")
    bench.time("paste them", lambda: p.activate("paste"))
    p.activate("select-sites", GLib.Variant("au", [1, 3, 5]))
    bench.do("delete a selection", "delete-selection")
    bench.do("generate", "sites", text(f"random {n} seed 5"))
    bench.do("order: input", "order", text("input"))
    bench.do("order: furthest", "order", text("furthest"))


def look(bench, p, n):
    for layer in ("hull paraboloid delaunay voronoi circumcircles lifts "
                  "labels furthest tangents why preview").split():
        shown = p.state("layer-" + layer)
        for state in (not shown, shown):
            bench.keep(f"layer {layer} {'on' if state else 'off'}",
                       "layer-" + layer, GLib.Variant("b", state))
    for theme in "dark", "projector", "light":
        bench.keep("theme " + theme, "theme", text(theme))
    bench.keep("lift", "lift", GLib.Variant("d", 0.5))
    bench.keep("lifted again", "lift", GLib.Variant("d", 1))
    bench.do("focus: horizon", "focus", text("horizon"))
    bench.do("focus: active", "focus", text("active"))
    bench.do("select a site", "select", text("s9"))
    bench.do("select a facet", "select", text("f9"))
    bench.do("views: plane", "views", text("plane"))
    bench.do("views: both", "views", text("both"))
    for state in True, False:
        bench.keep("space apart" if state else "space back", "detach-space",
                   GLib.Variant("b", state))
    bench.do("copy a picture", "copy-picture")
    bench.time("a smaller window", lambda: p.resize(1200, 760))
    bench.time("a larger window", lambda: p.resize(1440, 900))


def show(bench, p, n):
    bench.do("compare", "compare", text("furthest input"))
    bench.do("compare: to the middle", "goto", text(f"round {n // 2} see"))
    bench.do("compare: next round", "next-round")
    bench.do("compare: next event", "next-event")
    bench.do("compare in space", "compare-view", text("space"))
    bench.do("compare other orders", "compare", text("input hilbert"))
    bench.do("compare: no more", "compare", text("none"))
    bench.do("order: furthest again", "order", text("furthest"))
    for view in "planar", "signs", "rounded", "lifts":
        bench.do("view " + view, "view", text(view))
        if view in ("planar", "rounded"):
            bench.do(f"{view}: to the start", "first")
            bench.do(f"{view}: next event", "next-event")
            bench.do(f"{view}: to the end", "last")
            bench.do(f"{view}: add a site", "add-site",
                     GLib.Variant("(dd)", (0.7, 0.7 + len(view) / 1000)))


def save(bench, p, n):
    bench.do("save", "save")
    bench.do("modified?", "new")


PARTS = [open_and_step, point, edit, look, show, save]


def measure(n, only, parts):
    watch = Watch()
    start = os.path.join(FOLDER, "eight.txt")
    with open(start, "w", encoding="utf-8") as file:
        file.write("0 0\n1 0\n0 1\n2 2\n3 1\n1 3\n2 -1\n-1 2\n")
    p = Program(start)
    try:
        bench = Bench(p, watch, n, only)
        for part in PARTS:
            if not parts or part.__name__ in parts:
                part(bench, p, n)
            elif part is open_and_step:
                p.activate("open-file", text(points(n)))
                wait(lambda: p.state("n-sites") == n, "the sites")
        return bench.rows
    finally:
        p.process.kill()
        errors = p.process.communicate()[1]
        if os.environ.get("HULL2VD_LOOP_ERRORS"):
            sys.stderr.write(errors)


def main():
    words = sys.argv[1:]
    only = [w.split("=", 1)[1] for w in words if w.startswith("--only=")]
    parts = [w for w in words if w[0].isalpha()]
    sizes = [int(w) for w in words if w.isdigit()] or [2000, 10000, 100000]
    Atspi.init()
    for n in sizes:
        measure(n, only[0] if only else "", parts)


if __name__ == "__main__":
    main()
