#!/usr/bin/env python3
"""Tests the checks of versions on copies: each must fail, with its sentence, for the fault that it is for."""

import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
from declarations import declarations  # noqa: E402
from record import Record  # noqa: E402
from report_keys import keys_of  # noqa: E402

HERE = pathlib.Path(__file__).resolve().parent
ROOT = HERE.parents[1]
sys.path.insert(0, str(ROOT / "packaging"))
import set_version  # noqa: E402

HEADER = """
#include <span>
namespace n { // a comment with a ; and a {
/// What it is.
struct Plain { int a = 1; std::array<double, 3> at{0, 1}; };
class Held {
    int hidden;
  public:
    explicit Held(int a) : hidden(a) {}
    enum class Kind { one, two };
    int get() const { return hidden; }
  private:
    int more;
};
} // namespace n
"""


class Declarations(unittest.TestCase):
    def test_lists_what_users_can_name(self):
        self.assertEqual(declarations(HEADER), [
            "namespace n", "n: struct Plain", "n::Plain: int a= 1", "n::Plain: std::array<double, 3> at{0, 1}",
            "n: class Held", "n::Held: explicit Held(int a)", "n::Held: enum class Kind", "n::Held::Kind: one",
            "n::Held::Kind: two", "n::Held: int get()const"])

    def test_ignores_comments_layout_and_bodies(self):
        other = HEADER.replace("What it is.", "Other words.").replace("{ return hidden; }", "{\n  return 1;\n}")
        self.assertEqual(declarations(HEADER), declarations(other))
        self.assertNotEqual(declarations(HEADER), declarations(HEADER.replace("get()", "got()")))

    def test_has_a_line_for_each_string_of_a_type(self):
        self.assertEqual(declarations("export type T =\n  | 'a' | 'b'; /* c */"),
                         ["export type T= 'a'", "export type T= 'b'"])


class Keys(unittest.TestCase):
    def test_are_paths_with_kinds(self):
        report = {"a": [{"b": 1}, {"b": 2.5, "c": None}], "edges_by_opposite_count": {"1": 4}, "d": []}
        self.assertEqual(keys_of(report), ["a[].b: number", "a[].c: null", "edges_by_opposite_count.*: number",
                                           "d: array"])


class Copies(unittest.TestCase):
    """A copy of every place that names the version."""

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = pathlib.Path(self.folder.name)
        for name in {name for name, _, _ in set_version.PLACES} | {"CHANGELOG.md"}:
            (self.root / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(ROOT / name, self.root / name)
        (self.root / "CHANGELOG.md").write_text("# Changelog\n\n## [Unreleased]\n\n### Added\n\n- All.\n")
        self.record = Record(self.root / "tests/stable/records/words.txt")
        self.record.write(["pack", "info"], False)

    def tearDown(self):
        self.folder.cleanup()

    def run_it(self, *words):
        done = subprocess.run([sys.executable, "-B", ROOT / "packaging/set_version.py", *words, "--root", self.root],
                              capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    def expect_fault(self, words, sentence):
        status, text = self.run_it(*words)
        self.assertEqual(status, 1, text)
        self.assertIn(sentence, text)

    def released(self, lines):
        """Version 1.0.0 is released; then the lines change to these."""
        self.assertEqual(self.run_it("1.0.0")[0], 0)
        self.record = Record(self.record.path)
        self.record.write(lines, True)
        log = self.root / "CHANGELOG.md"
        log.write_text(log.read_text().replace("## [Unreleased]\n", "## [Unreleased]\n\n### Changed\n\n- Words.\n"))

    def test_every_place_is_checked(self):
        self.assertEqual(self.run_it("--check")[0], 0)
        for name, pattern, _ in set_version.PLACES[1:]:
            path = self.root / name
            before = path.read_text()
            start, end = re.search(pattern, before).span(1)
            path.write_text(before[:start] + re.sub(r"\d+$", "77", before[start:end]) + before[end:])
            self.expect_fault(["--check"], f"{name} says ")
            path.write_text(before)

    def test_one_command_sets_all(self):
        status, text = self.run_it("1.0.0")
        self.assertEqual(status, 0, text)
        self.assertEqual(self.run_it("--check"), (0, "Every place says 1.0.0.\n"))
        self.assertRegex((self.root / "CHANGELOG.md").read_text(),
                         r"## \[Unreleased\]\n\n## \[1\.0\.0\] - \d{4}-\d\d-\d\d\n\n### Added")
        self.expect_fault(["1.0.0"], "does not follow 1.0.0")

    def test_words_that_are_no_version(self):
        self.expect_fault(["1.0"], "'1.0' is no version")

    def test_an_empty_section(self):
        (self.root / "CHANGELOG.md").write_text("# Changelog\n\n## [Unreleased]\n")
        self.expect_fault(["1.0.0"], "is empty")

    def test_what_went_takes_a_major_version(self):
        self.released(["pack"])
        self.expect_fault(["1.1.0"], "'info' went: raise the major number")
        self.assertEqual(self.run_it("2.0.0")[0], 0)

    def test_what_came_takes_a_minor_version(self):
        self.released(["pack", "info", "view"])
        self.expect_fault(["1.0.1"], "'view' came: raise the minor number")
        self.assertEqual(self.run_it("1.1.0")[0], 0)
        self.assertEqual(Record(self.record.path).changes(), ([], []))


if __name__ == "__main__":
    unittest.main()
