"""A process that answers what a service asks it: questions come in by one pipe, replies go out by another."""

import gc
import os
import pickle
import signal
import struct
import sys
import threading
from queue import SimpleQueue
from typing import Any, BinaryIO

from cranktrain.web.asked import HowFar

LENGTH = struct.Struct("<I")
"""Before each question and reply."""

_MOST_YOUNG = 20_000
"""Objects that come without others going, after which garbage is looked for: an answer leaves none, a sweep little."""


def framed(value: object) -> bytes:
    """Give a value as it goes through a pipe."""
    content = pickle.dumps(value, pickle.HIGHEST_PROTOCOL)
    return LENGTH.pack(len(content)) + content


def work() -> None:
    """Answer until whoever asks is gone."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)  # Ctrl-C is for the service: it reaches all processes of a terminal
    replies = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what anything prints is no reply
    questions: SimpleQueue[bytes] = SimpleQueue()
    threading.Thread(target=_listen, args=(sys.stdin.buffer, questions), daemon=True).start()
    from cranktrain.web.replies import reply_to  # half a second, within which the first question may come

    def send(value: object) -> None:
        replies.write(framed(value))
        replies.flush()

    def answer() -> None:
        # Written by the service that started this process, and by nobody else.
        question: Any = pickle.loads(questions.get())
        send(reply_to(question, send))

    send(HowFar())  # it has imported all but what the first machine needs beside
    answer()
    gc.freeze()  # what stays as long as the process is looked through for garbage no more: some 60 ms, each 25th answer
    gc.set_threshold(_MOST_YOUNG)
    while True:
        answer()


def _listen(asked: BinaryIO, questions: "SimpleQueue[bytes]") -> None:
    """Take questions; where nobody is left to ask, end at once, whatever is being computed."""
    while len(head := asked.read(LENGTH.size)) == LENGTH.size:
        questions.put(asked.read(*LENGTH.unpack(head)))
    os._exit(0)
