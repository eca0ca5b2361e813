// Vectors on the drawing of a mechanism, and which of them are shown.

import type { PinVector, VectorsToScale, TabContent } from "./data.ts";
import { html, type Sketch, Sketched, svg } from "./elements.ts";
import { inkOf } from "./ink.ts";
import type { Edges, Labels, Place } from "./labels.ts";
import { between, row, same, ticks } from "./numbers.ts";
import { barbs, xy, type Point } from "./points.ts";
import { formula, spans } from "./words.ts";

/** A vector that is shorter is not drawn; in the units of the picture, as all lengths here. */
const LEAST = 3;

/** A vector with a shorter arrow has no name beside it. */
const LEAST_NAMED = 14;

/** Length of the largest vector, and to what part of that it is drawn shorter so that all stay in the picture. */
const LONG = 120;
const SHORTEST = 0.4;

/** In a narrower picture scales of vectors stand over that of lengths, so high, and need so much room. */
export const NARROW = 420;
const SCALE_ROW = 26;
export const SCALE_ROOM = 44;

/** From the end of an arrow to the middle of its name; and where else it may stand: so far [px], turned by how much from the arrow's direction. */
const BEYOND = 10;
const FARTHER: readonly number[] = [12, 24, 38];
const ASIDE: readonly number[] = [0, 0.8, -0.8, 1.6, -1.6, 2.4, -2.4];

/** Where the pin of a vector is at a crank angle. */
type PinOf = (one: PinVector, angle: number) => Point;

/** Vectors that are drawn to scale, and what a picture has of them; others may take their place. */
export class DrawnVectors {
  readonly element = svg("g");
  private readonly pin: PinOf;
  private readonly cycle: number;
  private readonly edges: Edges;
  private readonly labels: Labels;
  private scales: readonly OneScale[] = [];

  constructor(pin: PinOf, cycle: number, edges: Edges, labels: Labels) {
    this.pin = pin;
    this.cycle = cycle;
    this.edges = edges;
    this.labels = labels;
  }

  /** Take vectors, and no others, for when they are shown next. */
  take(shown: readonly VectorsToScale[]): void {
    const groups = new Map<string, VectorsToScale[]>();
    for (const one of shown) {
      const key = `${one.unit} ${one.largest}`;
      groups.set(key, [...(groups.get(key) ?? []), one]);
    }
    const before = this.scales;
    this.scales = [...groups.values()].map((sorts, place) => {
      const scale = before[place] ?? new OneScale();
      if (scale !== before[place]) this.element.append(scale.element);
      const all = sorts.flatMap((one) => one.vectors);
      const perUnit = scaleOf(all, sorts[0]?.largest ?? NaN, this.pin, this.cycle, this.edges);
      scale.take(all, perUnit, scaleArrow(sorts[0] as VectorsToScale, perUnit, this.edges, place));
      return scale;
    });
    for (const { element } of before.slice(groups.size)) element.remove();
    this.labels.keepClearOf(this.scales.map((one) => one.words));
  }

  show(angle: number): void {
    for (const one of this.scales) one.show(angle, this.cycle, this.pin, this.labels);
  }
}

/** An arrow of a round size: its words, where they stand, and how both are drawn. */
interface ScaleArrow {
  readonly words: readonly [string, Place];
  readonly sketches: readonly Sketch[];
}

/** Vectors of one scale; elements of those of the same name stay. */
class OneScale {
  words: readonly [string, Place] = ["", { x: NaN, y: NaN, anchor: "end", isCentral: false }];
  private readonly sketched: Sketched;
  private readonly scale = svg("g");
  private readonly drawn = svg("g");
  readonly element = svg("g", {}, this.scale, this.drawn);
  private perUnit = NaN;
  private vectors: readonly DrawnVector[] = [];

  constructor() {
    this.sketched = new Sketched(this.scale, []);
  }

  take(vectors: readonly PinVector[], perUnit: number, { words, sketches }: ScaleArrow): void {
    this.words = words;
    this.perUnit = perUnit;
    this.sketched.take(sketches);
    const before = this.vectors;
    this.vectors = vectors.map((one, place) => {
      const known = before[place];
      if (known?.isOf(one)) {
        known.take(one);
        return known;
      }
      const made = new DrawnVector(one);
      if (known) known.element.replaceWith(made.element);
      else this.drawn.append(made.element);
      return made;
    });
    for (const { element } of before.slice(vectors.length)) element.remove();
  }

  show(angle: number, cycle: number, pin: PinOf, labels: Labels): void {
    for (const one of this.vectors) one.show(angle, this.perUnit, cycle, pin, labels);
  }
}

/** A vector with its name. */
class DrawnVector {
  readonly element: SVGGElement;
  private readonly arrow = svg("path");
  private readonly label: SVGTextElement;
  private readonly name: string;
  private one: PinVector;
  private x: Float32Array;
  private y: Float32Array;

  constructor(one: PinVector) {
    this.label = svg("text", {}, ...spans(formula(one.symbol)));
    this.name = this.label.textContent ?? "";
    this.element = svg("g", { class: `vector ink-${inkOf(one.letter)}` }, svg("title", {}, `${one.mechanism} ${one.pin}`), this.arrow, this.label);
    this.one = one;
    [this.x, this.y] = [row(one.value, 0), row(one.value, 1)];
  }

  /** Whether it is of the same pin, by the same name. */
  isOf({ mechanism, pin, letter, symbol }: PinVector): boolean {
    return this.one.mechanism === mechanism && this.one.pin === pin && this.one.letter === letter && this.one.symbol === symbol;
  }

  take(one: PinVector): void {
    this.one = one;
    [this.x, this.y] = [row(one.value, 0), row(one.value, 1)];
  }

  show(angle: number, perUnit: number, cycle: number, pin: PinOf, labels: Labels): void {
    const start = pin(this.one, angle);
    const by = { x: perUnit * between(this.x, cycle, angle), y: -perUnit * between(this.y, cycle, angle) };
    const length = Math.hypot(by.x, by.y);
    const isThere = Number.isFinite(start.x) && length > LEAST;
    this.element.toggleAttribute("hidden", !isThere);
    const isNamed = isThere && length >= LEAST_NAMED;
    this.label.toggleAttribute("hidden", isThere && !isNamed);
    // What is not seen says nothing of where it was.
    if (!isThere) this.arrow.removeAttribute("d");
    if (!isNamed) for (const name of ["x", "y"]) this.label.removeAttribute(name);
    if (!isThere) return;
    const end = { x: start.x + by.x, y: start.y + by.y };
    const direction = Math.atan2(by.y, by.x);
    this.arrow.setAttribute("d", `M${xy(start)}L${xy(end)}${barbs(end, direction)}`);
    if (!isNamed) return;
    const place = labels.put(this.name, placesBeyond(end, direction, labels.pixel));
    this.label.setAttribute("x", (place?.x ?? end.x).toFixed(2));
    this.label.setAttribute("y", (place?.y ?? end.y).toFixed(2));
  }
}

/** Where the name of a vector may stand, in turn. */
function* placesBeyond(end: Point, direction: number, pixel: number): Generator<Place> {
  const at = (far: number, turn: number): Place => ({ x: end.x + far * Math.cos(direction + turn), y: end.y + far * Math.sin(direction + turn), anchor: "middle", isCentral: true });
  yield at(BEYOND, 0);
  for (const far of FARTHER) for (const turn of ASIDE) yield at(far * pixel, turn);
}

/** Length for one of a unit, so that the largest is long, and all stay in the picture if that is not much to ask. */
function scaleOf(all: readonly PinVector[], largest: number, pin: PinOf, cycle: number, edges: Edges): number {
  let scale = LONG / largest;
  for (const one of all) {
    const [x, y] = [row(one.value, 0), row(one.value, 1)];
    x.forEach((across, place) => {
      const start = pin(one, (place * cycle) / (x.length - 1));
      const up = y[place] ?? NaN;
      const room = Math.min(
        (across > 0 ? edges.right - start.x : start.x - edges.left) / Math.abs(across),
        (up > 0 ? start.y - edges.top : edges.bottom - start.y) / Math.abs(up),
      );
      if (room < scale) scale = room;
    });
  }
  return Math.max(scale, (SHORTEST * LONG) / largest);
}

/** An arrow of a round size, in the lower right corner, where there is room beside the scale of lengths. */
function scaleArrow(of: VectorsToScale, perUnit: number, edges: Edges, place: number): ScaleArrow {
  const largest = of.largest ?? NaN;
  const size = ticks(0, largest, 3)[1] ?? largest;
  const row = place + (edges.right - edges.left < NARROW ? 1 : 0);
  const [end, y] = [edges.right - 10, edges.bottom - 9 - SCALE_ROW * row];
  const start = end - size * perUnit;
  const words = `${size} ${of.unit}`;
  const [x, baseline] = [start - 6, y + 4];
  return {
    words: [words, { x, y: baseline, anchor: "end", isCentral: false }],
    sketches: [
      ["path", { class: `vector ink-${inkOf(of.vectors[0]?.letter ?? "")}`, d: `M${start} ${y}H${end}${barbs({ x: end, y }, 0)}` }],
      ["text", { class: "scale beside", x, y: baseline }, words],
    ],
  };
}

/** Buttons that choose what is shown on the drawing: what the open tab has, unless somebody wants something else. */
export class VectorChoice {
  readonly element = html("div", { class: "vectors", role: "group" });
  private readonly show: (shown: readonly VectorsToScale[]) => void;
  private readonly ask: (tab: string) => void;
  private readonly wanted = new Map<string, boolean>();
  /** Tabs of all sorts of vectors that were seen, by their titles, and what is known of them. */
  private readonly tabs = new Map<string, string>();
  private known: ReadonlyMap<string, VectorsToScale> = new Map();
  private titles: readonly string[] = [];
  private open = "";

  constructor(show: (shown: readonly VectorsToScale[]) => void, ask: (tab: string) => void) {
    this.show = show;
    this.ask = ask;
  }

  /** Show what the open tab has, and what is wanted of the others: of one that is not there it is asked for. */
  take(contents: ReadonlyMap<string, TabContent | null>, open: string): void {
    const found = [...contents].flatMap(([tab, content]) => (content?.vectors ?? []).map((one) => [tab, one] as const));
    this.known = new Map(found.map(([, one]) => [one.title, one]));
    for (const [title, tab] of this.tabs) if (contents.get(tab) !== null) this.tabs.delete(title);
    for (const [tab, one] of found) this.tabs.set(one.title, tab);
    const order = [...contents.keys()];
    const place = (title: string): number => order.indexOf(this.tabs.get(title) ?? "");
    this.titles = [...this.tabs.keys()].sort((one, other) => place(one) - place(other));
    this.open = open;
    this.draw();
  }

  private draw(): void {
    const { titles } = this;
    if (!same(titles, [...this.element.children].map((one) => one.textContent))) this.element.replaceChildren(...titles.map((title) => this.button(title)));
    const isShown = (title: string): boolean => this.wanted.get(title) ?? this.tabs.get(title) === this.open;
    [...this.element.children].forEach((button, place) => {
      button.setAttribute("aria-pressed", `${isShown(titles[place] ?? "")}`);
      button.className = `choice ink-${inkOf(this.known.get(titles[place] ?? "")?.vectors[0]?.letter ?? "")}`;
    });
    const shown = titles.filter(isShown);
    this.show(shown.flatMap((title) => this.known.get(title) ?? []));
    const missing = shown.filter((title) => !this.known.has(title)).map((title) => this.tabs.get(title) ?? "");
    for (const tab of new Set(missing)) this.ask(tab);
  }

  private button(title: string): HTMLButtonElement {
    const button = html("button", { type: "button" }, html("span", {}, title));
    button.addEventListener("click", () => {
      this.wanted.set(title, button.getAttribute("aria-pressed") !== "true");
      this.draw();
    });
    return button;
  }
}
