"""Motion: how pistons, rods, rockers and points on links move."""

from collections.abc import Iterator

from cranktrain.language import N_
from cranktrain.layout.design import Designs
from cranktrain.layout.question import Parts, Question, ResultDimension, Stage
from cranktrain.questions.motion import (
    axial_positions,
    closing,
    couplers,
    dead_centres,
    followed,
    grid_motion,
    pistons,
    point_paths,
    points,
    ranges,
    rocker_load,
    rockers,
    rods,
    rows,
)


def _parts(designs: Designs, _known: Parts) -> Iterator[object | None]:
    yield points.link_points_of(designs)
    yield ranges.open_mechanisms_of(designs)
    yield followed.followed_of(followed.FollowedLinks, designs.places)
    yield followed.followed_of(followed.FollowedSliders, designs.places)
    yield rocker_load.load_radius_of(designs)
    yield rods.permissible_angles_of(designs)


QUESTION = Question(
    "motion",
    problems=points.point_problems,
    parts=_parts,
    stages=(
        Stage(grid_motion.grid_motion),
        Stage(dead_centres.piston_turn),
        Stage(dead_centres.piston_grid),
        Stage(dead_centres.dead_centres),
        Stage(pistons.piston_motion),
        Stage(rods.rod_motion, applies=rods.on_rods),
        Stage(pistons.piston_speeds),
        Stage(rods.rod_speeds),
        Stage(rockers.rocker_turn),
        Stage(rockers.dead_positions),
        Stage(rockers.rocker_motion),
        Stage(couplers.coupler_motion, applies=couplers.on_rods),
        Stage(rockers.rocker_speeds),
        Stage(couplers.coupler_speeds),
        Stage(rocker_load.load_motion),
        Stage(points.point_motion),
        Stage(point_paths.point_turn),
        Stage(point_paths.point_paths),
        Stage(point_paths.point_speeds),
        Stage(followed.link_motion),
        Stage(followed.slider_motions),
        Stage(axial_positions.axial_positions),
        Stage(closing.closing),
        Stage(ranges.crank_ranges, applies=ranges.is_stuck),
        Stage(ranges.point_ranges, applies=ranges.is_stuck),
    ),
    dimensions=(
        ResultDimension("point", N_("point")),
        ResultDimension("link", N_("link")),
        ResultDimension("slider", N_("slider")),
        ResultDimension("ranged_link", N_("link")),
        ResultDimension("crank_range", N_("range"), is_number=True),
    ),
    headline=("stroke", "mean_piston_speed", "largest_piston_speed", "swing", "time_ratio", "closing_margin"),
    title=N_("Motion"),
    rows=(rows.slider_rows, rows.rocker_rows, rows.point_rows, rows.closing_rows, rows.range_rows),
    offers={
        "piston_velocity": N_("speeds and accelerations"),
        "point_x": N_("curves of points"),
    },
    curve_tables={
        "motion": (
            *("piston_displacement", "piston_velocity", "piston_acceleration"),
            *("rod_angle", "rod_angular_velocity", "rod_angular_acceleration"),
            *("rocker_angle", "rocker_angular_velocity", "rocker_angular_acceleration"),
            *("coupler_angle", "coupler_angular_velocity", "coupler_angular_acceleration"),
            *("load_displacement", "load_velocity_coefficient"),
        )
    },
)
