"""What other compiled code alone calls is optimised once, within what Python calls, and not by itself as well.

Numba optimises whatever it compiles, with all that it calls, and makes machine code of it; of what no one calls but
compiled code all that is thrown away. A function ten calls deep is so optimised ten times.
"""

from functools import cache
from typing import Any, NamedTuple, cast

_OF_A_LIBRARY = (
    "add_linking_library",
    "finalize",
    "get_pointer_to_function",
    "enable_object_caching",
    "_optimize_functions",
    "_optimize_final_module",
)
"""What Numba's library of compiled code does, which is done here otherwise."""


class HowCompiled(NamedTuple):
    """Options for Numba of what other compiled code alone calls, and of what Python may call."""

    part: dict[str, Any]
    whole: dict[str, Any]


@cache
def how_compiled() -> HowCompiled:
    """Options for Numba under which parts are put together in the whole that calls them, and nowhere else.

    There are none where Numba has not what that takes: then all is compiled as it does by itself, in more time.
    """
    from numba.core import codegen, compiler

    from cranktrain.linkage.shorter import shorter

    library_class: Any = getattr(codegen, "JITCodeLibrary", None)
    generator_class: Any = getattr(codegen, "JITCPUCodegen", None)
    compiler_class: Any = getattr(compiler, "Compiler", None)
    is_there = all(hasattr(library_class, name) for name in _OF_A_LIBRARY)
    if compiler_class is None or not is_there or not hasattr(generator_class, "_module_pass_manager"):
        return HowCompiled({}, {})

    class Own(library_class):
        """A library of which no function is optimised by itself."""

        def _optimize_functions(self, ll_module: Any) -> None:
            """Leave it as it is."""

    class Part(Own):
        """A function alone, without what it calls, neither optimised nor made machine code of."""

        def finalize(self) -> None:
            """Leave it as it is."""
            self._finalized = True

        def get_pointer_to_function(self, name: str) -> int:
            """Nowhere: there is no machine code."""
            del name
            return 0

        @property
        def codegen(self) -> "Part":
            """Who is told what object a function has in Python."""
            return self

        def set_env(self, env_name: str, env: object) -> None:
            """Take no notice: what Python does not call needs none."""

    class Whole(Own):
        """A function with all that it calls."""

        def all_passes_once(self) -> None:
            """Let all passes run once: the cheap ones before them are for counts of who holds arrays."""
            made: Any = self._codegen._module_pass_manager()
            # before Numba 0.62 there is no builder
            manager, *more = cast("tuple[Any, ...]", made if isinstance(made, tuple) else (made,))
            manager.run(self._final_module, *more)

        _optimize_final_module = all_passes_once  # so Numba calls it

        def add_linking_library(self, library: Any) -> None:
            """Take in what it calls, and of parts what these call."""
            if library in self._linking_libraries:
                return
            library_class.add_linking_library(self, library)
            for each in library._linking_libraries if isinstance(library, Part) else ():
                self.add_linking_library(each)

    shorter_class = shorter(compiler_class)

    def compiler_to(kind: Any) -> Any:
        class OwnCompiler(shorter_class):
            """Numba's own, but for where it puts what it makes."""

            def __init__(self, typingctx: Any, targetctx: Any, *more: Any) -> None:
                shorter_class.__init__(self, typingctx, targetctx, *more)
                self.state.library = kind(targetctx.codegen(), "own")
                self.state.library.enable_object_caching()

        return OwnCompiler

    return HowCompiled({"pipeline_class": compiler_to(Part)}, {"pipeline_class": compiler_to(Whole)})
