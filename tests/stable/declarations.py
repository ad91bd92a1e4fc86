"""Declarations of C++ headers and of TypeScript's .d.ts files, one a line, without comments, layout and bodies.

`declarations(text)` lists them as "scope: declaration". Private members of classes are left out, and so are the
names of headers that a header includes.
"""

import re

# Strings, words, numbers; signs of two or three characters; else one character.
TOKEN = re.compile(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\'|[A-Za-z_]\w*|\d[\w.]*|::|->|=>|\.\.\.|&&|<<|\S')
COMMENT = re.compile(r'("(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])*\')|//[^\n]*|/\*.*?\*/', re.S)
SCOPE = re.compile(r"(?:export |declare )*(?:default )?(namespace|struct|class|enum|union|interface|global)\b")
OPEN, CLOSE = "({[", ")}]"


def joined(tokens):
    """Tokens as one line; blanks only where two words meet."""
    line = ""
    for token in tokens:
        meets = line and re.match(r"[\w\"']", token) and re.search(r"[\w\"'>&*,=|?]$|[^:]:$", line)
        line += (" " if meets else "") + token
    return line


def closing(tokens, start):
    """The index of the bracket that closes the one at `start`."""
    depth = 0
    for index in range(start, len(tokens)):
        depth += (tokens[index] in OPEN) - (tokens[index] in CLOSE)
        if depth == 0:
            return index
    raise ValueError(f"'{tokens[start]}' is not closed: {joined(tokens[start:start + 8])}")


def is_body(statement):
    """Whether the brace after these tokens opens a function's body: it follows the parameters."""
    return "(" in statement and "=" not in statement[statement.index("("):] or \
        statement[-1:] in ([")"], ["const"], ["noexcept"], ["override"])


def cpp_constructor(line, scope):
    """Whether a colon in the line begins a constructor's list of members."""
    return scope and re.match(rf"(explicit )?{re.escape(scope.rsplit('::', 1)[-1])}\(", line)


def walk(tokens, scope, found, hidden=False):
    """Appends the declarations of a scope; `hidden` ones are private."""
    statement, index = [], 0

    def end(line):
        nonlocal statement
        line = re.sub(r"\): .*", ")", line) if cpp_constructor(line, scope) else line
        if line and not hidden:
            found.append(f"{scope}: {line}" if scope else line)
        statement = []

    while index < len(tokens):
        token = tokens[index]
        line = joined(statement)
        kind = SCOPE.match(line)
        if token in "([":
            last = closing(tokens, index)
            statement += tokens[index:last + 1]
            index = last
        elif token == "{" and kind and "=" not in statement:
            last = closing(tokens, index)
            inside = tokens[index + 1:last]
            if hidden:
                inside = []
            end(line)
            name = f"{scope}::{line}" if scope else line
            short = re.sub(r"(export|declare|namespace|struct|class|enum|union|interface) ?|[<:].*| extends .*", "", line).strip()
            short = f"{scope}::{short}" if scope and short else short or scope
            if kind.group(1) == "enum":
                found += [f"{short}: {value.strip()}" for value in joined(inside).split(",") if value]
            else:
                cpp_class = line.startswith("class ")  # private until it says otherwise
                walk(inside, short or name, found, cpp_class)
            index = last + (tokens[last + 1:last + 2] == [";"])
        elif token == "{":
            last = closing(tokens, index)
            if is_body(statement):
                end(line)
            else:
                statement += tokens[index:last + 1]
            index = last
        elif token == ":" and line in ("public", "private", "protected"):
            hidden = line == "private"
            statement = []
        elif token == ";":
            end(line)
        else:
            statement.append(token)
        index += 1
    end(joined(statement))


def members_of_union(line):
    """A line for each string that a TypeScript type lists, so that a further one removes no line."""
    name, _, values = line.partition("=")
    strings = [value.strip() for value in values.split("|") if value.strip()]
    if not name.startswith("export type ") or not all(re.fullmatch("'[^']*'", value) for value in strings):
        return [line]
    return [f"{name}= {value}" for value in strings]


def declarations(text):
    """The declarations in a header's text, in its order. Throws ValueError for brackets that don't match."""
    text = COMMENT.sub(lambda match: match.group(1) or " ", text)
    macros = [" ".join(line.split()) for line in re.findall(r"^\s*#\s*define.*", text, re.M)]
    found = []
    walk(TOKEN.findall(re.sub(r"^\s*#.*", "", text, flags=re.M)), "", found)
    return macros + [line for whole in found for line in members_of_union(whole)]
