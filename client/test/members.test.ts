import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { written } from "../src/members.ts";

describe("numbers at the crank angle", () => {
  const column = (step: number, around: number | null = null) => ({ is: "CursorColumn", head: "", step, n_parts: 1, around }) as const;
  it("have the decimals of their column", () => {
    assert.equal(written(-12.3456, column(0.01)), "−12.35");
    assert.equal(written(12345.6, column(1)), "12346");
    assert.equal(written(-0.0004, column(0.001)), "0.000");
    assert.equal(written(NaN, column(1)), "–");
  });
  it("begin again after a turn", () => {
    assert.equal(written(-90, column(0.01, 360)), "270.00");
    assert.equal(written(359.997, column(0.01, 360)), "0.00");
    assert.equal(written(1090.5, column(0.01, 360)), "10.50");
  });
});
