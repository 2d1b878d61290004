#!/usr/bin/env python3
"""Makes catalogs of a language that nobody speaks: every string a third longer
and accented, with its formats, names, markup and mnemonics as they were. What
is cut off in it will be cut off in some language.

pseudo.py CATALOG.po… FOLDER    writes FOLDER/LANGUAGE/LC_MESSAGES/NAME.mo, NAME
being that of the catalog's project
"""
import os
import re
import subprocess
import sys

LANGUAGE = "pseudo"
ACCENTS = str.maketrans(
    "aceginosuyzACEGINOSUYZ", "åçéĝîñöšûýžÅÇÉĜÎÑÖŠÛÝŽ")
VOWELS = "aeiouAEIOU"
# What must stay as it is; the rest is prose.
FIXED = re.compile(
    r"(\\.|%[-+ #0-9.]*(?:l|ll|z)?[a-zA-Z%]|%\".*?\"|\{\w\}|<[^>]*>|&\w+;"
    r"|`[^`]*`|\b[sfvre]%?u?[0-9]*\b|\*+|_(?=\w))")


def stretch(text):
    """Doubles vowels until a third has come in."""
    missing, result = (len(text) + 2) // 3, ""
    for character in text:
        result += character
        if character in VOWELS and missing > 0:
            result += character.lower()
            missing -= 1
    return result.translate(ACCENTS)


def pseudo(text):
    parts = FIXED.split(text)
    parts[::2] = [stretch(part) for part in parts[::2]]
    text = "".join(parts)
    end = "\\n" if text.endswith("\\n") else ""
    return "⟦" + text[:len(text) - len(end)] + "⟧" + end


def read(block):
    """The strings of an entry, which may go on in further lines."""
    strings, name = {}, None
    for line in block.splitlines():
        if match := re.match(r'(msg\w+(?:\[\d\])?) "(.*)"$', line):
            name = match.group(1)
            strings[name] = match.group(2)
        elif line.startswith('"'):
            strings[name] += line[1:-1]
    return strings


def translate(catalog):
    """The catalog's strings in the language; PO, one line a string."""
    text = subprocess.run(
        ["msgcat", "--no-wrap", catalog], check=True, capture_output=True,
        text=True).stdout
    blocks = text.strip().split("\n\n")
    result = [blocks[0]]
    for block in blocks[1:]:
        if block.startswith("#~"):
            continue
        strings = read(block)
        forms = [pseudo(strings[name]) for name in ("msgid", "msgid_plural")
                 if name in strings]
        lines = [f'{name} "{strings[name]}"' for name in
                 ("msgctxt", "msgid", "msgid_plural") if name in strings]
        lines += [f'msgstr[{i}] "{form}"' for i, form in enumerate(forms)] \
            if len(forms) > 1 else [f'msgstr "{forms[0]}"']
        result.append("\n".join(lines))
    return "\n\n".join(result) + "\n"


def project(catalog):
    with open(catalog, encoding="utf-8") as file:
        return re.search(r"Project-Id-Version: ([\w-]+)", file.read()).group(1)


def main(*arguments):
    *catalogs, folder = arguments
    folder = os.path.join(folder, LANGUAGE, "LC_MESSAGES")
    os.makedirs(folder, exist_ok=True)
    for catalog in catalogs:
        path = os.path.join(folder, project(catalog) + ".mo")
        subprocess.run(["msgfmt", "--output-file", path, "-"], check=True,
                       input=translate(catalog), text=True)


main(*sys.argv[1:])
