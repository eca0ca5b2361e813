// How lines look: colours by quantity, habits by role. No meaning is in colour alone.

import type { Curve, PanelLine } from "./data.ts";

interface Pen {
  readonly width: number;
  readonly dashes: readonly number[];
}

const pen = (width: number, dashes: readonly number[] = []): Pen => ({ width, dashes });

/** Width in pixels, and dashes. */
export const PENS: Readonly<Record<Curve["role"], Pen>> = {
  first: pen(2.2),
  second: pen(1.3),
  other: pen(0.9),
  textbook: pen(1, [3, 5]),
  error: pen(1.4, [4, 3]),
  main: pen(2),
  side: pen(1.5, [9, 3]),
  radial: pen(1.3, [6, 3]),
  resultant: pen(1.2, [2, 2.5]),
  formula: pen(0.9, [4, 4]),
  chamber: pen(1.2, [5, 3]),
  whole: pen(2.2),
  mean: pen(1.2, [7, 4]),
  each: pen(0.7),
  carried: pen(1.4, [7, 3]),
  card: pen(1.8),
  later_card: pen(1.2),
  ray: pen(0.9),
  half_ray: pen(0.6),
  saved: pen(1.4, [1.4, 2.6]),
};

/** Of lines across a panel. */
export const LEVELS: Readonly<Record<PanelLine["role"], Pen & { readonly ink: Ink }>> = {
  limit: { ...pen(0.8, [4, 3]), ink: "ink" },
  natural: { ...pen(1.5), ink: "s" },
  declared: { ...pen(1.2, [7, 4]), ink: "T" },
  event: { ...pen(0.9, [5, 3]), ink: "ink" },
  often: { ...pen(0.7, [1, 3]), ink: "muted" },
};

/** Of methods in the order of trust; what is by no method is as the first. */
export function methodPen(place: number | null): Pen & { readonly ink: Ink } {
  const known: readonly (Pen & { readonly ink: Ink })[] = [
    { ...pen(1.9), ink: "ink" },
    { ...pen(1.2, [7, 3]), ink: "s" },
    { ...pen(1.1, [2, 2]), ink: "v" },
    { ...pen(1, [9, 2, 2, 2]), ink: "j" },
    { ...pen(1), ink: "T" },
    { ...pen(1.1, [4, 2]), ink: "p" },
  ];
  const dots = Array.from({ length: Math.max(0, (place ?? 0) - known.length + 2) }, () => [2, 2]).flat();
  return known[place ?? 0] ?? { ...pen(1, [7, 2, ...dots]), ink: "N" };
}

const INKS = ["s", "v", "j", "p", "N", "T", "K", "F", "ink", "muted", "ground", "rule", "grid", "error"] as const;
export type Ink = (typeof INKS)[number];

/** The ink of a quantity by its letter. */
export const inkOf = (letter: string): Ink => (INKS as readonly string[]).includes(letter) ? (letter as Ink) : "muted";

/** A colour as SVG takes it. */
export const colour = (ink: Ink): string => `var(--${ink})`;

/** A colour as a canvas takes it. */
export const canvasColour = (ink: Ink, of: Element): string => getComputedStyle(of).getPropertyValue(`--${ink}`).trim();
