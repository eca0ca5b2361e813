import copy
import subprocess
import sys
import tomllib

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from tests.sentences import NO_PATH, SET_A_KEY, WHOLE_LIST

from cranktrain.errors import InputError
from cranktrain.io.document import Document
from cranktrain.io.editing import toml_value, with_value
from cranktrain.io.text_spans import places
from cranktrain.paths import path_text, quantity_path


class TestQuantityPath:
    @pytest.mark.parametrize(
        ("path", "parts"),
        [
            ("name", ("name",)),
            ("bank.R.mechanism.rod_length", ("bank", "R", "mechanism", "rod_length")),
            ("shaft.main.throws[3]", ("shaft", "main", "throws", 3)),
            ("mechanism.part[1].rod.length", ("mechanism", "part", 1, "rod", "length")),
            ("a[0][12].b", ("a", 0, 12, "b")),
            ('cylinder."1.exhaust".bore', ("cylinder", "1.exhaust", "bore")),
            ("cylinder.'1.exhaust'.bore", ("cylinder", "1.exhaust", "bore")),
            (r'a."\u0416 \"" . b [ 2 ]', ("a", 'Ж "', "b", 2)),
            ("банк.left bank.x", ("банк", "left bank", "x")),
            ('""', ("",)),
        ],
    )
    def test_parts(self, path, parts):
        assert quantity_path(path) == parts

    @pytest.mark.parametrize(
        "path",
        [
            "",
            ".",
            "a.",
            ".a",
            "a..b",
            "[0]",
            "a[",
            "a[x]",
            "a[-1]",
            "a[0]b",
            "a]",
            'a"b"',
            '"a',
            r'"\q"',
            "a=b",
            "a\nb",
        ],
    )
    def test_no_path(self, path):
        with pytest.raises(InputError, match=NO_PATH):
            quantity_path(path)

    @given(st.lists(st.text(st.characters(codec="utf-8"), max_size=5) | st.integers(0, 10**9 - 1), max_size=6))
    def test_undoes_path_text(self, rest):
        parts = ("a", *rest)
        assert quantity_path(path_text(parts)) == parts


class TestTomlValue:
    @pytest.mark.parametrize(
        "text",
        [
            "14.5",
            "-3",
            "0x1F",
            "1_000",
            "true",
            "nan",
            "-inf",
            '"3 mm"',
            "'3'",
            "[1, [2]]",
            "[]",
            "{ a = 1 }",
            "[\n1,\n]",
        ],
    )
    def test_taken_as_it_is(self, text):
        assert toml_value(f" {text} ") == text

    @pytest.mark.parametrize(
        "text",
        [
            "320 mm", "dual", "True", "1,5", "2020-02-29", "07:30:00", "a\\b", '5 "in"', "ж\x7f\x01", "1 # one",
            "1, b = 2", "1\nb = 2", "1}\nc = { d = 2", "1 }", "9" * 5000, "01", "1.",
        ],
    )  # fmt: skip
    def test_written_as_text(self, text):
        assert tomllib.loads(f"x = {toml_value(text)}") == {"x": text}

    @pytest.mark.parametrize("text", ["[0 deg]", "[1", '"abc', "'", "{ a = 3 mm }", '"a" b', "[" * 5000])
    def test_broken(self, text):
        with pytest.raises(InputError, match="is no value"):
            toml_value(text)

    @pytest.mark.parametrize("text", ["", "  "])
    def test_none(self, text):
        with pytest.raises(InputError, match="no value is given"):
            toml_value(text)


class TestWithValue:
    @pytest.mark.parametrize(
        ("text", "path", "value", "changed"),
        [
            ("a = 1  # one\n", "a", "2 mm", 'a = "2 mm"  # one\n'),
            ("a = [1, 2] # x", "a[1]", "3", "a = [1, 3] # x"),
            ("a = [\n  1,  # one\n  2,\n]\n", "a[0]", "3", "a = [\n  3,  # one\n  2,\n]\n"),
            ('a = { value = "1 m", status = "fitted" } # f', "a", "2 m", 'a = "2 m" # f'),
            ('a = { value = "1 m", status = "y" } # f', "a.status", "x", 'a = { value = "1 m", status = "x" } # f'),
            ('a = { value = "1 m" }', "a.note", "of me", 'a = { value = "1 m", note = "of me" }'),
            ("a = { }", "a.b.c", "1", "a = { b.c = 1 }"),
            ("a = { b.c = 1 }", "a.b.d", "2", "a = { b.c = 1, b.d = 2 }"),
            ("a = [{}, { b = 1 }]", "a[1].c", "2", "a = [{}, { b = 1, c = 2 }]"),
            ("'a b'.\"c\" = 1", "a b.c", "2", "'a b'.\"c\" = 2"),
            ("x = 'ж'\r\n", "y", "1", "x = 'ж'\r\ny = 1\r\n"),
            ("x = 1 # one", "y", "2", "x = 1 # one\ny = 2"),
            ("# t\n\n[a]\nx = 1\n", "name", "n", '# t\n\nname = "n"\n\n[a]\nx = 1\n'),
            ("# t", "name", "n", '# t\nname = "n"\n'),
            ("", "name", "n", 'name = "n"\n'),
            ("[a] # a\n\n# of b\n[b]\n", "a.x", "1", "[a] # a\nx = 1\n\n# of b\n[b]\n"),
            ("[a]\n  x = [\n  1] # x\n\n # b\n[b]\n", "a.y", "1", "[a]\n  x = [\n  1] # x\n  y = 1\n\n # b\n[b]\n"),
            ("[a]\nx = 1\n", "b.c.y", "2", "[a]\nx = 1\n\n[b.c]\ny = 2\n"),
            ("[a]\nx = 1", "a.b.y z", "2", '[a]\nx = 1\n\n[a.b]\n"y z" = 2\n'),
            ("[a.b]\nx = 1\n", "a.y", "2", "[a]\ny = 2\n\n[a.b]\nx = 1\n"),
            ("[a]\nb.x = 1\n[c]\n", "a.b.y", "2", "[a]\nb.x = 1\nb.y = 2\n[c]\n"),
            ("[a]\nb.x = 1\n[c]\n", "a.b.c.y", "2", "[a]\nb.x = 1\nb.c.y = 2\n[c]\n"),
            ("[a.b.c]\nx = 1\n[a]\nb.y = 2\n", "a.b.z", "3", "[a.b.c]\nx = 1\n[a]\nb.y = 2\nb.z = 3\n"),
            ("[[m.p]]\nx = 1\n[[m.p]]\n", "m.p[0].r.l", "2", "[[m.p]]\nx = 1\nr.l = 2\n[[m.p]]\n"),
            ("[[m.p]]\n[[m.p]]\n[m.p.r.q]\n", "m.p[1].r.l", "2", "[[m.p]]\n[[m.p]]\n[m.p.r]\nl = 2\n\n[m.p.r.q]\n"),
            ("[[m.p]]\n", "m.kind", "chain", '[m]\nkind = "chain"\n\n[[m.p]]\n'),
        ],
    )  # fmt: skip
    def test_text(self, text, path, value, changed):
        assert with_value(text.encode(), path, value).decode() == changed
        tomllib.loads(changed)

    @pytest.mark.parametrize(
        ("path", "said"),
        [
            ("t[2]", rf"t\[2\]: t is a list: only t\[0\] to t\[1\]; {WHOLE_LIST}t=\[…\]"),
            ("t.x", rf"t.x: t is a list: only t\[0\] to t\[1\]; {WHOLE_LIST}t=\[…\]"),
            ("one[1]", rf"one\[1\]: one is a list: only one\[0\]; {WHOLE_LIST}one=\[…\]"),
            ("none[0]", rf"none\[0\]: none is an empty list; {WHOLE_LIST}none=\[…\]"),
            (
                "n.x",
                'n.x: n is a plain value, with nothing under it; set it whole: n={ value = "…", status',
            ),
            ("n[0]", r"n\[0\]: n is a plain value"),
            ("a", f"a: a {SET_A_KEY}; a.b, a.c"),
            ("a.b", f"a.b: a.b {SET_A_KEY}; a.b.x"),
            ("a[0]", rf"a\[0\]: a {SET_A_KEY}"),
            ("m.p", r"m.p: m.p is a list: only m.p\[0\] to m.p\[1\]$"),
            ("m.p[2].x", r"m.p\[2\].x: m.p is a list: only m.p\[0\] to m.p\[1\]$"),
            ("m.p[1]", rf"m.p\[1\]: m.p\[1\] {SET_A_KEY}$"),
            ("q.w[0]", r"q.w\[0\]: there is no list q.w; set the whole list: q.w=\[…\]"),
            ("a.c.w[0].y", r"a.c.w\[0\].y: there is no list a.c.w; set the whole list: a.c.w=\[…\]"),
        ],
    )
    def test_refusals(self, path, said):
        text = b"n = 1\nt = [1, 2]\none = [1]\nnone = []\n[a.b]\nx = 1\n[a.c]\n[[m.p]]\nx = 1\n[[m.p]]\n"
        with pytest.raises(InputError, match=said):
            with_value(text, path, "3")


KEYS = st.sampled_from(["a", "b", "rod_length", "2L", "1.exhaust", "ключ", 'q "', "-"])
SCALARS = st.sampled_from(
    ["1", "-2.5", "true", "1e-3", '"180 mm"', "'x # y'", r'"ж\u0416\n\""', '"""[a]\n# b = 1"""', '"}, ]"']
)
COMMENTS = st.sampled_from(["", "  # note", " # [a] = {", ' # "ж'])


class Writer:
    """Writes random data as TOML text in random layout; leaves are the text of scalars."""

    def __init__(self, draw):
        self.draw = draw

    def key(self, name):
        bare = name.isascii() and name.replace("_", "a").replace("-", "a").isalnum()
        if bare and self.draw(st.booleans()):
            return name
        return f"'{name}'" if self.draw(st.booleans()) else '"' + name.replace('"', '\\"') + '"'

    def comment(self):
        return self.draw(COMMENTS)

    def value(self, value):
        if isinstance(value, list):
            gap = self.draw(st.sampled_from(["", " ", "\n  "]))
            return "[" + gap + f", {gap}".join(self.value(item) for item in value) + gap + "]"
        if isinstance(value, dict):
            pairs = [pair for name, inner in value.items() for pair in self.pairs(name, inner, "")]
            return "{ " + ", ".join(f"{key} = {text}" for key, text in pairs) + "}"
        return value

    def pairs(self, name, value, prefix):
        key = prefix + self.key(name)
        if isinstance(value, dict) and value and self.draw(st.booleans()):
            return [pair for inner in value.items() for pair in self.pairs(*inner, f"{key}{self.draw(DOTS)}")]
        return [(key, self.value(value))]

    def table(self, table, above):
        lines, sections = [], []
        for name, value in table.items():
            here = [*above, self.key(name)]
            if isinstance(value, dict) and self.draw(st.booleans()):
                body, inner = self.table(value, here)
                if body or not inner or self.draw(st.booleans()):
                    inner.insert(0, [f"[{'.'.join(here)}]{self.comment()}", *body])
                sections += inner
            elif isinstance(value, list) and value and all(isinstance(item, dict) for item in value):
                for item in value:
                    body, inner = self.table(item, here)
                    sections += [[f"[[{' . '.join(here)}]]{self.comment()}", *body], *inner]
            else:
                indent = self.draw(st.sampled_from(["", "  "]))
                lines += [f"{indent}{key} = {text}{self.comment()}" for key, text in self.pairs(name, value, "")]
        return lines, sections


DOTS = st.sampled_from([".", " . "])
VALUES = st.recursive(
    SCALARS, lambda inner: st.lists(inner, max_size=3) | st.dictionaries(KEYS, inner, max_size=3), max_leaves=8
)


@st.composite
def documents(draw):
    data = draw(st.dictionaries(KEYS, VALUES, max_size=4))
    writer = Writer(draw)
    lines, sections = writer.table(data, [])
    gap = draw(st.sampled_from(["\n", "\n\n", "\n# between\n"]))
    text = gap.join(["\n".join(lines), *("\n".join(section) for section in sections)])
    text += draw(st.sampled_from(["", "\n"]))
    return text.replace("\n", draw(st.sampled_from(["\n", "\r\n"])))


def paths_of(value, path=()):
    yield path
    if isinstance(value, dict):
        for key, inner in value.items():
            yield from paths_of(inner, (*path, key))
    if isinstance(value, list):
        for place, inner in enumerate(value):
            yield from paths_of(inner, (*path, place))


def at(data, path):
    for part in path:
        data = data[part]
    return data


@settings(max_examples=150, deadline=None)
@given(documents())
def test_every_place_is_found(text):
    data = tomllib.loads(text)
    source = text.encode()
    found = places(source)
    assert not found.repeated
    for path in list(paths_of(data))[1:]:
        place = found.deepest(path)
        assert place.path == path
        if place.kind in ("scalar", "list", "inline"):
            assert tomllib.loads(f"x = {source[place.start : place.end].decode()}") == {"x": at(data, path)}
        position = Document(text, "").locate(path_text(path))
        assert (
            text.split("\n")[position.line - 1][position.column - 1 :]
            .encode()
            .startswith(source[place.start : place.end].split(b"\n")[0])
        )


@settings(max_examples=250, deadline=None)
@given(documents(), st.data())
def test_edited_text_says_exactly_what_is_wanted(text, choices):
    document = Document(text, "m.toml")
    data = tomllib.loads(text)
    path = choices.draw(st.sampled_from(list(paths_of(data))))
    if isinstance(at(data, path), dict):
        path += tuple(choices.draw(st.lists(KEYS, max_size=3)))
    value = choices.draw(st.sampled_from(["320 mm", "14.5", '["0 deg", 1]', "{ value = 1 }", "dual", "'q'"]))
    wanted = copy.deepcopy(data)
    try:
        changed = document.with_value(path_text(path), value)
    except InputError:
        # Refused is only what the text writes as a table with keys of its own, or what leads through no table.
        assert is_table_or_blocked(data, path)
        return
    inner = wanted
    for part in path[:-1]:
        inner = inner.setdefault(part, {}) if isinstance(inner, dict) else inner[part]
    inner[path[-1]] = tomllib.loads(f"x = {toml_value(value)}")["x"]
    assert tomllib.loads(changed.text) == wanted
    if not exists(data, path):
        assert is_with_one_piece_more(changed.text, text)


def is_with_one_piece_more(changed, text):
    more = len(changed) - len(text)
    return more > 0 and any(changed[:place] + changed[place + more :] == text for place in range(len(text) + 1))


def exists(data, path):
    try:
        at(data, path)
    except (KeyError, IndexError, TypeError):
        return False
    return True


def is_table_or_blocked(data, path):
    if exists(data, path):
        value = at(data, path)
        return isinstance(value, dict) or (isinstance(value, list) and any(isinstance(item, dict) for item in value))
    while not exists(data, path):
        path = path[:-1]
    return not isinstance(at(data, path), dict)


def test_tree_sitter_is_loaded_only_when_needed():
    code = (
        "import sys; from cranktrain.io.document import Document; "
        "assert Document.from_text('a = 1', 'm').data == {'a': 1}; assert 'tree_sitter' not in sys.modules"
    )
    subprocess.run([sys.executable, "-c", code], check=True)
