"""The same outputs as the kernels', written by hand: one function each, as one would write it for this alone.

Plain NumPy takes an array of angles and gives a tuple of arrays; Numba loops over the angles and fills a table, a row
per angle. Both reuse what they can and know what a kernel cannot: that the rocker's pivot stands still. They have no
need to stay exact where a kernel must: for links nearly in line, or a whole that turns nearly as one body.
"""

import numpy as np
from numba import njit


def slider_crank_numpy(angle, crank_radius, rod_length, offset):
    """Pin, slider and rod of a slider-crank: x, x', x'', y, y', y'', s, s', s'', θ, θ', θ'', cos θ, sin θ."""
    x = crank_radius * np.cos(angle)
    y = crank_radius * np.sin(angle)
    minus_x = -x
    minus_y = -y
    drop = offset - y
    reach = np.sqrt((rod_length - drop) * (rod_length + drop))
    turn = minus_x / reach
    rate = (y + drop * turn * turn) / reach
    return (
        x,
        minus_y,
        minus_x,
        y,
        x,
        minus_y,
        x + reach,
        -(y + drop * turn),
        x * turn - (x + drop * rate),
        np.arctan2(drop, reach),
        turn,
        rate,
        reach / rod_length,
        drop / rod_length,
    )


def crank_rocker_numpy(angle, crank_radius, rod_length, rocker_length, ground_length, side):
    """Pin, joint, rod and rocker: (x, x', x'', y, y', y'') of both points, (θ, θ', θ'', cos θ, sin θ) of both links."""
    x = crank_radius * np.cos(angle)
    y = crank_radius * np.sin(angle)
    minus_x = -x
    minus_y = -y
    dx = ground_length - x
    square = dx * dx + y * y
    longest = (rod_length + rocker_length) ** 2
    shortest = (rod_length - rocker_length) ** 2
    cross = 0.5 * side * np.sqrt((longest - square) * (square - shortest))
    along = 0.5 + 0.5 * (rod_length**2 - rocker_length**2) / square
    across = cross / square
    qx = along * dx + across * y
    qy = across * dx - along * y
    tx = qx - dx
    ty = qy + y
    rod_turn = (y * tx - x * ty) / cross
    rocker_turn = (y * qx - x * qy) / cross
    rod_square = rod_turn * rod_turn
    rocker_square = rocker_turn * rocker_turn
    kx = x + rod_square * qx - rocker_square * tx
    ky = y + rod_square * qy - rocker_square * ty
    rod_rate = (kx * tx + ky * ty) / cross
    rocker_rate = (kx * qx + ky * qy) / cross
    return (
        x,
        minus_y,
        minus_x,
        y,
        x,
        minus_y,
        x + qx,
        -ty * rocker_turn,
        -(ty * rocker_rate + tx * rocker_square),
        y + qy,
        tx * rocker_turn,
        tx * rocker_rate - ty * rocker_square,
        np.arctan2(qy, qx),
        rod_turn,
        rod_rate,
        qx / rod_length,
        qy / rod_length,
        np.arctan2(ty, tx),
        rocker_turn,
        rocker_rate,
        tx / rocker_length,
        ty / rocker_length,
    )


def slider_crank_forces_numpy(angle, geometry, crank, rod, piston_mass, pressing, speed, acceleration, gravity):
    """Bearing on crank, crank on rod, rod on slider (x and y of each), wall on slider, torque.

    Bodies are (mass, along, across, inertia); gravity is (x, y); without friction.
    """
    crank_radius, rod_length, offset = geometry
    crank_mass, crank_along, crank_across, crank_inertia = crank
    rod_mass, along, across, rod_inertia = rod
    gx, gy = gravity
    square = speed * speed
    cos = np.cos(angle)
    sin = np.sin(angle)
    x = crank_radius * cos
    y = crank_radius * sin
    drop = offset - y
    reach = np.sqrt((rod_length - drop) * (rod_length + drop))
    turn = -x / reach
    rate = (y + drop * turn * turn) / reach
    s1 = -(y + drop * turn)
    s2 = x * turn - (x + drop * rate)
    rod_cos = reach / rod_length
    rod_sin = drop / rod_length
    arm_x = along * rod_cos - across * rod_sin
    arm_y = along * rod_sin + across * rod_cos
    vx = -y - turn * arm_y
    vy = x + turn * arm_x
    ax = -x - rate * arm_y - turn * turn * arm_x
    ay = -y + rate * arm_x - turn * turn * arm_y
    rod_x = rod_mass * (gx - (ax * square + vx * acceleration))
    rod_y = rod_mass * (gy - (ay * square + vy * acceleration))
    moment = arm_x * rod_y - arm_y * rod_x - rod_inertia * (rate * square + turn * acceleration)
    wrist_x = piston_mass * (s2 * square + s1 * acceleration - gx) + pressing
    wrist_y = (wrist_x * drop + moment) / reach
    pin_x = wrist_x - rod_x
    pin_y = wrist_y - rod_y
    crank_x = crank_along * cos - crank_across * sin
    crank_y = crank_along * sin + crank_across * cos
    on_x = crank_mass * (gx + crank_x * square + crank_y * acceleration)
    on_y = crank_mass * (gy + crank_y * square - crank_x * acceleration)
    torque = crank_inertia * acceleration + (crank_y * on_x - crank_x * on_y) + (x * pin_y - y * pin_x)
    return pin_x - on_x, pin_y - on_y, pin_x, pin_y, wrist_x, wrist_y, -wrist_y - piston_mass * gy, torque


slider_crank_forces_at = njit(error_model="numpy")(slider_crank_forces_numpy)


@njit(error_model="numpy")
def slider_crank_forces_numba(angles, geometry, crank, rod, piston_mass, pressing, speed, acceleration, gravity, table):
    """Fill `table`, a row per angle, with the columns of `slider_crank_forces_numpy`."""
    for i in range(angles.size):
        row = slider_crank_forces_at(
            angles[i], geometry, crank, rod, piston_mass, pressing, speed, acceleration, gravity
        )
        table[i, 0] = row[0]
        table[i, 1] = row[1]
        table[i, 2] = row[2]
        table[i, 3] = row[3]
        table[i, 4] = row[4]
        table[i, 5] = row[5]
        table[i, 6] = row[6]
        table[i, 7] = row[7]


def ideal_gas_numpy(angle, crank_radius, rod_length, area, clearance, cycle):
    """Volume over a central slider-crank and the ideal four-stroke cycle's pressure in it, from firing to 4π.

    cycle: pressures at the start, at the inlet, at the exhaust, both exponents, both ratios of heat.
    """
    start, inlet, exhaust, compression_exponent, expansion_exponent, pressure_ratio, cut_off_ratio = cycle
    y = crank_radius * np.sin(angle)
    x = crank_radius * np.cos(angle) + np.sqrt((rod_length - y) * (rod_length + y))
    volume = clearance + area * (crank_radius + rod_length - x)
    largest = clearance + 2.0 * area * crank_radius
    cut_off = cut_off_ratio * clearance
    peak = pressure_ratio * start * (largest / clearance) ** compression_exponent
    compression = start * (largest / volume) ** compression_exponent
    expansion = peak * (cut_off / np.maximum(volume, cut_off)) ** expansion_exponent
    grows = y > 0.0
    exchange = np.where(grows, inlet, exhaust)
    return volume, np.where(np.cos(0.5 * angle) > 0.0, np.where(grows, expansion, compression), exchange)


@njit(error_model="numpy")
def ideal_gas_numba(angles, crank_radius, rod_length, area, clearance, cycle, table):
    """Fill `table`, a row per angle, with the columns of `ideal_gas_numpy`; one power for each at most."""
    start, inlet, exhaust, compression_exponent, expansion_exponent, pressure_ratio, cut_off_ratio = cycle
    largest = clearance + 2.0 * area * crank_radius
    cut_off = cut_off_ratio * clearance
    peak = pressure_ratio * start * (largest / clearance) ** compression_exponent
    for i in range(angles.size):
        y = crank_radius * np.sin(angles[i])
        x = crank_radius * np.cos(angles[i]) + np.sqrt((rod_length - y) * (rod_length + y))
        volume = clearance + area * (crank_radius + rod_length - x)
        table[i, 0] = volume
        if np.cos(0.5 * angles[i]) <= 0.0:
            table[i, 1] = inlet if y > 0.0 else exhaust
        elif y <= 0.0:
            table[i, 1] = start * (largest / volume) ** compression_exponent
        elif volume <= cut_off:
            table[i, 1] = peak
        else:
            table[i, 1] = peak * (cut_off / volume) ** expansion_exponent


@njit(error_model="numpy")
def slider_crank_numba(angles, crank_radius, rod_length, offset, table):
    """Fill `table`, a row per angle, with the columns of `slider_crank_numpy`."""
    for i in range(angles.size):
        x = crank_radius * np.cos(angles[i])
        y = crank_radius * np.sin(angles[i])
        drop = offset - y
        reach = np.sqrt((rod_length - drop) * (rod_length + drop))
        turn = -x / reach
        rate = (y + drop * turn * turn) / reach
        table[i, 0] = x
        table[i, 1] = -y
        table[i, 2] = -x
        table[i, 3] = y
        table[i, 4] = x
        table[i, 5] = -y
        table[i, 6] = x + reach
        table[i, 7] = -(y + drop * turn)
        table[i, 8] = x * turn - (x + drop * rate)
        table[i, 9] = np.arctan2(drop, reach)
        table[i, 10] = turn
        table[i, 11] = rate
        table[i, 12] = reach / rod_length
        table[i, 13] = drop / rod_length


@njit(error_model="numpy")
def crank_rocker_numba(angles, crank_radius, rod_length, rocker_length, ground_length, side, table):
    """Fill `table`, a row per angle, with the columns of `crank_rocker_numpy`."""
    longest = (rod_length + rocker_length) ** 2
    shortest = (rod_length - rocker_length) ** 2
    middle = 0.5 * (rod_length**2 - rocker_length**2)
    for i in range(angles.size):
        x = crank_radius * np.cos(angles[i])
        y = crank_radius * np.sin(angles[i])
        dx = ground_length - x
        square = dx * dx + y * y
        cross = 0.5 * side * np.sqrt((longest - square) * (square - shortest))
        per_cross = 1.0 / cross
        along = 0.5 + middle / square
        across = cross / square
        qx = along * dx + across * y
        qy = across * dx - along * y
        tx = qx - dx
        ty = qy + y
        rod_turn = (y * tx - x * ty) * per_cross
        rocker_turn = (y * qx - x * qy) * per_cross
        rod_square = rod_turn * rod_turn
        rocker_square = rocker_turn * rocker_turn
        kx = x + rod_square * qx - rocker_square * tx
        ky = y + rod_square * qy - rocker_square * ty
        rod_rate = (kx * tx + ky * ty) * per_cross
        rocker_rate = (kx * qx + ky * qy) * per_cross
        table[i, 0] = x
        table[i, 1] = -y
        table[i, 2] = -x
        table[i, 3] = y
        table[i, 4] = x
        table[i, 5] = -y
        table[i, 6] = x + qx
        table[i, 7] = -ty * rocker_turn
        table[i, 8] = -(ty * rocker_rate + tx * rocker_square)
        table[i, 9] = y + qy
        table[i, 10] = tx * rocker_turn
        table[i, 11] = tx * rocker_rate - ty * rocker_square
        table[i, 12] = np.arctan2(qy, qx)
        table[i, 13] = rod_turn
        table[i, 14] = rod_rate
        table[i, 15] = qx / rod_length
        table[i, 16] = qy / rod_length
        table[i, 17] = np.arctan2(ty, tx)
        table[i, 18] = rocker_turn
        table[i, 19] = rocker_rate
        table[i, 20] = tx / rocker_length
        table[i, 21] = ty / rocker_length


def chain_numpy(angle, cranks, pins, slides):
    """Chain of five cranks, each with a rod to a rocker and a rod from the joint to a slider on a guide.

    pins: rod, rocker, pivot's x and y, side; slides: rod, guide's direction and offset from the shaft. (x, x', x'', y,
    y', y'') of crank pin, joint and slider's pin, (s, s', s'') of each slider, (θ, θ', θ'', cos θ, sin θ) of rod,
    rocker and the slider's rod.
    """
    columns = []
    for (radius, ahead), (rod, rocker, px, py, side), (link, direction, offset) in zip(
        cranks, pins, slides, strict=True
    ):
        x = radius * np.cos(angle + ahead)
        y = radius * np.sin(angle + ahead)
        dx = px - x
        dy = py - y
        square = dx * dx + dy * dy
        cross = 0.5 * side * np.sqrt(((rod + rocker) ** 2 - square) * (square - (rod - rocker) ** 2))
        along = 0.5 + 0.5 * (rod**2 - rocker**2) / square
        across = cross / square
        qx = along * dx - across * dy
        qy = along * dy + across * dx
        tx = qx - dx
        ty = qy - dy
        rod_turn = (y * tx - x * ty) / cross
        rocker_turn = (y * qx - x * qy) / cross
        rod_square = rod_turn * rod_turn
        rocker_square = rocker_turn * rocker_turn
        kx = x + rod_square * qx - rocker_square * tx
        ky = y + rod_square * qy - rocker_square * ty
        rod_rate = (kx * tx + ky * ty) / cross
        rocker_rate = (kx * qx + ky * qy) / cross
        bx, by = x + qx, y + qy
        bx1, by1 = -ty * rocker_turn, tx * rocker_turn
        bx2 = -(ty * rocker_rate + tx * rocker_square)
        by2 = tx * rocker_rate - ty * rocker_square
        cos, sin = np.cos(direction), np.sin(direction)
        gx, gy = cos * bx + sin * by, cos * by - sin * bx
        gx1, gy1 = cos * bx1 + sin * by1, cos * by1 - sin * bx1
        gx2, gy2 = cos * bx2 + sin * by2, cos * by2 - sin * bx2
        drop = offset - gy
        reach = np.sqrt((link - drop) * (link + drop))
        turn = -gy1 / reach
        rate = (drop * turn * turn - gy2) / reach
        s, s1, s2 = gx + reach, gx1 - drop * turn, gx2 + gy1 * turn - drop * rate
        along, across = reach / link, drop / link
        columns += [x, -y, -x, y, x, -y, bx, bx1, bx2, by, by1, by2]
        columns += [cos * s - sin * offset, cos * s1, cos * s2, sin * s + cos * offset, sin * s1, sin * s2, s, s1, s2]
        columns += [np.arctan2(qy, qx), rod_turn, rod_rate, qx / rod, qy / rod]
        columns += [np.arctan2(ty, tx), rocker_turn, rocker_rate, tx / rocker, ty / rocker]
        columns += [direction + np.arctan2(drop, reach), turn, rate]
        columns += [cos * along - sin * across, sin * along + cos * across]
    return columns
