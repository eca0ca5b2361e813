import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { between, extent, figure, figures, interpolated, ofBytes, read, revived, row, smooth, ticks } from "../src/numbers.ts";
import type { Numbers } from "../src/data.ts";

describe("a curve that is read", () => {
  const across = Float32Array.from({ length: 361 }, (_one, place) => place);
  const wave = across.map((angle) => 100 * Math.sin((4 * angle * Math.PI) / 180));
  it("is as it would be computed between its points, at its ends too", () => {
    for (const place of [0.5, 22.5, 90.3, 359.5]) {
      const exact = 100 * Math.sin((4 * place * Math.PI) / 180);
      assert.ok(Math.abs(read(across, wave, place) - exact) < 2e-4, `${place}`);
    }
    assert.ok(Math.abs(read(across, wave, 22.5) - interpolated(across, wave, 22.5)) > 0.05);
    assert.equal(read(across, wave, 90), wave[90]);
  });
  it("is a chord over a jump and beside a kink", () => {
    const jump = across.map((angle) => (angle < 100 ? 1 : 5));
    assert.equal(read(across, jump, 99.5), 3);
    for (const place of [97.5, 98.5, 100.5, 101.5]) assert.equal(read(across, jump, place), interpolated(across, jump, place));
    const kink = across.map((angle) => Math.max(angle - 100, 0));
    for (const place of [98.5, 99.5, 100.5]) assert.equal(read(across, kink, place), interpolated(across, kink, place));
  });
  it("is a chord where points stand unevenly, or are few, and nothing outside", () => {
    assert.equal(read(Float32Array.of(0, 1, 4, 9, 16, 25, 36), Float32Array.of(0, 1, 2, 3, 4, 5, 6), 2.5), 1.5);
    assert.equal(read(Float32Array.of(0, 1), Float32Array.of(2, 4), 0.5), 3);
    assert.ok(Number.isNaN(read(across, wave, 400)));
  });
});

describe("arrays", () => {
  const block = Float32Array.from([9, 0, 1, 2, 3, 4, 5]);
  it("stand where their places are, however deep", () => {
    const found = revived({ is: "X", deep: [{ at: 1, shape: [2, 3] }], name: "a" }, block) as { deep: [Numbers]; name: string };
    assert.equal(found.name, "a");
    assert.deepEqual(Array.from(row(found.deep[0], 1)), [3, 4, 5]);
  });
  it("come byte by byte", () => {
    assert.deepEqual(Array.from(ofBytes(Uint8Array.from([0, 0, 0, 0, 0xc0, 0, 0x3f, 0xc0]))), [1.5, -2]);
  });
  it("have ends, of which NaN is none", () => {
    assert.deepEqual(extent([NaN, 2, -1]), [-1, 2]);
    assert.deepEqual(extent([NaN]), [NaN, NaN]);
  });
});

describe("between points", () => {
  it("goes straight", () => {
    assert.equal(between(Float32Array.from([0, 2, 4]), 360, 90), 1);
    assert.equal(between(Float32Array.from([0, 2, 4]), 360, 360), 4);
    assert.equal(interpolated(Float32Array.from([0, 1, 10]), Float32Array.from([0, 1, 19]), 5.5), 10);
  });
  it("is nothing beside a gap and outside", () => {
    assert.ok(Number.isNaN(between(Float32Array.from([0, NaN, 4]), 2, 0.5)));
    assert.ok(Number.isNaN(interpolated(Float32Array.from([0, 1]), Float32Array.from([0, 1]), 1.01)));
  });
  it("is a point's own value at it, also beside a gap", () => {
    assert.equal(between(Float32Array.from([5, NaN, 4]), 2, 0), 5);
  });
  it("goes on the polynomial of six, also at both ends", () => {
    const quintic = (x: number): number => x ** 5 - 20 * x ** 3 + 7;
    const values = Float32Array.from({ length: 9 }, (_one, place) => quintic(place - 4));
    for (const place of [0, 0.3, 3.7, 4, 7.9, 8]) assert.ok(Math.abs(smooth(values, 8, place) - quintic(place - 4)) < 1e-3, `${place}`);
  });
  it("goes straight beside a gap, and where there are few", () => {
    assert.equal(smooth(Float32Array.from([0, 2, 4]), 2, 0.5), 1);
    assert.equal(smooth(Float32Array.from([0, 1, 2, 9, NaN, 5, 6, 7]), 7, 2.5), 5.5);
    assert.ok(Number.isNaN(smooth(Float32Array.from([0, 1, 2, 9, NaN, 5, 6, 7]), 7, 3.5)));
  });
  it("takes one side of a jump", () => {
    assert.equal(interpolated(Float32Array.from([0, 1, 1, 2]), Float32Array.from([0, 0, 7, 7]), 1), 7);
  });
});

describe("axes", () => {
  it("have round numbers", () => {
    assert.deepEqual(ticks(-2009, 2845, 4), [-2000, 0, 2000]);
    assert.deepEqual(ticks(0, 0.36, 4), [0, 0.1, 0.2, 0.30000000000000004]);
    assert.deepEqual(ticks(1, 1), []);
  });
  it("have as few decimals as their step", () => {
    assert.equal(figure(0.30000000000000004, 0.1), "0.3");
    assert.equal(figure(-2000, 2000), "−2000");
    assert.equal(figure(-0, 50), "0");
  });
});

describe("read-outs", () => {
  it("have four figures and a true minus", () => {
    assert.equal(figures(-0.0123456, 1), "−0.01235");
    assert.equal(figures(2845.3, 3000), "2845");
    assert.equal(figures(186.698, 200), "186.7");
  });
  it("are 0 where that is rounding beside the largest", () => {
    assert.equal(figures(1e-7, 1), "0");
    assert.equal(figures(NaN, 1), "–");
  });
});
