"""Coroutines in a thread of their own: a browser's tests leave a loop in the thread of all tests."""

import asyncio
from concurrent.futures import ThreadPoolExecutor


def finished(coroutine):
    """Run a coroutine to its end."""
    with ThreadPoolExecutor(1) as pool:
        return pool.submit(asyncio.run, coroutine).result()
