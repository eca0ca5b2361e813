"""`textbook --source`: the texts, their formulas with the commands that show them, and what a new user mistypes."""

import re
import shlex

import pytest
from tests.sentences import FOR_MOTION_OR_FORCES

from cranktrain.texts.contents import TEXTS

SCREEN = 45
"""Lines of the first screen, at most."""
SCREENS = [
    *([name, *more] for name in ("3d12", "10d100", "great_northern", "m_503", "deltic") for more in ([], ["--table"])),
    ["10d100", "--source", "bolotin", "--table"],
    ["errata"],
    *(["--drive", name] for name in ("example", "tilting_table")),
    ["--drive", "example", "--set", "i=20"],
    *(["--throw", name] for name in ("example", "kamaz_740", "ls3")),
    ["--throw", "kamaz_740", "--throw-number", "3", "--at", "420", "--table"],
    *(["--forces", "kN", name] for name in ("3d12", "vaz_21213")),
    *(["errata", "--source", text.letter] for text in TEXTS),
]
OTHERS = {
    "3d12": [
        "textbook 3d12 --source steam-engine",
        "textbook 3d12 --source bolotin",
        "textbook --throw 3d12",
    ],
    "pumping_unit_c57": ["textbook pumping_unit_c57 --source gandzha"],
    "shaper": [],
}
"""What has something for a machine of which a text does not speak."""
COMMANDS = {command: text.name for text in TEXTS for one in text.formulas for command in one.commands}


@pytest.mark.parametrize("text", TEXTS, ids=lambda text: text.name)
def test_every_formula_is_listed_with_what_it_is(typed, text):
    answer = typed("textbook", "--source", text.name, "--full")
    assert (answer.status, answer.errors) == (0, "")
    # a command is not folded, so that it can be copied
    assert all(len(line) <= 80 or line.startswith(("  see ", "  of a machine ")) for line in answer.output.splitlines())
    for one in text.formulas:
        assert f"\n{one.number}  " in answer.output
        for command in one.commands:
            assert re.search(rf"^  (see|of a machine) +{re.escape(command)}$", answer.output, re.MULTILINE)
    assert answer.output.count("\n  it is  ") == len(text.formulas)


@pytest.mark.parametrize("text", TEXTS, ids=lambda text: text.name)
def test_the_first_screen_of_a_text_has_every_formula_in_a_line(typed, text):
    lines = typed("textbook", "--source", text.name).output.splitlines()
    assert len(lines) <= SCREEN
    assert all(len(line) <= 80 for line in lines)
    heads = {line: place for place, line in enumerate(lines) if line and not line.startswith(" ")}
    for one in text.formulas:
        places = [place for place, line in enumerate(lines) if line.startswith(f"  {one.number}  ")]
        said = {max((head for head in heads if heads[head] < place), key=heads.get) for place in places}
        assert one.said_verdict[:1].upper() + one.said_verdict[1:] in said
    assert sum(line.startswith("  ") for line in lines) >= len(text.formulas)
    assert re.search(r"^  `cranktrain textbook --source . --full`: all of them so$", "\n".join(lines), re.MULTILINE)
    (example,) = re.findall(r"`(cranktrain textbook --source . --equation \S+)`", "\n".join(lines))
    assert "\n  it is  " in typed(*shlex.split(example)[1:]).output


@pytest.mark.parametrize("arguments", SCREENS, ids=" ".join)
def test_a_page_begins_with_one_screen(typed, arguments):
    """With no sign or unit that is not as in print, and with the command for the rest, which can be typed."""
    answer = typed("textbook", *arguments)
    assert (answer.status, answer.errors) == (0, "")
    lines = answer.output.splitlines()
    assert len(lines) <= SCREEN
    assert all(len(line) <= 80 for line in lines)
    assert not re.search(r"\bdeg\b|\*m|\^[23]|(?<![\w.-])-\d", answer.output)
    rest = re.search(r"`cranktrain (textbook [^`]*--full[^`]*)`", " ".join(answer.output.replace("\\\n", " ").split()))
    assert rest
    whole = typed(*shlex.split(rest[1]))
    assert (whole.status, whole.errors) == (0, "")
    assert whole.output.splitlines()[0] == lines[0]
    assert not re.search(r"\bdeg\b|\*m|\^[23]", whole.output)


def test_without_a_name_the_texts_are_listed(typed):
    answer = typed("textbook", "--source")
    assert (answer.status, answer.errors) == (0, "")
    for text in TEXTS:
        assert f"\n{text.name}\n" in answer.output
        assert f"{len(text.formulas)} formulas and figures: " in answer.output


@pytest.mark.parametrize("text", TEXTS, ids=lambda text: text.name)
def test_commands_of_a_page_can_be_typed_in_order(text):
    """No two write one file."""
    commands = dict.fromkeys(command for one in text.formulas for command in one.commands if " -o " in command)
    written = [command.rpartition(" -o ")[2] for command in commands]
    assert len(set(written)) == len(written)


@pytest.mark.parametrize("command", COMMANDS)
def test_every_command_shows_its_formula(typed, command):
    answer = typed(*shlex.split(command)[1:])
    assert (answer.status, answer.errors) == (0, "")
    if not command.startswith("cranktrain textbook"):
        return
    (text,) = (text for text in TEXTS if text.name == COMMANDS[command])
    for one in text.formulas:
        if command in one.commands and one.number.startswith("("):
            assert one.number in answer.output or one.number in ("(6)", "(8)", "(9)")  # (4) and (10) in other words


@pytest.mark.parametrize(
    ("arguments", "said"),
    [
        (["--source", "bolotni"], '; write "bolotin"\n'),
        (["--source", "3d12"], "; a machine stands before it: cranktrain textbook 3d12\n"),
        (
            ["bolotin"],
            "bolotin  is a text, and no machine file is called so; such as: cranktrain textbook --source bol",
        ),
        (["--source", "bolotin", "--table"], "--table: is for a machine: name FILE\n"),
        (["errata", "--table"], "--table: is for a machine: name FILE\n"),
        (["errata", "--set", "a=1"], "--set  a=1: is for a machine: name FILE\n"),
        (["3d12", "--harmonics", "--full"], f"--full: {FOR_MOTION_OR_FORCES}"),
        (["--equation", "337", "--full"], "--full: must be left out beside --equation"),
        (["--source", "bolotin", "--set", "a=1"], "--set  a=1: is for a machine: name FILE\n"),
        (["3d12", "--source", "bolotin", "--harmonics"], "--source  bolotin: is for the motion or its forces"),
        (["3d12", "--source", "bolotin", "--forces", "N"], "--source  bolotin: is for the motion: ask for it without"),
    ],
)
def test_mistakes(typed, arguments, said):
    answer = typed("textbook", *arguments)
    assert (answer.status, answer.output) == (2, "")
    assert said in answer.errors.replace(" = ", "  ", 1)


@pytest.mark.parametrize(
    ("file", "source", "said"),
    [
        ("3d12", "gandzha", "[gandzha] speaks of crank-rockers; the mechanisms of this machine are"),
        ("pumping_unit_c57", "bolotin", "[bolotin] speaks of opposed pistons, and slaves on articulated rods"),
        ("shaper", "steam-engine", "[steam-engine] speaks of central slider-cranks and eccentrics"),
        ("3d12", "synthesis", "[slider-crank-synthesis] speaks of dimensions that are sought, not a machine"),
        ("3d12", "crankshaft", "[crankshaft-reactions] speaks of crankshafts with their supports"),
    ],
)
def test_a_machine_of_which_a_text_does_not_speak(typed, file, source, said):
    answer = typed("textbook", file, "--source", source)
    assert (answer.status, answer.errors) == (0, "")
    assert said in " ".join(answer.output.split())
    commands = re.findall(r"`cranktrain ([^`]+)` has something for this machine", " ".join(answer.output.split()))
    assert commands == OTHERS[file]
    for command in commands:
        shown = typed(*shlex.split(command))
        assert (shown.status, shown.errors) == (0, "")
        assert "speaks of" not in shown.output


def test_one_text_alone_for_a_machine(typed):
    for more in ([], ["--table"], ["--full"]):
        output = typed("textbook", "3d12", "--source", "bolotin", *more).output
        assert "(I.13)" in output
        assert "(333)" not in output
        assert "[steam-engine]" not in output


def test_errata_of_one_text(typed):
    output = typed("textbook", "errata", "--source", "bolotin").output
    assert "[bolotin]" in output
    assert "[slider-crank-synthesis]" not in output


def test_a_formula_by_its_number(typed):
    done = typed("textbook", "--equation", "44", "--source", "e")
    assert (done.status, done.errors) == (0, "")
    assert "(44)" in done.output and "cranktrain textbook --throw example" in done.output


@pytest.mark.parametrize(
    ("arguments", "answer"),
    [
        (
            ["--equation", "999"],
            "--equation = 999: must be the number of a formula, figure or page: A fig. 146, (333)–(335)",
        ),
        (["--equation", ""], "must be the number"),
        (
            ["--equation", "44", "--source", "Z"],
            "--source = Z: must be the name of a text, its letter or its author: A",
        ),
        (["3d12", "--equation", "44", "--harmonics"], "must be left out beside --equation"),
        (["--equation", "20", "--drive", "example"], "--drive = example: must be left out beside --equation"),
    ],
)
def test_bad_numbers_are_answered(typed, arguments, answer):
    done = typed("textbook", *arguments)
    assert done.status == 2
    assert answer in " ".join(done.errors.split())


@pytest.mark.parametrize(
    ("spelt", "heading"),
    [
        *((one, "fig. 35") for one in ("35", "fig35", "fig. 35", "Figure 35", "рис. 35")),
        ("fig 146", "fig. 146"),
        *((one, "p. 14") for one in ("p14", "p. 14", "стр. 14")),
        ("eq 44", "(44)"),
        ("equation 44", "(44)"),
        *((one, "(I.13)") for one in ("I13", "I.13", "i 13")),
        ("p. 19", "p. 19, 1"),
        ("fig 1.3", "fig. 1.3"),
        ("2", "(2)"),
        ("fig. 2", "fig. 2"),
    ],
)
def test_numbers_are_found_as_people_write_them(typed, spelt, heading):
    answer = typed("textbook", "--equation", spelt)
    assert (answer.status, answer.errors) == (0, "")
    assert f"\n{heading}  " in answer.output


def test_a_number_that_no_text_has_is_told_with_those_there_are(typed):
    wrong = typed("textbook", "--equation", "99")
    assert wrong.status == 2
    for words in ("A fig. 146, (333)–(335), fig. 147, (336)–(337)", "B fig. 1, (1)–(21), fig. 2", "p. 14", "fig. 35"):
        assert words in wrong.errors
    other = typed("textbook", "--source", "bolotin", "--equation", "337")
    assert other.status == 2
    assert "that number is in A steam-engine" in other.errors
