#!/usr/bin/env python3
"""Writes the index of conditions in docs/method.md: a row for each heading "C8. ..." of docs/method/*.md.

With --check it writes nothing, and ends with status 1 if the index is out of date.
"""

import pathlib
import re
import sys

from check_links import ROOT, anchor, headings

METHOD = ROOT / "docs/method.md"
BEGIN, END = "<!-- conditions: begin -->\n", "<!-- conditions: end -->"


def conditions():
    """(number, title, anchor, chapter's file, chapter's title), in the order of numbers."""
    found = {}
    for path in sorted((ROOT / "docs/method").glob("*.md")):
        titles = headings(path.read_text())
        for heading in titles:
            condition = re.match(r"C(\d+)\. (.+)", heading)
            if not condition:
                continue
            number = int(condition.group(1))
            if number in found:
                sys.exit(f"{path.relative_to(ROOT)} has a second condition C{number}.")
            found[number] = (number, condition.group(2), anchor(heading),
                             path.relative_to(METHOD.parent).as_posix(), titles[0])
    return [found[number] for number in sorted(found)]


def table():
    lines = ["| number | condition | chapter |", "| --- | --- | --- |"]
    lines += [f"| [C{number}]({file}#{place}) | {title} | [{chapter}]({file}) |"
              for number, title, place, file, chapter in conditions()]
    return "\n".join(lines) + "\n"


def main():
    old = METHOD.read_text()
    if BEGIN not in old or END not in old:
        sys.exit(f"docs/method.md lacks {BEGIN.strip()} or {END}.")
    head, rest = old.split(BEGIN, 1)
    new = head + BEGIN + table() + END + rest.split(END, 1)[1]
    if sys.argv[1:] == ["--check"]:
        if new != old:
            sys.exit("The conditions in docs/method.md are stale: run tests/docs/method_index.py.")
    elif sys.argv[1:]:
        sys.exit("usage: method_index.py [--check]")
    else:
        METHOD.write_text(new)


if __name__ == "__main__":
    main()
