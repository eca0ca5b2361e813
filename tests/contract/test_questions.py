"""What every question brings: its folder with README, its tables, results, dimensions and sources, in its place."""

import re
import tomllib
import types
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import Annotated, Any, get_args, get_origin, get_type_hints

import pytest
from tests.dimensions import DECLARED, DIMENSIONS
from tests.stages import EVERY_STAGE, stages_of

from cranktrain.all_questions import QUESTIONS
from cranktrain.layout.question import needs_of
from cranktrain.machine import Machine
from cranktrain.saying.catalogue import entries
from cranktrain.spec import Spec
from cranktrain.viz import PICTURES
from cranktrain.when_given import meant

ROOT = Path(__file__).parents[2]
FOLDER = ROOT / "src/cranktrain/questions"
OF_LAYOUT = {"units", "name", "rotation", "running", "crank_zero", "angle", "shaft", "mechanism", "bank"}
HEADS = ["Tables", "Parts", "Results", "Rests on", "Theory", "What it does not do"]

every_question = pytest.mark.parametrize("question", QUESTIONS, ids=lambda question: question.name)


def quantities(question) -> list[str]:
    """Names of its results, in the order of their stages."""
    return [entry.name for stage in stages_of(question) for entry in entries(stage.gives)]


def levels() -> dict[str, int]:
    """Of the questions' layers in the settings, the lowest first."""
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"]
    (layers,) = (one["layers"] for one in contracts["contracts"] if one.get("containers") == ["cranktrain.questions"])
    return {name: level for level, names in enumerate(reversed(layers)) for name in names.split(" | ")}


def classes_in(annotation: Any) -> Iterator[type]:
    """Classes that values of a field are of: of a union all, of a mapping what stands in it by name."""
    if get_origin(annotation) is Annotated:
        annotation = meant(get_args(annotation)[0], get_args(annotation)[1:])
    inner = get_args(annotation)
    if isinstance(annotation, type) and not isinstance(annotation, types.GenericAlias):
        yield annotation
    for one in inner[1:] if len(inner) == 2 and inner[0] is str else inner:
        yield from classes_in(one)


def section(question, head: str) -> str:
    """What its README has below a head."""
    text = (FOLDER / question.name / "README.md").read_text(encoding="utf-8")
    return text.partition(f"\n## {head}\n")[2].partition("\n## ")[0]


def test_questions_are_the_folders():
    folders = {path.parent.name for path in FOLDER.glob("*/__init__.py")}
    assert sorted(question.name for question in QUESTIONS) == sorted(folders), (
        "a folder of questions/ is a line in QUESTIONS of all_questions.py, and its Question has the folder's name"
    )


def test_questions_come_in_the_order_of_their_layers():
    level = levels()
    order = [level[question.name] for question in QUESTIONS]
    assert order == sorted(order), "put the question in QUESTIONS behind all that its layer in pyproject.toml stands on"


@every_question
def test_folder_and_pages(question):
    assert (ROOT / f"docs/questions/{question.name}.md").is_file(), "write the page, which includes the folder's README"
    text = (FOLDER / question.name / "README.md").read_text(encoding="utf-8")
    assert text.startswith(f"# {question.name.capitalize().replace('_', ' ')}\n"), (
        "a question's README begins with its name"
    )
    assert [head for head in re.findall(r"^## (.+)$", text, re.MULTILINE) if head in HEADS] == HEADS, (
        "give the README these heads in this order"
    )


@every_question
def test_readme_names_results_that_there_are_in_their_order(question):
    """Not all of them: what is new need not be written there."""
    rows = [line.split(" | ") for line in section(question, "Results").splitlines() if line.startswith("| `")]
    classes = [stage.gives.__name__ for stage in stages_of(question)]
    named = [name for row in rows for name in re.findall(r"`(\w+)`", row[0])]
    assert named == [name for name in classes if name in named], (
        "name the results of the README in the order of the question's stages"
    )
    for row in rows:
        own = re.findall(r"`(\w+)`", row[0])
        names = [
            entry.name for stage in stages_of(question) if stage.gives.__name__ in own for entry in entries(stage.gives)
        ]
        told = [name for name in re.findall(r"`([a-z_]+)`", row[-1]) if name not in DIMENSIONS]
        assert told == [name for name in names if name in told], (
            f"{own}: name quantities that it has, in the order of its fields"
        )


@every_question
def test_readme_names_its_tables_and_headline(question):
    assert {key for key in question.tables if f"[{key}" not in section(question, "Tables")} <= {"gravity"}, (
        "tell these tables in the README, under Tables"
    )
    assert [name for name in question.headline if f"`{name}`" not in section(question, "Results")] == [], (
        "tell these facts of the headline in the README, under Results"
    )


@every_question
def test_readme_rests_on_the_questions_whose_results_it_needs(question):
    homes = {stage.gives: one.name for one in reversed(QUESTIONS) for stage in stages_of(one)}
    needed = {homes[need] for stage in stages_of(question) for need in stage.needs.values() if need in homes}
    linked = set(re.findall(r"/docs/questions/(\w+)\.md\)", section(question, "Rests on")))
    assert needed - {question.name} <= linked, (
        "link the pages of these questions in the README, under Rests on: its stages need their results"
    )


@every_question
def test_sources_are_pages_of_the_theory(question):
    index = (ROOT / "docs/theory/index.md").read_text(encoding="utf-8")
    pages = {f"docs/theory/{name}" for name in re.findall(r"^[a-z0-9-]+$", index, re.MULTILINE)} | {"docs/conventions"}
    sources = {entry.source for stage in stages_of(question) for entry in entries(stage.gives)}
    assert sources <= pages, "a source is a page of docs/theory that its index.md lists"
    assert all((ROOT / f"{source}.md").is_file() for source in sources)
    links = {
        f"docs/{page}" for page in re.findall(r"\(\.\./\.\./\.\./\.\./docs/(.+?)\.md", section(question, "Theory"))
    }
    assert sources <= links, "link these pages of the theory in the README, under Theory"


@every_question
def test_dimensions_are_declared(question):
    for stage in stages_of(question):
        for entry in entries(stage.gives):
            assert set(entry.dimensions) <= DIMENSIONS.keys(), (
                f"{entry.name}: declare these as dimensions of the Question"
            )
    used = {name for stage in EVERY_STAGE for entry in entries(stage.gives) for name in entry.dimensions}
    assert {dimension.name for dimension in question.dimensions} <= used, (
        "no quantity has this dimension: take it out of the Question"
    )


def test_dimensions_are_declared_once():
    assert [name for name, n in Counter(dimension.name for dimension in DECLARED).items() if n > 1] == [], (
        "a dimension that several have is declared once, in layout/parts.py"
    )


@every_question
def test_headline_is_of_its_own_facts(question):
    facts = {entry.name for stage in question.stages for entry in entries(stage.gives) if entry.is_fact}
    assert len(set(question.headline)) == len(question.headline), "name each fact of the headline once"
    assert set(question.headline) <= facts, "its headline is of facts that its own stages give"


def test_each_title_has_a_headline():
    """Questions that answer under one title may share it; one without rows has none."""
    with_headline = {question.title for question in QUESTIONS if question.headline}
    assert {question.title for question in QUESTIONS if question.rows} == with_headline, (
        "give the Question, or one of the same title, a headline: the facts that say most"
    )


@every_question
def test_rows_and_offers_are_of_its_own_results(question):
    """What a row asks for may be of a question asked before; what is offered, and the rows themselves, are its own."""
    asked_before = {stage.gives for one in QUESTIONS[: QUESTIONS.index(question) + 1] for stage in one.stages}
    assert question.title, "give the Question a title: the head of its rows"
    drawn = {name for picture in PICTURES for name in picture.needs} & set(quantities(question))
    assert question.rows or drawn or not question.stages, "what stages give is said in rows, or drawn by a picture"
    assert question.stages or not question.rows, "rows say what stages give"
    for function in question.rows:
        assert function.__module__ == f"cranktrain.questions.{question.name}.rows", (
            "rows stand in the question's rows.py"
        )
        assert set(needs_of(function).types.values()) <= asked_before, (
            "a row asks for results of its question, or of one before it in QUESTIONS"
        )
    assert set(question.offers) <= set(quantities(question)), "a question offers quantities that its own stages give"


@every_question
def test_tables_are_fields_of_the_machine(question):
    hints = get_type_hints(Machine, include_extras=True)
    for key, table in question.tables.items():
        found = [one for one in classes_in(hints[key]) if issubclass(one, table)]
        assert found, key
        assert [one for one in classes_in(hints[key]) if issubclass(one, Spec) and one not in found] == [], key


@every_question
def test_a_question_is_asked_by_its_tables(question):
    asked_by = QUESTIONS.asked_by[question.name]
    assert not asked_by or set(question.tables) <= set(asked_by), (
        "name the question's tables in QUESTIONS of all_questions.py, or none where every machine is asked"
    )


def test_every_table_of_the_machine_is_of_one_question_or_the_layout():
    keys = [*OF_LAYOUT, *(key for question in QUESTIONS for key in question.tables)]
    assert sorted(keys) == sorted(Machine.model_fields), (
        "a field of Machine is a table of one Question, or stands in OF_LAYOUT above"
    )


@every_question
def test_stages_live_in_its_folder(question):
    home = f"cranktrain.questions.{question.name}"
    before = QUESTIONS[: QUESTIONS.index(question)]
    rivals = {stage.gives for one in before for stage in one.over_time()}
    for stage in stages_of(question):
        assert stage.function.__module__.startswith(f"{home}."), "a stage stands in the folder of its question"
        assert stage.gives.__module__.startswith((f"{home}.", "cranktrain.layout.")) or stage.gives in rivals, (
            "a result stands beside its stage, or below, in layout; or another stage over time gives it, too"
        )


@every_question
def test_what_shows_a_use_is_computed_by_then(question):
    before = QUESTIONS[: QUESTIONS.index(question) + 1]
    results = {stage.gives for one in before for stage in one.stages}
    for use in question.uses:
        assert {*use.results, *filter(None, [use.instead])} <= results, (
            "a Use names results of its question, or of one before it in QUESTIONS"
        )
