"""Which tests are quick: all but those listed here, so that `pytest -m quick` takes less than a minute."""

import pytest
from tests.beside import start_type_checker

SLOW = (
    "docs/pictures.md",
    "docs/terminal.md",
    "tests/contract/test_catalogue.py::test_needed_stages_are_those_that_are_run",
    "tests/contract/test_code.py::test_tool_finds_nothing",
    "tests/contract/test_compiled.py",
    "tests/contract/test_designs.py",
    "tests/contract/test_docs.py::test_all_public_names_stand_in_the_reference",
    "tests/contract/test_docs.py::test_all_results_stand_in_the_table",
    "tests/contract/test_docs.py::test_blocks_that",
    "tests/contract/test_docs.py::test_equations_are_numbered_as_labelled",
    "tests/contract/test_docs.py::test_formulas_are_for_browsers",
    "tests/contract/test_docs.py::test_pictures_are_there",
    "tests/contract/test_docs.py::test_readers_need_no_network",
    "tests/contract/test_kinds.py::test_gap_is_open_where_the_motion_is_nan",
    "tests/contract/test_language.py::test_template_holds_what_the_code_says",
    "tests/contract/test_motors.py::test_compiled",
    "tests/contract/test_picture_words.py",
    "tests/contract/test_pictures.py",
    "tests/contract/test_types.py",
    "tests/e2e/",
    "tests/exact/",
    "tests/property/",
    "tests/unit/cli/test_attacks.py",
    "tests/unit/cli/test_help.py::test_examples_in_help_work",
    "tests/unit/cli/test_lists.py::test_every_example_runs",
    "tests/unit/cli/test_plot.py::test_at_the_running_speed",
    "tests/unit/cli/test_synthesise.py::test_what_is_written_runs",
    "tests/unit/io/test_editing.py::test_edited_text_says_exactly_what_is_wanted",
    "tests/unit/io/test_editing.py::test_every_place_is_found",
    "tests/unit/mechanisms/test_closing.py::test_articulated_rod",
    "tests/unit/mechanisms/test_equation.py::test_compiled_for_numbers",
    "tests/unit/mechanisms/test_valve_gears.py",
    "tests/unit/numerics/test_numerics.py::test_residual_of_derivatives",
    "tests/unit/plans/test_force_polygons.py",
    "tests/unit/plans/test_uneven_plans.py::test_polygons_close_and_levers_balance",
    "tests/unit/questions/drive/test_clutched.py::test_worst_stop",
    "tests/unit/questions/evenness/test_load_curve.py::test_designs_may_have_curves_of_their_own",
    "tests/unit/questions/evenness/test_rim.py::test_compiled",
    "tests/unit/questions/forces/test_friction.py::test_reactions_and_work_agree_and_friction_takes_power",
    "tests/unit/questions/forces/test_guides.py::test_a_long_guide_is_as_one_without_length",
    "tests/unit/questions/forces/test_guides.py::test_the_shaft_gives_what_both_edges_take",
    "tests/unit/questions/test_doubts.py::test_no_example_is_doubted",
    "tests/unit/questions/test_unlikely.py",
    "tests/unit/questions/torsion/test_modes.py",
    "tests/unit/synthesis/test_counterweights.py",
    "tests/unit/synthesis/test_knuckle.py::test_run_gives_the_requirements",
    "tests/unit/synthesis/test_radial.py::test_reference_case",
    "tests/unit/viz/",
    "tests/validation/",
    "tests/validation/test_heavy_flywheels.py",
    "tests/validation/test_motor_corners.py",
    "tests/validation/test_starts_and_sizing.py",
)
"""What takes more than a second or two, by the beginning of its name."""

QUICK = (
    "tests/contract/test_compiled.py::test_a_kernel_is_compiled_once",
    "tests/contract/test_compiled.py::test_every_kernel_has_an_example",
    "tests/contract/test_compiled.py::test_numbers[slide.slide]",
    "tests/contract/test_designs.py::test_designs_differ[slider_crank]",
    "tests/contract/test_motors.py::test_compiled[0.0-cage]",
    "tests/contract/test_pictures.py::test_nothing_below_names_pictures",
    "tests/e2e/test_program.py::test_errors_go_to_stderr_with_status_2",
    "tests/e2e/test_program.py::test_run_says_everything_on_stdout",
    "tests/exact/test_valve_gears.py::test_stephenson[1-",
    "tests/exact/test_valve_gears.py::test_walschaerts[1-",
    "tests/exact/test_yoke.py",
    "tests/property/test_invariance.py::test_wordings[other_units-0]",
    "tests/property/test_machines.py::test_twice_as_large_moves_twice_as_far",
    "tests/unit/cli/test_attacks.py::TestPipes",
    "tests/unit/mechanisms/test_equation.py::test_compiled_for_numbers[slider_crank]",
    "tests/unit/mechanisms/test_valve_gears.py::test_walschaerts_has_one_lead_in_all_notches",
    "tests/unit/plans/test_force_polygons.py::test_slider_crank_by_hand",
    "tests/unit/questions/torsion/test_modes.py::test_two",
    "tests/unit/viz/test_evenness_pictures.py::test_tangents_are_drawn_at_both_speeds",
    "tests/unit/viz/test_force_pictures.py::test_curves_are_the_results",
    "tests/unit/viz/test_force_pictures.py::test_plan_is_readable[plan_forces-slider_crank]",
    "tests/unit/viz/test_force_pictures.py::test_sheet_of_what_has_no_forces",
    "tests/unit/viz/test_pictures.py::test_construction_is_readable[24-plan_arc-vaz_21213]",
    "tests/unit/viz/test_pictures.py::test_plan_is_readable[angles1-velocities-3d12]",
    "tests/unit/viz/test_pictures.py::test_sheet_of_every_kind_is_readable[slider_crank]",
    "tests/unit/viz/test_running_speed_pictures.py::test_curves_are_the_results",
    "tests/validation/test_flywheel.py",
    "tests/validation/test_torque_orders.py",
)
"""One for each of the slow, of those that have quick cases."""


def is_quick(name: str) -> bool:
    """Whether a test belongs to those that are run while working."""
    return name.startswith(QUICK) or not name.startswith(SLOW)


def pytest_configure(config: pytest.Config) -> None:
    """Name the marker."""
    config.addinivalue_line("markers", "quick: nearly all tests, which take less than a minute together")


@pytest.hookimpl(tryfirst=True)
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark the quick tests, before `-m` chooses among the marked."""
    for item in items:
        if is_quick(item.nodeid):
            item.add_marker("quick")


def pytest_collection_finish(session: pytest.Session) -> None:
    """Let the type checker begin with the tests, where they ask for it."""
    if not session.config.option.collectonly and any(item.path.name == "test_types.py" for item in session.items):
        start_type_checker()
