"""How long a thing takes by the clock, where other programs may be at the processors."""

_TRIES = 3


def is_done_within(seconds, timed):
    """Look whether something is done within a time.

    What is slow is slow each time; where the processors are somebody else's for a while, it is only once. So the
    quickest of a few tries counts, and it is tried again only as long as none was quick enough.

    Parameters
    ----------
    seconds : float
        What is allowed. [s]
    timed : callable
        Does it once and gives how long it took. [s]
    """
    return any(timed() < seconds for _try in range(_TRIES))
