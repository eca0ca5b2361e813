import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { changes, stepped } from "../src/handles.ts";

describe("numbers that a pin changes", () => {
  it("are typed to their step", () => {
    assert.equal(stepped(78.26, 0.5), "78.5");
    assert.equal(stepped(181.2, 2), "182");
    assert.equal(stepped(0.2513, 0.002), "0.252");
    assert.equal(stepped(-0.01, 0.5), "0.0");
  });
  it("take of one direction what is along it", () => {
    assert.deepEqual(changes([{ x: 0, y: 0.125 }], { x: 5, y: 2.5 }), [20]);
  });
  it("reach a point by two", () => {
    const [one, other] = changes([{ x: 0.001, y: 0 }, { x: 0.001, y: 0.002 }], { x: 0.003, y: 0.004 }) as [number, number];
    assert.ok(Math.abs(one - 1) < 1e-9 && Math.abs(other - 2) < 1e-9);
  });
  it("that go the same way leave the second as it is", () => {
    assert.deepEqual(changes([{ x: 0.125, y: 0 }, { x: 0.25, y: 0 }], { x: 0.375, y: 0.5 }), [3, 0]);
  });
});
