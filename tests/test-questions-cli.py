#!/usr/bin/env python3
"""What hull2vd-cli questions writes, read back by parsers of its own and
compared with a key that is computed here: by definition, in fractions, from
the words of the question alone.
"""
import io
import itertools
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
import zipfile
from fractions import Fraction

CLI = os.environ["HULL2VD_CLI"]
SOURCE = pathlib.Path(os.environ["HULL2VD_SOURCE"])
FOLDER = pathlib.Path(tempfile.mkdtemp(prefix="hull2vd-"))
QTI = "{http://www.imsglobal.org/xsd/imsqti_v2p1}"
PACKAGE = "{http://www.imsglobal.org/xsd/imscp_v1p1}"
N_SETS = 8 // int(os.environ.get("HULL2VD_SAMPLE", "1"))

# In the order of the lesson: what has been shown cannot be asked.
ASKS = [
    ("simplex", "click lower-facets"),
    ("simplex", "click facets-seen-by s4"),
    ("simplex", "choose several\noption s4 sees f1 if sees s4 f1\n"
     "option s4 sees f2 if sees s4 f2\noption f0 is {a=b}: ~lower~ if is-lower "
     "f0\noption there is a facet if facets > 0"),
    ("before round 1 choose", "click furthest-site"),
    ("before round 1 see", "click visible-facets"),
    ("before round 1 horizon", "click horizon"),
    ("before round 2 see", "click circles"),
    ("before round 2 horizon", "number horizon cone"),
    ("before round 3 see", "click dying-triangles"),
    ("before round 4 choose", "order phases"),
    ("before round 5 see", "number visible"),
    ("complete", "click unbounded-cells"),
    ("complete", "click neighbours s0"),
    ("complete", "drag s4 until tie"),
    ("complete", "always voronoi-vertices = triangles"),
]


class Fault(Exception):
    """A sentence that turned out false."""


def check(is_true, what):
    if not is_true:
        raise Fault(what)


def run(*arguments):
    return subprocess.run([CLI, "questions", *map(str, arguments)],
                          capture_output=True, timeout=100)


def lesson(name, sites, asks):
    text = f"# {name}/x\n\n```lesson\nformat 1\nsites {sites}\n```\n"
    for position, ask in asks:
        title = f"{position}; {ask.splitlines()[0]}"
        text += f"\n## {title}\n\nWhat?\n\n```ask\n{position}\n{ask}\n```\n"
    path = FOLDER / f"{name}.md"
    path.write_text(text, encoding="utf-8")
    return path


# The judge

def turn(a, b, c):
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def lift(p):
    return (p[0], p[1], p[0] * p[0] + p[1] * p[1])


def volume(a, b, c, d):
    """Of the tetrahedron, six times, signed."""
    u, v, w = ([q[i] - d[i] for i in range(3)] for q in (a, b, c))
    return (u[0] * (v[1] * w[2] - v[2] * w[1])
            - u[1] * (v[0] * w[2] - v[2] * w[0])
            + u[2] * (v[0] * w[1] - v[1] * w[0]))


class Scene:
    """What a question says in words."""

    def __init__(self, given):
        self.sites, self.facet = {}, {}
        self.apex, self.outside = None, []
        hull = None
        for line in given:
            for s, x, y in re.findall(r"s(\d+) \(([^,]+), ([^)]+)\)", line):
                self.sites[int(s)] = (Fraction(x), Fraction(y))
            if line.startswith("On the hull so far"):
                hull = [int(n) for n in re.findall(r"s(\d+)", line)]
            if line.endswith("comes next."):
                self.apex = int(re.match(r"s(\d+)", line).group(1))
            if line.startswith("Outside set"):
                self.outside = [int(n) for n in re.findall(r"s(\d+)", line)]
            named = re.match(r"f(\d+) \(([^,)]*)", line)
            if named:
                self.facet[int(named.group(1))] = corners(named.group(2))
        self.active = sorted(self.sites) if hull is None else hull
        self.facets = {}
        for trio in itertools.combinations(self.active, 3):
            signs = {self.side(trio, s) > 0 for s in self.active
                     if s not in trio}
            if len(signs) == 1:
                self.facets[frozenset(trio)] = signs.pop()

    def side(self, trio, site):
        a, b, c = (lift(self.sites[s]) for s in sorted(trio))
        return volume(a, b, c, lift(self.sites[site]))

    def sees(self, site, facet):
        """All others lie on one side of a facet, and site on the other."""
        value = self.side(facet, site)
        check(value != 0, "a tie")
        return (value > 0) != self.facets[facet]

    def visible(self):
        return {f for f in self.facets if self.sees(self.apex, f)}

    def is_lower(self, facet):
        """Straight below its centre there is nothing of the hull."""
        a, b, c = (lift(self.sites[s]) for s in sorted(facet))
        deep = tuple(sum(p[i] for p in (a, b, c)) / 3 - (i == 2)
                     for i in range(3))
        return (volume(a, b, c, deep) > 0) != self.facets[facet]

    def in_circle(self, trio, site):
        a, b, c = (self.sites[s] for s in sorted(trio))
        area = turn(a, b, c)
        rows = [(p[0] - self.sites[site][0], p[1] - self.sites[site][1])
                for p in (a, b, c)]
        (ax, ay), (bx, by), (cx, cy) = rows
        value = ((ax * ax + ay * ay) * (bx * cy - cx * by)
                 - (bx * bx + by * by) * (ax * cy - cx * ay)
                 + (cx * cx + cy * cy) * (ax * by - bx * ay))
        return value * area > 0

    def horizon(self):
        visible = self.visible()
        count = {}
        for facet in visible:
            for edge in itertools.combinations(sorted(facet), 2):
                count[edge] = count.get(edge, 0) + 1
        return {frozenset(e) for e, n in count.items() if n == 1}

    def extreme(self):
        """Corners: some line through the site leaves all others on a side."""
        return {s for s in self.active if any(
            all(turn(self.sites[s], self.sites[t], self.sites[u]) > 0
                for u in self.active if u not in (s, t))
            for t in self.active if t != s)}

    def neighbours(self, site):
        return {t for f in self.facets if site in f and self.is_lower(f)
                for t in f} - {site}


def corners(words):
    return frozenset(int(n) for n in re.findall(r"s(\d+)", words))


def facet_of(text):
    return corners(re.sub(r"^f\d+ ", "", text))


def site_of(text):
    return int(text[1:])


def key(ask, scene, text):
    """Whether an option is right."""
    if ask == "click lower-facets":
        check("lower" not in text and "upper" not in text, "given away")
        return scene.is_lower(facet_of(text))
    if ask == "click visible-facets":
        return facet_of(text) in scene.visible()
    if ask == "click dying-triangles":
        f = facet_of(text)
        check(("lower" in text) == scene.is_lower(f), "the facing")
        return f in scene.visible() and scene.is_lower(f)
    if ask == "click circles":
        return scene.in_circle(corners(text), scene.apex)
    if ask == "click horizon":
        return corners(text) in scene.horizon()
    if ask == "click facets-seen-by s4":
        return scene.sees(4, facet_of(text))
    if ask == "click furthest-site":
        f, s = next(iter(scene.facet.values())), site_of(text)
        return s in scene.outside and all(
            abs(scene.side(f, s)) >= abs(scene.side(f, t))
            for t in scene.outside)
    if ask == "click unbounded-cells":
        return site_of(text) in scene.extreme()
    if ask == "click neighbours s0":
        return site_of(text) in scene.neighbours(0)
    if ask == "choose several":
        if text == "there is a facet":
            return True
        if text == "f0 is {a=b}: ~lower~":
            return scene.is_lower(scene.facet[0])
        site, facet = map(int, re.findall(r"\d+", text))
        return scene.sees(site, scene.facet[facet])
    if ask.startswith("always"):
        return text.startswith("No")
    raise Fault(f"no key for {ask}")


def number(label, scene):
    if label == "facets that are visible" or "visible" in label:
        return len(scene.visible())
    return len(scene.horizon())


# GIFT

def unescape(text):
    return re.sub(r"\\(.)", r"\1", text)


def words(html):
    text = re.sub(r"<[^>]*>", "", html)
    for entity, sign in (("&lt;", "<"), ("&gt;", ">"), ("&quot;", '"'),
                         ("&apos;", "'"), ("&#39;", "'"), ("&amp;", "&")):
        text = text.replace(entity, sign)
    return text.strip()


def cut(text, sign):
    """At the sign where no backslash stands before it."""
    return re.split(r"(?<!\\)" + re.escape(sign), text)


class Item:
    """A question as a bank tells it."""

    def __init__(self, title, given, form):
        self.title, self.given, self.form = title, given, form
        self.options = []  # (text, is right, reason)
        self.number, self.order = None, []

    def __eq__(self, other):
        return vars(self) == vars(other)


def read_gift(text):
    items, category = [], None
    for block in text.split("\n\n"):
        if block.startswith("$CATEGORY: "):
            category = block[11:]
        elif block.strip():
            check(category is not None, "no category")
            items.append(read_gift_item(block))
    return items


def read_gift_item(block):
    match = re.fullmatch(
        r"::((?:[^\\:]|\\.)*)::\[html\]((?:[^\\{}]|\\.)*)"
        r"\{\n((?:[^\\{}]|\\.)*)\}", block, re.S)
    check(match is not None, f"no GIFT: {block[:200]}")
    title, stem, body = match.groups()
    given = [words(p) for p in re.findall(r"<p>(.*?)</p>", unescape(stem))]
    item = Item(words(unescape(title)), given[1:], None)
    whole = cut(body, "####")
    for line in whole[0].splitlines():
        read_gift_line(item, line)
    if item.form == "several":
        total = sum(o[3] for o in item.options if o[3] > 0)
        check(abs(total - 100) < 0.001, f"{total} %")
        check(all(o[3] in (-100, item.options[0][3]) or o[3] > 0
                  for o in item.options), "a weight")
        item.options = [o[:3] for o in item.options]
    return item


def read_gift_line(item, line):
    if line.startswith("#"):
        item.form = "number"
        item.number = int(re.fullmatch(r"#=(\d+):0", line).group(1))
    elif " -> " in line:
        item.form = "order"
        place, text = line[1:].split(" -> ")
        check(int(place) == len(item.order) + 1, "places")
        item.order.append(words(unescape(text)))
    else:
        text, *reason = cut(line[1:], "#")
        reason = words(unescape(reason[0])) if reason else None
        weight = re.match(r"%(-?[\d.]+)%", text)
        item.form = "several" if weight else "one"
        if weight:
            value = float(weight.group(1))
            item.options.append((words(unescape(text[weight.end():])),
                                 value > 0, reason, value))
        else:
            item.options.append((words(unescape(text)), line[0] == "=",
                                 reason))


# QTI

def read_qti(data):
    package = zipfile.ZipFile(io.BytesIO(data))
    check(package.testzip() is None, "a broken zip")
    files = {n: ET.fromstring(package.read(n)) for n in package.namelist()}
    for name in files:
        lint = subprocess.run(["xmllint", "--noout", "--nonet", "-"],
                              input=package.read(name), capture_output=True)
        check(lint.returncode == 0, lint.stderr.decode())
    check_manifest(files)
    test = files["assessment.xml"]
    check(test.tag == QTI + "assessmentTest", test.tag)
    refs = [r.get("href") for r in test.iter(QTI + "assessmentItemRef")]
    check(sorted(refs) == sorted(n for n in files if n.startswith("items/")),
          "the test's items")
    return [read_qti_item(files[name]) for name in refs]


def check_manifest(files):
    manifest = files["imsmanifest.xml"]
    check(manifest.tag == PACKAGE + "manifest", manifest.tag)
    resources = list(manifest.iter(PACKAGE + "resource"))
    listed = [f.get("href") for f in manifest.iter(PACKAGE + "file")]
    check(sorted(listed) == sorted(set(files) - {"imsmanifest.xml"}),
          "the manifest's files")
    names = {r.get("identifier") for r in resources}
    check(len(names) == len(resources), "names twice")
    for dependency in manifest.iter(PACKAGE + "dependency"):
        check(dependency.get("identifierref") in names, "a dependency")
    check({r.get("type") for r in resources} == {
        "imsqti_test_xmlv2p1", "imsqti_item_xmlv2p1"}, "types")


def check_item(root):
    """References lead somewhere, and the parts stand in their order."""
    check(root.tag == QTI + "assessmentItem", root.tag)
    check(re.fullmatch(r"[A-Za-z_][\w.-]*", root.get("identifier")), "a name")
    order = [child.tag[len(QTI):] for child in root]
    ranks = ["responseDeclaration", "outcomeDeclaration", "itemBody",
             "responseProcessing", "modalFeedback"]
    check([ranks.index(t) for t in order]
          == sorted(ranks.index(t) for t in order), "the order of parts")
    declared = {c.get("identifier") for c in root
                if c.tag.endswith("Declaration")}
    for node in root.iter():
        for name in ("responseIdentifier", "outcomeIdentifier"):
            check(node.get(name, "SCORE") in declared, f"{name} of {node.tag}")
        if node.tag in (QTI + "variable", QTI + "correct",
                        QTI + "mapResponse", QTI + "setOutcomeValue"):
            check(node.get("identifier") in declared, node.tag)


def text_of(node):
    return " ".join("".join(node.itertext()).split())


def read_qti_item(root):
    check_item(root)
    body = root.find(QTI + "itemBody")
    response = root.find(QTI + "responseDeclaration")
    correct = [v.text for v in response.find(QTI + "correctResponse")]
    mapped = [e.get("mapKey") for e in response.iter(QTI + "mapEntry")]
    given = [text_of(p) for p in body.findall(QTI + "p")][1:]
    title = root.get("title").split("/x: ", 1)[-1]
    item = Item(title, given, None)
    choice, order = (body.find(QTI + t) for t in ("choiceInteraction",
                                                  "orderInteraction"))
    if choice is not None:
        is_one = choice.get("maxChoices") == "1"
        item.form = "one" if is_one else "several"
        check(response.get("cardinality")
              == ("single" if is_one else "multiple"), "cardinality")
        for option in choice:
            reason = option.find(QTI + "feedbackInline")
            name = option.get("identifier")
            item.options.append((
                option.text.strip(), name in (mapped if is_one else correct),
                None if reason is None else text_of(reason)))
        check(not is_one or (len(correct) == 1 and correct[0] in mapped),
              "the correct one")
    elif order is not None:
        item.form = "order"
        check(response.get("cardinality") == "ordered", "cardinality")
        texts = {c.get("identifier"): text_of(c) for c in order}
        item.order = [texts[name] for name in correct]
    else:
        item.form = "number"
        check(response.get("baseType") == "integer", "baseType")
        item.number = int(correct[0])
        item.given = [g for g in item.given if g]
    return item


# Tests

def judge(item):
    position, ask = item.title.split("; ", 1)
    del position
    if ask == "order phases":
        check([o.split()[0] for o in item.order]
              == ["choose", "find", "find", "build", "retire,"], "phases")
        return
    scene = None if ask.startswith("always") else Scene(item.given)
    if ask.startswith("number"):
        label = re.search(r"How many: (.*)\?", item.given[-1]).group(1)
        check(scene.apex is not None, "the site in hand")
        check(item.number == number(label, scene),
              f"{label}: {item.number}, not {number(label, scene)}")
        return
    check(any(o[1] for o in item.options), "nothing is right")
    for text, is_right, reason in item.options:
        check(is_right == key(ask, scene, text), f"{ask}: {text} {is_right}")
        check(reason, f"{ask}: {text} has no reason")
    if ask in ("click visible-facets", "click lower-facets"):
        check({facet_of(o[0]) for o in item.options} == set(scene.facets),
              "not all facets")


def every_answer_is_the_one_of_the_definition():
    n_sets = 0
    for seed in itertools.count():
        path = lesson(f"set{seed}", f"random 9 seed {seed}", ASKS)
        done = run("--format", "gift", path)
        errors = done.stderr.decode().splitlines()
        if done.returncode == 2 and "the answer is empty" in errors[0]:
            check(seed < 4 * N_SETS, "no sets")
            continue  # a site may see upper facets alone
        check(done.returncode == 0, done.stderr.decode())
        check(len(errors) == 1 and errors[0].startswith(f"{path}:")
              and "dragging" in errors[0], f"left out: {errors}")
        items = read_gift(done.stdout.decode())
        check(len(items) == len(ASKS), f"{len(items)} questions")
        for item in items:
            judge(item)
        n_sets += 1
        if n_sets == N_SETS:
            break


def both_forms_say_the_same():
    path = lesson("both", "random 9 seed 4", ASKS)
    out = FOLDER / "both.zip"
    check(run("--format", "qti", path, "-o", out).returncode == 0, "status")
    gift = read_gift(run("--format", "gift", path).stdout.decode())
    qti = read_qti(out.read_bytes())
    check(len(gift) == len(qti), f"{len(gift)} and {len(qti)}")
    for left, right in zip(gift, qti):
        check(left == right, f"{vars(left)}\n# {vars(right)}")


def the_lessons_of_the_program_make_a_bank():
    paths = sorted((SOURCE / "lessons").glob("[0-9]*.md"))
    done = run("--format", "qti", *paths)
    check(done.returncode == 0, done.stderr.decode())
    items = read_qti(done.stdout)
    left_out = done.stderr.decode().splitlines()
    asked = sum(p.read_text(encoding="utf-8").count("\n```ask\n")
                for p in paths)
    check(len(items) + len(left_out) >= asked, "some are lost")
    check(len(items) > 3 * len(left_out), f"{len(left_out)} left out")
    check(all("left out: " in line for line in left_out), "a reason")


def tied_answers_each_have_the_whole_grade():
    path = lesson("tied", "0 0; 4 0; 0 4; 5 5; 2 1; 1 2",
                  [("before round 1 choose", "click furthest-site")])
    items = read_gift(run("--format", "gift", path).stdout.decode())
    right = [o[0] for o in items[0].options if o[1]]
    check(items[0].form == "one" and right == ["s4", "s5"], f"{right}")


def the_same_lesson_makes_the_same_bytes():
    path = lesson("same", "random 9 seed 4", ASKS)
    first, second = (run("--format", "qti", path).stdout for _ in range(2))
    check(first and first == second, "they differ")


def what_is_wrong_writes_nothing():
    good = lesson("good", "random 9 seed 4", ASKS)
    bad = FOLDER / "bad.md"
    bad.write_text("# T\n\n```lesson\nformat 1\nsites 0 0\n```\n\n## S\n\n"
                   "```steps\ngotto start\n```\n", encoding="utf-8")
    out = FOLDER / "none.txt"
    for status, arguments in (
            (2, ("--format", "gift", good, bad)),
            (66, ("--format", "gift", FOLDER / "missing.md")),
            (64, ("--format", "pdf", good)), (64, (good,)),
            (64, ("--format", "gift"))):
        done = run(*arguments, "-o", out)
        check(done.returncode == status, f"{arguments}: {done.returncode}")
        check(done.stderr and not done.stdout and not out.exists(), "output")
    check(f"{bad}:11:1: ".encode() in run("--format", "qti", bad).stderr,
          "FILE:LINE:COL")
    done = run("--format", "gift", good, "-o", FOLDER / "no" / "where")
    check(done.returncode == 73, "cannot write")


def main():
    tests = [every_answer_is_the_one_of_the_definition,
             both_forms_say_the_same, the_lessons_of_the_program_make_a_bank,
             tied_answers_each_have_the_whole_grade,
             the_same_lesson_makes_the_same_bytes,
             what_is_wrong_writes_nothing]
    n_failed = 0
    print(f"1..{len(tests)}")
    for count, test in enumerate(tests, 1):
        name = f"{count} - {test.__name__.replace('_', ' ')}"
        try:
            test()
            print(f"ok {name}", flush=True)
        except Fault as fault:
            n_failed += 1
            print(f"# {fault}\nnot ok {name}", flush=True)
    subprocess.run(["rm", "-rf", FOLDER], check=True)
    return 1 if n_failed else 0


if __name__ == "__main__":
    sys.exit(main())
