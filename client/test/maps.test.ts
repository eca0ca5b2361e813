import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { crossings, levelsOf, nearestTo } from "../src/maps.ts";
import { typed } from "../src/numbers.ts";

describe("a line of equal value", () => {
  const cell = (...values: number[]) => [[0, 0], [1, 0], [1, 1], [0, 1]].map(([x, y], place) => ({ x: x ?? 0, y: y ?? 0, value: values[place] ?? NaN }));
  it("goes where a plane has the value", () => {
    const [pair] = crossings(cell(0, 4, 4, 0), 1);
    assert.deepEqual(pair, [{ x: 0.25, y: 0 }, { x: 0.25, y: 1 }]);
  });
  it("goes twice through a saddle, and not where all is above", () => {
    assert.equal(crossings(cell(0, 1, 0, 1), 0.5).length, 2);
    assert.deepEqual(crossings(cell(2, 3, 4, 5), 1), []);
  });
  it("is there for round values, of which few lie beyond most", () => {
    const levels = levelsOf([...Array.from({ length: 99 }, (_one, place) => place / 10), 1e6]);
    assert.ok(levels.every((one) => one < 20) && levels.length >= 4);
  });
});

describe("a range", () => {
  it("has a number and a unit", () => {
    assert.deepEqual(typed("1500 rpm"), { number: 1500, unit: "rpm" });
    assert.deepEqual(typed(" -.5e1mm"), { number: -5, unit: "mm" });
    assert.deepEqual(typed("8.5"), { number: 8.5, unit: "" });
    assert.equal(typed("otto"), null);
  });
  it("has a value that is nearest", () => {
    assert.equal(nearestTo(Float32Array.from([1, 2, 4]), 2.9), 1);
    assert.equal(nearestTo(Float32Array.from([1, 2, 4]), 99), 2);
  });
});
