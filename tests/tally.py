#!/usr/bin/env python3
"""Counts the subtests that the last `meson test` of build directories ran.

Every line `ok` or `not ok` of TAP is one. What did not run is a failure too:
a skipped subtest, one that was planned and never came, a program that
crashed, timed out or printed no TAP, a test that is not in the log. A test
that tells by its exit status alone is one subtest. The last line is
`N passed, N failed`.
"""
import argparse
import json
import pathlib
import re
import sys

RESULT = re.compile(r"(not )?ok\b(?: \d+)?(?: - | )?(.*)")
PLAN = re.compile(r"1\.\.(\d+)")
DIRECTIVE = re.compile(r"#\s*(skip|todo)\b", re.IGNORECASE)
N_LINES = 60  # of diagnostics for each failing program


def failures_of_output(stdout):
    """Returns the number of subtests that passed, the names of the others."""
    n_passed, n_planned, failed = 0, None, []
    for line in stdout.splitlines():
        if plan := PLAN.match(line):
            n_planned = int(plan[1])
        elif result := RESULT.match(line):
            if result[1] or DIRECTIVE.search(result[2]):
                failed.append(result[2] or "a subtest without a name")
            else:
                n_passed += 1
        elif line.startswith("Bail out!"):
            failed.append(line)
    if not n_planned:
        failed.append("it planned no subtests")
    else:
        n_missing = n_planned - n_passed - len(failed)
        failed += ["a planned subtest did not run"] * n_missing
    return n_passed, failed


def failures_of_test(record, protocol):
    is_ok = record["result"] == "OK"
    if protocol == "exitcode":
        return (1, []) if is_ok else (0, ["it fails"])
    n_passed, failed = failures_of_output(record.get("stdout") or "")
    if not is_ok and not failed:
        failed.append("the program: " + record["result"].lower())
    return n_passed, failed


def diagnostics(record):
    lines = [
        line
        for line in (record.get("stdout") or "").splitlines()
        if not re.match(r"ok\b|# (Start|End|slow|random)", line)
    ]
    lines += (record.get("stderr") or "").splitlines()
    lines.append(f"({record['result']}, status {record['returncode']})")
    return lines[-N_LINES:]


def read_log(directory):
    log = directory / "meson-logs" / "testlog.json"
    if not log.exists():
        return {}
    records = map(json.loads, log.read_text().splitlines())
    return {record["name"].split(" / ")[-1]: record for record in records}


def tests_of(directory, arguments):
    """Returns the tests that should have run: names and protocols."""
    listing = directory / "meson-info" / "intro-tests.json"
    if not listing.exists():
        return {"every test": "tap"}
    return {
        test["name"]: test["protocol"]
        for test in json.loads(listing.read_text())
        if (not arguments.only or test["name"] in arguments.only)
        and (
            not arguments.suite
            or any(suite.endswith(arguments.suite) for suite in test["suite"])
        )
    }


def tally(directory, arguments):
    n_passed, n_failed = 0, 0
    records = read_log(directory)
    tests = tests_of(directory, arguments) or {"no such test": "tap"}
    for name, protocol in tests.items():
        if name not in records:
            print(f"FAILED {directory}: {name}: it did not run")
            n_failed += 1
            continue
        passed, failed = failures_of_test(records[name], protocol)
        n_passed += passed
        n_failed += len(failed)
        for reason in failed:
            print(f"FAILED {directory}: {name}: {reason}")
        if failed:
            print(*("    " + line for line in diagnostics(records[name])), sep="\n")
    return n_passed, n_failed


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("directories", nargs="+", type=pathlib.Path)
    parser.add_argument("--only", nargs="*", help="names of tests")
    parser.add_argument("--suite", help="tests of one suite")
    arguments = parser.parse_args()
    counts = [tally(directory, arguments) for directory in arguments.directories]
    n_passed = sum(passed for passed, _ in counts)
    n_failed = sum(failed for _, failed in counts)
    print(f"{n_passed} passed, {n_failed} failed")
    return 0 if n_passed and not n_failed else 1


if __name__ == "__main__":
    sys.exit(main())
