"""No product of matrices wakes threads of BLAS, which then spin beside the run: all that may be large go by blocks."""

import ast
import os
import subprocess
import sys

import numpy as np
import pytest
from tests.contract.test_code import MODULES, SOURCE

from cranktrain.numerics.products import product, product_by_columns, summed_products

PACKAGE = SOURCE / "cranktrain"
MOST = 1.02
"""Of the time of the thread that calls; one waking of threads costs a tenth of a second."""
PRODUCTS = {"dot", "matmul", "inner", "tensordot", "vdot", "multi_dot"}
SMALL = {
    "fluids/wiebe/curve.py": "a stack of some forty panels of twelve points",
    "layout/standing.py": "two vectors of the plane",
    "mechanisms/chain/adding/": "two vectors of the plane",
    "numerics/products.py": "the blocks",
    "numerics/tops.py": "a stack of four by five",
    "panels/": "vectors of the plane",
    "plans/": "vectors of the plane",
    "transient/clutched/": "the few states of a clutched drive",
    "questions/drive/cycle_equation.py": "the pieces of a cycle, at most some hundreds, by twelve nodes",
    "questions/reduction/cycle_pieces.py": "made once; the pieces of a cycle by the weights of their nodes",
    "questions/servo/demand.py": "made once",
    "questions/drive/settling.py": "the pieces of a cycle by twelve nodes and four places",
    "questions/reduction/smooth.py": "a stack of at most a thousand pieces of twelve nodes",
    "questions/evenness/law_between_events.py": "a stack of the pieces between events",
    "questions/torsion/train.py": "a stack of the discs of a train",
    "synthesis/": "as many unknowns as there are weights, and stacks of plane vectors",
    "viz/": "vectors of the plane",
}
"""Where matrices are multiplied otherwise, and why that stays on the thread that calls."""


def is_product(node):
    """Whether BLAS may do it: `@`, a function of products, a sum that is put in an order of its own."""
    match node:
        case ast.BinOp(op=ast.MatMult()) | ast.AugAssign(op=ast.MatMult()):
            return True
        case ast.Call(func=ast.Attribute(attr="einsum"), keywords=keywords):
            return any(keyword.arg == "optimize" for keyword in keywords)
        case ast.Call(func=ast.Attribute(attr=attr)):
            return attr in PRODUCTS
    return False


def with_products():
    """Modules that multiply matrices, by their path in the package."""
    for path in MODULES:
        if path.is_relative_to(PACKAGE) and any(map(is_product, ast.walk(ast.parse(path.read_text(encoding="utf-8"))))):
            yield path.relative_to(PACKAGE).as_posix()


def test_products_go_by_blocks():
    found = set(with_products())
    assert {path for path in found if not path.startswith(tuple(SMALL))} == set()
    assert {begin for begin in SMALL if not any(path.startswith(begin) for path in found)} == set()


@pytest.mark.parametrize(
    ("left", "right"),
    [
        ((3, 2), (2, 4)),
        ((5000, 15), (15, 130)),
        ((1, 9000), (9000, 2)),
        ((2, 1), (1, 9000)),
        ((0, 3), (3, 2)),
        ((131, 8), (8, 257)),
        ((5, 2, 1000, 12), (12, 13)),
        ((4, 1, 30, 2), (3, 2, 5)),
        ((70,), (70, 300)),
        ((9, 400, 70), (70,)),
        ((3,), (3,)),
    ],
)
def test_product_by_blocks_is_the_product(left, right):
    rows, matrix = (np.cos(np.arange(np.prod(shape)) + 0.3).reshape(shape) for shape in (left, right))
    close = {"rtol": 0, "atol": 1e-13 * left[-1]}
    np.testing.assert_allclose(product(rows, matrix), rows @ matrix, **close)
    np.testing.assert_allclose(product(1j * rows, 1j * matrix), -(rows @ matrix), **close)


@pytest.mark.parametrize(
    ("matrix", "columns"), [((14, 54), (54, 150)), ((2, 3), (3, 1)), ((3, 40, 300), (3, 300, 70)), ((33, 12), (12, 0))]
)
def test_a_column_is_the_same_whatever_stands_beside_it(matrix, columns):
    rows, many = (np.cos(np.arange(np.prod(shape)) + 0.3).reshape(shape) for shape in (matrix, columns))
    whole = product_by_columns(rows, many)
    np.testing.assert_allclose(whole, rows @ many, rtol=0, atol=1e-13 * columns[-2])
    for first in range(0, columns[-1], 7):
        for last in (first + 1, first + 5, columns[-1]):
            some = slice(first, last)
            np.testing.assert_array_equal(product_by_columns(rows, many[..., some]), whole[..., some])


def test_summed_products():
    left, right = np.cos(np.arange(60000.0)).reshape(-1, 6), np.sin(np.arange(40000.0)).reshape(-1, 4)
    np.testing.assert_allclose(summed_products(left, right), left.T @ right, rtol=0, atol=1e-10)


def test_no_example_wakes_threads():
    """Nearly all time of the process is that of the thread that calls, with as many threads as BLAS takes by itself."""
    program = """
import time
import cranktrain as ct

machines = [ct.load(name) for name in ct.example_names()]
whole, own = time.process_time(), time.thread_time()
for machine in machines:
    ct.run(machine).find_all()
own = time.thread_time() - own
time.sleep(0.3)  # until what was woken sleeps again
print((time.process_time() - whole) / own)
"""
    environment = {name: value for name, value in os.environ.items() if not name.endswith("_NUM_THREADS")}
    said = subprocess.run([sys.executable, "-c", program], env=environment, capture_output=True, text=True, check=True)
    assert float(said.stdout) <= MOST
