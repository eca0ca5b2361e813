"""Answers of a service as a browser opens them."""

import json
import struct

import numpy as np


def opened(answer):
    """JSON of an answer, and its numbers."""
    assert answer.status_code == 200, answer.text[:500]
    (length,) = struct.unpack_from("<I", answer.content)
    by_byte = np.frombuffer(answer.content[4 + length :], np.uint8).reshape(4, -1)
    return json.loads(answer.content[4 : 4 + length]), np.ascontiguousarray(by_byte.T).view("<f4").ravel()
