"""What a synthesis wants: numbers in SI, annotated with the quantity as which each is typed."""

from typing import Annotated, TypeAlias

from cranktrain.language import N_
from cranktrain.quantities import Dimension, Quantity

Length: TypeAlias = Annotated[float, Quantity(Dimension.LENGTH)]
Angle: TypeAlias = Annotated[float, Quantity(Dimension.ANGLE)]
Ratio: TypeAlias = Annotated[float, Quantity(Dimension.RATIO)]
Velocity: TypeAlias = Annotated[float, Quantity(Dimension.VELOCITY)]
Count: TypeAlias = Annotated[int, Quantity(Dimension.RATIO, example="9")]
TimeRatio: TypeAlias = Annotated[
    float,
    Quantity(Dimension.RATIO, example="1.2"),
    N_("Time of the slow stroke over that of the quick one."),
]
Bore: TypeAlias = Annotated[float, Quantity(Dimension.LENGTH, above=0.0), N_("For the machine file.")]
Speed: TypeAlias = Annotated[float, Quantity(Dimension.SPEED, above=0.0), N_("Of the crank.")]
Friction: TypeAlias = Annotated[
    float, Quantity(Dimension.RATIO, above=0.0, at_most=2.0), N_("Coefficient of friction of the slider on its guide.")
]
Mass: TypeAlias = Annotated[float, Quantity(Dimension.MASS)]
