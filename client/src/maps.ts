// Maps: a quantity over two numbers, by lines of equal value over tones; hatched where nothing can be.

import type { Map as PlottedMap, PageMaps } from "./data.ts";
import type { Shown } from "./curves.ts";
import { html, picture, svg } from "./elements.ts";
import { extent, figure, figures, ticks } from "./numbers.ts";
import { said } from "./words.ts";

const WIDTH = 560;
const HEIGHT = 380;
const LEFT = 72;
const FOOT = 40;
const TOP = 8;
const RIGHT = 14;
const LINES = 8;
/** Percent of all values on either side, which have lines as far beyond the others as these lie apart. */
const TAIL = 0.1;
/** Tones of what is least and most, as parts of the ink. */
const TONES = [0.04, 0.34] as const;

/** Which design is meant: its place along both numbers. */
export type Picked = (across: number, up: number) => void;

/** Where a machine stands among the designs of a map. */
export interface Standing {
  readonly across: number;
  readonly up: number;
}

/** Show maps; where somebody clicks, that design is meant. */
export function maps(part: PageMaps, picked: Picked, standing: Standing | null): Shown {
  const element = html("div", { class: "maps" }, ...part.maps.map((one) => map(one, part.over, picked, standing)));
  return { element, show: () => undefined, fit: () => undefined };
}

function map(of: PlottedMap, over: string, picked: Picked, standing: Standing | null): HTMLElement {
  const [across, up] = [of.across.values, of.up.values];
  const [[left, right], [bottom, top]] = [extent(across), extent(up)];
  const x = (value: number): number => LEFT + ((value - left) / (right - left)) * (WIDTH - LEFT - RIGHT);
  const y = (value: number): number => TOP + ((top - value) / (top - bottom)) * (HEIGHT - TOP - FOOT);
  const value = (column: number, row: number): number => of.values.values[row * across.length + column] ?? NaN;
  const drawn = picture("map", [0, 0, WIDTH, HEIGHT], svg("title", {}, of.title));
  const levels = levelsOf(Array.from(of.values.values).filter(Number.isFinite));
  const step = (levels[1] ?? 1) - (levels[0] ?? 0);
  const cells = svg("g", { class: "cells", "shape-rendering": "crispEdges" });
  const lines = svg("g", { class: "lines" });
  const paths = levels.map(() => "");
  const labels: { level: number; x: number; y: number }[] = [];
  for (let row = 0; row + 1 < up.length; row++) {
    for (let column = 0; column + 1 < across.length; column++) {
      const corners = [[column, row], [column + 1, row], [column + 1, row + 1], [column, row + 1]] as const;
      const points = corners.map(([i, j]) => ({ x: x(across[i] ?? NaN), y: y(up[j] ?? NaN), value: value(i, j) }));
      const [first, , third] = points as [Point, Point, Point, Point];
      const box = { x: first.x, y: third.y, width: third.x - first.x, height: first.y - third.y };
      if (points.some((one) => !Number.isFinite(one.value))) {
        cells.append(svg("rect", { class: "missing", fill: "url(#hatched)", ...box }));
        continue;
      }
      const mean = points.reduce((sum, one) => sum + one.value, 0) / 4;
      cells.append(svg("rect", { class: "tone", "fill-opacity": toneOf(mean, levels).toFixed(3), ...box }));
      levels.forEach((level, which) => {
        for (const [one, other] of crossings(points, level)) {
          paths[which] += `M${one.x.toFixed(1)} ${one.y.toFixed(1)}L${other.x.toFixed(1)} ${other.y.toFixed(1)}`;
          if (isClear(one, level, labels)) labels.push({ level, ...one });
        }
      });
    }
  }
  for (const d of paths) if (d) lines.append(svg("path", { d }));
  const axes = svg("g", { class: "map-axes" });
  const [alongTicks, upTicks] = [ticks(left, right, 6), ticks(bottom, top, 5)];
  for (const one of alongTicks) axes.append(svg("text", { class: "along", x: x(one), y: HEIGHT - FOOT + 15 }, figure(one, (alongTicks[1] ?? 1) - (alongTicks[0] ?? 0))));
  for (const one of upTicks) axes.append(svg("text", { class: "upward", x: LEFT - 6, y: y(one) }, figure(one, (upTicks[1] ?? 1) - (upTicks[0] ?? 0))));
  axes.append(svg("text", { class: "along", x: (LEFT + WIDTH - RIGHT) / 2, y: HEIGHT - 6 }, over));
  axes.append(svg("text", { class: "along", transform: `translate(13 ${(TOP + HEIGHT - FOOT) / 2}) rotate(-90)` }, [of.upward, of.up_unit].filter(Boolean).join(", ")));
  axes.append(svg("rect", { class: "frame", x: LEFT, y: TOP, width: WIDTH - LEFT - RIGHT, height: HEIGHT - TOP - FOOT }));
  drawn.append(hatching(), cells, lines, axes);
  for (const { level, x: at, y: high } of labels) drawn.append(svg("text", { class: "level", x: at, y: high }, figure(level, step)));
  if (standing && within(standing.across, left, right) && within(standing.up, bottom, top)) {
    const [at, high] = [x(standing.across), y(standing.up)];
    drawn.append(svg("path", { class: "standing", d: `M${at - 7} ${high}h14M${at} ${high - 7}v14` }));
  }
  const reading = html("span", { class: "reading" });
  const nearest = (event: PointerEvent | MouseEvent): readonly [number, number] => {
    const point = new DOMPoint(event.clientX, event.clientY).matrixTransform(drawn.getScreenCTM()?.inverse());
    return [nearestTo(across, left + ((point.x - LEFT) / (WIDTH - LEFT - RIGHT)) * (right - left)), nearestTo(up, top - ((point.y - TOP) / (HEIGHT - TOP - FOOT)) * (top - bottom))];
  };
  const largest = Math.max(...extent(Array.from(of.values.values).filter(Number.isFinite)).map(Math.abs));
  drawn.addEventListener("pointermove", (event) => {
    const [column, row] = nearest(event);
    reading.textContent = `${+(across[column] ?? NaN).toPrecision(5)} · ${+(up[row] ?? NaN).toPrecision(5)}: ${figures(value(column, row), largest)} ${of.unit}`;
  });
  drawn.addEventListener("click", (event) => { picked(...nearest(event)); });
  return html("figure", { class: "panel" }, html("h3", {}, said(of.title), html("span", { class: "unit" }, ", ", said(of.unit))), drawn, html("figcaption", {}, reading));
}

interface Point {
  readonly x: number;
  readonly y: number;
  readonly value: number;
}

/** Place of the value that is nearest. */
export function nearestTo(values: Float32Array, wanted: number): number {
  let found = 0;
  values.forEach((one, place) => { if (Math.abs(one - wanted) < Math.abs((values[found] ?? NaN) - wanted)) found = place; });
  return found;
}

/** Values that have a line: of what grows beyond all others not all that it reaches. */
export function levelsOf(known: readonly number[]): number[] {
  const sorted = [...known].sort((one, other) => one - other);
  const at = (part: number): number => sorted[Math.round(part * (sorted.length - 1))] ?? NaN;
  const [low, high] = [at(TAIL), at(1 - TAIL)];
  return ticks(Math.max(at(0), low - (high - low)), Math.min(at(1), high + (high - low)), LINES);
}

function toneOf(value: number, levels: readonly number[]): number {
  const [low, high] = [levels[0] ?? 0, levels[levels.length - 1] ?? 1];
  const part = high > low ? Math.min(Math.max((value - low) / (high - low), 0), 1) : 0;
  return TONES[0] + part * (TONES[1] - TONES[0]);
}

/** Where a line of equal value goes through a cell: pairs of points on its sides, round the cell. */
export function crossings(corners: readonly Point[], level: number): [Omit<Point, "value">, Omit<Point, "value">][] {
  const found: Omit<Point, "value">[] = [];
  corners.forEach((one, place) => {
    const other = corners[(place + 1) % corners.length] as Point;
    if (one.value < level === other.value < level) return;
    const part = (level - one.value) / (other.value - one.value);
    found.push({ x: one.x + part * (other.x - one.x), y: one.y + part * (other.y - one.y) });
  });
  const pairs: [Omit<Point, "value">, Omit<Point, "value">][] = [];
  for (let place = 0; place + 1 < found.length; place += 2) pairs.push([found[place] as Point, found[place + 1] as Point]);
  return pairs;
}

/** Whether a number has room at a place: off the edges, off other numbers, and far off its own line's. */
const isClear = (one: Omit<Point, "value">, level: number, labels: readonly { level: number; x: number; y: number }[]): boolean =>
  one.x > LEFT + 24 && one.x < WIDTH - RIGHT - 24 && one.y > TOP + 12 && one.y < HEIGHT - FOOT - 12 &&
  labels.every((label) => Math.hypot(label.x - one.x, 1.6 * (label.y - one.y)) > (label.level === level ? 190 : 60));

const within = (value: number, low: number, high: number): boolean => value >= low && value <= high;

function hatching(): SVGElement {
  return svg("defs", {}, svg("pattern", { id: "hatched", width: 6, height: 6, patternUnits: "userSpaceOnUse", patternTransform: "rotate(45)" }, svg("line", { class: "hatch", y2: 6 })));
}
