"""Drives the real program: its actions over D-Bus, what it shows over AT-SPI,
pointer and keys through the X server."""
import contextlib
import os
import shutil
import subprocess
import time

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, Gio, GLib  # noqa: E402

NAME = "io.github.hull2vd.Hull2VD"
PATH = "/io/github/hull2vd/Hull2VD/window/1"
PATIENCE = float(os.environ.get("HULL2VD_PATIENCE", "20"))

ALL = Atspi.CollectionMatchType.ALL
ANY = Atspi.CollectionMatchType.ANY
ROLES = {Atspi.role_get_name(Atspi.Role(i)): Atspi.Role(i)
         for i in range(Atspi.Role.PUSH_BUTTON_MENU)}

# A busy machine takes its time to answer.
Atspi.set_timeout(10000, 20000)


class Failure(Exception):
    """What was expected did not come about."""


def wait(condition, what):
    """Waits until condition() is true, and returns its value. What it asks
    of may not be there yet, or be gone since: it is None then, or has an
    error of its own."""
    end = time.monotonic() + PATIENCE
    missing = None
    while time.monotonic() < end:
        try:
            value = condition()
            if value:
                return value
            missing = None
        except (AttributeError, GLib.Error) as error:
            missing = error
        time.sleep(0.03)
    raise Failure(f"waited in vain: {what}") from missing


def xdotool(*words):
    subprocess.run(["xdotool", *map(str, words)], check=True,
                   stdout=subprocess.DEVNULL)


def progress_path(name="progress.json"):
    return os.path.join(os.environ["XDG_DATA_HOME"], "hull2vd", name)


def forget_progress():
    """What a program before has kept."""
    if os.path.exists(progress_path()):
        os.remove(progress_path())
    shutil.rmtree(progress_path("unsaved"), ignore_errors=True)


@contextlib.contextmanager
def listening():
    """The sentences that are announced."""
    heard = []
    listener = Atspi.EventListener.new(
        lambda event: heard.append(str(event.any_data)))
    listener.register("object:announcement")
    try:
        yield heard
    finally:
        listener.deregister("object:announcement")


def hear():
    """Lets what was announced arrive."""
    context = GLib.MainContext.default()
    while context.pending():
        context.iteration(False)
    return True


def windows():
    """Their numbers, as the X server knows them."""
    return set(subprocess.run(
        ["xdotool", "search", "--onlyvisible", "--class", "hull2vd"],
        check=False, capture_output=True, text=True).stdout.split())


class Program:
    """The program with one window, from its start to its end."""

    def __init__(self, *files, keeps_progress=False):
        if not keeps_progress:
            forget_progress()
        self.errors = ""  # what it has printed when it ends
        self.bus = Gio.bus_get_sync(Gio.BusType.SESSION)
        xdotool("mousemove", 0, 0)
        wait(lambda: not self.is_on_bus(), "no other program")
        self.process = subprocess.Popen(
            [os.environ["HULL2VD"], *files], stderr=subprocess.PIPE,
            text=True)
        wait(self.has_actions, "the window's actions")
        wait(lambda: self.find("canvas"), "the pictures")

    def __enter__(self):
        return self

    def __exit__(self, kind, value, trace):
        if kind is not None:
            self.process.kill()
            print("#", self.process.communicate()[1].replace("\n", "\n# "))
            return
        try:
            self.errors = errors = self.quit()
        finally:
            self.process.kill()
        if self.process.returncode != 0 or "WARNING" in errors:
            raise Failure(f"ended with {self.process.returncode}: {errors}")

    def quit(self):
        """Quits, gives up what is not saved, returns what was printed."""
        self.activate("quit")
        wait(lambda: self.process.poll() is not None or self.close_button(),
             "the program to end, or to ask")
        if self.process.poll() is None:
            self.close_button().do_action(0)
        return self.process.communicate(timeout=2 * PATIENCE)[1]

    def close_button(self):
        try:
            return self.find("push button", "Close without Saving")
        except GLib.Error:
            return None

    # Actions

    def call(self, method, parameters, path=PATH, name="org.gtk.Actions"):
        return self.bus.call_sync(NAME, path, name, method, parameters, None,
                                  Gio.DBusCallFlags.NO_AUTO_START, 20000,
                                  None)

    def is_on_bus(self):
        return self.bus.call_sync(
            "org.freedesktop.DBus", "/org/freedesktop/DBus",
            "org.freedesktop.DBus", "NameHasOwner",
            GLib.Variant("(s)", (NAME,)), None, Gio.DBusCallFlags.NONE, -1,
            None).unpack()[0]

    def has_actions(self):
        if self.process.poll() is not None:
            raise Failure(self.process.communicate()[1])
        try:
            return "next" in self.list_actions()
        except GLib.Error:
            return False

    def list_actions(self):
        return self.call("List", None).unpack()[0]

    def activate(self, action, parameter=None):
        parameters = [] if parameter is None else [parameter]
        self.call("Activate",
                  GLib.Variant("(sava{sv})", (action, parameters, {})))

    def set_state(self, action, state):
        self.call("SetState", GLib.Variant("(sva{sv})", (action, state, {})))

    def describe(self, action):
        return self.call("Describe",
                         GLib.Variant("(s)", (action,))).unpack()[0]

    def state(self, action):
        return self.describe(action)[2][0]

    def is_enabled(self, action):
        return self.describe(action)[0]

    def expect(self, action, state):
        wait(lambda: self.state(action) == state,
             f"{action} to be {state}, not {self.state(action)}")

    # What it shows

    def root(self):
        desktop = Atspi.get_desktop(0)
        desktop.clear_cache()
        for i in range(desktop.get_child_count()):
            child = desktop.get_child_at_index(i)
            if child is not None and child.get_process_id() == \
                    self.process.pid:
                return child
        return None

    def find(self, role, name=None, contains=None):
        """The first thing shown of this role, by its name."""
        root = self.root()
        return root and self.find_below(root, role, name, contains)

    def the(self, role, name=None, contains=None):
        """What find finds, once it is shown."""
        return wait(lambda: self.find(role, name, contains),
                    name or contains or role)

    def find_below(self, node, role, name=None, contains=None):
        for child in self.find_all(role, node):
            try:
                title = child.get_name()
            except GLib.Error:  # gone since
                continue
            if name in (None, title) and (
                    contains is None or contains in title):
                return child
        return None

    def find_all(self, role, node=None):
        """The program looks itself: to walk all that it shows from here takes
        a question for each thing."""
        rule = Atspi.MatchRule.new(
            Atspi.StateSet.new([Atspi.StateType.SHOWING]), ALL, {}, ALL,
            [ROLES[role]], ANY, [], ALL, False)
        return Atspi.Collection.get_matches(
            node or self.root(), rule, Atspi.CollectionSortOrder.CANONICAL, 0,
            True)

    def focus(self):
        """The name of what has the keyboard, in a list; empty: nothing."""
        rule = Atspi.MatchRule.new(
            Atspi.StateSet.new([Atspi.StateType.FOCUSED]), ALL, {}, ALL, [],
            ANY, [], ALL, False)
        found = Atspi.Collection.get_matches(
            self.root(), rule, Atspi.CollectionSortOrder.CANONICAL, 0, True)
        return [child.get_name() for child in found][-1:]

    def canvas(self, name):
        return self.the("canvas", name)

    def extents(self, accessible):
        accessible.clear_cache()
        return accessible.get_extents(Atspi.CoordType.SCREEN)

    def site(self, number, canvas="Plane"):
        """A site as the canvas tells of it."""
        return wait(lambda: self.canvas(canvas).get_child_at_index(number),
                    f"s{number} in the {canvas} view")

    def site_at(self, number, canvas="Plane"):
        box = self.extents(self.site(number, canvas))
        return box.x + box.width // 2, box.y + box.height // 2

    def coordinates(self, number):
        site = self.site(number)
        site.clear_cache()
        words = site.get_name().split("(")[1].split(")")[0].split(", ")
        return tuple(map(float, words))

    # Pointer and keys

    def point(self, x, y):
        xdotool("mousemove", x, y)

    def resize(self, width, height):
        """Gives all its windows this size."""
        windows = subprocess.run(
            ["xdotool", "search", "--onlyvisible", "--class", "hull2vd"],
            check=True, capture_output=True, text=True).stdout.split()
        for window in windows:
            xdotool("windowsize", window, width, height)

    def resize_window(self, title, width, height):
        window = subprocess.run(
            ["xdotool", "search", "--name", title], check=True,
            capture_output=True, text=True).stdout.split()[-1]
        xdotool("windowsize", window, width, height)

    def click(self, x, y, button=1):
        xdotool("mousemove", x, y, "click", button)

    def drag(self, start, end, button=1):
        xdotool("mousemove", *start, "mousedown", button)
        for part in (0.2, 0.5, 0.8, 1):
            xdotool("mousemove",
                    round(start[0] + part * (end[0] - start[0])),
                    round(start[1] + part * (end[1] - start[1])))
            time.sleep(0.02)
        xdotool("mouseup", button)

    def keys(self, *names):
        box = self.extents(self.find("frame"))
        xdotool("mousemove", box.x + box.width // 2, box.y + 20,
                "key", "--delay", 30, *names)
