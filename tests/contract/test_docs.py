"""The documentation: it builds without a warning, its equations are numbered as labelled, and its blocks are run."""

import importlib.util
import re
import shutil
import subprocess
import sys
from collections import Counter
from collections.abc import Callable
from html import unescape
from pathlib import Path

import pytest

import cranktrain as ct
from cranktrain.analysis import every_stage
from cranktrain.io.schema import machine_schema
from cranktrain.saying.catalogue import entries

ROOT = Path(__file__).parents[2]
DOCS = ROOT / "docs"
PAGES = sorted(DOCS.rglob("*.md"))
LABELS = {
    page.stem: re.findall(r"^\$\$ \((.+)\)$", page.read_text(encoding="utf-8"), re.MULTILINE)
    for page in PAGES
    if page.parent == DOCS / "theory"
}
DECISIONS = sorted((DOCS / "decisions").glob("[0-9]*.md"))
DECISION_HEADS = ["Context", "Choice", "Considered", "What would change our mind"]
CITED = re.compile(
    r"docs/theory/(?P<page>[\w-]+)(?:,\s+eqs?\.?\s+(?P<equations>\(\d+\.\d+\)(?:(?:,| to| and) \(\d+\.\d+\))*))?"
)

BLOCKS_THAT_HOLD = """\
```console
$ cranktrain new "a part" > made.txt
$ cat made.txt
new a part
$ cranktrain run \\
    made.txt
run ...txt
```

```python
from pathlib import Path
text = Path("made.txt").read_text(encoding="utf-8")
```

```python
>>> text
'new a part\\n'
```

```console
$ a command of something else
```
"""
BLOCKS_THAT_FAIL = {
    "other output": "```console\n$ cranktrain list\nsomething else\n```\n",
    "crash": "```console\n$ cranktrain crash\ncrash\n```\n",
    "python": "```python\nassert 1 == 2\n```\n",
    "doctest": "```python\n>>> 1 + 1\n3\n```\n",
}
ECHO = """\
def main(arguments):
    print(*arguments)
    return "crash" in arguments
"""
START = "import sys\nfrom cranktrain.cli import main\nsys.exit(main(sys.argv[1:]))\n"


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    """The documentation as HTML, where what it takes is installed."""
    pytest.importorskip("myst_nb", reason="the documentation is built with the extra `docs`")
    folder = tmp_path_factory.mktemp("site")
    done = subprocess.run(
        [sys.executable, "-m", "sphinx", "-nW", "--keep-going", "-q", "-d", folder / "doctrees", DOCS, folder / "html"],
        cwd=folder,
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return folder / "html"


@pytest.mark.parametrize("page", LABELS)
def test_equations_are_numbered_as_labelled(site, page):
    html = (site / "theory" / f"{page}.html").read_text(encoding="utf-8")
    assert re.findall(r'class="eqno">\((.+?)\)', html) == LABELS[page]


def test_readers_need_no_network(site):
    """Links may lead elsewhere; what a page shows comes with it."""
    fetched = re.compile(r"""<(?:script|img|link|iframe|source)\b[^>]*?(?:src|href)=["'](?:https?:)?//""")
    pages = {path.relative_to(site).as_posix(): path.read_text(encoding="utf-8") for path in site.rglob("*.html")}
    assert [name for name, html in pages.items() if fetched.search(html)] == []
    styles = "".join(path.read_text(encoding="utf-8") for path in site.rglob("*.css"))
    assert re.findall(r"url\([\"']?https?:[^)]*\)|@import[^;]*", styles) == []


def test_formulas_are_for_browsers(site):
    html = (site / "theory/forces.html").read_text(encoding="utf-8")
    source = (DOCS / "theory/forces.md").read_text(encoding="utf-8")
    assert html.count('<math xmlns="http://www.w3.org/1998/Math/MathML" display="block">') == len(LABELS["forces"])
    assert r"\mathbf r" in source
    assert "<mi>\N{MATHEMATICAL BOLD SMALL R}</mi>" in html
    assert r"\math" not in html


def test_all_keys_of_the_machine_file_stand_in_the_tables(site):
    """By the schema: every table once, with its sentence and every key of it."""
    html = "".join(page.read_text(encoding="utf-8") for page in sorted((site / "machine-file").glob("*.html")))
    schema = machine_schema()
    tables = {name: made for name, made in schema["$defs"].items() if "properties" in made and "InBank" not in name}
    headed = {key for key in schema["properties"] if f'<section id="{key.replace("_", "-")}">' in html}
    keys = {key for table in (schema, *tables.values()) for key in table["properties"]} - headed
    assert {key for key in keys if f'<span class="pre">{key}</span>' not in html} == set()
    said = re.sub(r"<[^>]*>|\s+", "", unescape(html)).replace("\N{RIGHT SINGLE QUOTATION MARK}", "'")
    plain = {name: re.sub(r"[`\s]", "", made["description"]) for name, made in tables.items()}
    assert [name for name, sentence in plain.items() if sentence not in said] == []


def test_the_index_of_the_machine_file_has_every_key_and_leads_to_its_tables(site):
    index = (site / "machine-file.html").read_text(encoding="utf-8")
    links = set(re.findall(r'href="machine-file/([\w-]+\.html)#(table-[\w-]+)"', index))
    pages = {page.name: page.read_text(encoding="utf-8") for page in (site / "machine-file").glob("*.html")}
    assert [link for link in links if f'id="{link[1]}"' not in pages[link[0]]] == []
    schema = machine_schema()
    tables = [made for name, made in schema["$defs"].items() if "properties" in made and "InBank" not in name]
    headed = {key for html in pages.values() for key in re.findall(r'<section id="([\w-]+)">', html)}
    keys = {key for table in (schema, *tables) for key in table["properties"] if key.replace("_", "-") not in headed}
    assert {key for key in keys if f'<span class="pre">{key}</span>' not in index} == set()


def test_all_results_stand_in_the_table(site):
    html = (site / "results.html").read_text(encoding="utf-8")
    names = [entry.name for stage in every_stage() for entry in entries(stage.gives)]
    assert len(names) > 200
    assert [name for name in names if f">{name}</span>" not in html] == []


def test_all_public_names_stand_in_the_reference(site):
    html = (site / "api.html").read_text(encoding="utf-8")
    names = [name for name in ct.__all__ if isinstance(getattr(ct, name), Callable)]
    assert "run" in names
    assert [name for name in names if f'id="cranktrain.{name}"' not in html] == []


def test_pictures_are_there(site):
    """Each has words for those who do not see it."""
    shown = [
        (path, tag)
        for path in site.rglob("*.html")
        for tag in re.findall(r"<img\b[^>]*>", path.read_text(encoding="utf-8"))
    ]
    drawn = [(path, tag) for path, tag in shown if "_images" in tag]
    assert len(drawn) > 15
    for path, tag in drawn:
        where, words = re.search(r'src="([^"]+)"', tag), re.search(r'alt="([^"]+)"', tag)
        assert where is not None
        assert (path.parent / where[1]).stat().st_size > 1000, tag
        assert words is not None, tag


def test_every_equation_has_a_label_of_its_own():
    labels = Counter(label for page in LABELS.values() for label in page)
    assert [label for label, n in labels.items() if n > 1] == [], "number the equation on: two have this number"


def test_theory_cited_by_the_code_exists():
    lost = []
    for path in (ROOT / "src").rglob("*.py"):
        for cited in CITED.finditer(path.read_text(encoding="utf-8")):
            equations = set(re.findall(r"\d+\.\d+", cited["equations"] or ""))
            if cited["page"] not in LABELS or not equations <= set(LABELS[cited["page"]]):
                lost.append((path.relative_to(ROOT).as_posix(), cited[0]))
    assert lost == [], "these pages or equations are not in docs/theory: cite what is there"


def test_files_that_pages_name_are_there():
    """Named from the package or the root: `questions/gas/chambers.py`."""
    named = [
        (page.relative_to(ROOT).as_posix(), file)
        for page in (*PAGES, ROOT / "CONTRIBUTING.md")
        for file in re.findall(r"`((?:\w+/)+\w+\.(?:py|toml))`", page.read_text(encoding="utf-8"))
    ]
    assert len(named) > 20
    places = (ROOT, ROOT / "src/cranktrain")
    assert [(page, file) for page, file in named if not any((place / file).is_file() for place in places)] == []


@pytest.mark.parametrize("page", DECISIONS, ids=lambda page: page.stem)
def test_decision_has_its_heads(page):
    text = page.read_text(encoding="utf-8")
    assert re.findall(r"^## (.+)$", text, re.MULTILINE) == DECISION_HEADS, "a decision has these heads, in this order"
    assert re.search(rf"^# {int(page.stem[:4])}\. ", text)


@pytest.fixture(scope="module")
def blocks_run(tmp_path_factory):
    """Pages of blocks run with this project's conftest and a `cranktrain` that only repeats its arguments."""
    folder = tmp_path_factory.mktemp("blocks")
    shutil.copy(ROOT / "conftest.py", folder)
    (folder / "cranktrain").mkdir()
    (folder / "cranktrain/__init__.py").touch()
    (folder / "cranktrain/cli.py").write_text(ECHO, encoding="utf-8")
    (folder / "cranktrain/__main__.py").write_text(START, encoding="utf-8")
    (folder / "pytest.ini").write_text("[pytest]\n", encoding="utf-8")
    (folder / "README.md").write_text(BLOCKS_THAT_HOLD, encoding="utf-8")
    (folder / "docs").mkdir()
    for reason, text in BLOCKS_THAT_FAIL.items():
        (folder / f"docs/{reason}.md").write_text(text, encoding="utf-8")
    command = [sys.executable, "-m", "pytest", "-p", "no:cacheprovider", "-p", "no:xdist", "-rA", "README.md", "docs"]
    return subprocess.run(command, cwd=folder, capture_output=True, encoding="utf-8", check=False).stdout


def outcomes(said: str, page: str) -> list[str]:
    """What became of the blocks of a page."""
    return re.findall(rf"^([A-Z]+) {re.escape(page)}::", said, re.MULTILINE)


def test_blocks_that_hold_pass(blocks_run):
    assert outcomes(blocks_run, "README.md") == ["PASSED"] * 4, blocks_run


@pytest.mark.parametrize("reason", BLOCKS_THAT_FAIL)
def test_blocks_that_do_not_hold_fail(blocks_run, reason):
    assert outcomes(blocks_run, f"docs/{reason}.md") == ["FAILED"], blocks_run


def test_pages_of_the_texts_are_made_of_what_the_program_knows():
    """Where this fails: `python docs/text_pages.py` makes them anew."""
    spec = importlib.util.spec_from_file_location("text_pages", DOCS / "text_pages.py")
    text_pages = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(text_pages)
    written = {path.name: path.read_text(encoding="utf-8") for path in (DOCS / "texts").glob("*.md")}
    assert written == text_pages.pages()
