"""Numba's way from a function to what LLVM is given, without what no loop of ours needs, and with nothing asked twice.

What Numba does in Python takes as long as LLVM twice. A third of that is left out here:

* it looks for what loops do not have, expressions of whole arrays and functions within functions;
* it asks anew, for each sum and product, which of all its ways to add fits numbers;
* it notes after each step which arrays nobody holds any more, and makes a place in memory of what is known already, all
  of which LLVM has to see through. Loops that make no arrays count no holders.
"""

from collections import defaultdict
from collections.abc import Callable, Generator
from contextlib import AbstractContextManager, contextmanager
from types import CodeType
from typing import Any, cast

_LOOKS_FOR_ARRAYS = "NopythonRewrites"
_LOOKS_WITHIN = "InlineClosureLikes"
_LOOKS_FOR_HOLDERS = "IRLegalization"
"""What Numba calls passes that find nothing to do."""
_TRIED = (0, 61), (0, 68)
"""From which Numba on to which what is made by fewer steps was compared with what it makes by its own."""
_OF_LOWERING = (
    "_find_singly_assigned_variable",
    "_disable_sroa_like_opt",
    "_alloca_var",
    "getvar",
    "storevar",
)
"""What makes LLVM's words of Numba's, which is done here otherwise."""


def shorter(compiler_class: Any) -> Any:
    """Give a compiler that does what one of Numba does, in fewer steps.

    That one itself where Numba has not the steps, or is newer than any with which this was tried: it might mean another
    thing by the same names.

    Parameters
    ----------
    compiler_class : type
        `numba.core.compiler.Compiler`.
    """
    import numba
    from numba.core import compiler_machinery, lowering, typed_passes, types

    version: Any = numba.version_info
    lower_class: Any = getattr(lowering, "Lower", None)
    step_class: Any = getattr(typed_passes, "NativeLowering", None)
    is_there: bool = (
        _TRIED[0] <= version.short <= _TRIED[1]
        and step_class is not None
        and all(hasattr(lower_class, name) for name in _OF_LOWERING)
        and all(hasattr(compiler_class, name) for name in ("compile_extra", "define_pipelines"))
        and all(hasattr(compiler_machinery.PassManager, name) for name in ("_runPass", "add_pass", "finalize"))
        and hasattr(types.BaseFunction, "get_call_type")
    )
    if not is_there:
        return compiler_class
    manager_class = _step_by_step(compiler_machinery.PassManager)
    own_step = _lowering(step_class, _lower(lower_class))
    remembered = _remembering()

    class Shorter(compiler_class):
        """Numba's own, but for some of its steps."""

        def compile_extra(self, func: Any) -> Any:
            """Compile a function, and what it calls."""
            with remembered():
                return compiler_class.compile_extra(self, func)

        def define_pipelines(self) -> Any:
            """Numba's steps less those that find nothing to do."""
            made: Any = compiler_class.define_pipelines(self)
            return [self._without_idle(manager) for manager in made]

        def _without_idle(self, manager: Any) -> Any:
            """Give a way that has not the steps that find nothing to do in a function."""
            idle, own = self._idle(), manager_class(manager.pipeline_name)
            for step, why in manager.passes:
                if step.__name__ not in idle:
                    own.add_pass(own_step if step is step_class else step, why)
            own.finalize()
            return own

        def _idle(self) -> set[str]:
            """Names of steps that find nothing to do in a function."""
            if self.state.flags.nrt:
                return set()
            constants = self.state.func_id.code.co_consts
            has_within = any(isinstance(each, CodeType) for each in constants)
            return {_LOOKS_FOR_ARRAYS, _LOOKS_FOR_HOLDERS} | (set() if has_within else {_LOOKS_WITHIN})

    return Shorter


def _remembering() -> Callable[[], AbstractContextManager[None]]:
    """Give what has Numba know, for a while, how a function was called before under the same options."""
    from numba.core import types
    from numba.core.targetconfig import ConfigStack

    stack = cast(Any, ConfigStack)
    of_functions: Any = types.BaseFunction
    plain = of_functions.get_call_type
    known: dict[str, dict[Any, Any]] = defaultdict(dict)
    under: dict[int, tuple[Any, dict[Any, Any]]] = {}

    def known_under(options: Any) -> dict[Any, Any]:
        if id(options) not in under:
            under[id(options)] = options, known[options.get_mangle_string()]
        return under[id(options)][1]

    def get_call_type(function: Any, context: Any, args: Any, kws: Any) -> Any:
        options = stack.top_or_none()
        if kws or options is None:
            return plain(function, context, args, kws)
        before, key = known_under(options), (context, function, tuple(args))
        if key not in before:
            found = plain(function, context, args, kws)
            before[key] = found, function._impl_keys[found.args]
        found, way = before[key]
        # under other options it may have been another since
        function._impl_keys[found.args] = way
        return found

    @contextmanager
    def remembered() -> Generator[None]:
        is_within = of_functions.get_call_type is get_call_type
        of_functions.get_call_type = get_call_type
        try:
            yield
        finally:
            if not is_within:
                of_functions.get_call_type = plain

    return remembered


def _step_by_step(manager_class: Any) -> Any:
    """Give what goes step by step, and tells nobody."""
    from numba.core.compiler_lock import global_compiler_lock

    class StepByStep(manager_class):
        """Numba's own, which times each step, and puts into words what it is about to do to whom."""

        @global_compiler_lock
        def _runPass(self, index: int, pss: Any, internal_state: Any) -> None:  # noqa: N802 - Numba's name
            del index
            pss.analysis = self._analysis
            for step in (pss.run_initialization, pss.run_pass, pss.run_finalizer):
                step(internal_state)

    return StepByStep


def _lowering(step_class: Any, lower_class: Any) -> Any:
    """Step that makes LLVM's words of a function by a class of one's own."""
    from numba.core import compiler_machinery

    @cast(Any, compiler_machinery).register_pass(mutates_CFG=True, analysis_only=False)
    class Lowering(step_class):
        """Numba's own, by another class."""

        _name = "lowering_of_loops"

        @property
        def lowering_class(self) -> Any:
            return lower_class

    return Lowering


def _lower(lower_class: Any) -> Any:
    """Class that makes LLVM's words, in which what is given a value once has no place in memory."""
    from numba.core import analysis, ir

    looking = cast(Any, analysis)

    class Lower(lower_class):
        """Numba's own, which does so only within a block."""

        def _find_singly_assigned_variable(self) -> None:
            """Find what is given a value once, before all that reads it."""
            lower_class._find_singly_assigned_variable(self)
            if self.flags.nrt:
                return
            blocks: dict[int, Any] = self.func_ir.blocks
            reads: dict[int, set[str]] = looking.compute_use_defs(blocks).usemap
            before: dict[int, set[int]] = looking.compute_cfg_from_blocks(blocks).dominators()
            given: dict[str, list[int]] = defaultdict(list)
            for place, block in blocks.items():
                for each in block.find_insts(ir.Assign):
                    given[each.target.name].append(place)
            once = {name: places[0] for name, places in given.items() if len(places) == 1}
            # blocks are put into words in their order, and a value has to be there
            too_early = {
                name
                for place, names in reads.items()
                for name in once.keys() & names
                if once[name] >= place or once[name] not in before[place]
            }
            known: set[str] = self._singly_assigned_vars
            known |= once.keys() - too_early

        def storevar(self, value: Any, name: str, argidx: int | None = None) -> None:
            """Give a variable a value, and do not look at the one before, of which no holders are counted."""
            known: set[str] = self._singly_assigned_vars
            if self.flags.nrt or argidx is not None or name in known:
                lower_class.storevar(self, value, name, argidx)
                return
            self._alloca_var(name, self.typeof(name))
            self.builder.store(value, self.getvar(name))

    return Lower
