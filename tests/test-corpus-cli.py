#!/usr/bin/env python3
"""What hull2vd-cli compute writes of every file of the corpora: verified by
the program itself, and counted here from the JSON alone, against MANIFEST.tsv.

Files of 60 sites or fewer are verified at every round as well.
"""
import collections
import csv
import json
import os
import pathlib
import subprocess
import sys

SOURCE = pathlib.Path(os.environ["HULL2VD_SOURCE"])
CLI = os.environ["HULL2VD_CLI"]
FEW = 60


class Fault(Exception):
    """A sentence that turned out false."""


def run(*arguments):
    return subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True)


def compute(path, *options):
    process = run("compute", "--verify", *options, path)
    if process.returncode != 0 or process.stderr:
        raise Fault(f"{' '.join(map(str, options))}: {process.stderr.strip()}")
    return json.loads(process.stdout)


def check_refusal(row, path):
    line = row["expected"].split()[1]
    process = run("compute", path)
    if process.returncode != 1 or process.stdout:
        raise Fault(f"status {process.returncode} and {len(process.stdout)} bytes")
    if not process.stderr.startswith(f"{path}:{line}: "):
        raise Fault(f"not line {line}: {process.stderr.strip()}")


def boundary_of(result):
    """The sites with a ray between them."""
    if result["dimension"] != 2:
        return set()
    rays = [e for e in result["voronoi"]["edges"] if e[3] == -1]
    return {site for ray in rays for site in ray[:2]}


def edges_of(result):
    if result["dimension"] < 2:
        return {frozenset(pair) for pair in result.get("segments", [])}
    return {
        frozenset((t[k], t[k - 1])) for t in result["triangles"] for k in range(3)
    }


def counts_of(result, merged):
    """The columns of the manifest."""
    edges = result["voronoi"]["edges"]
    is_plane = result["dimension"] == 2
    groups = result["voronoi"].get("vertex_of_triangle", [])
    sizes = collections.Counter(groups)
    kinds = merged["hull3d"]["kinds"]
    return {
        "n": result["n"],
        "distinct": result["n"] - len(result.get("duplicates", [])),
        "dimension": result["dimension"],
        "hull2d": len(result["hull2d"]),
        "boundary_points": len(boundary_of(result)),
        "triangles": len(result["triangles"]),
        "delaunay_edges": len(edges_of(result)),
        "cocircular_cells": sum(n > 1 for n in sizes.values()),
        "voronoi_vertices": len(result["voronoi"]["vertices"]),
        "voronoi_edges": sum(e[3] != -1 for e in edges) if is_plane else 0,
        "voronoi_rays": sum(e[2] != -1 and e[3] == -1 for e in edges),
        "hull3d_dimension": result["hull3d"]["dimension"],
        "facets_triangulated": len(result["hull3d"]["facets"]),
        "lower_merged": kinds.count("lower"),
        "upper_merged": kinds.count("upper"),
        "vertical_merged": kinds.count("vertical"),
    }


def check_counts(row, result, merged):
    for name, count in counts_of(result, merged).items():
        if str(count) != row[name]:
            raise Fault(f"{name} is {count} instead of {row[name]}")


def check_groups(result, merged):
    """Merged lower facets are the circle groups, one Voronoi vertex each, and
    no Voronoi edge joins a vertex to itself."""
    groups = {}
    for triangle, group in zip(
        result["triangles"], result["voronoi"].get("vertex_of_triangle", [])
    ):
        groups.setdefault(group, set()).update(triangle)
    hull = merged["hull3d"]
    lower = [
        frozenset(facet)
        for facet, kind in zip(hull["facets"], hull["kinds"])
        if kind == "lower"
    ]
    if set(lower) != set(map(frozenset, groups.values())) or len(lower) != len(groups):
        raise Fault("merged lower facets are not the circle groups")
    if len(groups) != len(result["voronoi"]["vertices"]):
        raise Fault("not one Voronoi vertex for each circle group")
    if any(e[2] == e[3] != -1 for e in result["voronoi"]["edges"]):
        raise Fault("a Voronoi edge has no length")


def check_rounds(result, path):
    """Returns how many rounds were verified."""
    n_distinct = result["n"] - len(result.get("duplicates", []))
    last = n_distinct - 4
    n_rounds = 0
    if result["hull3d"]["dimension"] < 3 or n_distinct > FEW:
        return 0
    for r in range(last + 1):
        step = compute(path, "--merged", "--round", r)
        if len(step["active"]) != r + 4:
            raise Fault(f"round {r} has {len(step['active'])} active sites")
        n_rounds += 1
    return n_rounds


def check_file(row, path):
    """Returns what was looked at, in words."""
    if path.stat().st_size != int(row["bytes"]):
        raise Fault("another size")
    if row["expected"].startswith("refuse"):
        check_refusal(row, path)
        return "refused by line"
    result, merged = compute(path), compute(path, "--merged")
    check_counts(row, result, merged)
    check_groups(result, merged)
    for order in "input", "random", "seeded", "hilbert":
        check_groups(compute(path, "--order", order), merged)
    return f"{check_rounds(result, path)} rounds verified"


def main():
    folders = [SOURCE / "tests" / "corpus"]
    if os.environ.get("HULL2VD_PEERS"):
        folders.append(pathlib.Path(os.environ["HULL2VD_PEERS"]))
    files = []
    for folder in folders:
        with open(folder / "MANIFEST.tsv", newline="", encoding="utf-8") as table:
            rows = csv.DictReader(table, delimiter="\t", quoting=csv.QUOTE_NONE)
            files += [(row, folder / row["file"]) for row in rows]
    print(f"1..{len(files)}")
    n_failed = 0
    for number, (row, path) in enumerate(files, 1):
        try:
            print(f"# {path.name}: {check_file(row, path)}")
            print(f"ok {number} - {path.name} comes out as listed")
        except Fault as fault:
            n_failed += 1
            print(f"# {fault}")
            print(f"not ok {number} - {path.name} comes out as listed")
        sys.stdout.flush()
    return 1 if n_failed else 0


if __name__ == "__main__":
    sys.exit(main())
