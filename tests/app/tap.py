"""Runs the tests of a file: its functions, their names sentences. TAP."""
import atexit
import os
import shutil
import sys
import tempfile
import traceback

from program import Atspi, Failure

FOLDER = tempfile.mkdtemp(prefix="hull2vd-")
atexit.register(shutil.rmtree, FOLDER, ignore_errors=True)
HELPERS = set()


def helper(function):
    """Marks what is no test."""
    HELPERS.add(function.__name__)
    return function


def check(is_true, what):
    if not is_true:
        raise Failure(what)


def write(name, content):
    path = os.path.join(FOLDER, name)
    with open(path, "w", encoding="utf-8") as file:
        file.write(content)
    return path


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def tests_among(names):
    """The functions among names that are defined where it is called."""
    return [value for name, value in list(names.items())
            if getattr(value, "__module__", "") == "__main__"
            and callable(value) and name not in HELPERS]


def run(prefix, names):
    """Runs tests, or those among names."""
    tests = tests_among(names) if isinstance(names, dict) else names
    wanted = sys.argv[1:]
    tests = [t for t in tests if not wanted or t.__name__ in wanted]
    print(f"1..{len(tests)}")
    Atspi.init()
    for number, test in enumerate(tests, 1):
        name = f"/{prefix}/" + test.__name__.replace("_", "-")
        try:
            test()
            print(f"ok {number} {name}", flush=True)
        except Exception:  # whatever it is, the test has failed
            for line in traceback.format_exc().splitlines():
                print("#", line)
            print(f"not ok {number} {name}", flush=True)
