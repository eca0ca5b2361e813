"""How Numba makes what other compiled code calls alone: as a part of its callers, with no machine code of its own.

By itself Numba optimises each function as if it were the last, and makes machine code of it, which nobody calls where
its callers hold a copy: a tenth of all time of compiling. A part is tidied, and joined to its callers; with these it is
optimised.
"""

from functools import cache
from typing import Any


@cache
def part_compiler() -> Any:
    """Give the class of Numba's compilers that makes parts, as `numba.njit` takes it for its `pipeline_class`."""
    from numba.core import codegen as untyped_codegen
    from numba.core import compiler as untyped_compiler
    from numba.core import compiler_machinery as untyped_machinery
    from numba.core import cpu as untyped_cpu
    from numba.core import typed_passes as untyped_passes

    codegen: Any = untyped_codegen
    compiler: Any = untyped_compiler
    machinery: Any = untyped_machinery
    cpu: Any = untyped_cpu
    passes: Any = untyped_passes

    class Part(codegen.JITCodeLibrary):
        """What is made of a part, for its callers."""

        def finalize(self) -> None:
            """Take in what it calls, and end there: no optimising, no machine code."""
            for called in dict.fromkeys(self._linking_libraries):
                self._reload_init.update(called._reload_init)
                self._final_module.link_in(called._get_module_for_linking(), preserve=True)
            self._finalize_dynamic_globals()
            self._verify_declare_only_symbols()
            self._finalized = True

    @machinery.register_pass(mutates_CFG=True, analysis_only=False)
    class PartLowering(passes.NativeLowering):
        _name = "part_lowering"

        def run_pass(self, state: Any) -> bool:
            """Lower a function into a part, and tell its callers of it."""
            known: Any = super()
            name = state.func_id.func_qualname
            library = state.library = Part(state.targetctx.codegen(), name)
            state.flags.no_compile = True
            known.run_pass(state)
            library.finalize()
            made, nowhere = state["cr"], 0
            home = made.fndesc.lookup_module()
            entry = cpu._dynfunc.make_function(home, name, "", nowhere, made.env, (library,))
            state.targetctx.insert_user_function(entry, made.fndesc, [library])
            state["cr"] = made._replace(cfunc=entry)
            return True

    class PartCompiler(compiler.CompilerBase):
        def define_pipelines(self) -> list[Any]:
            """Do all as usual but for the last pass."""
            usual = compiler.DefaultPassBuilder.define_nopython_pipeline(self.state)
            made = compiler.PassManager("part")
            made.passes.extend(
                (PartLowering if one is passes.NativeLowering else one, said) for one, said in usual.passes
            )
            made.finalize()
            return [made]

    return PartCompiler
