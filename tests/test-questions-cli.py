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

from question_judge import Fault, check, corners, facet_of, key, number, Scene

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
              == ["choose", "find", "find", "build", "retire"], "phases")
        return
    scene = None if ask.startswith("always") else Scene(item.given)
    if ask.startswith("number"):
        label = re.search(r"How many: (.*)\?", item.given[-1]).group(1)
        check(scene.apex is not None, "the current site")
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
