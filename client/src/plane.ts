// Pictures in the plane: polar diagrams, stars, circles of wear, bars, shapes along a shaft.

import { type Figures, NumbersOf, titled } from "./charts.ts";
import type { Bars, PolarDiagram, PagePolars, ShaftShapes, Stars, PageWear, Rays } from "./data.ts";
import { html, picture, type Sketch, Sketched, svg } from "./elements.ts";
import { colour, methodPen } from "./ink.ts";
import { at, between, extent, figure, figures, number, row, same, ticks } from "./numbers.ts";
import type { Part, Shown } from "./curves.ts";
import { said, spans } from "./words.ts";

const POLAR = 300;
const RIM = 26;
/** Between directions and crank angles of tables. [deg] */
const STEP = 30;

/** Show polar diagrams to one scale; a dot on each stands at the crank angle. */
export function polars(part: PagePolars, numbers: string): Shown {
  const reach = Math.max(...part.diagrams.flatMap((one) => one.curves.flatMap((curve) => extent(curve.points.values).map(Math.abs))));
  const shown = part.diagrams.map((one) => polar(one, part, reach, numbers));
  const element = html("div", { class: "plane" }, html("div", { class: "side-by-side" }, ...shown.map((one) => one.element)));
  if (part.notes) element.append(html("p", { class: "note" }, said(part.notes)));
  return { element, show: (angle) => { for (const one of shown) one.show(angle); }, fit: () => undefined };
}

/** By how much the middle of a diagram is enlarged, one after the other. */
const ZOOMS = [1, 2, 4, 8] as const;

/** A polar diagram, of which the middle may be enlarged. */
function polar(diagram: PolarDiagram, { unit, zoom }: PagePolars, reach: number, numbers: string): Shown {
  const first = diagram.curves[0];
  const cycle = number(diagram.cycle);
  const place = (angle: number): readonly [number, number] => {
    const at_ = (line: number): number => (first ? between(row(first.points, line), cycle, angle % cycle) : NaN);
    return [at_(0), at_(1)];
  };
  const below = new NumbersOf(numbers, diagram.title, () => ({
    heads: ["φ, °", `x, ${unit}`, `y, ${unit}`, unit],
    rows: Array.from({ length: Math.ceil(cycle / STEP) }, (_one, step) => step * STEP).map((angle) => {
      const [across, up] = place(angle);
      return [`${angle}`, ...[across, up, Math.hypot(across, up)].map((one) => figures(one, reach))];
    }),
  }));
  const title = html("h3", {}, said(diagram.title), html("span", { class: "unit" }, ", ", unit));
  const reading = html("span", { class: "reading" }, `${+Math.hypot(at(diagram.largest, 0), at(diagram.largest, 1)).toPrecision(4)} ${unit}`);
  const larger = html("button", { type: "button", class: "zoom", title: zoom });
  let factor = 0;
  let now = NaN;
  let shown = drawnPolar(diagram, reach);
  const named = (): void => {
    larger.textContent = `×${ZOOMS[factor] ?? 1}`;
    larger.setAttribute("aria-label", `${zoom} ×${ZOOMS[factor] ?? 1}`);
  };
  const show = (angle: number): void => {
    now = angle;
    const [across, up] = place(angle);
    if (!Number.isFinite(across)) return;
    shown.point(across, up);
    reading.textContent = `${Math.hypot(across, up).toPrecision(4)} ${unit}`;
  };
  larger.addEventListener("click", () => {
    factor = (factor + 1) % ZOOMS.length;
    const before = shown.element;
    shown = drawnPolar(diagram, reach / (ZOOMS[factor] ?? 1));
    before.replaceWith(shown.element);
    named();
    show(now);
  });
  named();
  const element = html("figure", { class: "panel" }, titled(title, below), shown.element, html("figcaption", {}, reading, " ", larger), below.table);
  return { element, show, fit: () => undefined };
}

/** Draw a polar diagram to a scale; its pointer is set to a point of it. */
function drawnPolar(diagram: PolarDiagram, reach: number): { element: SVGSVGElement; point: (across: number, up: number) => void } {
  const scale = (POLAR / 2 - RIM) / (reach || 1);
  const half = POLAR / 2;
  const x = (value: number): number => value * scale;
  const y = (value: number): number => -value * scale;
  const drawn = picture("polar", [-half, -half, POLAR, POLAR], svg("title", {}, diagram.title));
  const rings = ticks(0, reach, 3).filter((one) => one > 0);
  const step = rings[0] ?? reach;
  const labels: { x: number; y: number }[] = [];
  for (const ring of rings) {
    const place = { x: x(ring) * 0.707 + 2, y: -x(ring) * 0.707 - 2 };
    drawn.append(svg("circle", { class: "ring", r: x(ring) }), svg("text", { class: "ring", ...place }, figure(ring, step)));
    labels.push({ x: place.x + 8, y: place.y });
  }
  drawn.append(svg("path", { class: "axes", d: `M${-half + 8} 0H${half - 8}M0 ${-half + 8}V${half - 8}` }));
  [...diagram.curves].reverse().forEach((curve) => {
    const [across, up] = [row(curve.points, 0), row(curve.points, 1)];
    const d = Array.from(across, (one, place) => `${place ? "L" : "M"}${x(one).toFixed(2)} ${y(up[place] ?? NaN).toFixed(2)}`).join("");
    const pen = methodPen(curve.place);
    drawn.append(svg("path", { class: "load-curve", d, stroke: colour(pen.ink), "stroke-width": pen.width, "stroke-dasharray": pen.dashes.join(" ") }));
  });
  const largest = { x: x(at(diagram.largest, 0)), y: y(at(diagram.largest, 1)) };
  const way = Math.hypot(largest.x, largest.y) || 1;
  const called = { x: (largest.x * (way + 15)) / way, y: (largest.y * (way + 15)) / way };
  labels.push(called);
  diagram.marked.values.forEach((angle, which) => {
    const mark = { x: x(at(diagram.marks, which)), y: y(at(diagram.marks, diagram.marked.values.length + which)) };
    drawn.append(svg("circle", { class: "mark", cx: mark.x, cy: mark.y, r: 1.6 }));
    const length = Math.hypot(mark.x, mark.y) || 1;
    const place = { x: (mark.x * (length + 11)) / length, y: (mark.y * (length + 11)) / length };
    if (angle % 60 || labels.some((one) => Math.abs(one.x - place.x) < 30 && Math.abs(one.y - place.y) < 18)) return;
    labels.push(place);
    drawn.append(svg("text", { class: "mark", ...place }, `${angle}`));
  });
  drawn.append(
    svg("circle", { class: "largest", cx: largest.x, cy: largest.y, r: 4.5 }),
    svg("text", { class: "largest", ...called }, `${+diagram.largest_at!.toFixed(0)}°`),
  );
  const vector = svg("line", { class: "now", x1: 0, y1: 0 });
  const dot = svg("circle", { class: "now", r: 3.2 });
  drawn.append(vector, dot);
  return {
    element: drawn,
    point: (across, up) => {
      vector.setAttribute("x2", x(across).toFixed(2));
      vector.setAttribute("y2", y(up).toFixed(2));
      dot.setAttribute("transform", `translate(${x(across).toFixed(2)} ${y(up).toFixed(2)})`);
    },
  };
}

/** Show stars of phases. */
export function stars(part: Stars, numbers: string): HTMLElement {
  const below = new NumbersOf(numbers, part.title, () => raysOf(part.rays, (rays) => rays.direction.values.map((_one, place) => place), 1, ""));
  const title = titled(html("h3", {}, said(part.title)), below);
  return html("div", { class: "plane" }, title, html("div", { class: "side-by-side" }, ...part.rays.map(star)), below.table);
}

/** Directions and sizes of some of several rays, in parts of a size. */
function raysOf(all: readonly Rays[], some: (rays: Rays) => Iterable<number>, whole: number, unit: string): Figures {
  const rows = all.flatMap((rays) => Array.from(some(rays), (place) => {
    const direction = (at(rays.direction, place) * 180) / Math.PI;
    return [rays.title.replaceAll("\n", " "), rays.names[place] ?? "", figure(direction, 1), figures(at(rays.size, place) / whole, 1)];
  }));
  return { heads: ["", "", "°", unit], rows };
}

function star(rays: Rays): HTMLElement {
  const radius = 44;
  const drawn = picture("star", [-72, -66, 144, 132], svg("title", {}, rays.title), svg("circle", { class: "ring", r: radius }));
  const groups = new Map<string, { x: number; y: number; names: string[] }>();
  rays.direction.values.forEach((direction, place) => {
    const size = at(rays.size, place);
    const [x, y] = [size * Math.cos(direction), -size * Math.sin(direction)];
    const key = `${x.toFixed(4)} ${y.toFixed(4)}`.replaceAll("-0.0000", "0.0000");
    const group = groups.get(key) ?? { x, y, names: [] };
    group.names.push(rays.names[place] ?? "");
    groups.set(key, group);
  });
  let isFirst = true;
  for (const { x, y, names } of groups.values()) {
    drawn.append(svg("line", { class: "ray", x2: radius * x, y2: radius * y }), svg("circle", { class: "tip", cx: radius * x, cy: radius * y, r: 2.4 }));
    const words = names.join(",");
    if (isFirst || groups.size <= 12) drawn.append(svg("text", { x: (radius + 13) * x, y: (radius + 13) * y }, words.length <= 5 ? words : `×${names.length}`));
    isFirst = false;
  }
  return html("figure", { class: "small" }, drawn, html("figcaption", {}, said(rays.title)));
}

/** Show circles off which loads take. */
export function wear(part: PageWear, numbers: string): HTMLElement {
  const all = part.rows.flat();
  const even = (rays: Rays): Iterable<number> => {
    const n = rays.direction.values.length;
    const step = Math.max(1, Math.round((n * STEP) / 360));
    return Array.from({ length: Math.ceil(n / step) }, (_one, place) => place * step);
  };
  const below = new NumbersOf(numbers, part.words, () => raysOf(all, even, number(part.most) / 100, "%"));
  const rows = part.rows.map((own) => html("div", { class: "side-by-side" }, ...own.map((one) => worn(one, number(part.most)))));
  return html("div", { class: "plane" }, ...rows, titled(html("p", { class: "note" }, said(part.words)), below), below.table);
}

function worn(rays: Rays, most: number): HTMLElement {
  const radius = 62;
  const depth = (0.62 * radius) / (most || 1);
  const point = (size: number, direction: number): string => `${(size * Math.cos(direction)).toFixed(2)} ${(-size * Math.sin(direction)).toFixed(2)}`;
  const inner = Array.from(rays.direction.values, (direction, place) => `${place ? "L" : "M"}${point(radius - at(rays.size, place) * depth, direction)}`).join("");
  const circle = `M${radius} 0A${radius} ${radius} 0 1 0 ${-radius} 0A${radius} ${radius} 0 1 0 ${radius} 0Z`;
  const drawn = picture(
    "wear", [-92, -86, 184, 172], svg("title", {}, rays.title.replaceAll("\n", " ")),
    svg("path", { class: "axes", d: "M-70 0H70M0 -70V70" }),
    svg("path", { class: "worn", d: `${circle}${inner}Z`, "fill-rule": "evenodd" }),
    svg("path", { class: "edge", d: circle }), svg("path", { class: "edge", d: `${inner}Z` }),
  );
  if (rays.hole !== null) {
    const [near, far] = [point(0.25 * radius, rays.hole), point(radius + 4, rays.hole)];
    drawn.append(svg("path", { class: "hole", d: `M${near}L${far}` }));
    // A word is wider than it is high.
    const [x, y] = point(radius + 14 + 9 * Math.abs(Math.cos(rays.hole)), rays.hole).split(" ") as [string, string];
    drawn.append(svg("text", { x, y }, `${((number(rays.hole_angle) * 180) / Math.PI).toFixed(0)}°`));
  }
  return html("figure", { class: "small" }, html("figcaption", {}, said(rays.title.replaceAll("\n", " "))), drawn);
}

/** Show bars; others of the same names take their place where they stand. */
export function bars(part: Bars, numbers: string): Shown {
  let now = part;
  const below = new NumbersOf(numbers, part.title, () => {
    const most = Math.max(...extent([...now.low.values, ...now.high.values]).map(Math.abs));
    const rows = Array.from(now.across.values, (across, place) => {
      const ends = [at(now.low, place), at(now.high, place)].map((one) => figures(one, most));
      return [now.names[place] ?? `${across}`, ends[0] === "0" ? `${ends[1]}` : ends.join(" … ")];
    });
    return { heads: ["", now.unit], rows };
  });
  const element = html("figure", { class: "panel" }, titled(html("h3", {}, said(part.title)), below));
  const drawing = picture("bars", [0, 0, BARS, BARS_HIGH], svg("title", {}, part.title));
  const drawn = hasBars(part) ? new Sketched(drawing, barsOf(part)) : null;
  if (drawn) element.append(drawing);
  for (const note of part.notes) element.append(html("figcaption", {}, said(note)));
  element.append(below.table);
  const take = (next: Part): boolean => {
    if (!drawn || next.is !== "Bars" || !hasBars(next) || !same(headOf(now), headOf(next))) return false;
    now = next;
    below.renew();
    drawn.take(barsOf(next));
    return true;
  };
  return { element, show: () => undefined, fit: () => undefined, take };
}

const [BARS, BARS_HIGH] = [560, 210];

/** What of bars is no value of theirs. */
const headOf = (part: Bars): unknown => [part.title, part.unit, part.names, part.notes];

/** Whether one of them is not nothing. */
const hasBars = (part: Bars): boolean => part.low.values.some((low, place) => low !== at(part.high, place));

/** Draw bars over their names or numbers. */
function barsOf(part: Bars): Sketch[] {
  const [width, height, left, foot, top] = [BARS, BARS_HIGH, 46, part.names.length ? 34 : 22, 8];
  const n = part.across.values.length;
  const [low, high] = extent([0, ...part.low.values, ...part.high.values]);
  const room = (high - low) * 0.06;
  const [bottom, ceiling] = [low < 0 ? low - room : 0, high + room];
  const first = at(part.across, 0);
  const each = n > 1 ? at(part.across, 1) - first : 1;
  const [start, end] = part.names.length ? [first - 0.7, at(part.across, n - 1) + 0.7] : [0, at(part.across, n - 1) + each / 2];
  const x = (value: number): number => left + ((value - start) / (end - start)) * (width - left - 6);
  const y = (value: number): number => top + ((ceiling - value) / (ceiling - bottom)) * (height - top - foot);
  const levels = ticks(bottom, ceiling, 4);
  const grid = levels.flatMap((level): Sketch[] => [["line", { class: "grid", x1: left, x2: width - 6, y1: y(level), y2: y(level) }], ["text", { class: "level", x: left - 6, y: y(level) }, figure(level, (levels[1] ?? 1) - (levels[0] ?? 0))]]);
  const wide = Math.abs(x(each) - x(0)) * 0.66;
  const drawn = Array.from(part.across.values, (across, place): Sketch[] => {
    const [one, other] = [y(at(part.low, place)), y(at(part.high, place))];
    const looks = ["bar", part.is_filled[place] ? "filled" : "", place === part.framed ? "framed" : ""].join(" ");
    const bar: Sketch = ["rect", { class: looks, x: x(across) - wide / 2, y: Math.min(one, other), width: wide, height: Math.abs(one - other) }];
    const name = part.names.length ? (part.names[place] ?? "").split(".").pop() ?? "" : Number.isInteger(across) && across % (2 * Math.ceil(n / 24) - (n <= 12 ? 1 : 0)) === 0 ? `${across}` : "";
    return name ? [bar, ["text", { class: "name", x: x(across), y: height - foot + 14 }, name]] : [bar];
  });
  return [...grid, ...drawn.flat(), ["line", { class: "zero", x1: left, x2: width - 6, y1: y(0), y2: y(0) }]];
}

/** Show shapes along a shaft. */
export function shapes(part: ShaftShapes, numbers: string): HTMLElement {
  const [width, each, left] = [560, 96, 30];
  const n = part.names.length;
  const isTurned = part.names.some((name) => name.length * 6.5 > (width - left) / n);
  const foot = isTurned ? 12 + 6 * Math.max(...part.names.map((name) => name.length)) : 24;
  const height = part.shapes.length * each + foot;
  const x = (place: number): number => left + ((place + 0.5) * (width - left)) / n;
  const drawn = picture("modes", [0, 0, width, height], svg("title", {}, part.title));
  part.shapes.forEach((shape, number_) => {
    const middle = number_ * each + each / 2 + 12;
    const most = Math.max(...Array.from(shape.amplitude.values, Math.abs), 1e-30);
    const y = (value: number): number => middle - (value / most) * (each / 2 - 20);
    drawn.append(svg("text", { class: "title", x: left, y: number_ * each + 11 }, ...spans(shape.title)), svg("line", { class: "zero", x1: left, x2: width, y1: middle, y2: middle }));
    shape.following.forEach((to, from) => {
      drawn.append(svg("line", { class: to === from + 1 ? "shape" : "shape branch", x1: x(from), y1: y(at(shape.amplitude, from)), x2: x(to), y2: y(at(shape.amplitude, to)) }));
    });
    shape.amplitude.values.forEach((value, place) => drawn.append(svg("circle", { class: "disc", cx: x(place), cy: y(value), r: 2.6 })));
    for (const node of shape.nodes.values) drawn.append(svg("circle", { class: "node", cx: x(node), cy: middle, r: 3 }));
  });
  part.names.forEach((name, place) => {
    const [across, y] = [x(place), height - foot + 16];
    drawn.append(svg("text", isTurned ? { class: "name turned", transform: `translate(${across + 4} ${y - 4}) rotate(90)` } : { class: "name", x: across, y }, name));
  });
  const below = new NumbersOf(numbers, part.title, () => ({
    heads: ["", ...part.shapes.map((shape) => said(shape.title))],
    rows: part.names.map((name, place) => [name, ...part.shapes.map((shape) => figures(at(shape.amplitude, place), 1))]),
  }));
  return html("figure", { class: "panel" }, titled(html("h3", {}, said(part.title)), below), drawn, below.table);
}
