#!/usr/bin/env python3
"""Handouts as hull2vd-cli writes them, judged by what poppler reads in them and
by the lessons' own text."""
import html
import os
import pathlib
import re
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(os.environ["HULL2VD_SOURCE"])
CLI = os.environ["HULL2VD_CLI"]
LESSONS = sorted((SOURCE / "lessons").glob("[0-9][0-9]-*.md"))
# What is the same for all is seen on one lesson in three, but in ./dev soak.
SAMPLE = LESSONS if "HULL2VD_SOAK" in os.environ else LESSONS[1::3]
INSIDE = SOURCE / "lessons" / "07-one-insertion-inside.md"
PAPERS = {"a4": (595.276, 841.89), "letter": (612, 792)}
MARGIN = 28  # pt, that no printer reaches
FOLDER = tempfile.TemporaryDirectory()


class Fault(Exception):
    """A sentence that turned out false."""


def check(holds, reason):
    if not holds:
        raise Fault(reason)


LANGUAGE = {"LC_ALL": "C.UTF-8"}


def run(*arguments):
    return subprocess.run([*map(str, arguments)], capture_output=True, check=False,
                          env={**os.environ, **LANGUAGE})


def write(lesson, *options, name="out.pdf"):
    """Returns: the handout's path."""
    path = pathlib.Path(FOLDER.name) / name
    process = run(CLI, "handout", lesson, "-o", path, *options)
    check(process.returncode == 0 and not process.stderr,
          f"{lesson.name} {options}: {process.returncode} {process.stderr.decode()}")
    return path


def text_of(path):
    """Its words, as they are read: line ends are spaces."""
    return " ".join(run("pdftotext", "-raw", path, "-").stdout.decode().split())


def layout_of(path):
    """The words of each page with their boxes."""
    pages = []
    for line in run("pdftotext", "-bbox", path, "-").stdout.decode().splitlines():
        numbers = [float(n) for n in re.findall(r'="([-\d.]+)"', line)]
        if "<page" in line:
            pages.append((numbers, []))
        elif "<word" in line:
            word = re.sub("<[^>]*>", "", line).strip()
            pages[-1][1].append((html.unescape(word), numbers))
    return pages


def info_of(path, *options):
    lines = run("pdfinfo", *options, path).stdout.decode().splitlines()
    return dict(line.split(":", 1) for line in lines if ":" in line)


def outline_of(path):
    """The titles in the outline, in the order of the file."""
    titles = []
    for match in re.finditer(rb"<< /Title (\((?:\\.|[^\\)])*\)|<[0-9A-Fa-f]*>)",
                             path.read_bytes()):
        raw = match.group(1)
        if raw.startswith(b"<"):
            titles.append(bytes.fromhex(raw[1:-1].decode())[2:].decode("utf-16-be"))
        else:
            titles.append(re.sub(rb"\\(.)", rb"\1", raw[1:-1]).decode())
    return titles


def plain(markdown):
    return re.sub(r"[*`]", "", markdown).strip()


def stops_of(lesson):
    text = lesson.read_text(encoding="utf-8")
    return [plain(t) for t in re.findall(r"^## (.*)$", text, re.M)]


def fits(path, paper):
    width, height = PAPERS[paper]
    for numbers, words in layout_of(path):
        check(abs(numbers[0] - width) < 1 and abs(numbers[1] - height) < 1,
              f"{path}: a page of {numbers}")
        for word, (left, top, right, bottom) in words:
            check(left >= MARGIN and top >= MARGIN - 8 and right <= width - MARGIN
                  and bottom <= height - 20, f"“{word}” at {left} {top} {right} {bottom}")


def a_lesson_without_options_is_one_page():
    for lesson in LESSONS:
        for paper in PAPERS if lesson in SAMPLE else ("a4",):
            path = write(lesson, "--paper", paper)
            pages = info_of(path)["Pages"].strip()
            check(pages == "1", f"{lesson.name} on {paper}: {pages} pages")
            fits(path, paper)
            title = plain(lesson.read_text(encoding="utf-8").splitlines()[0][2:])
            text = text_of(path)
            for words in (title, "Terms and facts", "Sources"):
                check(words in text, f"{lesson.name} on {paper}: no “{words}”")


def full_handouts_have_every_stop_and_its_text():
    for lesson in SAMPLE:
        path = write(lesson, "--full")
        fits(path, "a4")
        text, outline = text_of(path), outline_of(path)
        for number, title in enumerate(stops_of(lesson), 1):
            check(f"{number} {title}" in text, f"{lesson.name}: no stop “{title}”")
            check(title in outline, f"{lesson.name}: “{title}” is not in the outline")
    text = text_of(write(INSIDE, "--full"))
    for words in ("C ← cone from p over H", "s4 sees f1: its circle contains s4."):
        check(words in text, f"no “{words}”")


def nothing_is_lost_of_long_texts_and_words():
    long = " ".join(f"Wortungetüm{i}zusammengesetzt" for i in range(300))
    lesson = pathlib.Path(FOLDER.name) / "long.md"
    lesson.write_text(f"# {'Überschriften ' * 12}\n\n{long}\n\n```lesson\nformat 1\n"
                      "sites 0 0; 1 0; 0 1; 1 1.5; 0.5 0.25\nminutes 3\n```\n\n"
                      f"## {'Auch Stationen haben lange Namen ' * 6}\n\n{long}\n\n"
                      "```steps\ngoto round 1 see\nexpect visible 2\n```\n\n"
                      f"> Note: {long}\n", encoding="utf-8")
    path = write(lesson, "--notes")
    fits(path, "a4")
    letters = re.sub(r"\W", "", text_of(path))
    for i in range(300):
        n = letters.count(f"Wortungetüm{i}zusammengesetzt")
        check(n == 3, f"word {i} is there {n} times, not 3")
    path = write(lesson)
    check(info_of(path)["Pages"].strip() == "1", "it is not one page")
    fits(path, "a4")


def every_language_has_its_place():
    english = text_of(write(INSIDE, "--full"))
    for language in "de_DE.UTF-8", "es_ES.UTF-8":
        LANGUAGE["LC_ALL"] = language
        try:
            for lesson in SAMPLE:
                path = write(lesson)
                check(info_of(path)["Pages"].strip() == "1", f"{lesson.name} in {language}")
                fits(path, "a4")
            for options in ("--notes", "--steps"), ("--blanks", "--key"):
                path = write(INSIDE, *options)
                fits(path, "a4")
            check(text_of(path)[:60] != english[:60], f"{language} is English")
        finally:
            LANGUAGE["LC_ALL"] = "C.UTF-8"


def blanks_hide_what_the_key_tells():
    for lesson in SAMPLE:
        key = text_of(write(lesson, "--key", name="key.pdf"))
        path = write(lesson, "--blanks")
        fits(path, "a4")
        blanks = text_of(path)
        told = re.findall(r"[sf]\d+ sees f\d+: it lies [^.]*\.", key)
        told += re.findall(r"The circle of f\d+ contains [^.]*\.", key)
        told += re.findall(r"“[^”]*” is right", key)
        told += re.findall(r"Answer: \S+", key)
        for words in told:
            check(words not in blanks, f"{lesson.name}: “{words}” in the blanks")
        check("Answer:" not in blanks, f"{lesson.name}: an answer in the blanks")
        prompts = re.findall(r"^prompt (.*)$", lesson.read_text(encoding="utf-8"), re.M)
        check(told or not prompts, f"{lesson.name}: the key tells nothing")
        for prompt in prompts:
            for words in (key, blanks):
                check(plain(prompt)[:30] in words, f"{lesson.name}: no “{prompt}”")


def the_key_is_what_the_lesson_says():
    key = text_of(write(INSIDE, "--key"))
    for words in ("Answer: s4, s5, s6, s7", "facets of the cone 4",
                  "triangles that die 4 triangles that are born 6",
                  "s5 sees f4: it lies inside f4’s circle, by a power of −"):
        check(words in key, f"no “{words}”")


def the_legend_names_what_the_pictures_show():
    path = write(INSIDE, "--full")
    text = " ".join(text_of(path).split())
    check("Legend" in outline_of(path), "it is not in the outline")
    for words in ("Legend", "Delaunay edge", "horizon", "new site p", "cone: lower"):
        check(words in text, f"no “{words}”")
    check("missed" not in text, "somebody has missed something")
    text = text_of(write(INSIDE, "--steps"))
    check("p sees: lower" in text and "furthest cell" not in text, "that of the steps")
    check("Legend" not in text_of(write(INSIDE)), "there is no room for it on one page")


def each_insertion_has_four_panels():
    path = write(INSIDE, "--steps")
    fits(path, "a4")
    text = text_of(path)
    for number, site in enumerate((4, 5, 6, 7), 1):
        check(f"Round {number}: s{site}" in text, f"no round {number}")
        check(f"Round {number}: s{site}" in outline_of(path), f"{number} not in outline")
    for words in ("Before", "Visible", "Cone", "After"):
        check(len(re.findall(rf"\b{words}\b", text)) == 4, f"“{words}” is not there 4 times")
    for words in ("s4 sees 2 facets: f0, f1.", "4 = 2 + 2", "6 = 2·5 − 4", "12 = 2·8 − 4"):
        check(words in text, f"no “{words}”")


def notes_are_for_the_lecturer_alone():
    words = "trace the four ridges in both views"
    times = "0:00"
    notes = text_of(write(INSIDE, "--notes"))
    check(words in notes.lower() and times in notes and "15:00" in notes, "no notes")
    for options in ((), ("--full",), ("--blanks",), ("--key",), ("--steps",)):
        text = text_of(write(INSIDE, *options))
        check(words not in text.lower() and times not in text, f"notes with {options}")


def the_same_lesson_gives_the_same_bytes():
    for options in ((), ("--notes", "--steps", "--key"), ("--blanks", "--theme", "light")):
        first = write(INSIDE, *options, name="first.pdf").read_bytes()
        second = write(INSIDE, *options, name="second.pdf").read_bytes()
        check(first == second, f"{options}: other bytes")


def options_matter():
    seen = {}
    for options in ((), ("--full",), ("--steps",), ("--notes",), ("--blanks",), ("--key",),
                    ("--blanks", "--key"), ("--paper", "letter"), ("--theme", "light"),
                    ("--theme", "dark"), ("--line-scale", "2"), ("--text-scale", "1.5")):
        pages = write(INSIDE, *options).read_bytes()
        check(pages not in seen, f"{options} is like {seen.get(pages)}")
        seen[pages] = options


def the_file_says_what_it_is():
    path = write(INSIDE, "--blanks", "--key")
    info = info_of(path)
    check(info["Title"].strip() == "One insertion inside, in two worlds", info["Title"])
    check("lesson" in info["Subject"], "no subject")
    check(info["Tagged"].strip() == "yes", "no structure")
    check("2004" in info["CreationDate"], "the time of making is in it")
    lesson = pathlib.Path(FOLDER.name) / "author.md"
    text = INSIDE.read_text(encoding="utf-8")
    lesson.write_text(text.replace("format 1\n", "format 1\nauthor A. N. Other\n", 1),
                      encoding="utf-8")
    for options in (), ("--full",):
        named = write(lesson, *options, name="author.pdf")
        check(info_of(named)["Author"].strip() == "A. N. Other", "another author")
        check("A. N. Other · 15 minutes" in text_of(named), "the author is not named")
    places = run("pdfinfo", "-dests", path).stdout.decode()
    for name in ("stop-1", "stop-18", "key-5", "key-18"):
        check(f'"{name}"' in places, f"no place {name}")
    check(path.read_bytes().count(b"/Subtype /Link") >= 7, "no links")


def what_cannot_be_is_refused():
    folder = pathlib.Path(FOLDER.name)
    points = folder / "points.txt"
    points.write_text("0 0\n1 0\n0 1\n1 1.5\n", encoding="utf-8")
    broken = folder / "broken.md"
    broken.write_text("# T\n\n```lesson\nformat 1\nsites 0 0\n```\n\n## S\n\n"
                      "```steps\njump\n```\n", encoding="utf-8")
    out = folder / "never.pdf"
    for status, words, arguments in (
            (64, "no output file is given", (INSIDE,)),
            (64, "no file is given", ("-o", out)),
            (64, "there is no paper “a5”; the papers are a4, letter",
             ("--paper", "a5", "-o", out, INSIDE)),
            (64, "there is no theme “red”", ("--theme", "red", "-o", out, INSIDE)),
            (66, "nowhere.md", ("-o", out, folder / "nowhere.md")),
            (2, "broken.md:11:1: ", ("-o", out, broken)),
            (1, "points.txt: a handout needs a lesson", ("-o", out, points)),
            (73, "out.pdf", ("-o", folder / "nowhere" / "out.pdf", INSIDE)),
            (73, "/dev/full", ("-o", "/dev/full", INSIDE))):
        process = run(CLI, "handout", *arguments)
        said = process.stderr.decode()
        check(process.returncode == status, f"{arguments}: {process.returncode}, {said}")
        check(words in said, f"{arguments}: “{said}”")
        check(not out.exists(), f"{arguments}: something is written")


TESTS = (
    a_lesson_without_options_is_one_page,
    full_handouts_have_every_stop_and_its_text,
    nothing_is_lost_of_long_texts_and_words,
    every_language_has_its_place,
    blanks_hide_what_the_key_tells,
    the_key_is_what_the_lesson_says,
    the_legend_names_what_the_pictures_show,
    each_insertion_has_four_panels,
    notes_are_for_the_lecturer_alone,
    the_same_lesson_gives_the_same_bytes,
    options_matter,
    the_file_says_what_it_is,
    what_cannot_be_is_refused,
)


def main():
    print(f"1..{len(TESTS)}")
    n_failed = 0
    for number, test in enumerate(TESTS, 1):
        name = "/handout/" + test.__name__.replace("_", "-")
        try:
            test()
            print(f"ok {number} - {name}")
        except Fault as fault:
            n_failed += 1
            print(f"# {fault}")
            print(f"not ok {number} - {name}")
        sys.stdout.flush()
    return 1 if n_failed else 0


if __name__ == "__main__":
    sys.exit(main())
