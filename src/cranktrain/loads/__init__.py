"""Forces, torque, balance and evenness as mathematics of arrays: no machine file, no units, no stages.

Angles are in radians, everything else is in SI. Axes are a mechanism's own or the theory's: x is the axis of bank angle
0, y is x turned by 90° in the sense of rotation. Leading axes (designs, cylinders) broadcast; the last one is the crank
angle or the order.

`piston`, `crank_pin`, `rod_masses`
    forces of a piston, and of its rod on the crank pin; rods replaced by masses
`rod_harmonics`, `harmonic_series`
    exact harmonics of a slider-crank; the texts' series and their errors
`harmonics`
    orders of any periodic curve, and back
`gathering`
    what several have, summed where it acts: cylinders on a throw, throws on a shaft
`torque`, `stars`
    one piston's torque laid over all, along the shaft; how the cylinders' orders add up
`vectors`, `balance`
    forces that turn with the crank and against it; shaking of any layout
`weights`, `counterweights`, `balance_shafts`, `balance_change`
    rotating weights given, solved for on the crank, on shafts beside it; before and after
`periodic`, `excess_work`, `speed`, `speed_law`, `mean_speed`
    curves between their points; excess work; speed over a cycle, under torques that depend on it, at a wanted mean
`flywheel`, `diagrams`, `rim`
    flywheel for a coefficient of fluctuation, exact and as texts have it; its diagrams; its dimensions
"""
