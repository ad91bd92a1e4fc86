#!/usr/bin/env python3
"""Checks that links, citations, paths and names of tests in documents and comments exist.

* Relative links in every Markdown file must lead to a file, and to a heading of it if they name one.
* Citations in code, such as "docs/method.md, C8" or "docs/method.md, The closed chain", must be headings of
  docs/method.md or of its chapters, docs/method/*.md; the part before a heading's colon is enough. Paths of
  documents in code must exist.
* Paths and tests that documents in docs/ name in backticks must exist. A file named `beside` such a path must be
  in the same folder.

Prints a sentence for each fault, and then ends with status 1.
"""

import os
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parents[2]
CODE = {".cpp", ".hpp", ".inc", ".glsl", ".vert", ".frag", ".py", ".js", ".mjs", ".ts", ".sh", ".cmake",
        ".txt", ".json"}
FOLDERS = "preprocess|src|shaders_es2|tests|web|cmake|docs|assets"


def files_here():
    """Files of the repository, as paths from its root."""
    for folder, inner, names in os.walk(ROOT):
        inner[:] = sorted(set(inner) - {"build", "node_modules", "wasm", ".git", ".cache"})
        for name in sorted(names):
            yield (pathlib.Path(folder) / name).relative_to(ROOT)


def text_of(path):
    return (ROOT / path).read_text(errors="replace")


def without_code(text):
    return re.sub(r"^```.*?^```", "", text, flags=re.S | re.M)


def headings(text):
    return [m.group(1).strip() for m in re.finditer(r"^#+ (.+)$", without_code(text), re.M)]


def anchor(heading):
    """The anchor that GitHub makes from a heading."""
    plain = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).lower()
    return re.sub(r"[^\w\- ]", "", plain).replace(" ", "-")


def broken_links(document):
    text = without_code(text_of(document))
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        if re.match(r"[a-z]+:", target):
            continue
        name, _, wanted = target.partition("#")
        path = (ROOT / document.parent / name).resolve() if name else ROOT / document
        if not path.exists():
            yield f"{document} links to {target}, which does not exist."
        elif wanted and wanted not in map(anchor, headings(path.read_text())):
            yield f"{document} links to {target}, which has no such heading."


def unwrapped(text):
    """Comments without their line breaks."""
    return re.sub(r"\s*\n\s*(?:///?<?|#|\*|--)?\s*", " ", text)


def broken_citations(source, sections, conditions):
    text = unwrapped(text_of(source))
    for cited in re.finditer(r"docs/method\.md, ?(?=(.{1,60}))", text):
        rest = cited.group(1)
        numbers = re.match(r"C\d+(?:(?:, | and | to )C\d+)*", rest)
        if numbers:
            for number in re.findall(r"C\d+", numbers.group(0)):
                if number not in conditions:
                    yield f"{source} cites docs/method.md, {number}, which is not there."
        elif not any(rest.startswith(section) for section in sections):
            yield f"{source} cites docs/method.md, '{rest[:30]}…', which is no section of it or its chapters."
    for section in re.findall(r"\bmethod,? \(?sections? [\d.]+", text):
        yield f"{source} cites '{section}': docs/method.md has names and numbers of its own."
    for path in re.findall(r"\bdocs/[\w/-]+\.(?:md|svg|png)\b", text):
        if not (ROOT / path).exists():
            yield f"{source} names {path}, which does not exist."


def missing_names(document, tests):
    text = without_code(text_of(document))
    for name in re.findall(r"`([^`\n]+)`", text):
        path = re.fullmatch(rf"(?:{FOLDERS})/[\w./*-]*", name)
        if path and not any(ROOT.glob(name.rstrip("/"))):
            yield f"{document} names {name}, which does not exist."
        if re.fullmatch(r"[A-Z]\w+\.[A-Z]\w+", name) and name not in tests:
            yield f"{document} names the test {name}, which does not exist."


def misplaced_neighbours(document):
    """Files named "beside" a path that are not in its folder."""
    for line in without_code(text_of(document)).replace("\n  ", " ").splitlines():
        folder = None
        for named in re.finditer(r"`([^`\n]+)`", line):
            path = re.fullmatch(rf"((?:{FOLDERS})/(?:[\w-]+/)*)[\w.-]+", named.group(1))
            if path:
                folder = path.group(1)
            elif (folder and re.fullmatch(r"\w+\.(?:cpp|hpp|js|py|glsl|vert|frag)", named.group(1))
                  and re.match(r"(?: and `[^`]+`)? beside it", line[named.end():])
                  and not (ROOT / folder / named.group(1)).exists()):
                yield f"{document} names {named.group(1)} beside {folder}, where it isn't."


def main():
    files = list(files_here())
    documents = [path for path in files if path.suffix == ".md"]
    sources = [path for path in files if path.suffix in CODE or path.name in ("run", "test")]
    method = [heading for path in documents
              if path == pathlib.Path("docs/method.md") or path.parts[:2] == ("docs", "method")
              for heading in headings(text_of(path))]
    conditions = {m.group(1) for m in map(re.compile(r"(C\d+)\. ").match, method) if m}
    sections = {heading.split(":")[0] for heading in method}
    tests = {".".join(m) for path in sources if path.parts[0] == "tests"
             for m in re.findall(r"\b(?:TEST|TEST_F|TEST_P|RC_GTEST_PROP)\((\w+),\s*(\w+)",
                                 text_of(path))}
    faults = [fault for document in documents for fault in broken_links(document)]
    faults += [fault for source in sources
               if source != pathlib.Path("tests/docs/check_links.py")
               for fault in broken_citations(source, sections, conditions)]
    faults += [fault for document in documents if document.parts[0] == "docs"
               for fault in (*missing_names(document, tests), *misplaced_neighbours(document))]
    print("\n".join(faults) or f"{len(documents)} documents, {len(sources)} sources: all is there")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
