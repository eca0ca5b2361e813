// A textbook's construction of a piston's position, which turns with the crank.

import type { Shown } from "./curves.ts";
import type { ConstructedLine, ConstructionDrawing } from "./data.ts";
import { html, picture, svg } from "./elements.ts";
import { apart } from "./nearest.ts";
import { at, between, extent, figures, number, row } from "./numbers.ts";
import { polyline, type Point } from "./points.ts";
import { said } from "./words.ts";

/** Crank radius in units of the picture, and how far the picture goes, in parts of that. */
const RADIUS = 150;
const ROOM = 1.32;
const TURN = 360;
/** Straight pieces of an arc. */
const PIECES = 12;
/** From a point to its letter: near, or farther out. */
const OFF = [15, 24];
/** Directions in which a letter may stand. */
const WAYS = 16;
/** Of a letter, how far its middle keeps from others, from points and from lines. */
const FROM_LETTER = 20;
const FROM_POINT = 12;
const FROM_LINE = 9;

/** Show it. */
export function constructed(part: ConstructionDrawing): Shown {
  const scale = RADIUS / number(part.radius);
  const half = ROOM * RADIUS;
  const drawn = picture("construction", [-half, -half, 2 * half, 2 * half], svg("title", {}, part.title));
  const clip = svg("g", {});
  const foot = { x: at(part.foot, 0) * scale, y: -at(part.foot, 1) * scale };
  const along = { x: at(part.along, 0), y: -at(part.along, 1) };
  const end = (by: number): Point => ({ x: foot.x + by * along.x, y: foot.y + by * along.y });
  const axis = [end(-2 * half), end(2 * half)];
  clip.append(svg("circle", { class: "circle", r: RADIUS }), svg("path", { class: "axis", d: polyline(axis) }));
  drawn.append(clip);
  const place = (letter: string, angle: number): Point => {
    const points = part.points[letter];
    return points ? { x: scale * between(row(points, 0), TURN, angle), y: -scale * between(row(points, 1), TURN, angle) } : { x: NaN, y: NaN };
  };
  const lines = part.lines.map((line) => {
    const path = clip.appendChild(svg("path", { class: line.look }));
    return (angle: number): readonly Point[] => {
      const points = pointsOf(line, (letter) => place(letter, angle));
      path.setAttribute("d", polyline(points));
      return points;
    };
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
    const drawnLines = [...lines.map((move) => move(within)), axis];
    const points = letters.map(({ letter }) => place(letter, within));
    const others: Point[] = [];
    letters.forEach(({ dot, text }, which) => {
      const point = points[which] as Point;
      const isThere = Math.max(Math.abs(point.x), Math.abs(point.y)) < half - FROM_POINT;
      for (const one of [dot, text]) one.toggleAttribute("hidden", !isThere);
      if (!isThere) return;
      dot.setAttribute("cx", point.x.toFixed(2));
      dot.setAttribute("cy", point.y.toFixed(2));
      const beside = clearest(point, along, { letters: others, points, lines: drawnLines });
      others.push(beside);
      text.setAttribute("x", beside.x.toFixed(2));
      text.setAttribute("y", beside.y.toFixed(2));
    });
    for (const { one, reading } of readings) reading.textContent = `S = ${figures(between(one.displacement.values, TURN, within), largest)} ${part.unit}`;
  };
  return { element, show, fit: () => undefined };
}

/** Points of a straight line, or of an arc of pieces about a point. */
function pointsOf(line: ConstructedLine, place: (letter: string) => Point): readonly Point[] {
  const [start, end] = [place(line.start), place(line.end)];
  if (!line.about) return [start, end];
  const centre = place(line.about);
  const direction = (of: Point): number => Math.atan2(of.y - centre.y, of.x - centre.x);
  const radius = Math.hypot(start.x - centre.x, start.y - centre.y);
  const first = direction(start);
  const turn = ((direction(end) - first + 3 * Math.PI) % (2 * Math.PI)) - Math.PI;
  return Array.from({ length: PIECES + 1 }, (_one, k) => aside(centre, radius, first + (turn * k) / PIECES));
}

/** What a letter keeps clear of. */
interface Surroundings {
  readonly letters: readonly Point[];
  readonly points: readonly Point[];
  readonly lines: readonly (readonly Point[])[];
}

/** Where a letter stands beside its point: as clear as can be of all else; of places alike, near it and across the line of stroke. */
function clearest(point: Point, along: Point, { letters, points, lines }: Surroundings): Point {
  const across = Math.atan2(along.x, -along.y);
  let [found, least] = [point, Infinity];
  for (const out of OFF) {
    for (let way = 0; way < WAYS; way++) {
      const turn = (2 * Math.PI * way) / WAYS;
      const one = aside(point, out, across + turn);
      const lacking = [
        ...letters.map((other) => FROM_LETTER - Math.hypot(other.x - one.x, other.y - one.y)),
        ...points.map((other) => FROM_POINT - Math.hypot(other.x - one.x, other.y - one.y)),
        ...lines.map((line) => FROM_LINE - Math.min(...line.slice(1).map((to, k) => apart(one, line[k] as Point, to)))),
      ];
      // What is nowhere takes no room.
      const cost = lacking.reduce((sum, lack) => sum + (lack > 0 ? lack : 0), 0) + out / 10 + 1 - Math.cos(turn);
      if (cost < least) [found, least] = [one, cost];
    }
  }
  return found;
}

/** A point so far from another, in a direction. */
const aside = (from: Point, far: number, direction: number): Point => ({ x: from.x + far * Math.cos(direction), y: from.y + far * Math.sin(direction) });
