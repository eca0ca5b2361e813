"""The service as a process: how soon it answers, how it ends, and what it does when one of its processes is gone."""

import http.client
import json
import os
import signal
import time
from urllib.error import HTTPError
from urllib.parse import urlsplit
from urllib.request import Request, urlopen

import psutil
import pytest
from tests.serving import address_of, served, started
from tests.soon import is_done_within

STOPPED = 130
"""What a shell says of a program that Ctrl-C has ended."""
needs_signals = pytest.mark.skipif(os.name != "posix", reason="processes are stopped and killed by signals")


def asked(address, machine="3d12", timeout=60, **headers):
    """Ask for a page; give the status and what came."""
    body = json.dumps({"machine": machine, "tab": "Largest forces"}).encode()
    request = Request(f"{address}api/case", body, {"Content-Type": "application/json", **headers})
    try:
        with urlopen(request, timeout=timeout) as answer:
            return answer.status, answer.read()
    except HTTPError as error:
        return error.code, error.read()


def crew_of(process):
    """Processes of a service, as soon as it has them."""
    for _wait in range(200):
        found = psutil.Process(process.pid).children()
        if found:
            return found
        time.sleep(0.05)
    pytest.fail("no process computes")


def seconds_to_end(process, end):
    """End a service, and give how long it takes until it and all its processes are gone. [s]"""
    crew = crew_of(process)
    since = time.monotonic()
    end()
    process.wait(timeout=20)
    _gone, left = psutil.wait_procs(crew, timeout=20)
    assert left == []
    return time.monotonic() - since


def test_it_answers_soon(tmp_path):
    def first_page():
        since = time.monotonic()
        with served(tmp_path) as address:
            with urlopen(address, timeout=20) as answer:
                assert b'id="page"' in answer.read()
            taken = time.monotonic() - since
            assert asked(address)[0] == 200
        return taken

    def first_answer():
        since = time.monotonic()
        with served(tmp_path) as address:
            assert asked(address)[0] == 200
            return time.monotonic() - since

    assert is_done_within(3.0, first_page)
    assert is_done_within(10.0, first_answer)  # a second where nobody else is at the processors


def test_what_a_browser_asks_one_after_the_other_is_sent_at_once(tmp_path):
    """Where a server does not ask for that, the end of each answer waits up to 40 ms for the next to be confirmed."""
    with served(tmp_path) as address:
        connection = http.client.HTTPConnection(urlsplit(address).netloc, timeout=20)

        def ask():
            connection.request("GET", "/api/examples")
            assert connection.getresponse().read()

        def fifty():
            since = time.monotonic()
            for _each in range(50):
                ask()
            return time.monotonic() - since

        ask()
        assert is_done_within(1.0, fifty)  # two seconds where they wait
        connection.close()


@needs_signals
def test_ctrl_c_ends_it_at_once_and_says_so(tmp_path):
    def end():
        with started(tmp_path) as process:
            assert asked(address_of(process))[0] == 200
            seconds = seconds_to_end(process, lambda: process.send_signal(signal.SIGINT))
            assert process.stderr.read() == "stopped\n"
            assert process.returncode == STOPPED
        return seconds

    assert is_done_within(2.0, end)


@needs_signals
def test_ctrl_c_does_not_wait_for_what_is_computed(tmp_path):
    def end():
        with started(tmp_path) as process:
            address = address_of(process)
            assert asked(address)[0] == 200  # one that is stopped before it has begun would stop who starts it
            for one in crew_of(process):
                one.suspend()  # so that it is at it for as long as anybody waits
            with pytest.raises(TimeoutError):
                asked(address, timeout=0.5)
            seconds = seconds_to_end(process, lambda: process.send_signal(signal.SIGINT))
            assert process.stderr.read() == "stopped\n"
        return seconds

    assert is_done_within(2.0, end)


@needs_signals
def test_none_is_left_when_it_is_killed(tmp_path):
    def end():
        with started(tmp_path) as process:
            assert asked(address_of(process))[0] == 200
            return seconds_to_end(process, process.kill)

    assert is_done_within(2.0, end)


@needs_signals
def test_processes_that_are_killed_are_replaced(tmp_path):
    with started(tmp_path) as process:
        address = address_of(process)
        assert asked(address)[0] == 200
        for one in crew_of(process):
            one.kill()
        time.sleep(0.2)
        assert {asked(address)[0] for _time in range(4)} <= {200, 503}
        assert asked(address)[0] == 200


def test_another_host_asks_for_the_token_of_the_address(tmp_path):
    with started(tmp_path, "--host", "0.0.0.0") as process:
        shown = address_of(process)
        token = shown.partition("?token=")[2]
        address = f"http://127.0.0.1:{shown.partition('?')[0].rstrip('/').rpartition(':')[2]}/"
        status, said = asked(address)
        assert status == 401
        assert b"needs the token" in said
        assert asked(address, Authorization="Bearer no")[0] == 401
        assert asked(address, Authorization=f"Bearer {token}")[0] == 200
        assert len(token) >= 32
        process.terminate()
        assert "whoever reaches 0.0.0.0" in process.stderr.read()


@pytest.mark.parametrize("host", ["192.0.2.7", "nowhere.invalid", "a" * 70, ""])
def test_a_host_that_is_not_this_computer_is_refused(tmp_path, host):
    with started(tmp_path, "--host", host) as process:
        assert process.wait(timeout=30) == 2
        assert "--host" in process.stderr.read()
