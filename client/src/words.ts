// Words with formulas among them, set as mathematics.

import { html, svg } from "./elements.ts";

const FORMULA = "\ue000";

interface Piece {
  readonly text: string;
  readonly level: "on" | "below" | "above";
  readonly isUpright: boolean;
}

/** Give the pieces of a formula: an index stands below, an exponent above, whole words upright. */
export function pieces(formula: string): Piece[] {
  const found: Piece[] = [];
  const scan = (text: string, level: Piece["level"], isUpright: boolean): void => {
    let rest = text;
    while (rest) {
      const special = /\\mathrm\{|_\{|\^\{|_(?=[^{])|\^(?=[^{])/.exec(rest);
      const plain = special ? rest.slice(0, special.index) : rest;
      if (plain) found.push({ text: unescaped(plain), level, isUpright });
      if (!special) return;
      rest = rest.slice(special.index + special[0].length);
      const isBraced = special[0].endsWith("{");
      const end = isBraced ? closing(rest) : (/^\\[A-Za-z]+(\{[^}]*\})?/.exec(rest)?.[0].length ?? 1);
      const inner = rest.slice(0, end);
      rest = rest.slice(end + (isBraced ? 1 : 0));
      if (special[0].startsWith("\\")) scan(inner, level, true);
      else scan(inner, special[0].startsWith("_") ? "below" : "above", isUpright);
    }
  };
  scan(formula, "on", false);
  return found;
}

/** Where the brace closes that was opened before a text. */
function closing(text: string): number {
  let depth = 1;
  for (let place = 0; place < text.length; place++) {
    if (text[place] === "{") depth++;
    else if (text[place] === "}" && --depth === 0) return place;
  }
  return text.length;
}

const GREEK: Readonly<Record<string, string>> = {
  alpha: "α", beta: "β", gamma: "γ", delta: "δ", epsilon: "ε", varepsilon: "ε", zeta: "ζ", eta: "η", theta: "θ",
  kappa: "κ", lambda: "λ", mu: "μ", nu: "ν", xi: "ξ", pi: "π", rho: "ρ", sigma: "σ", tau: "τ", phi: "φ", varphi: "φ",
  chi: "χ", psi: "ψ", omega: "ω", Delta: "Δ", Sigma: "Σ", Omega: "Ω", Theta: "Θ", Phi: "Φ", Psi: "Ψ",
};

const unescaped = (text: string): string =>
  text.replace(/\\?frac\{1\}\{2\}/g, "½").replace(/\\([A-Za-z]+) ?/g, (_all, name: string) => GREEK[name] ?? name).replace(/\\(.)/g, "$1");

const isSlanted = (piece: Piece): boolean => !piece.isUpright && /\p{Letter}/u.test(piece.text);

/** Give a symbol as words have it among them. */
export const formula = (symbol: string): string => `${FORMULA}${symbol}${FORMULA}`;

/** Give words as HTML. */
export function said(words: string): DocumentFragment {
  const all = document.createDocumentFragment();
  words.split(FORMULA).forEach((part, place) => {
    if (place % 2 === 0) all.append(part);
    else all.append(symbol(part));
  });
  return all;
}

/** Give a symbol as HTML. */
export function symbol(formula: string): HTMLElement {
  const whole = html("span", { class: "symbol" });
  for (const piece of pieces(formula)) {
    const tag = piece.level === "on" ? "span" : piece.level === "below" ? "sub" : "sup";
    whole.append(html(tag, isSlanted(piece) ? {} : { class: "upright" }, piece.text));
  }
  return whole;
}

/** Give words as spans of a text of SVG. */
export function spans(words: string): SVGTSpanElement[] {
  const found: SVGTSpanElement[] = [];
  words.split(FORMULA).forEach((part, place) => {
    if (place % 2 === 0) {
      if (part) found.push(svg("tspan", {}, part));
      return;
    }
    let shift = 0;
    for (const piece of pieces(part)) {
      const level = piece.level === "on" ? 0 : piece.level === "below" ? 0.3 : -0.4;
      const size = piece.level === "on" ? {} : { "font-size": "75%" };
      const own = isSlanted(piece) ? "symbol" : "symbol upright";
      found.push(svg("tspan", { class: own, dy: `${level - shift}em`, ...size }, piece.text));
      shift = level;
    }
    if (shift !== 0) found.push(svg("tspan", { dy: `${-shift}em` }, "\u200b"));
  });
  return found;
}
