// A textbook's construction of a piston's position, which turns with the crank.

import type { Shown } from "./curves.ts";
import type { ConstructedLine, ConstructionDrawing } from "./data.ts";
import { html, picture, svg } from "./elements.ts";
import { at, between, extent, figures, number, row } from "./numbers.ts";
import { xy, type Point } from "./points.ts";
import { said } from "./words.ts";

/** Crank radius in units of the picture, and how far the picture goes, in parts of that. */
const RADIUS = 150;
const ROOM = 1.32;
const TURN = 360;
/** Straight pieces of an arc. */
const PIECES = 12;
/** From a point to its letter. */
const OFF = 16;
/** Between letters. */
const APART = 24;

/** Show it. */
export function constructed(part: ConstructionDrawing): Shown {
  const scale = RADIUS / number(part.radius);
  const half = ROOM * RADIUS;
  const drawn = picture("construction", [-half, -half, 2 * half, 2 * half], svg("title", {}, part.title));
  const clip = svg("g", {});
  const foot = { x: at(part.foot, 0) * scale, y: -at(part.foot, 1) * scale };
  const along = { x: at(part.along, 0), y: -at(part.along, 1) };
  const end = (by: number): Point => ({ x: foot.x + by * along.x, y: foot.y + by * along.y });
  clip.append(svg("circle", { class: "circle", r: RADIUS }), svg("path", { class: "axis", d: `M${xy(end(-2 * half))}L${xy(end(2 * half))}` }));
  drawn.append(clip);
  const place = (letter: string, angle: number): Point => {
    const points = part.points[letter];
    return points ? { x: scale * between(row(points, 0), TURN, angle), y: -scale * between(row(points, 1), TURN, angle) } : { x: NaN, y: NaN };
  };
  const lines = part.lines.map((line) => {
    const path = clip.appendChild(svg("path", { class: line.look }));
    return (angle: number): void => { path.setAttribute("d", lineOf(line, (letter) => place(letter, angle))); };
  });
  const letters = Object.keys(part.points).map((letter) => {
    const dot = drawn.appendChild(svg("circle", { class: "dot", r: 2.6 }));
    const text = drawn.appendChild(svg("text", { class: "symbol" }, letter));
    return { letter, dot, text };
  });
  const readings = part.readings.map((one) => {
    const reading = html("output", { "aria-live": "off" });
    const sample = svg("svg", { class: "sample", viewBox: "0 0 26 10" }, svg("line", { class: one.look, x1: 1, y1: 5, x2: 25, y2: 5 }));
    return { one, reading, item: html("li", {}, sample, html("span", { class: "symbol" }, one.point), said(one.name), reading) };
  });
  const largest = Math.max(...part.readings.map((one) => extent(one.displacement.values)[1]));
  const element = html(
    "figure", { class: "construction-figure" },
    html("h3", {}, said(part.title)), drawn,
    html("ul", { class: "legend" }, ...readings.map(({ item }) => item)),
    html("figcaption", {}, said(part.note)),
  );
  const show = (angle: number): void => {
    const within = ((angle % TURN) + TURN) % TURN;
    for (const move of lines) move(within);
    const taken: Point[] = [];
    for (const { letter, dot, text } of letters) {
      const point = place(letter, within);
      const isThere = Math.max(Math.abs(point.x), Math.abs(point.y)) < half - OFF / 2;
      for (const one of [dot, text]) one.toggleAttribute("hidden", !isThere);
      if (!isThere) continue;
      dot.setAttribute("cx", point.x.toFixed(2));
      dot.setAttribute("cy", point.y.toFixed(2));
      const beside = free(point, along, taken);
      taken.push(beside);
      text.setAttribute("x", beside.x.toFixed(2));
      text.setAttribute("y", beside.y.toFixed(2));
    }
    for (const { one, reading } of readings) reading.textContent = `S = ${figures(between(one.displacement.values, TURN, within), largest)} ${part.unit}`;
  };
  return { element, show, fit: () => undefined };
}

/** A straight line, or an arc of pieces about a point. */
function lineOf(line: ConstructedLine, place: (letter: string) => Point): string {
  const [start, end] = [place(line.start), place(line.end)];
  if (!line.about) return `M${xy(start)}L${xy(end)}`;
  const centre = place(line.about);
  const direction = (of: Point): number => Math.atan2(of.y - centre.y, of.x - centre.x);
  const radius = Math.hypot(start.x - centre.x, start.y - centre.y);
  const first = direction(start);
  const turn = ((direction(end) - first + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
  const points = Array.from({ length: PIECES + 1 }, (_one, k) => first + (turn * k) / PIECES);
  return `M${points.map((one) => xy({ x: centre.x + radius * Math.cos(one), y: centre.y + radius * Math.sin(one) })).join("L")}`;
}

/** Where a letter stands beside a point: across the line of stroke, on the side and as far out as others leave it. */
function free(point: Point, along: Point, taken: readonly Point[]): Point {
  const sides = [1, -1, 2.6, -2.6, 4.2, -4.2].map((by) => ({ x: point.x - by * OFF * along.y, y: point.y + by * OFF * along.x }));
  return sides.find((one) => taken.every((other) => Math.hypot(other.x - one.x, other.y - one.y) > APART)) ?? (sides[0] as Point);
}
