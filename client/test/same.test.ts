import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { same } from "../src/numbers.ts";

describe("data", () => {
  const data = (last: number): unknown => ({ name: "a", deep: [{ values: Float32Array.from([1, NaN, last]), shape: [3] }], none: null });
  it("are the same number by number, whether there is one or not", () => {
    assert.ok(same(data(2), data(2)));
    assert.ok(!same(data(2), data(3)));
  });
  it("are others with more or less in them", () => {
    assert.ok(!same({ a: 1 }, { a: 1, b: undefined }));
    assert.ok(!same({ a: undefined }, { b: undefined }));
    assert.ok(!same([1], [1, 2]));
    assert.ok(!same(null, {}));
    assert.ok(!same(Float32Array.from([1]), Float32Array.from([1, 2])));
    assert.ok(!same(Float32Array.from([1]), [1]));
  });
});
