"""A machine whose numbers are set anew is that of the file that has them."""

from functools import partial

import pytest

from cranktrain.errors import InputError
from cranktrain.io.document import Document
from cranktrain.io.examples import example_names
from cranktrain.io.machine_file import inputs_of, read_machine
from cranktrain.io.machine_source import source_called

MACHINE = '[mechanism]\nkind = "slider_crank"\nstroke = "80 mm"\nrod_length = "136 mm"\n'


@pytest.mark.parametrize("name", example_names())
def test_numbers_that_are_set_anew_give_the_machine_of_the_file_that_has_them(name):
    source = source_called(name)
    inputs = inputs_of(source.with_set(partial=True))
    for path, given in inputs[:: 1 + len(inputs) // 12]:
        setting = f"{path}={given.text.replace(' ', '  ', 1)}"  # another text, of the same size
        anew, read = source.with_set([setting], partial=True), read_machine(name, [setting], partial=True)
        assert anew.machine == read.machine
        assert anew.document.text == read.document.text
        assert anew.document.data == Document.from_text(read.document.text, "").data
        assert [one.given for one in inputs_of(anew)] == [one.given for one in inputs_of(read)]


@pytest.mark.parametrize("setting", ["mechanism.rod_length=1 mm", "mechanism.rod_length=1 kg", "nothing.at.all=3", "x"])
def test_what_is_wrong_with_numbers_that_are_set_anew_is_said_as_of_the_file(setting):
    source = source_called("burning_cylinder")
    said = []
    for read in (source.with_set, partial(read_machine, "burning_cylinder"), source.with_set):
        with pytest.raises(InputError) as caught:
            read([setting])
        said.append(str(caught.value))
    assert said[0] == said[1] == said[2]


def test_a_file_that_a_machine_names_is_read_again_when_a_number_is_set_anew(tmp_path):
    card, machine = tmp_path / "cut.csv", tmp_path / "m.toml"
    cut = '[load.cut]\non = "piston"\ncounts = "against"\nfile = "cut.csv"\n'
    machine.write_text(f"{MACHINE}\n{cut}", encoding="utf-8")
    source, forces = source_called(machine), []
    for force in (1, 2):
        card.write_text(f"travel [mm],force [kN]\n0,{force}\n80,{force}\n0,{force}\n", encoding="utf-8")
        file = source.with_set(["mechanism.rod_length=140 mm"])
        forces.append([given.si for given in file.machine.loads["load"]["cut"].force])
    assert forces == [[1e3, 1e3], [2e3, 2e3]]
