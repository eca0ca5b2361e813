"""Forces, torque, balance and evenness as mathematics of arrays: no machine file, no units, no stages.

Angles are in radians, everything else is in SI. Axes are a mechanism's own or the theory's: x is the axis of bank angle
0, y is x turned by 90° in the sense of rotation. Leading axes (designs, cylinders) broadcast; the last one is the crank
angle or the order.
"""
