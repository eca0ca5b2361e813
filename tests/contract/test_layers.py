"""No module needs itself: imports form no circle, those inside functions and for types alone counted too.

That they point down, and that each module stands in a layer, `lint-imports` says in `test_code`.
"""

from graphlib import TopologicalSorter

import grimp


def test_imports_form_no_circle():
    graph = grimp.build_graph("cranktrain", cache_dir=None)
    imported = {module: graph.find_modules_directly_imported_by(module) for module in graph.modules}
    assert len(imported) > 300
    TopologicalSorter(imported).prepare()  # names the circle in its error
