import { describe, expect, it } from "vitest";

import { pieces } from "../src/words";

const said = (formula: string): string[] => pieces(formula).map((one) => `${one.level}${one.isUpright ? " upright" : ""}: ${one.text}`);

describe("a formula", () => {
  it("has indices below and exponents above", () => {
    expect(said("a_{BA}^{n}")).toEqual(["on: a", "below: BA", "above: n"]);
  });
  it("has words upright", () => {
    expect(said(String.raw`p_\mathrm{head}`)).toEqual(["on: p", "below upright: head"]);
    expect(said(String.raw`p_{\mathrm{head}}`)).toEqual(["on: p", "below upright: head"]);
  });
  it("has Greek letters and a half", () => {
    expect(said(String.raw`T_\Sigma`)).toEqual(["on: T", "below: Σ"]);
    expect(said(String.raw`\frac{1}{2}\omega_a^2 J_v`)).toEqual(["on: ½ω", "below: a", "above: 2", "on:  J", "below: v"]);
  });
});
