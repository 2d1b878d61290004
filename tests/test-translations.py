#!/usr/bin/env python3
"""The translations: complete, and true to what must not be translated. TAP.

test-translations.py LANGUAGE=LOCALE…
"""
import collections
import os
import re
import subprocess
import sys
import tempfile

SOURCE = os.environ["HULL2VD_SOURCE"]
CLI = os.environ["HULL2VD_CLI"]
LOCALES = dict(pair.split("=") for pair in sys.argv[1:])
FOLDERS = {"interface": "po", "lessons": "lessons/po"}

# What meson's preset for GLib looks for.
KEYWORDS = [f"--keyword={word}" for word in (
    "_", "N_", "C_:1c,2", "NC_:1c,2", "g_dcgettext:2", "g_dngettext:2,3",
    "g_dpgettext2:2c,3")]

Entry = collections.namedtuple("Entry", "context ids strings flags places")


def run(*command, **options):
    return subprocess.run(command, check=True, capture_output=True, text=True,
                          cwd=SOURCE, **options).stdout


def lesson_paths():
    return sorted(
        f"lessons/{name}" for name in os.listdir(f"{SOURCE}/lessons")
        if name[0].isdigit() and name.endswith(".md"))


def unquoted(lines):
    """Strings as PO writes them, put together."""
    text = "".join(line[1:-1] for line in lines)
    return re.sub(r"\\(.)", lambda m: {"n": "\n", "t": "\t"}.get(
        m.group(1), m.group(1)), text)


def read_entry(block):
    parts = collections.defaultdict(list)
    flags, places, part = set(), [], None
    for line in block.splitlines():
        if line.startswith("#,"):
            flags |= {flag.strip() for flag in line[2:].split(",")}
        elif line.startswith("#:"):
            places += line[2:].split()
        elif match := re.match(r'(msg\w+(?:\[\d\])?) (".*")$', line):
            part = match.group(1)
            parts[part].append(match.group(2))
        elif line.startswith('"'):
            parts[part].append(line)
    found = {name: unquoted(lines) for name, lines in parts.items()}
    return Entry(
        found.get("msgctxt"),
        [found[name] for name in ("msgid", "msgid_plural") if name in found],
        [found[name] for name in sorted(found) if name.startswith("msgstr")],
        flags, places)


def read_catalog(text):
    entries = [read_entry(block) for block in text.strip().split("\n\n")
               if not block.startswith("#~")]
    return [entry for entry in entries if entry.ids and entry.ids[0]]


def catalog(folder, language):
    with open(f"{SOURCE}/{folder}/{language}.po", encoding="utf-8") as file:
        return read_catalog(file.read())


def names_of(entries):
    return {(entry.context, entry.ids[0]) for entry in entries}


def gather(*arguments, **options):
    return read_catalog(run("xgettext", "--from-code=UTF-8", "--no-wrap",
                            "--output=-", *KEYWORDS, *arguments, **options))


def words_of_interface():
    return gather("--files-from=po/POTFILES", "--directory=.")


def words_of_lessons():
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "words.c")
        with open(path, "w", encoding="utf-8") as file:
            file.write(run(CLI, "words", *lesson_paths()))
        return gather(path)


def check_complete(language):
    faults = []
    for folder, words in (("po", words_of_interface()),
                          ("lessons/po", words_of_lessons())):
        done = names_of(
            entry for entry in catalog(folder, language)
            if all(entry.strings) and "fuzzy" not in entry.flags)
        faults += [f"{folder}: no translation: {name[1]!r}"
                   for name in sorted(names_of(words) - done, key=str)]
    return faults


def check_gathered(_):
    """Every file with words is in POTFILES."""
    with open(f"{SOURCE}/po/POTFILES", encoding="utf-8") as file:
        listed = set(file.read().split())
    marked = run("grep", "-rlE", r"\b(N?_|N?C_|g_dn?gettext|ngettext) \(\"",
                 "src", "--include=*.c", "--include=*.h").split()
    marked += run("grep", "-rl", "translatable=", "ui").split()
    return [f"not in po/POTFILES: {path}" for path in sorted(marked)
            if path not in listed]


def check_formats(language):
    faults = []
    for folder in FOLDERS.values():
        result = subprocess.run(
            ["msgfmt", "--check", "--output-file=/dev/null",
             f"{SOURCE}/{folder}/{language}.po"],
            capture_output=True, text=True, check=False)
        if result.returncode != 0 or "error" in result.stderr:
            faults += result.stderr.splitlines()
    return faults


def differing(language, what, find, folders=tuple(FOLDERS.values())):
    """Entries in which find() finds other things in a translation."""
    faults = []
    for folder in folders:
        for entry in catalog(folder, language):
            expected = {str(find(words)) for words in entry.ids}
            for string in entry.strings:
                if str(find(string)) not in expected:
                    faults.append(f"{folder}: {what}: {entry.ids[0]!r}: "
                                  f"{string!r}")
    return faults


def check_code(language):
    return differing(language, "code spans",
                     lambda text: sorted(re.findall(r"`[^`]+`", text)))


def check_names(language):
    """Sites, facets and the like are called the same: s5, f7, {p}."""
    return differing(
        language, "names of objects",
        lambda text: sorted(set(re.findall(
            r"\b[sfvre][0-9]+\b|[sfvre]%u|\{\w\}", text))))


def check_numbers(language):
    """Numbers are those of the original, with a decimal point."""
    return differing(
        language, "numbers",
        lambda text: sorted(re.findall(
            r"(?<![\w%.-])[0-9]+(?:[.,][0-9]+)*(?![\w]|\.º)",
            re.sub(r"%\S+", " ", text))))


def check_emphasis(language):
    """As many words stressed, in bold and in italics."""
    return differing(
        language, "emphasis",
        lambda text: (len(re.findall(r"\*\*[^*]+\*\*", text)),
                      len(re.findall(r"(?<!\*)\*[^*\s][^*]*\*(?!\*)", text))))


def check_mnemonics(language):
    """Where there is a letter to press there is one in the translation."""
    return differing(
        language, "mnemonic",
        lambda text: len(re.findall(r"_(?=[^\W_])", text)) if
        re.match(r"[^`“„«\n]{1,60}$", text) and "(" not in text else 0,
        ("po",))


def check_narration(language):
    """What is loud in a sentence is found in it: sees, horizon, cone."""
    entries = catalog("po", language)
    words = {word: next(entry.strings[0] for entry in entries
                        if entry.ids == [word] and entry.context is None)
             for word in ("sees", "horizon", "cone")}
    return [f"{word} in {entry.strings[0]!r}"
            for entry in entries for word in words
            if any("narration.c" in place for place in entry.places)
            and re.search(rf"\{{p\}} {word}\b|(?:the|The) {word}\b",
                          entry.ids[0])
            and not re.search(rf"\b{words[word]}\b", entry.strings[0])]


def replay(locale):
    environment = dict(os.environ, LC_ALL=locale, LANGUAGE="")
    return run(CLI, "replay", *lesson_paths(), env=environment)


def check_replay(language):
    """Titles are other words; what is done and what holds is the same."""
    def deeds(report):
        return [(line.startswith("ok"), line.rsplit(": ", 1)[1])
                for line in report.splitlines() if "ok" in line[:6]]
    english, other = replay("C.UTF-8"), replay(LOCALES[language])
    faults = [] if deeds(english) == deeds(other) else ["they differ"]
    faults += [line for line in other.splitlines() if line.startswith("not")]
    title = next(entry.strings[0] for entry in catalog("lessons/po", language)
                 if entry.ids[0] == "Why it works")
    return faults + ([] if title in other else [f"no title {title}"])


BROKEN = """# A

```lesson
format 1
sites 0 0; 1 1; 2 0
```

## S

```steps
sites 0 0; 1
```
"""


def check_faults(language):
    """What is wrong with a site is said in the person's language."""
    environment = dict(os.environ, LC_ALL=LOCALES[language], LANGUAGE="")
    reason = next(entry.strings[0] for entry in catalog("po", language)
                  if entry.ids == ["expected two numbers, found only one"])
    with tempfile.NamedTemporaryFile("w", suffix=".md") as lesson:
        lesson.write(BROKEN)
        lesson.flush()
        told = subprocess.run([CLI, "lint", lesson.name], env=environment,
                              capture_output=True, text=True, check=False)
    words = told.stdout + told.stderr
    scale = subprocess.run([CLI, "export", "-o", "no.svg", "--line-scale", "9",
                            "no.txt"], env=environment, capture_output=True,
                           text=True, check=False).stderr
    return ([] if f":11:1: {reason}" in words else [words]) + (
        [] if " 0.5 " in scale else [scale])


CHECKS = [
    ("every-string-has-a-translation", check_complete),
    ("every-file-with-words-is-gathered", check_gathered),
    ("formats-and-plurals-are-sound", check_formats),
    ("code-is-not-translated", check_code),
    ("names-of-objects-are-the-same", check_names),
    ("numbers-are-the-same", check_numbers),
    ("emphasis-is-kept", check_emphasis),
    ("mnemonics-are-kept", check_mnemonics),
    ("loud-words-are-in-the-sentences", check_narration),
    ("lessons-replay-the-same", check_replay),
    ("faults-of-sites-are-told-in-it", check_faults),
]

print(f"1..{len(CHECKS) * len(LOCALES)}")
number = 0
for language in LOCALES:
    for name, check in CHECKS:
        number += 1
        try:
            faults = check(language)
        except subprocess.CalledProcessError as error:
            faults = [f"{error}: {error.stderr}"]
        state = "not ok" if faults else "ok"
        print(f"{state} {number} - /translations/{language}/{name}",
              flush=True)
        for fault in faults[:20]:
            print(f"# {fault}")
