#!/usr/bin/env python3
"""Runs the engine beside its peers, in turn, and prints a table of ratios.

table.py BUILD [--quick | --huge]

Every row runs its programs one after the other, ROUNDS times over, on one
processor, with a heap that is kept; the least time of each counts. Quote the
ratios: the times are those of this machine in these minutes.
"""
import json
import os
import subprocess
import sys
import tempfile
import time

ROUNDS = 5

HEAP = {
    "GLIBC_TUNABLES": "glibc.malloc.mmap_threshold=4294967296"
    ":glibc.malloc.trim_threshold=17179869184"
    ":glibc.malloc.top_pad=268435456",
}

# What, kind, sites, ours, against what, the ratio wanted.
ROWS = [
    ("hilbert / CGAL", "uniform", 100000, "hilbert", "cgal", 0.50),
    ("hilbert / CGAL", "uniform", 1000000, "hilbert", "cgal", 0.50),
    ("furthest / CGAL", "uniform", 100000, "furthest", "cgal", 1.0),
    ("furthest / qhull", "uniform", 100000, "furthest", "qhull", 1 / 15),
    ("seeded / CGAL", "uniform", 100000, "seeded", "cgal", 0.75),
    ("seeded / CGAL", "uniform", 1000000, "seeded", "cgal", 0.75),
]
for tied in ("grid", "duplicates"):
    for size in (10000, 100000):
        for name in ("hilbert", "seeded", "furthest"):
            ROWS.append((f"{name} / its uniform", tied, size, name,
                         "uniform", 1.5))
for near in ("circle", "line"):
    for name in ("hilbert", "seeded", "furthest"):
        ROWS.append((f"{name} / its uniform", near, 100000, name, "uniform",
                     2.0))
for other in ("clusters", "kuzmin", "spiral"):
    ROWS.append(("hilbert / CGAL", other, 100000, "hilbert", "cgal", None))


def run(command):
    """Runs a program on one processor and reads its line of JSON."""
    out = subprocess.run(["taskset", "-c", "0", *command], check=True,
                         capture_output=True, text=True,
                         env={**os.environ, **HEAP})
    return json.loads(out.stdout)


class Bench:
    """The programs of one build, and the files of sites made for them."""

    def __init__(self, build, folder):
        self.build = os.path.join(build, "tests", "bench")
        self.folder = folder

    def sites(self, kind, size):
        """The path of a file of sites, made when it is first asked for."""
        path = os.path.join(self.folder, f"{kind}-{size}.txt")
        if not os.path.exists(path):
            with open(path, "w", encoding="ascii") as file:
                subprocess.run([os.path.join(self.build, "bench-sites"), kind,
                                str(size)], check=True, stdout=file)
        return path

    def ours(self, kind, size, order):
        """Times the engine."""
        return run([os.path.join(self.build, "hull-bench"),
                    self.sites(kind, size), order, repeats(size)])

    def other(self, against, kind, size, order):
        """Times what a row is measured against."""
        if against == "uniform":
            return self.ours("uniform", size, order)
        return run([os.path.join(self.build, "peer-" + against),
                    self.sites(kind, size), repeats(size)])

    def has(self, against):
        """Whether the peer was built."""
        return against == "uniform" or os.path.exists(
            os.path.join(self.build, "peer-" + against))


def repeats(size):
    """So many runs that each program takes about a second."""
    return str(max(3, min(50, 1000000 // size)))


def machine():
    """The processor's name."""
    with open("/proc/cpuinfo", encoding="ascii") as file:
        for line in file:
            if line.startswith("model name"):
                return line.split(":", 1)[1].strip()
    return "unknown processor"


def print_ratios(bench, largest):
    """The rows that compare two programs."""
    print("| what | sites | ns a site | other | ratio | wanted |")
    print("|---|---|---|---|---|---|")
    for what, kind, size, order, against, wanted in ROWS:
        if size > largest:
            continue
        if not bench.has(against):
            print(f"| {what} | {kind} {size} | the peer is not there | | | |")
            continue
        ours = others = float("inf")
        for _ in range(ROUNDS):
            ours = min(ours, bench.ours(kind, size, order)["ns_per_site_min"])
            others = min(others, bench.other(against, kind, size, order)
                         ["ns_per_site_min"])
        goal = "" if wanted is None else f"≤ {wanted:.2f}"
        print(f"| {what} | {kind} {size} | {ours:.0f} | {others:.0f} "
              f"| {ours / others:.2f} | {goal} |", flush=True)


def print_traces(bench):
    """The rows of a whole trace with its diagrams, and of a mere log."""
    print("\n| QuickHull, trace, Voronoi | ms | wanted | all / no hook "
          "| trace / no hook | log / no hook | log without claims "
          "| its bytes a site |")
    print("|---|---|---|---|---|---|---|---|")
    for size, wanted in ((200, ""), (2000, "≤ 1 ms"), (10000, "≤ 6 ms")):
        best = run([os.path.join(bench.build, "trace-bench"),
                    bench.sites("uniform", size), repeats(size)])
        alone = best["hull_ns_per_site_min"]
        ratios = [best[key] / alone for key in
                  ("ns_per_site_min", "record_ns_per_site_min",
                   "log_ns_per_site_min",
                   "log_without_claims_ns_per_site_min")]
        print(f"| {size} sites | {best['ms_min']:.2f} | {wanted} "
              f"| {ratios[0]:.2f} | {ratios[1]:.2f} | {ratios[2]:.2f} "
              f"| {ratios[3]:.2f} | {best['log_without_claims_bytes_per_site']} |", flush=True)


def print_growth(bench, largest):
    """Memory, and how time grows: wanted are 1.25 and 100 bytes at most."""
    print("\n| uniform | ns a site | / 100000 sites | bytes a site | wanted |")
    print("|---|---|---|---|---|")
    for order in ("hilbert", "seeded", "furthest"):
        first = None
        for size in (100000, 1000000, 10000000):
            if size > largest or (size > 1000000 and order != "hilbert"):
                continue
            ours = min((bench.ours("uniform", size, order)
                        for _ in range(ROUNDS if size < 10000000 else 1)),
                       key=lambda line: line["ns_per_site_min"])
            least = ours["ns_per_site_min"]
            first = first or least
            print(f"| {order} {size} | {least:.0f} | {least / first:.2f} "
                  f"| {ours['peak_bytes'] / size:.0f} "
                  f"| ≤ 1.25, ≤ 100 bytes |", flush=True)


def print_command(bench):
    """The whole command, from a file to JSON."""
    command = os.path.join(bench.build, "..", "..", "src", "cli",
                           "hull2vd-cli")
    path = bench.sites("uniform", 100000)
    best = float("inf")
    for _ in range(ROUNDS):
        began = time.monotonic()
        with open(os.devnull, "wb") as sink:
            process = subprocess.Popen([command, "compute", path],
                                       stdout=sink)
            _, status, usage = os.wait4(process.pid, 0)
        if status != 0:
            sys.exit("hull2vd-cli compute failed")
        process.returncode = 0
        best = min(best, time.monotonic() - began)
    print("\n| whole command, 100000 sites to JSON | s | MB | wanted |")
    print("|---|---|---|---|")
    print(f"| compute | {best:.2f} | {usage.ru_maxrss / 1024:.0f} "
          f"| < 1 s, < 200 MB |")


def main():
    """Prints all tables."""
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    largest = 100000 if "--quick" in sys.argv else 1000000
    if "--huge" in sys.argv:
        largest = 10000000
    print(f"{machine()}, {os.cpu_count()} processors\n")
    with tempfile.TemporaryDirectory() as folder:
        bench = Bench(sys.argv[1], folder)
        print_ratios(bench, largest)
        print_traces(bench)
        print_growth(bench, largest)
        print_command(bench)


main()
