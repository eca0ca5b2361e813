import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { taken } from "../src/adding.ts";

const PLACES: Readonly<Record<string, { readonly x: number; readonly y: number }>> = { A: { x: 0, y: 0 }, B: { x: 100, y: 0 }, C: { x: 100, y: 80 } };
const place = (name: string): { readonly x: number; readonly y: number } => PLACES[name] ?? { x: NaN, y: NaN };
const pin = (name: string): Target => ({ name, pins: [name] });
const [a, b, gone] = [pin("A"), pin("B"), pin("D")];
const link: Target = { name: "link", pins: ["A", "B", "C"] };
const ground: Target = { name: "", pins: [] };

interface Target {
  readonly name: string;
  readonly pins: readonly string[];
}

describe("what a click takes", () => {
  it("is the nearest pin that is not far, where pins are all it takes", () => {
    assert.deepEqual(taken([a, b, gone], { x: 70, y: 30 }, place, 10), { target: b, at: PLACES["B"] });
    assert.equal(taken([a, b, gone], { x: 70, y: 400 }, place, 10), null);
  });
  it("is a link at the foot of what is near it", () => {
    assert.deepEqual(taken([link, ground], { x: 40, y: 9 }, place, 10), { target: link, at: { x: 40, y: 0 } });
    assert.deepEqual(taken([link, ground], { x: 104, y: 60 }, place, 10), { target: link, at: { x: 100, y: 60 } });
  });
  it("is the ground beside a link, or a place beside the link where there is no other", () => {
    const at = { x: 40, y: 12 };
    assert.deepEqual(taken([link, ground], at, place, 10), { target: ground, at });
    assert.deepEqual(taken([link], at, place, 10), { target: link, at });
    assert.deepEqual(taken([link], { x: 40, y: 400 }, place, 10), { target: link, at: { x: 40, y: 400 } });
  });
  it("is any place where the ground is all it takes", () => {
    const at = { x: -5, y: 7 };
    assert.deepEqual(taken([ground], at, place, 10), { target: ground, at });
  });
  it("is nothing where pins are nowhere", () => {
    assert.equal(taken([gone], { x: 0, y: 0 }, place, 10), null);
  });
});
