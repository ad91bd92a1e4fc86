#!/usr/bin/env python3
"""Finds prose that is hard to read, in comments of sources and in documents.

* openings: comments of sources that open with a bare relation, such as "Of" or "Which", instead of naming the
  thing that they describe. Questions are allowed.
* long sentences: sentences of documents with more than 35 words.
* words: words of documents and comments that the table "Words to avoid" of docs/architecture.md replaces.

Prints file:line for each finding and a count for each kind; with --counts only the counts. Ends with status 1
if it finds anything.
"""

import argparse
import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
OPENING = re.compile(r"(?:Of|That of|Those of|What|Which|Whose|Who)\b(?!.*\?)")
MOST_WORDS = 35
SLASHES = {".cpp", ".hpp", ".inc", ".glsl", ".vert", ".frag", ".js", ".mjs", ".ts"}
HASHES = {".py", ".sh", ".cmake", ".txt"}
DOCUMENTS = ("README.md", "CONTRIBUTING.md", "docs/", "web/")
COMMENT = {"//": re.compile(r"(?:^|(?<=\s))(?://[/!]?|/\*\*?)<?\s*|^\s*\*(?!/)\s+"),
           "#": re.compile(r'(?:^|(?<=\s))#(?!!)\s*|^\s*"""\s*')}
ABBREVIATION = re.compile(r"(?:\b(?:e\.g|i\.e|al|cf|vs|Eq|Fig|St)|^\W*[A-Z]|\s[A-Z])\.$")


def files_here():
    """Files of the repository, as paths from its root."""
    for folder, inner, names in os.walk(ROOT):
        inner[:] = sorted(set(inner) - {"build", "node_modules", "wasm", "dist", ".git", ".cache"})
        for name in sorted(names):
            yield (pathlib.Path(folder) / name).relative_to(ROOT)


def marker_of(path):
    if path.suffix in SLASHES:
        return "//"
    if path.suffix in HASHES or path.name in ("run", "test"):
        return "#"
    return None


def comments(lines, marker):
    """(line number, text, whether a comment begins here) for each line of a comment."""
    previous = None  # the column of the comment on the line before
    for number, line in enumerate(lines, 1):
        found = COMMENT[marker].search(line)
        if not found:
            previous = None
            continue
        continues = found.start() == previous and not line[:found.start()].strip()
        inside = found.group(0).lstrip().startswith("*")
        yield number, line[found.end():], not continues and not inside
        previous = found.start()


def paragraphs(lines):
    """(line number, text) for each paragraph and list item of a document; skips code, tables and headings."""
    start, gathered, code = 0, [], False
    for number, line in enumerate([*lines, ""], 1):
        plain = line.strip()
        fence = plain.startswith("```")
        ends = not plain or fence or code or re.match(r"[|#<]|!\[", plain)
        if (ends or re.match(r"(?:[*+-]|\d+\.) ", plain)) and gathered:
            yield start, " ".join(gathered)
            gathered = []
        code ^= fence
        if not ends:
            start = start if gathered else number
            gathered.append(re.sub(r"^(?:[*+-]|\d+\.) ", "", plain))


def read_aloud(text):
    """Markdown as it is read: code counts as a word, and a link as its text."""
    text = re.sub(r"`[^`]*`", "code", re.sub(r"<[^>]*>", "", text))
    return re.sub(r"!?\[([^]]*)\]\([^)]*\)", r"\1", text).replace("*", "")


def sentences(text):
    """The sentences of a paragraph."""
    gathered = ""
    for piece in re.split(r"(?<=[.!?])\s+|(?<=[.!?]\))\s+", read_aloud(text)):
        gathered = f"{gathered} {piece}".strip()
        if not ABBREVIATION.search(gathered):
            yield gathered
            gathered = ""
    if gathered:
        yield gathered


def is_link_list(text):
    links = " ".join(re.findall(r"\[([^]]*)\]\(", text))
    return len(links.split()) * 2 > len(read_aloud(text).split())


def words_to_avoid():
    """(pattern, word to avoid, replacement) for each row of the table."""
    table = (ROOT / "docs/architecture.md").read_text().partition("## Words to avoid")[2]
    for row in re.findall(r"^\| (.+?) \| (.+?) \|$", table, re.M)[2:]:
        for word in row[0].split("; "):
            yield re.compile(rf"\b{re.escape(word)}\b", re.I), word, row[1]


def findings():
    """(kind, place, text) for each finding."""
    avoided = list(words_to_avoid())

    def words(path, number, text):
        plain = re.sub(r"`[^`]*`|\]\([^)]*\)", "", text)
        for pattern, word, instead in avoided:
            if pattern.search(plain):
                yield "words", f"{path}:{number}", f"'{word}': say {instead}"

    for path in files_here():
        marker = marker_of(path)
        if marker:
            for number, text, opens in comments((ROOT / path).read_text(errors="replace").splitlines(), marker):
                if opens and OPENING.match(text):
                    yield "openings", f"{path}:{number}", text.strip()
                yield from words(path, number, text)
        elif path.suffix == ".md" and str(path).startswith(DOCUMENTS):
            text = (ROOT / path).read_text().partition("## Words to avoid")[0]
            for number, paragraph in paragraphs(text.splitlines()):
                for sentence in [] if is_link_list(paragraph) else sentences(paragraph):
                    count = len(re.findall(r"\S*\w\S*", sentence))
                    if count > MOST_WORDS:
                        yield "long sentences", f"{path}:{number}", f"{count} words: {sentence[:60]}…"
            for number, line in enumerate(re.sub(r"^```.*?^```", lambda m: "\n" * m.group(0).count("\n"), text,
                                                 flags=re.S | re.M).splitlines(), 1):
                yield from words(path, number, line)


def main():
    arguments = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    arguments.add_argument("--counts", action="store_true", help="print the counts alone")
    counts_alone = arguments.parse_args().counts
    counts = {"openings": 0, "long sentences": 0, "words": 0}
    for kind, place, what in findings():
        counts[kind] += 1
        if not counts_alone:
            print(f"{place}: {kind}: {what}")
    print(", ".join(f"{count} {kind}" for kind, count in counts.items()))
    return 1 if any(counts.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
