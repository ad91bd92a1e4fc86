"""A record of stable lines: how they were in the last release, and how they are now.

A line of a record's file begins with two characters: two blanks if the last release has it, "+" if it came since,
"-" if it went since. Before the first release all lines have blanks: nothing is promised yet.
"""

import difflib


class Record:
    def __init__(self, path):
        self.path = path
        lines = path.read_text().splitlines() if path.exists() else []
        self.marked = [(line[0], line[2:]) for line in lines]

    def released(self):
        return [line for mark, line in self.marked if mark in " -"]

    def now(self):
        return [line for mark, line in self.marked if mark in " +"]

    def changes(self):
        """The lines that came and those that went since the last release."""
        return ([line for mark, line in self.marked if mark == "+"],
                [line for mark, line in self.marked if mark == "-"])

    def write(self, lines, is_released):
        """Records `lines`, against those of the last release if there was one."""
        old = self.released() if is_released else lines
        diff = difflib.SequenceMatcher(None, old, lines, autojunk=False)
        self.marked = []
        for kind, a, b, c, d in diff.get_opcodes():
            if kind == "equal":
                self.marked += [(" ", line) for line in old[a:b]]
            else:
                self.marked += [("-", line) for line in old[a:b]] + [("+", line) for line in lines[c:d]]
        self.save()

    def release(self):
        """From now on the lines of now are those of the last release."""
        self.marked = [(" ", line) for line in self.now()]
        self.save()

    def save(self):
        self.path.parent.mkdir(parents=True, exist_ok=True)
        self.path.write_text("".join(f"{mark} {line}\n" for mark, line in self.marked))
