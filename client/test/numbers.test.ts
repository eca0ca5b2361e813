import { describe, expect, it } from "vitest";

import { between, extent, figure, figures, interpolated, revived, row, ticks } from "../src/numbers";
import type { Numbers } from "../src/data";

describe("arrays", () => {
  const block = Float32Array.from([9, 0, 1, 2, 3, 4, 5]);
  it("stand where their places are, however deep", () => {
    const found = revived({ is: "X", deep: [{ at: 1, shape: [2, 3] }], name: "a" }, block) as { deep: [Numbers]; name: string };
    expect(found.name).toBe("a");
    expect(Array.from(row(found.deep[0], 1))).toEqual([3, 4, 5]);
  });
  it("have ends, of which NaN is none", () => {
    expect(extent([NaN, 2, -1])).toEqual([-1, 2]);
    expect(extent([NaN])).toEqual([NaN, NaN]);
  });
});

describe("between points", () => {
  it("goes straight", () => {
    expect(between(Float32Array.from([0, 2, 4]), 360, 90)).toBe(1);
    expect(between(Float32Array.from([0, 2, 4]), 360, 360)).toBe(4);
    expect(interpolated(Float32Array.from([0, 1, 10]), Float32Array.from([0, 1, 19]), 5.5)).toBe(10);
  });
  it("is nothing beside a gap and outside", () => {
    expect(between(Float32Array.from([0, NaN, 4]), 2, 0.5)).toBeNaN();
    expect(interpolated(Float32Array.from([0, 1]), Float32Array.from([0, 1]), 1.01)).toBeNaN();
  });
  it("is a point's own value at it, also beside a gap", () => {
    expect(between(Float32Array.from([5, NaN, 4]), 2, 0)).toBe(5);
  });
  it("takes one side of a jump", () => {
    expect(interpolated(Float32Array.from([0, 1, 1, 2]), Float32Array.from([0, 0, 7, 7]), 1)).toBe(7);
  });
});

describe("axes", () => {
  it("have round numbers", () => {
    expect(ticks(-2009, 2845, 4)).toEqual([-2000, 0, 2000]);
    expect(ticks(0, 0.36, 4)).toEqual([0, 0.1, 0.2, 0.30000000000000004]);
    expect(ticks(1, 1)).toEqual([]);
  });
  it("have as few decimals as their step", () => {
    expect(figure(0.30000000000000004, 0.1)).toBe("0.3");
    expect(figure(-2000, 2000)).toBe("−2000");
    expect(figure(-0, 50)).toBe("0");
  });
});

describe("read-outs", () => {
  it("have four figures and a true minus", () => {
    expect(figures(-0.0123456, 1)).toBe("−0.01235");
    expect(figures(2845.3, 3000)).toBe("2845");
    expect(figures(186.698, 200)).toBe("186.7");
  });
  it("are 0 where that is rounding beside the largest", () => {
    expect(figures(1e-7, 1)).toBe("0");
    expect(figures(NaN, 1)).toBe("–");
  });
});
