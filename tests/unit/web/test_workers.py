"""Processes of a service: nobody waits for another one's question, none ends with what it computes."""

import asyncio
import json
import time

import psutil
import pytest
from tests.apart import finished
from tests.odd_questions import Fatal, Faulty, Hanging, Leaving, Naming
from tests.soon import is_done_within

from cranktrain.web.asked import Case, PageQuestion, SentMachine
from cranktrain.web.workers import InThisProcess, Workers

SMALL = '[mechanism]\nkind = "slider_crank"\ncrank_radius = "50 mm"\nrod_length = "130 mm"\n'
QUESTION = PageQuestion(Case(SentMachine(SMALL), ("mechanism.rod_length=140 mm",)), "page")
SOON = 60.0
"""A process that begins anew answers sooner even on a busy computer. [s]"""


def with_workers(do, n_at_once=1, **limits):
    """Do something with workers, and look that none is left."""

    async def all_of_it():
        workers = Workers(n_at_once, **limits)
        await workers.start()
        try:
            return await do(workers)
        finally:
            await workers.stop()

    before = set(psutil.Process().children())
    found = finished(all_of_it())
    assert set(psutil.Process().children()) == before
    return found


def said(reply):
    """The sentence of a refusal."""
    (problem,) = json.loads(reply.content)
    return problem["allowed"]


@pytest.mark.parametrize("part", ["page", "tab", "trust", "file"])
def test_they_give_what_one_process_gives(part):
    question = QUESTION._replace(part=part)
    expected = finished(InThisProcess().reply(question))
    assert expected.status == 200
    assert with_workers(lambda workers: workers.reply(question)) == expected


def test_what_is_wrong_is_said():
    question = QUESTION._replace(case=Case(SentMachine(SMALL), ("mechanism.rod_length=-1 mm",)))
    reply = with_workers(lambda workers: workers.reply(question))
    assert reply.status == 422
    assert [problem["path"] for problem in json.loads(reply.content)] == ["mechanism.rod_length"]


@pytest.mark.parametrize(
    ("question", "longest", "sentence"),
    [
        (Hanging(), 2.0, "takes longer than 2 s, and was given up"),
        (Fatal(), SOON, "could not be computed: its process ended"),
    ],
)
def test_a_question_that_goes_wrong_is_said_so_and_the_next_is_answered(question, longest, sentence):
    async def both(workers):
        refused = await workers.reply(question)
        workers._longest = SOON
        return refused, await workers.reply(QUESTION)

    refused, answered = with_workers(both, longest=longest)
    assert (refused.status, said(refused)) == (503, sentence)
    assert answered.status == 200


def test_a_fault_of_the_program_shows_no_traceback(capfd):
    reply = with_workers(lambda workers: workers.reply(Faulty()))
    assert reply.status == 500
    assert b"canary" not in reply.content
    assert "canary-of-a-traceback" in capfd.readouterr().err


def test_a_long_question_does_not_stop_another():
    async def both(workers):
        long = asyncio.ensure_future(workers.reply(Hanging()))
        await asyncio.sleep(0)
        answered = await asyncio.wait_for(workers.reply(QUESTION), SOON)
        assert not long.done()
        return answered, long

    answered, _long = with_workers(both)
    assert answered.status == 200


def test_many_short_questions_start_no_other_process():
    async def asked(workers):
        assert (await workers.reply(QUESTION)).status == 200
        replies = await asyncio.gather(*(workers.reply(Naming(Case(str(n)))) for n in range(8)))
        return {json.loads(reply.content)[0]["given"] for reply in replies}

    assert len(with_workers(asked)) == 1


def test_who_waits_at_the_end_is_said_so():
    async def asked(workers):
        long = asyncio.ensure_future(workers.reply(Hanging()))
        waiting = asyncio.ensure_future(workers.reply(QUESTION))
        await asyncio.sleep(0.1)
        since = time.monotonic()
        await workers.stop()
        return await long, await waiting, time.monotonic() - since

    def end():
        long, waiting, seconds = with_workers(asked)
        assert {(one.status, said(one)) for one in (long, waiting)} == {(503, "has ended")}
        return seconds

    assert is_done_within(1.0, end)


def test_what_has_not_begun_when_nobody_waits_any_more_never_does(tmp_path):
    path = tmp_path / "computed"

    async def given_up(workers):
        hanging = asyncio.ensure_future(workers.reply(Hanging()))
        leaving = asyncio.ensure_future(workers.reply(Leaving(str(path))))
        await asyncio.sleep(0.1)
        leaving.cancel()
        hanging.cancel()
        return await asyncio.wait_for(workers.reply(QUESTION), SOON)

    assert with_workers(given_up).status == 200
    assert not path.exists()


def test_one_machine_goes_to_one_process():
    async def asked(workers):
        first, second = Naming(Case("a")), Naming(Case("b"))
        pids = []
        for _time in range(3):
            both = await asyncio.gather(workers.reply(first), workers.reply(second))
            pids.append(tuple(json.loads(reply.content)[0]["given"] for reply in both))
            first, second = second, first
        return pids

    found = with_workers(asked, 2)
    assert len(set(found[0])) == 2
    assert found == [found[0], found[0][::-1], found[0]]


def test_more_than_can_wait_are_refused_at_once():
    async def asked(workers):
        waiting = [asyncio.ensure_future(workers.reply(Hanging())) for _each in range(110)]
        done, _rest = await asyncio.wait(waiting, timeout=0.3)
        return [one.result() for one in done]

    refused = with_workers(asked)
    assert len(refused) == 9
    assert {said(one) for one in refused} == {"has too much to do now"}
