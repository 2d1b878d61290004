"""Drives the real program: its actions over D-Bus, what it shows over AT-SPI,
pointer and keys through the X server."""
import contextlib
import glob
import os
import shutil
import subprocess
import time

import gi

gi.require_version("Atspi", "2.0")
from gi.repository import Atspi, Gio, GLib  # noqa: E402

NAME = "io.github.hull2vd.Hull2VD"
PATH = "/io/github/hull2vd/Hull2VD/window/1"
# A busy machine takes its time to answer. Who waits in vain has failed anyway.
PATIENCE = float(os.environ.get("HULL2VD_PATIENCE", "90"))
PATIENCE_MS = round(1000 * PATIENCE)
SERVER = int(os.environ["HULL2VD_SERVER"])  # the process that is the screen

ALL = Atspi.CollectionMatchType.ALL
ANY = Atspi.CollectionMatchType.ANY
ROLES = {Atspi.role_get_name(Atspi.Role(i)): Atspi.Role(i)
         for i in range(Atspi.Role.PUSH_BUTTON_MENU)}

Atspi.set_timeout(PATIENCE_MS, PATIENCE_MS)


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


def work_of(pid):
    """The nanoseconds that the threads of a process have run; None: one of
    them runs, or would if there were a processor for it."""
    work = 0
    for thread in glob.glob(f"/proc/{pid}/task/*"):
        with contextlib.suppress(OSError):  # it has ended
            with open(f"{thread}/stat", encoding="utf-8") as file:
                if file.read().rpartition(")")[2].split()[0] in ("R", "D"):
                    return None
            with open(f"{thread}/schedstat", encoding="utf-8") as file:
                work += int(file.read().split()[0])
    return work


def sleep_sound(pids, seconds):
    """Waits until the processes have had next to nothing to do for so long:
    what was asked for is shown, also where the machine is busy with something
    else. A look at the clock, frame by frame, is next to nothing."""
    def slept():
        before = [work_of(pid) for pid in pids]
        time.sleep(seconds)
        after = [work_of(pid) for pid in pids]
        return None not in before + after and \
            sum(after) - sum(before) < 0.05e9 * seconds
    wait(slept, "nothing moves any more")


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
        wait(windows, "its window on the screen")
        self.rest()

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
        wait(lambda: self.process.poll() is not None
             or self.press("Close without Saving"),
             "the program to end, or to ask")
        return self.process.communicate(timeout=2 * PATIENCE)[1]

    def press(self, name):
        """Presses a button, if there is one, as a screen reader would."""
        button = self.find("push button", name)
        return button is not None and button.do_action(0)

    def rest(self, seconds=0.1, *others):
        """Waits until there is nothing to do for the program, for the screen
        and for other processes."""
        sleep_sound([self.process.pid, SERVER, *others], seconds)

    # Actions

    def call(self, method, parameters, path=PATH, name="org.gtk.Actions"):
        return self.bus.call_sync(NAME, path, name, method, parameters, None,
                                  Gio.DBusCallFlags.NO_AUTO_START,
                                  PATIENCE_MS, None)

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
        """The first thing shown of this role, by its name. What is asked may
        be gone before it answers; then all are asked again."""
        found = []

        def look():
            root = self.root()
            found.append(
                root and self.find_below(root, role, name, contains))
            return True
        wait(look, f"an answer: {name or contains or role}")
        return found[-1]

    def the(self, role, name=None, contains=None):
        """What find finds, once it is shown."""
        return wait(lambda: self.find(role, name, contains),
                    name or contains or role)

    def no(self, role, name=None, contains=None):
        """Waits until nothing such is shown."""
        wait(lambda: not self.find(role, name, contains),
             f"{name or contains or role} to go")

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
        """Where it is, when nothing moves."""
        self.rest(0.05)
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
        self.rest()

    def focus_on(self, *names):
        """Waits until one of them has the keyboard."""
        wait(lambda: set(self.focus()) & set(names), f"the focus on {names}")

    def choose_file(self, path):
        """Names a file in the dialog of files, to be written anew."""
        dialog = self.the("file chooser")
        name = wait(lambda: self.find_below(dialog, "text"), "its entry")
        self.rest()  # it proposes a name
        wait(lambda: Atspi.EditableText.set_text_contents(name, path)
             and Atspi.Text.get_text(name, 0, -1) == path, path)
        self.rest()
        wait(lambda: self.find_below(dialog, "push button", "Save"),
             "its button").do_action(0)

    def keys(self, *names):
        box = self.extents(self.the("frame"))
        xdotool("mousemove", box.x + box.width // 2, box.y + 20,
                "key", "--delay", 30, *names)
