"""What Python users call: run and compare whatever one has of a machine."""

from collections.abc import Generator, Iterable, Mapping, Sequence
from contextlib import contextmanager
from dataclasses import replace
from functools import partial as with_arguments
from typing import TYPE_CHECKING, overload

from cranktrain import analysis
from cranktrain.analysis import Result
from cranktrain.analysis.comparison import Comparison, compared
from cranktrain.errors import InputError, Problem, problems_as
from cranktrain.io.any_machine import name_of, names_in, sources_of, texts_in, values_of
from cranktrain.language import said as _
from cranktrain.quantities import shown_by, units_by_dimension

if TYPE_CHECKING:
    import os

    from distributed import Client
    from numpy.typing import ArrayLike

    from cranktrain.analysis import SpeedWanted
    from cranktrain.analysis.pipeline import Pipeline
    from cranktrain.io.any_machine import MachineLike
    from cranktrain.panels.drawing import MachineDrawing
    from cranktrain.study.start import Start
    from cranktrain.study.starts import Starts
    from cranktrain.study.sweep import Sweep
    from cranktrain.transient.runs import Progress


def run(
    machine: "MachineLike | Iterable[MachineLike]",
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
    quantities: "str | Iterable[str] | None" = None,
    speed: "SpeedWanted" = "constant",
    step_degrees: float = 1.0,
    partial: bool = False,
) -> Result:
    """Compute all that a machine's tables allow.

    Parameters
    ----------
    machine : str, path-like, dict or Machine, or an iterable of these
        A machine file, the name of an example, the tables of a file, or a machine. Several designs of one machine give
        a leading dimension `design`.
    set : mapping of str, optional
        Other values by path, as `Machine.with_` takes them; for all of several.
    quantities : str or iterable of str, optional
        Names from the catalogue; only what these need is computed, and the dataset holds them alone. All unless given.
    speed : "constant", "running", array-like of shape (crank_angle,) or (design, crank_angle), or SpeedCurve
        At which everything is computed: the declared one all round; that of steady running; or one's own at the crank
        angles of the result. [rad/s]
    step_degrees : float
        Of the crank angles at which curves stand; a turn must be a whole number of steps. [deg]
    partial : bool
        Compute where the links close and give NaN where they do not, instead of refusing the machine.

    Returns
    -------
    Result

    Raises
    ------
    InputError
        With everything that is wrong: in a file at its line, of a `set` value at `set`.

    Examples
    --------
    >>> result = run("3d12", quantities="stroke")
    >>> round(float(result.stroke[0]), 6)
    0.18
    >>> round(float(run("3d12", set={"bank.L.mechanism.stroke": "190 mm"}).stroke[0]), 6)
    0.19
    """
    sources, has_designs = sources_of(machine, set, partial=partial)
    asked = names_in(quantities)
    machines = tuple(source.machine for source in sources)
    found = with_arguments(analysis.run, speed=speed, step_degrees=step_degrees, partial=partial, quantities=asked)
    if has_designs:
        return replace(found(machines), asked=asked)
    with problems_as(sources[0].placed):
        return replace(found(machines[0]), asked=asked)


@overload
def start(
    machine: "MachineLike", *, set: "Mapping[str, object] | None" = None, progress: "Progress | None" = None
) -> "Start": ...
@overload
def start(machine: "Sequence[MachineLike]", *, set: "Mapping[str, object] | None" = None) -> "Starts": ...


def start(
    machine: "MachineLike | Sequence[MachineLike]",
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
    progress: "Progress | None" = None,
) -> "Start | Starts":
    """Run a machine with its motor over time, as its table [drive.start] says; or several designs of it.

    Parameters
    ----------
    machine : str, path-like, dict or Machine, or a sequence of these
        As `run` takes it; with [drive]. Several differ in numbers alone.
    set : mapping of str, optional
        Other values by path, as `Machine.with_` takes them; for all of several.
    progress : callable, optional
        Told time, angle and speed that one machine has come to [s, rad, rad/s]; Ctrl-C then keeps what was computed.

    Returns
    -------
    Start or Starts
        Its `time` and curves by name, `events`, `rows()` and `dataset`. Of several their facts, arrays along the
        designs, NaN and a sentence in `refused` where one cannot start; `found[2]` is the start of one with its curves.

    Raises
    ------
    InputError
        With everything that is wrong with the machine, or what it lacks for a start; where none of several can start.

    Examples
    --------
    >>> float(start("tilting_table", set={"drive.start.duration": "0.5 s"}).time[-1])
    0.5
    """
    sources, are_several = sources_of(machine, set, partial=False)
    if are_several:
        from cranktrain.study.starts import starts

        return starts([one.machine for one in sources], [one.placed for one in sources], progress=progress)
    from cranktrain.study.start import start as start_alone

    with problems_as(sources[0].placed):
        return start_alone(sources[0].machine, progress=progress)


def sweep(
    machine: "MachineLike",
    vary: "Mapping[str, object] | Sequence[Mapping[str, object]]",
    wanted: "str | Iterable[str] | None" = None,
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
    over_time: bool = False,
    processes: int = 1,
    store: "str | os.PathLike[str] | None" = None,
    resume: bool = False,
    scheduler: "str | Client | None" = None,
) -> "Sweep":
    """Compute facts of a machine over values of its file.

    Parameters
    ----------
    machine : str, path-like, dict or Machine
        As `run` takes it.
    vary : mapping of str, or sequence of such
        What is varied, by path, or by the last name of one where the file has it once: a range `"130..160 mm:31"`, a
        list `"1000, 1500 rpm"`, or values one by one, as `Machine.with_` takes them. All combinations are computed.
        Of a sequence each item is a design: its values by path.
    wanted : str or iterable of str, optional
        Names of facts; the headlines of the machine's questions unless given.
    set : mapping of str, optional
        Other values by path, of all designs.
    over_time : bool
        Whether they are facts of starts, as `start` runs each design, and not of the cycle.
    processes : int
        How many may work at once; from a script these need `if __name__ == "__main__":`.
    store : str or path-like, optional
        A folder `NAME.zarr` that keeps facts while they are computed; with `pip install 'cranktrain[store]'`.
    resume : bool
        Go on with that store, whatever stopped it; where there is none, begin it.
    scheduler : str or distributed.Client, optional
        Of a cluster of Dask, `"tcp://HOST:8786"`; with `pip install 'cranktrain[cluster]'`.

    Returns
    -------
    Sweep
        Every fact along what is varied, NaN where a design cannot be: `refused`; `dataset`, `plot()`, `best(least=…)`.

    Raises
    ------
    InputError
        With everything that is wrong with the machine, or with what is asked.

    Examples
    --------
    >>> found = sweep("vaz_21213", {"rod_length": "120..160 mm:3"}, "largest_side_force")
    >>> found.largest_side_force.shape
    (4, 3)
    >>> [round(float(force)) for force in found.largest_side_force[0]]
    [2663, 1676, 1420]
    """
    from cranktrain.io.any_sweep import any_swept

    return any_swept(
        machine,
        vary,
        names_in(wanted, "wanted"),
        set or {},
        over_time=over_time,
        processes=processes,
        store=store,
        resume=resume,
        scheduler=scheduler,
    )


def compare(
    first: "MachineLike | Result",
    second: "MachineLike | Result | None" = None,
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
    quantities: "str | Iterable[str] | None" = None,
) -> Comparison:
    """Compare two machines, or one with itself where some values are others.

    Parameters
    ----------
    first, second : str, path-like, dict, Machine or Result
        As `run` takes them; or what it gave of one machine. Without a second one it is the first with other values.
    set : mapping of str, optional
        Other values by path: of the second machine where only one is named, else of both.
    quantities : str or iterable of str, optional
        Names from the catalogue; the headlines of all questions unless given.

    Returns
    -------
    Comparison
        Its `rows` have both values, their difference and percent; `plot()` lays the curves over each other.

    Raises
    ------
    InputError
        With everything that is wrong; where nothing is there to be compared.

    Examples
    --------
    >>> for row in compare("3d12", "kamaz_740", quantities="displacement").rows:
    ...     print(row.quantity, round(row.first, 4), round(row.second, 4), round(row.percent, 1))
    displacement 0.0389 0.0109 -72.1
    >>> compare("vaz_21213", set={"shaft.main.speed": "3000 rpm"})
    <Comparison of vaz_21213 and vaz_21213 with shaft.main.speed = 3000 rpm: ... rows>
    """
    values = values_of(set)
    if second is None and not values:
        allowed = _("is missing: name a second machine, or what is to be another value")
        raise InputError([Problem("second", None, allowed, _("write set={example}", example=_EXAMPLE))])
    said = ", ".join(f"{path} = {value}" for path, value in values.items())
    named = first if second is None else second
    names = [name_of(first), name_of(named)]
    if second is None:
        names[1] = _("{name} with {values}", name=names[0], values=said)
    asked = names_in(quantities)
    one = _result(first, {} if second is None else values, asked)
    return compared((one, _result(named, values, asked)), (names[0], names[1]), asked)


def behind(
    quantity: str,
    machine: "MachineLike | None" = None,
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
) -> "Pipeline":
    """Find what stands behind a quantity: what a machine file declares, and the stages that lead from there to it.

    Parameters
    ----------
    quantity : str
        Its name in the catalogue.
    machine : str, path-like, dict or Machine, optional
        What leads to the quantity in this machine, and which tables of its file are read; in any unless given.
    set : mapping of str, optional
        Other values by path, as `Machine.with_` takes them.

    Returns
    -------
    Pipeline
        Its `declared` parts and its `stages`, each with where its code stands; `print` writes it as a page.

    Raises
    ------
    InputError
        Where there is no such quantity, or the machine's file does not allow it; with all that is wrong with it.

    Examples
    --------
    >>> found = behind("stroke", "3d12")
    >>> found.declared[0].name, found.declared[0].tables[0]
    ('Pistons', '[bank.L.mechanism]')
    >>> found.stages[-1].name, found.stages[-1].word, found.stages[-1].place.file
    ('dead_centres', 'result', 'questions/motion/dead_centres.py')
    """
    from cranktrain.analysis.behind import behind as found_behind

    if machine is None:
        return found_behind(quantity)
    source = sources_of(machine, set, partial=False)[0][0]
    with problems_as(source.placed):
        return found_behind(quantity, source.machine)


def drawing(
    machine: "MachineLike",
    at: "ArrayLike" = 0.0,
    *,
    set: "Mapping[str, object] | None" = None,  # noqa: A002 - as the terminal's --set
    mechanism: str | None = None,
    speed: "SpeedWanted" = "constant",
) -> "MachineDrawing":
    """Give a machine's drawing as data: every mechanism of every throw, where it stands, at crank angles.

    Parameters
    ----------
    machine : str, path-like, dict or Machine
        As `run` takes it. Its links may close over a part of the turn; elsewhere pins are NaN.
    at : float or array-like of shape (n,)
        Crank angles as the machine shows them. [deg]
    set : mapping of str, optional
        Other values by path, as `Machine.with_` takes them.
    mechanism : str, optional
        Whose throw alone is drawn, by the mechanism's name or its cylinder's, with all that shares cylinders with it.
    speed : "constant", "running", array-like of shape (crank_angle,), or SpeedCurve
        By which some loads go; as `run` takes it.

    Returns
    -------
    MachineDrawing
        Its `shafts`, `mechanisms` with pins of shape (2, n), links, guides and paths, and `loads`, in metres, newtons
        and radians: X right and Y up from the centre of the main shaft. `to_dict()` is the same for JSON.

    Raises
    ------
    InputError
        With everything that is wrong with the machine; for angles that are none, and for a mechanism that there is not.

    Examples
    --------
    >>> drawn = drawing("deltic", [0.0, 90.0])
    >>> len(drawn.mechanisms), [shaft.name for shaft in drawn.shafts]
    (36, ['main', 'right', 'bottom'])
    >>> drawn.mechanism("1A.exhaust").pins["B"].shape
    (2, 2)
    """
    from cranktrain.panels.drawing_of_machine import machine_drawing

    source = sources_of(machine, set, partial=True)[0][0]
    with problems_as(source.placed):
        return machine_drawing(source.machine, at, mechanism=mechanism, speed=speed)


@contextmanager
def units(*names: str) -> Generator[None]:
    """Show numbers in some units for a while, as the terminal's --units does.

    In pictures, sentences, tables and datasets; arrays of a result stay in the units of the catalogue. What is not
    named is shown in the units of the machine's file, or in the usual ones.

    Parameters
    ----------
    *names : str
        Units of machine files, one for each quantity: `"psi", "in"`, or with commas between, `"psi,in"`.

    Raises
    ------
    InputError
        For names of no unit, and two units of one quantity.

    Examples
    --------
    >>> result = run("3d12", quantities="stroke")
    >>> with units("in"):
    ...     in_inches = result.dataset["stroke"]
    >>> in_inches.attrs["units"], round(float(in_inches[0]), 3), round(float(result.dataset["stroke"][0]), 3)
    ('in', 7.087, 0.18)
    """
    texts = texts_in("units", names, _("must be names of units, such as psi or in"))
    each = [name.strip() for text in texts for name in text.split(",")]
    with shown_by(units_by_dimension(each, "units")):
        yield


_EXAMPLE = '{"mechanism.rod_length": "140 mm"}'


def _result(given: "MachineLike | Result", values: "Mapping[str, object]", asked: tuple[str, ...] | None) -> Result:
    """Compute a machine; a result is there already."""
    if not isinstance(given, Result):
        return run(given, set=values, quantities=asked)
    if given.has_designs:
        allowed = _("has several designs; compare two machines")
        raise InputError([Problem("compare", None, allowed, _("name one: result.machines[0]"))])
    return run(given.machines[0], set=values, quantities=asked) if values else given
