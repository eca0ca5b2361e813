import errno
import os
from pathlib import Path

import pytest
from tests.sentences import CLOSE_QUOTES, FIRST_IN_LINE, IS_A_FOLDER, KEEP_ONE, NO_FILE, QUOTES, TOO_LARGE

from cranktrain.errors import InputError, Position, Problem
from cranktrain.io.document import LARGEST_FILE, Document

ENGINE = """\
name = "V6 \u00b0"   # a V engine
shape.bank_count = 2

[shaft.main]
throws = ["0 deg", "240 deg",
  "120 deg"]   # ahead of throw 1
speed = "1500 rpm"

[bank.R]
angle = "30 deg"
[bank.R.mechanism]
kind = 'articulated_rod'
ζ = 1
""".replace("ζ = 1", '"ζ 1" = { note = "ж", value = "66.63 deg", status = "fitted" }')
ENGINE += """
[cylinder.2L]
bore = "150 mm"

[[mechanism.part]]
rod = { name = "pitman", length = "400 mm" }
[[mechanism.part]]
rod.length = "250 mm"
[mechanism.part.guide]
offset = 0.0
"""


@pytest.fixture
def engine():
    return Document.from_text(ENGINE, "v6.toml")


def problem_of(call, *arguments):
    with pytest.raises(InputError) as caught:
        call(*arguments)
    (problem,) = caught.value.problems
    return problem


def syntax_problem(text):
    return problem_of(lambda: Document.from_text(text, "m.toml").data)


class TestData:
    def test_is_what_the_text_says(self, engine):
        assert engine.data["mechanism"] == {
            "part": [
                {"rod": {"name": "pitman", "length": "400 mm"}},
                {"rod": {"length": "250 mm"}, "guide": {"offset": 0.0}},
            ]
        }

    def test_is_read_once(self, engine):
        assert engine.data is engine.data

    def test_dates_nan_and_infinity_are_left_to_the_specification(self):
        data = Document.from_text("a = 2020-02-29\nb = inf\nc = nan\n", "m.toml").data
        assert (data["a"].day, data["b"]) == (29, float("inf"))
        assert data["c"] != data["c"]

    @pytest.mark.parametrize("text", ["", "  \n\n", "# only a comment\n", "\ufeff"])
    def test_nothing_in_it(self, text):
        assert str(syntax_problem(text)) == "m.toml  no machine in it; start with `cranktrain new slider_crank`"


class TestRead:
    def test_text_and_name(self, tmp_path):
        file = tmp_path / "v6.toml"
        file.write_bytes(ENGINE.replace("\n", "\r\n").encode())
        document = Document.read(file)
        assert document == Document(ENGINE.replace("\n", "\r\n"), str(file))
        assert document.data == Document.from_text(ENGINE, "").data

    def test_byte_order_mark_of_utf_8(self, tmp_path):
        (tmp_path / "m.toml").write_text("a = 1", encoding="utf-8-sig")
        assert Document.read(tmp_path / "m.toml").text == "a = 1"

    def test_missing_with_the_nearest_name(self, tmp_path):
        (tmp_path / "engine.toml").touch()
        said = str(problem_of(Document.read, tmp_path / "engin.toml"))
        assert said.endswith(f"engin.toml  {NO_FILE}; is it engine.toml?")

    def test_missing_with_none_near(self, tmp_path):
        assert problem_of(Document.read, tmp_path / "engine.toml").repair is None

    def test_missing_folder(self, tmp_path):
        assert problem_of(Document.read, tmp_path / "no" / "m.toml").allowed == f"there is no folder {tmp_path / 'no'}"

    def test_folder(self, tmp_path):
        (tmp_path / "m.toml").touch()
        problem = problem_of(Document.read, str(tmp_path))
        assert problem.allowed == IS_A_FOLDER
        assert problem.repair == f"name a file in it, such as {tmp_path / 'm.toml'}"

    def test_file_in_place_of_a_folder(self, tmp_path):
        (tmp_path / "m").touch()
        assert problem_of(Document.read, tmp_path / "m" / "m.toml").allowed.startswith("cannot be read: ")

    def test_not_permitted(self, tmp_path, monkeypatch):
        def refuse(*_arguments, **_options):
            raise PermissionError(errno.EACCES, os.strerror(errno.EACCES))

        (tmp_path / "m.toml").touch()
        monkeypatch.setattr(Path, "open", refuse)
        assert problem_of(Document.read, tmp_path / "m.toml").allowed == "may not be read"

    @pytest.mark.skipif(not hasattr(os, "geteuid") or os.geteuid() == 0, reason="root may read everything")
    def test_mode_forbids(self, tmp_path):
        (tmp_path / "m.toml").touch(mode=0)
        assert problem_of(Document.read, tmp_path / "m.toml").allowed == "may not be read"

    @pytest.mark.parametrize("name", ["a\0b", "\ud800", "x" * 300])
    def test_impossible_name(self, tmp_path, name):
        problem_of(Document.read, tmp_path / name)

    def test_name_that_is_no_text_can_be_shown(self, tmp_path):
        assert str(problem_of(Document.read, tmp_path / "\udcff.toml")).isprintable()

    def test_too_large_is_not_read(self, tmp_path, monkeypatch):
        with (tmp_path / "m.toml").open("wb") as file:
            file.truncate(LARGEST_FILE + 1)
        monkeypatch.setattr(Path, "open", None)
        assert problem_of(Document.read, tmp_path / "m.toml").allowed.startswith(TOO_LARGE)

    def test_as_large_as_may_be(self, tmp_path):
        (tmp_path / "m.toml").write_text("#" * LARGEST_FILE)
        assert len(Document.read(tmp_path / "m.toml").text) == LARGEST_FILE

    @pytest.mark.skipif(not Path("/dev/zero").exists(), reason="no such device")
    def test_endless_device(self):
        assert problem_of(Document.read, "/dev/zero").allowed.startswith(TOO_LARGE)

    @pytest.mark.parametrize("encoding", ["utf-16", "utf-16-le", "utf-16-be", "utf-32", "utf-32-le", "utf-32-be"])
    @pytest.mark.parametrize("text", ["a = 1\r\n", '# Двигатель\nrod_length = "320 мм"\n'])
    def test_wide_encodings(self, tmp_path, encoding, text):
        (tmp_path / "m.toml").write_bytes(text.encode(encoding))
        problem = problem_of(Document.read, tmp_path / "m.toml")
        assert (problem.allowed, problem.repair) == (f"is written in {encoding[:6].upper()}", "save it as UTF-8")

    @pytest.mark.parametrize(
        "content",
        [
            b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR\0\0\0\x10\0\0\0\x10\x08=",
            b"a = 1\n\0",
            b"\x7fELF\x02\x01\x01\0\0\0\0\0\0\0\0\0\x03\0>\0",
        ],
    )
    def test_binary(self, tmp_path, content):
        (tmp_path / "m.toml").write_bytes(content)
        assert problem_of(Document.read, tmp_path / "m.toml").allowed == "is no text: it has NUL bytes"

    def test_other_encoding(self, tmp_path):
        (tmp_path / "m.toml").write_bytes("name = 1\n# ж ".encode() + "ж".encode("cp1251"))
        problem = problem_of(Document.read, tmp_path / "m.toml")
        assert problem.allowed == "the byte 0xE6 here is not UTF-8"
        assert problem.position == Position(str(tmp_path / "m.toml"), 2, 5)

    def test_half_characters(self):
        problem = problem_of(Document.from_text, "a = 1\nb = '\udc80'", "m.toml")
        assert problem.position == Position("m.toml", 2, 6)


class TestSyntax:
    @pytest.mark.parametrize(
        ("text", "said"),
        [
            (
                "# x\n  rod_length = 320 mm # l\n",
                f'2:20  rod_length = 320 mm # l: {QUOTES}; write rod_length = "320 mm"',
            ),
            ("kind = dual", f'1:8  kind = dual: {QUOTES}; write kind = "dual"'),
            ("a = “3 mm”", f'1:5  a = “3 mm”: {QUOTES}; write a = "3 mm"'),
            ("a = 1,5", "1:6  a = 1,5: this is no number and no true or false of TOML; write a = 1.5"),
            ("a = 1,5 m", f'1:6  a = 1,5 m: {QUOTES}; write a = "1.5 m"'),
            ("a = True", "1:5  a = True: this is no number and no true or false of TOML; write a = true"),
            ("a = 1\na = 2", f"2:1  a: {FIRST_IN_LINE} 1; {KEEP_ONE}"),
            ("[x.y]\n[x.z]\n\n[x.y]", f"4:4  x.y: {FIRST_IN_LINE} 1; {KEEP_ONE}"),
            ("[x]\ny.z = 1\n[q]\n[x.y]", f"4:4  x.y: {FIRST_IN_LINE} 2; {KEEP_ONE}"),
            ("[x]\ny = { a.b = 1, a.b = 2 }", f"2:18  x.y.a.b: {FIRST_IN_LINE} 2; {KEEP_ONE}"),
            ("[[x]]\na = 1\n[[x]]\na = 1\na = 2", f"5:1  x[1].a: {FIRST_IN_LINE} 4; {KEEP_ONE}"),
            ("x = [1]\n[[x]]", f"2:3  x: {FIRST_IN_LINE} 1; {KEEP_ONE}"),
            ("x = 1\n[x.y]", f"2:4  x: {FIRST_IN_LINE} 1; {KEEP_ONE}"),
            ('a = "3 mm\nb = 1', f'1:10  a = "3 mm: a text is not closed in this line; {CLOSE_QUOTES}'),
            ("b = 1\na = '3 mm", f"2:5  '3 mm: this text is not closed; {CLOSE_QUOTES}"),
            ('b = 1\na = """3 mm\nc', f'2:5  """3 mm: this text is not closed; {CLOSE_QUOTES}'),
            ("name: x", "1:5  name: x: a key needs = and a value after it; write key = value"),
        ],
    )
    def test_is_said_in_our_words(self, text, said):
        assert str(syntax_problem(text)) == f"m.toml:{said}"

    @pytest.mark.parametrize(
        ("text", "line", "column", "allowed"),
        [
            ("a = ", 1, 5, "no value: "),
            ("a = 1 b = 2", 1, 7, "after the value"),
            ("ключ = 1", 1, 1, "a line begins with"),
            ("a..b = 1", 1, 3, "a key has the letters"),
            ("[bank.R\na = 1", 1, 8, "the head of a table"),
            ("[[bank.R]\na = 1", 1, 9, "the head of a table"),
            ("a = [0 deg]", 1, 8, "a comma or the closing ]"),
            ("a = { b = 3 mm }", 1, 13, "a comma or the closing }"),
            ('a = "C:\\d"', 1, 10, "a single \\"),
            ('a = "\\u12"', 1, 8, "\\u and \\U"),
            ('a = "\x1b[31m"', 1, 6, "a control character"),
            ("# \x07", 1, 3, "a control character"),
            ("x = 1\na = " + "9" * 5000, 2, 5, "a number of thousands of digits"),
        ],
    )
    def test_says_where(self, text, line, column, allowed):
        problem = syntax_problem(text)
        assert problem.position == Position("m.toml", line, column)
        assert problem.allowed.startswith(allowed)
        assert str(problem).isprintable()

    @pytest.mark.parametrize(
        "text",
        [
            "a = " + "[" * 5000,
            "a = " + "[" * 5000 + "]" * 5000,
            "a = " + "{ a = " * 5000,
            "a = " + "[" * 40 + "]" * 40,
        ],
    )
    def test_nested_too_deep(self, text):
        assert syntax_problem(text).allowed == "lists and tables stand more than 32 deep in one another"

    def test_a_long_line_is_shortened(self):
        assert len(syntax_problem("a = [" + "1 " * 1000).given) == 60


class TestLocate:
    @pytest.mark.parametrize(
        ("path", "line", "column"),
        [
            ("name", 1, 8),
            ("shape.bank_count", 2, 20),
            ("shape", 2, 1),
            ("shaft.main.throws", 5, 10),
            ("shaft.main.throws[1]", 5, 20),
            ("shaft.main.throws[2]", 6, 3),
            ("shaft.main", 4, 1),
            ("shaft", 4, 1),
            ("bank.R.mechanism", 11, 1),
            ("bank.R.mechanism.kind", 12, 8),
            ('bank.R.mechanism."ζ 1"', 13, 9),
            ("bank.R.mechanism.ζ 1", 13, 9),
            ("bank.R.mechanism.ζ 1.value", 13, 31),
            ("cylinder.2L.bore", 16, 8),
            ("mechanism.part", 18, 1),
            ("mechanism.part[0].rod.length", 19, 35),
            ("mechanism.part[1]", 20, 1),
            ("mechanism.part[1].rod.length", 21, 14),
            ("mechanism.part[1].guide.offset", 23, 10),
        ],
    )
    def test_of_what_is_there(self, engine, path, line, column):
        assert engine.locate(path) == Position("v6.toml", line, column)

    @pytest.mark.parametrize(
        ("path", "line", "column"),
        [
            ("bank.R.mechanism.rod_length", 11, 1),
            ("bank.R.offset", 9, 1),
            ("bank.L.angle", 9, 1),
            ("mechanism.part[1].side", 20, 1),
            ("mechanism.part[7].side", 18, 1),
            ("shaft.main.throws[3]", 5, 10),
            ("name.value", 1, 8),
            ("bank.R.mechanism.ζ 1.source", 13, 9),
            ("gas.kind", 1, 1),
            ("no path..", 1, 1),
        ],
    )
    def test_of_what_is_not(self, engine, path, line, column):
        assert engine.locate(path) == Position("v6.toml", line, column)

    def test_of_a_key(self, engine):
        assert engine.locate("bank.R.mechanism.ζ 1.value", at_key=True) == Position("v6.toml", 13, 23)
        assert engine.locate("cylinder.2L", at_key=True) == Position("v6.toml", 15, 11)

    def test_of_the_file(self, engine):
        assert engine.locate("") == Position("v6.toml")

    def test_after_windows_line_ends(self):
        document = Document.from_text(ENGINE.replace("\n", "\r\n"), "v6.toml")
        assert document.locate("shaft.main.throws[2]") == Position("v6.toml", 6, 3)


class TestLocated:
    def test_adds_place_and_what_was_given(self, engine):
        problems = [
            Problem("shaft.main.speed", None, "a"),
            Problem("shaft.main.throws", None, "b"),
            Problem("bank.R.mechanism", None, "c"),
            Problem("bank.R.mechanism.rod_length", None, "d"),
            Problem("mechanism.part[1].guide.offset", "0 mm", "e"),
        ]
        assert [str(problem) for problem in map(engine.located, problems)] == [
            "v6.toml:7:9  shaft.main.speed = 1500 rpm: a",
            'v6.toml:5:10  shaft.main.throws = ["0 deg", "240 deg", "120 deg"]: b',
            "v6.toml:11:1  bank.R.mechanism: c",
            "v6.toml:11:1  bank.R.mechanism.rod_length: d",
            "v6.toml:23:10  mechanism.part[1].guide.offset = 0 mm: e",
        ]

    def test_keeps_a_place_that_is_there(self, engine):
        problem = Problem("name", None, "a", position=Position("other.toml", 3, 4))
        assert engine.located(problem) == problem

    @pytest.mark.parametrize(
        ("typed", "given"), [('""', '""'), ('" a"', " a"), (r'"\u0041"', r'"\u0041"'), ("nan", "nan")]
    )
    def test_given_as_typed(self, typed, given):
        problem = Document.from_text(f"x = {typed}", "m.toml").located(Problem("x", None, "a"))
        assert problem.given == given.strip()

    def test_a_path_that_cannot_be_read(self, engine):
        problem = engine.located(Problem("a..b", None, "x"))
        assert problem == Problem("a..b", None, "x", position=Position("v6.toml", 1, 1))


class TestWithValue:
    def test_keeps_all_else(self, engine):
        changed = engine.with_value("shaft.main.throws[1]", "90 deg")
        assert changed == Document(ENGINE.replace("240 deg", "90 deg"), "v6.toml")

    def test_takes_the_provenance_with_the_value(self, engine):
        changed = engine.with_value('bank.R.mechanism."ζ 1"', "66 deg")
        assert changed.data["bank"]["R"]["mechanism"]["ζ 1"] == "66 deg"

    def test_of_a_text_that_is_not_toml(self):
        problem = problem_of(Document.from_text("a = 1 mm", "m.toml").with_value, "a", "2")
        assert problem.position == Position("m.toml", 1, 7)

    def test_of_an_empty_text(self):
        assert Document.from_text("", "m.toml").with_value("shaft.main.speed", "3 rpm").data == {
            "shaft": {"main": {"speed": "3 rpm"}}
        }

    @pytest.mark.parametrize(("path", "given"), [("name", "\udcff"), ("\udcff", "name")])
    def test_half_characters(self, engine, path, given):
        problem_of(engine.with_value, path, given)


@pytest.mark.parametrize(
    ("typed", "said"),
    [
        ('["0 deg", "90 deg"]', '["0 deg", "90 deg"]'),
        (str([f"{i} mm" for i in range(40)]), "a list of 40, from 0 mm to 39 mm"),
        ('[{ value = "1 mm", note = "a, b" }, { value = "7 mm" }]', "a list of 2, from 1 mm to 7 mm"),
        ('[{ a = "1" }, { b = "2" }]', "a list of 2"),
        ('{ value = "45 mm", status = "assumed", note = "as drawn" }', "45 mm"),
        (str(list(range(100, 140))), "a list of 40"),
    ],
)
def test_what_was_typed_is_quoted_as_one_would_say_it(typed, said):
    """Of a list how many it has, and from where to where; of a number without its status."""
    document = Document.from_text(f"[load.x]\ntravel = {typed}\n", "x.toml")
    assert document.located(Problem("load.x.travel", None, "is wrong")).given == said
