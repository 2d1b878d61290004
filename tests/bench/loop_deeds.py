"""What a person does with many sites, for loop.py. Each function is a part;
its deeds stand alone, so that any of them can be measured."""
import os
import time

from program import GLib, wait, xdotool


def text(value):
    return GLib.Variant("s", value)


def place(canvas, x, y):
    return (round(canvas.x + x * canvas.width),
            round(canvas.y + y * canvas.height))


def opening(bench, p, n):
    bench.time("open a file", bench.load)
    bench.load()


def load_again(bench):
    while bench.p.state("n-sites") < bench.n:
        bench.p.activate("undo")
    bench.save()
    bench.load()


def steps(bench, p, n):
    def middle():
        p.activate("goto", text(f"round {n // 2} see"))

    def race():
        for _ in range(10):
            p.activate("next-round")

    def scrub():
        for i in range(20):
            p.activate("goto-step",
                       GLib.Variant("u", p.state("n-steps") * i // 20))
            time.sleep(0.03)

    def play():
        p.set_state("play", GLib.Variant("b", True))
        time.sleep(3)
        p.set_state("play", GLib.Variant("b", False))

    def last():
        p.activate("last")

    bench.do("to the start", "first")
    bench.do("to the end", "last")
    for grain in "event", "phase", "round":
        bench.do(f"back: {grain}", "back-" + grain, before=last)
    bench.time("go to a round", middle)
    for grain in "event", "phase", "round":
        bench.do(f"next: {grain}", "next-" + grain, before=middle)
    bench.time("ten rounds at once", race, middle)
    bench.time("scrub", scrub)
    bench.time("play", play, middle)
    p.activate("last")


def pointing(bench, p, n):
    plane, space = p.extents(bench.plane), p.extents(bench.space)

    def hover(canvas):
        for i in range(30):
            p.point(*place(canvas, 0.3 + i / 80, 0.4 + i / 90))
            time.sleep(0.02)

    def turn():
        p.drag(place(space, 0.5, 0.9), place(space, 0.8, 0.8))

    def show(*layers):
        for layer in "preview", "why":
            p.set_state("layer-" + layer, GLib.Variant("b", layer in layers))

    def hold():
        xdotool("mousemove", *place(plane, 0.453, 0.577), "mousedown", 1)
        time.sleep(1)
        for i in range(5):
            p.point(*place(plane, 0.45 + i / 50, 0.58))
            time.sleep(0.1)
        xdotool("mouseup", 1)

    def band():
        xdotool("keydown", "ctrl")
        p.drag(place(plane, 0.1, 0.1), place(plane, 0.9, 0.9))
        xdotool("keyup", "ctrl")

    def first_hover(canvas):
        p.point(*place(canvas, 0.5, 0.5))

    def another_step():
        p.point(plane.x + 5, plane.y - 30)
        p.activate("back-round")

    bench.time("first hover over the plane", lambda: first_hover(plane),
               another_step)
    bench.time("first hover over space", lambda: first_hover(space),
               another_step)
    bench.time("hover over the plane", lambda: hover(plane), show)
    bench.time("hover over space", lambda: hover(space), show)
    bench.time("hover with a preview", lambda: hover(plane),
               lambda: show("preview"))
    bench.time("first hover with a preview", lambda: first_hover(plane),
               another_step)

    def why():
        show("why")
        p.activate("select", text("f9"))

    bench.time("hover with why it works", lambda: hover(plane), why)
    bench.do("measure the next site", "measure-next", before=why)
    bench.time("hold the button", hold, show)
    bench.time("select by a band", band, show)
    p.activate("select-none")
    bench.time("click a site", lambda: p.click(*place(plane, 0.5, 0.5)))
    p.activate("last")
    bench.time("turn space", turn)
    bench.do("look down", "camera-look-down")
    bench.do("look home", "camera-home")
    bench.time("zoom in", lambda: xdotool(
        "mousemove", *place(plane, 0.5, 0.5), "click", "--repeat", 6, 4))
    bench.time("pan", lambda: p.drag(place(plane, 0.5, 0.5),
                                     place(plane, 0.6, 0.6), button=2))
    bench.do("fit", "fit")

    def focus():
        p.click(*place(plane, 0.5, 0.5))

    bench.time("Tab", lambda: xdotool("key", "--delay", 100, "Tab", "Tab",
                                      "Tab"), focus)
    bench.time("Shift Tab", lambda: xdotool("key", "shift+Tab"))
    bench.time("arrow", lambda: xdotool("key", "--delay", 100, "Right", "Up"))
    bench.time("look for something by AT-SPI",
               lambda: p.find("push button", "Nothing"))
    bench.time("menu of a site", lambda: xdotool("key", "Menu"))
    xdotool("key", "Escape")


def edit(bench, p, n):
    far = GLib.Variant("(udd)", (5, 0.4001, 0.6001))

    def add():
        p.activate("add-site", GLib.Variant("(dd)", (0.501, 0.502)))

    def undo():
        p.activate("undo")

    def site():
        p.activate("select", text("s5"))

    def every():
        p.activate("select-all")

    bench.time("add a site", add)
    bench.do("undo", "undo", before=add)
    bench.do("redo", "redo", before=lambda: (add(), time.sleep(2), undo()))
    bench.do("move a site", "move-site", far)
    if bench.wants("drag a site"):
        p.activate("fit")
        box = p.extents(bench.plane.get_child_at_index(5))
        ends = place(box, 0.5, 0.5), place(p.extents(bench.plane), 0.4, 0.4)
        bench.time("drag a site", lambda: p.drag(*ends))
    bench.do("remove a site", "remove-site", GLib.Variant("u", 7))
    bench.do("nudge", "nudge", text("right"), before=site)
    bench.time("the unsaved sites are kept",
               lambda: (add(), time.sleep(4)))

    def type_site():
        p.activate("add-site-at")
        time.sleep(1)
        xdotool("type", "0.123 0.456")
        xdotool("key", "Return")

    bench.time("type a site", type_site)
    bench.do("select all", "select-all")
    bench.do("select none", "select-none", before=every)
    bench.do("select several", "select-sites",
             GLib.Variant("au", range(0, n, 3)))
    bench.do("add one to all selected", "toggle-site", GLib.Variant("u", 9),
             before=every)
    bench.do("a step with all selected", "back-event", before=every)
    bench.do("nudge all", "nudge", text("left"), before=every)
    p.activate("select-none")
    bench.do("copy the sites", "copy")
    bench.do("paste them", "paste",
             before=lambda: (p.activate("copy"), time.sleep(2)))
    bench.do("delete a selection", "delete-selection",
             before=lambda: p.activate("select-sites",
                                       GLib.Variant("au", [1, 3, 5])))
    bench.do("delete all but three", "delete-selection",
             before=lambda: p.activate(
                 "select-sites", GLib.Variant("au", range(3, n - 3))))
    bench.do("generate", "sites", text(f"random {n} seed 5"))
    if bench.wants("delete all but three") or bench.wants("generate"):
        load_again(bench)
    bench.do("order: input", "order", text("input"))
    bench.do("order: furthest", "order", text("furthest"))


def look(bench, p, n):
    for layer in ("hull paraboloid delaunay voronoi circumcircles lifts "
                  "labels furthest tangents why preview").split():
        shown = p.state("layer-" + layer)
        for state in (not shown, shown):
            bench.keep(f"layer {layer} {'on' if state else 'off'}",
                       "layer-" + layer, GLib.Variant("b", state))

    def slide(action):
        for i in list(range(10, -1, -2)) + list(range(0, 11, 2)):
            p.set_state(action, GLib.Variant("d", i / 10))
            time.sleep(0.02)

    for theme in "dark", "projector", "print", "contrast", "paper", "light":
        bench.keep("theme " + theme, "theme", text(theme))
    for action in "lift", "opacity-hull":
        bench.time(f"the slider {action}", lambda a=action: slide(a))
    bench.keep("larger marks", "mark-scale", GLib.Variant("d", 2))
    bench.keep("marks as they were", "mark-scale", GLib.Variant("d", 1))
    bench.do("focus: horizon", "focus", text("horizon"))
    bench.do("focus: active", "focus", text("active"))
    bench.do("select a site", "select", text("s9"))
    bench.do("select a facet", "select", text("f9"))
    bench.do("views: plane", "views", text("plane"))
    bench.do("views: both", "views", text("both"))
    for state in True, False:
        bench.keep("space apart" if state else "space back", "detach-space",
                   GLib.Variant("b", state))
    bench.time("a smaller window", lambda: p.resize(1200, 760))
    bench.time("a larger window", lambda: p.resize(1440, 900))


def files(bench, p, n):
    def write(name):
        """Types where the picture is to go, as a person does."""
        path = os.path.join(bench.folder, name)
        dialog = wait(lambda: p.find("file chooser"), "the dialog of files")
        box = p.extents(dialog)
        p.point(box.x + box.width // 2, box.y + 12)
        time.sleep(0.5)
        xdotool("key", "ctrl+a")
        xdotool("type", "--delay", 5, path)
        xdotool("key", "Return")
        wait(lambda: os.path.exists(path), f"{name}")
        os.remove(path)

    def export(name):
        p.activate("export-picture")
        wait(lambda: p.find("push button", "Export…"),
             "the question of what").do_action(0)
        write(name)

    def storyboard():
        p.activate("storyboard")
        write("pages.pdf")

    bench.do("save", "save")
    bench.do("copy a picture", "copy-picture")
    for name in "out.svg", "out.pdf", "out.png":
        bench.time(f"export {name}", lambda f=name: export(f))
    bench.time("storyboard", storyboard)
    bench.do("new", "new", before=bench.save)
    load_again(bench)


def compare(bench, p, n):
    def both():
        p.activate("compare", text("furthest input"))

    bench.time("compare", both)
    bench.do("compare: to the middle", "goto", text(f"round {n // 2} see"),
             before=both)
    bench.do("compare: next round", "next-round", before=both)
    bench.do("compare: next event", "next-event", before=both)
    bench.do("compare in space", "compare-view", text("space"), before=both)
    bench.do("compare other orders", "compare", text("input hilbert"))
    bench.do("compare: no more", "compare", text("none"))
    p.activate("compare", text("none"))
    p.activate("order", text("furthest"))


def views(bench, p, n):
    for view in "planar", "rounded", "signs":
        def show(name=view):
            p.activate("view", text(name))

        bench.time(f"view {view}", show)
        for name, action in (("to the start", "first"),
                             ("next event", "next-event"),
                             ("next round", "next-round"),
                             ("to the end", "last")):
            if view != "signs":
                bench.do(f"{view}: {name}", action, before=show)
        bench.do(f"{view}: select all", "select-all", before=show)
        bench.do(f"{view}: add a site", "add-site",
                 GLib.Variant("(dd)", (0.7, 0.7 + len(view) / 1000)),
                 before=show)
        bench.keep(f"{view}: theme dark", "theme", text("dark"), before=show)
        bench.keep(f"{view}: theme light", "theme", text("light"))
    bench.do("signs: another node", "node", GLib.Variant("(uu)", (3, 4)),
             before=lambda: p.activate("view", text("signs")))
    bench.do("view lifts", "view", text("lifts"))
    p.activate("view", text("lifts"))


LESSON = """# Many sites

One stop to look at, one with a question.

```lesson
format 1
sites random {n} seed 5
```

## One

Many.

```steps
goto before round {middle} see
```

## What does it see?

```ask
before round {middle} see
click visible-facets
```

## Two

Many.

```steps
goto round {middle} horizon
```
"""


def lesson(bench, p, n):
    n = min(n, 20000)  # more a lesson may not have
    path = os.path.join(bench.folder, f"many-{n}.md")
    with open(path, "w", encoding="utf-8") as file:
        file.write(LESSON.format(n=n, middle=n // 2))

    def load():
        p.activate("open-file", text(path))
        wait(lambda: p.state("n-stops") == 3, "the lesson")

    bench.time("open a lesson", load, bench.save)
    if not bench.wants("open a lesson") and not bench.wants("lesson:"):
        return
    bench.save()
    load()
    bench.do("lesson: show the answer", "show-answer")
    bench.do("lesson: next stop", "next-stop")
    bench.do("lesson: previous stop", "previous-stop")
    bench.do("lesson: another", "another")
    bench.do("lesson: perform", "perform", text("2"))


PARTS = [opening, steps, pointing, edit, look, files, compare, views, lesson]
