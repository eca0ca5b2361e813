import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { Turning } from "../src/turning.ts";

function turning(): { crank: Turning; frames: ((time: number) => void)[]; angles: number[] } {
  const frames: ((time: number) => void)[] = [];
  const angles: number[] = [];
  const crank = new Turning(720, (angle) => angles.push(angle), (next) => frames.push(next));
  return { crank, frames, angles };
}

describe("the crank", () => {
  it("turns once in four seconds", () => {
    const { crank, frames } = turning();
    crank.play();
    frames.shift()?.(1000);
    frames.shift()?.(1050);
    assert.ok(Math.abs(crank.angle - 4.5) < 1e-12);
  });
  it("stops at a whole degree and stays there", () => {
    const { crank, frames } = turning();
    crank.play();
    frames.shift()?.(0);
    frames.shift()?.(16);
    crank.stop();
    assert.equal(crank.angle, 1);
    frames.shift()?.(32);
    assert.equal(crank.angle, 1);
    assert.equal(frames.length, 0);
  });
  it("goes on over the end of the cycle, and back", () => {
    const { crank } = turning();
    crank.stand(719);
    crank.step(10);
    assert.equal(crank.angle, 9);
    crank.step(-10);
    assert.equal(crank.angle, 719);
  });
  it("stands at the end where somebody points there", () => {
    const { crank } = turning();
    crank.stand(720);
    assert.equal(crank.angle, 720);
  });
  it("does not leap after the page was hidden", () => {
    const { crank, frames } = turning();
    crank.play();
    frames.shift()?.(0);
    frames.shift()?.(60_000);
    assert.ok(crank.angle <= 9);
  });
});
