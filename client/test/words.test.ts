import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { pieces } from "../src/words.ts";

const said = (formula: string): string[] => pieces(formula).map((one) => `${one.level}${one.isUpright ? " upright" : ""}: ${one.text}`);

describe("a formula", () => {
  it("has indices below and exponents above", () => {
    assert.deepEqual(said("a_{BA}^{n}"), ["on: a", "below: BA", "above: n"]);
  });
  it("has words upright", () => {
    assert.deepEqual(said(String.raw`p_\mathrm{head}`), ["on: p", "below upright: head"]);
    assert.deepEqual(said(String.raw`p_{\mathrm{head}}`), ["on: p", "below upright: head"]);
  });
  it("has Greek letters and a half", () => {
    assert.deepEqual(said(String.raw`T_\Sigma`), ["on: T", "below: Σ"]);
    assert.deepEqual(said(String.raw`\frac{1}{2}\omega_a^2 J_v`), ["on: ½ω", "below: a", "above: 2", "on:  J", "below: v"]);
  });
});
