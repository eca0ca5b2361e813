"""Every bad file is answered with file, line, field, value and what is allowed; nothing is written."""

import pytest
from tests.sentences import (
    AN_INERTIA,
    CANNOT_CLOSE,
    FIRST_IN_LINE,
    GAP_OVER_CREST,
    IS_A_FOLDER,
    IS_IT_THE_EXAMPLE,
    NO_FILE,
    NOT_A_KEY,
    NOT_POSITIVE,
    QUOTES,
    TOO_LARGE,
)

HEAD = 'name = "x"\n[mechanism]\nkind = "slider_crank"\n'
BANKS = """\
[shaft.main]
throws = ["0 deg", "180 deg"]
[bank.A]
[bank.A.mechanism]
kind = "slider_crank"
stroke = "80 mm"
rod_length = "136 mm"
[cylinder]
cycle = "four-stroke"
"""

CHAIN = """\
[mechanism]
kind = "chain"
output = "out"
[mechanism.fixed]
A = ["1500 mm", "200 mm"]
B = ["400 mm", "1600 mm"]
[mechanism.crank.main]
radius = "100 mm"
[[mechanism.part]]
type = "triad"
link = "plate"
leg = [
    { joint = "P", rod = { name = "first", from = "main.pin", length = "1200 mm" }, near = ["0 m", "1.2 m"] },
    { joint = "Q", along = "800 mm", rod = { name = "second", from = "A", length = "1100 mm" } },
    { joint = "S", along = "500 mm", across = "1200 mm", rod = { name = "out", from = "B", length = "900 mm" } },
]
[[mechanism.part]]
type = "slide"
rod = { name = "link", from = "S", length = "3 m" }
slider = "ram"
guide = { through = "O", direction = "0 deg" }
"""

ROD = """\
[shaft.main]
speed = "1500 rpm"
[mechanism]
kind = "slider_crank"
stroke = "80 mm"
rod_length = "136 mm"
[masses.rod]
mass = "0.7 kg"
along = "36 mm"
"""

FILES = {
    "centroid far beside the rod": (
        (ROD + 'across = "2 m"\n').encode(),
        "bad.toml:10:10  masses.rod.across = 2 m: must lie on the link or not far from it: -136 mm to 136 mm beside",
    ),
    "inertia in a unit of another size": (
        (ROD + 'inertia = "20 kg·cm²"\n').encode(),
        f"bad.toml:10:11  masses.rod.inertia = 20 kg·cm²: {AN_INERTIA}\n",
    ),
    "name before it exists": (
        CHAIN.replace('from = "main.pin"', 'from = "ram.pin"').encode(),
        "bad.toml:13:51  mechanism.part[0].leg[0].rod.from = ram.pin: is made only here or further down; must be",
    ),
    "not driven": (
        CHAIN.replace('from = "main.pin"', 'from = "A"').encode(),
        "bad.toml:9:1  mechanism.part[0]: is not driven: all that it hangs on stands still",
    ),
    "two speeds": (
        CHAIN.replace("[[", '[mechanism.crank.other]\nradius = "5 mm"\nratio = 2\n[[', 1).encode(),
        "bad.toml:11:9  mechanism.crank.other.ratio = 2: must be 1: all cranks of a chain are on one shaft",
    ),
    "triad that cannot turn": (
        CHAIN.replace('"100 mm"', '"500 mm"').encode(),
        f"bad.toml:9:1  mechanism.part[0]: {CANNOT_CLOSE} 33.87 deg to 142.66 deg (short by",
    ),
    "triad of unclear mode": (
        CHAIN.replace(', near = ["0 m", "1.2 m"]', "").encode(),
        "bad.toml:11:8  mechanism.part[0].link = plate: fits in 2 ways where the crank lies along x",
    ),
    "guide without a direction": (
        CHAIN.replace('"0 deg"', '"0 mm"').encode(),
        "bad.toml:21:38  mechanism.part[1].guide.direction = 0 mm: mm measures a length; must be an angle",
    ),
    "no output": (CHAIN.replace('output = "out"\n', "").encode(), "bad.toml:1:1  mechanism.output: is missing"),
    "output that is none": (
        CHAIN.replace('output = "out"', 'output = "oud"').encode(),
        "bad.toml:3:10  mechanism.output = oud: must be a slider or a link of this chain",
    ),
    "empty": (b"", "bad.toml  no machine in it"),
    "comment": (b"# nothing\n", "bad.toml  no machine in it"),
    "binary": (b"\x7fELF\x02\x01\x01\x00\x00\x00", "bad.toml  is no text"),
    "utf-16": ('name = "x"\n'.encode("utf-16"), "bad.toml  is written in UTF-16"),
    "latin-1": ('name = "é"\n'.encode("latin-1"), "bad.toml:1:9  the byte 0xE9 here is not UTF-8"),
    "huge": (b"# " + b"x" * 2**21, f"bad.toml  {TOO_LARGE}"),
    "syntax": (b'name = "x\n', "bad.toml:1:10"),
    "no quotes": (
        b"[mechanism]\nstroke = 80 mm\n",
        f"bad.toml:2:13  stroke = 80 mm: {QUOTES}",
    ),
    "no mechanism": (b'name = "x"\n', "bad.toml:1:1  mechanism: is missing"),
    "unknown key": (
        (HEAD + 'strok = "80 mm"\nrod_length = "136 mm"\n').encode(),
        f"bad.toml:4:9  mechanism.strok = 80 mm: {NOT_A_KEY}",
    ),
    "wrong dimension": (
        (HEAD + 'stroke = "80 kg"\nrod_length = "136 mm"\n').encode(),
        "bad.toml:4:10  mechanism.stroke = 80 kg: kg measures a mass",
    ),
    "no unit": (
        (HEAD + 'stroke = 80\nrod_length = "136 mm"\n').encode(),
        "bad.toml:4:10  mechanism.stroke = 80: must be a length",
    ),
    "negative": (
        (HEAD + 'stroke = "-80 mm"\nrod_length = "136 mm"\n').encode(),
        f"bad.toml:4:10  mechanism.stroke = -80 mm: {NOT_POSITIVE} mm",
    ),
    "nan": (
        (HEAD + 'stroke = "nan mm"\nrod_length = "136 mm"\n').encode(),
        "bad.toml:4:10  mechanism.stroke = nan mm: must be finite",
    ),
    "comma": (
        (HEAD + 'stroke = "80,5 mm"\nrod_length = "136 mm"\n').encode(),
        "bad.toml:4:10  mechanism.stroke = 80,5 mm",
    ),
    "unknown kind": (
        HEAD.replace("slider", "slidr").encode(),
        "bad.toml:3:8  mechanism.kind = slidr_crank: must be one of: slider_crank",
    ),
    "does not close": (
        (HEAD + 'crank_radius = "40 mm"\nrod_length = "30 mm"\n').encode(),
        f"bad.toml:5:14  mechanism.rod_length = 30 mm: {CANNOT_CLOSE} 48.59 deg to 131.41 deg",
    ),
    "no permutation": (
        (BANKS + 'firing_order = "1-1"\n').encode(),
        "bad.toml:10:16  cylinder.firing_order = 1-1: must name each cylinder once (1, 2); twice: 1; left out: 2",
    ),
    "cannot fire so": (
        (
            BANKS.replace("four", "two").replace('"180 deg"', '"180 deg", "90 deg"') + 'firing_order = "1-3-2"\n'
        ).encode(),
        "bad.toml:10:16  cylinder.firing_order = 1-3-2: cannot fire so",
    ),
    "twice": ((BANKS + "[bank.A]\n").encode(), f"bad.toml:10:7  bank.A: {FIRST_IN_LINE} 3"),
    "no such throw": (
        BANKS.replace("[bank.A]\n", "[bank.A]\nthrows = [1, 3]\n").encode(),
        "bad.toml:4:14  bank.A.throws[1] = 3: must be one of the shaft's throws, 1 to 2",
    ),
}


@pytest.mark.parametrize("command", ["check", "run"])
@pytest.mark.parametrize("name", FILES)
def test_bad_file(typed, tmp_path, name, command):
    content, said = FILES[name]
    (tmp_path / "bad.toml").write_bytes(content)
    output = ("-o", "out.csv") if command == "run" else ()
    answer = typed(command, "bad.toml", *output)
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors.startswith(said), answer.errors
    assert answer.errors.endswith("\n")
    assert [path.name for path in tmp_path.iterdir()] == ["bad.toml"]
    assert (tmp_path / "bad.toml").read_bytes() == content


def test_nearest_key_is_suggested(typed, tmp_path):
    (tmp_path / "bad.toml").write_bytes(FILES["unknown key"][0])
    assert "did you mean stroke?" in typed("check", "bad.toml").errors


def test_all_problems_at_once(typed, written):
    written('[bank.A]\nangle = "0"\n[bank.A.mechanism]\nkind = "slider_crank"\nstroke = "1 kg"\nrod_length = "x"\n')
    lines = typed("check", "machine.toml").errors.splitlines()
    assert [line.partition("  ")[0] for line in lines] == ["machine.toml:2:9", "machine.toml:5:10", "machine.toml:6:14"]


@pytest.mark.parametrize(
    ("name", "said"),
    [
        ("machin.toml", f"machin.toml  {NO_FILE}; is it machine.toml?"),
        ("3d13", f"3d13  {NO_FILE}{IS_IT_THE_EXAMPLE}"),
        ("", 'FILE = "": must be the name of a machine file, or of an example; `cranktrain list` names all'),
        ("no/such/file.toml", "no/such/file.toml  there is no folder no/such"),
        (".", f".  {IS_A_FOLDER}"),
        ("a\0b", "a"),
        ("x" * 300, "x" * 300),
    ],
)
def test_files_that_are_not_there(typed, written, name, said):
    written(HEAD)
    answer = typed("run", name)
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors.startswith(said)


def test_step_that_is_no_number(typed):
    answer = typed("run", "3d12", "--step", "1,5")
    assert answer.status == 2
    assert "'--step': 1,5 must be a number of degrees, such as 0.5" in answer.errors


def test_no_quantities_are_not_all_of_them(typed):
    answer = typed("run", "3d12", "--quantities", " , ")
    assert (answer.status, answer.output) == (2, "")
    assert answer.errors.startswith('--quantities = "": must be names of results, with commas between')


def test_gas_in_a_chamber_without_room_is_refused_where_the_room_is_given(typed):
    answer = typed("run", "3d12", "--set", "bank.R.mechanism.knuckle_radius=400 mm")
    assert (answer.status, answer.output) == (2, "")
    assert "cylinder.compression_ratio" in answer.errors
    assert "leaves no room over 1R–6R, whose pistons reach beyond the first one's deck" in answer.errors
    assert "such as [cylinder.R]" in answer.errors


def test_diagram_with_a_gap_is_refused_in_its_own_line(typed, written):
    """The problem is the diagram's, and names the table that asks for it."""
    rows = "\n".join(f"{angle};{1 + 30 / (1 + abs(angle - 370)):.4f}" for angle in range(720) if not 339 < angle < 380)
    written(f"angle [deg];p abs [bar]\n{rows}\n", "trace.csv")
    written(
        f"{ROD.partition('[masses')[0]}"
        '[cylinder]\nbore = "82 mm"\ncompression_ratio = 9.3\ncycle = "four-stroke"\n'
        '[gas]\nkind = "indicator"\nfile = "trace.csv"\n'
    )
    said = f"trace.csv:341  gas: {GAP_OVER_CREST}, in which the pressure may be "
    errors = typed("run", "machine.toml").errors
    assert errors.startswith(said)
    assert "; give what is missing" in errors


def test_weights_that_balance_nothing(typed, written):
    """Of two on one throw the second stands where the first one's opposite side is, unless an angle says so."""
    weight = '[[balance.weight]]\nmass = "1 kg"\nradius = "50 mm"\nthrow = 1\n'
    written(f'{ROD}inertia = "0.003 kg·m²"\n{weight}{weight}angle = "0 deg"\n')
    said = "machine.toml:15:1  balance.weight[1]: stands opposite balance.weight[0] on throw 1"
    assert typed("check", "machine.toml").errors.startswith(said)
    written(f'{ROD}inertia = "0.003 kg·m²"\n{weight}{weight}angle = "10 deg"\n')
    assert typed("check", "machine.toml").status == 0


def test_unreadable_file(typed, written, monkeypatch):
    path = written(HEAD)
    path.chmod(0)
    try:
        path.read_bytes()
    except PermissionError:
        assert typed("check", path.name).errors.startswith("machine.toml  may not be read")
    else:
        pytest.skip("this user may read everything")
