// Curves: panels one above the other over the crank angle, or side by side, each over its own.

import uPlot from "uplot";

import { type Figures, NumbersOf, plain, titled } from "./charts.ts";
import type { Curve, OtherCurve, PageCurves, PageSheet, Panel } from "./data.ts";
import { html, svg, write } from "./elements.ts";
import { canvasColour, type Ink, inkOf, LEVELS, PENS } from "./ink.ts";
import { along } from "./lines.ts";
import { extent, figure, figures, hasGap, interpolated, number, read, same, ticks } from "./numbers.ts";
import { fineness } from "./paper.ts";
import { nearest, type Line } from "./nearest.ts";
import { said, symbol } from "./words.ts";

const AXIS = 54;
/** Between crank angles of tables. [deg] */
const STEP = 30;
/** Between figures at an axis. */
const CLEAR = 28;
/** Of a table of a curve over something else. */
const MOST_ROWS = 25;
const LETTERS = 11;
/** Heights of a panel in a stack, the last of them as high as lets all of it be seen at once. */
const STACKED = [96, 132] as const;
/** What stands over and under a stack; and over each of its panels. */
const AROUND = 370;
const HEAD = 28;
const ALONE = 270;
const LAST = 30;
/** Of a scale: room over and under curves, in parts of their height; where curves come nearer to zero it is shown. */
const BESIDE = 0.08;
const NEAR = 0.5;
/** Which of the values set the scale where the links cannot close all round. */
const MIDDLE: readonly [number, number] = [0.04, 0.96];

/** How near one has to point at a line, and the line of other pistons at which one points. [px] */
const AIMED = 7;
const POINTED = 1.8;
const FAINT = 0.6;
/** Names of pistons that have one curve. */
const BETWEEN = ", ";

/** Of curves that stand beside others of their name. */
const UNNAMED: ReadonlySet<Curve["role"]> = new Set(["ray", "half_ray", "textbook", "saved"]);

/** A part of a sheet. */
export type Part = PageSheet["columns"][number][number];

/** What is shown of a part of a page. */
export interface Shown {
  readonly element: HTMLElement;
  /** Show other values where these stand; false where another is to take its place. */
  readonly take?: (part: Part) => boolean;
  /** Stand at a crank angle [deg], or at a time where the page is over time. */
  readonly show: (place: number) => void;
  /** Take the width and the colours of what it stands in. */
  readonly fit: () => void;
}

/** Curves on a page, with a cursor that all share; where somebody points at them, that is the crank angle. */
export class ShownCurves implements Shown {
  readonly element: HTMLElement;
  private readonly panels: readonly ShownPanel[];
  private part: PageCurves;

  constructor(part: PageCurves, numbers: string, turned: (place: number) => void, unit: string) {
    this.part = part;
    const height = (): number => Math.round(Math.min(Math.max((innerHeight - AROUND) / part.panels.length - HEAD, STACKED[0]), STACKED[1]));
    this.panels = part.panels.map((panel, place) => {
      const isLast = !part.is_stack || place === part.panels.length - 1;
      return new ShownPanel(panel, { over: part.is_stack ? part.over : panel.over, isStacked: part.is_stack, isLast, height, numbers, turned, unit });
    });
    this.element = html("div", { class: part.is_stack ? "stack" : "card" }, ...this.panels.map((one) => one.element));
  }

  show(angle: number): void {
    for (const one of this.panels) one.show(angle);
  }

  fit(): void {
    for (const one of this.panels) one.fit();
  }

  /** Show the same curves of other pistons behind these, panel by panel, with the word for them; or none. */
  takeOthers(panels: readonly (readonly OtherCurve[])[], word: string): void {
    this.panels.forEach((panel, place) => { panel.takeOthers(panels[place] ?? [], word); });
  }

  /** Show other values of the same curves where they stand; false of other curves. */
  take(part: Part): boolean {
    if (part.is !== "PageCurves" || !same(headOf(this.part), headOf(part))) return false;
    part.panels.forEach((panel, place) => this.panels[place]?.take(panel));
    this.part = part;
    return true;
  }
}

/** What of curves is no value of theirs. */
function headOf(part: PageCurves): unknown {
  return [part.is_stack, part.over, part.panels.map((one) => [one.title, one.unit, one.symbol, one.across_unit, one.over, one.curves.map(({ role, letter, symbol, name }) => [role, letter, symbol, name])])];
}

interface Manner {
  readonly over: string;
  readonly isStacked: boolean;
  readonly isLast: boolean;
  /** Of a panel in a stack. */
  readonly height: () => number;
  /** What numbers are called. */
  readonly numbers: string;
  readonly turned: (place: number) => void;
  /** Of what the cursor is over. */
  readonly unit: string;
}

class ShownPanel {
  readonly element: HTMLElement;
  private readonly room = html("div", { class: "plot" });
  private readonly corner = html("div", {});
  private readonly below = html("div", {});
  private readonly cursor = html("div", { class: "cursor" });
  private readonly numbers: NumbersOf;
  private readonly readings: HTMLElement[] = [];
  private readonly hasCursor: boolean;
  private readonly manner: Manner;
  private readonly inks = new Map<Ink, string>();
  private panel: Panel;
  private lines: readonly Line[] = [];
  private others: readonly OtherCurve[] = [];
  private otherLines: readonly Line[] = [];
  /** Of the other pistons' lines that at which somebody points, or −1. */
  private pointed = -1;
  private readonly otherWord = html("button", { type: "button", class: "whose-next" });
  private readonly otherItem = html("li", { class: "ink-muted", hidden: "" }, lineSample("each"), this.otherWord);
  private readonly whose = html("div", { class: "whose", hidden: "", role: "status" });
  private largest = 0;
  /** Ends of the axes. */
  private reach: readonly [number, number] = [0, 1];
  private limits: readonly [number, number] = [0, 1];
  private plot: uPlot | null = null;
  private finer = 1;
  private place = 0;

  constructor(panel: Panel, manner: Manner) {
    this.panel = panel;
    this.manner = manner;
    this.hasCursor = manner.isStacked && panel.across_unit === manner.unit;
    const title = html("h3", {}, said(panel.title));
    if (panel.symbol) title.append(" ", symbol(panel.symbol));
    if (panel.unit && manner.isStacked) title.append(html("span", { class: "unit" }, ", ", said(panel.unit)));
    this.room.setAttribute("role", "img");
    this.room.setAttribute("aria-label", title.textContent ?? "");
    this.numbers = new NumbersOf(manner.numbers, panel.title, () => this.figures());
    const head = html("div", { class: "head" }, titled(title, this.numbers), this.legend());
    this.element = html("figure", { class: "panel" }, head, this.room, this.corner);
    if (manner.over && manner.isLast) this.element.append(html("figcaption", {}, said(manner.over)));
    this.element.append(this.below, this.numbers.table);
    this.fill(panel);
  }

  /** Show other values of the same curves; what is the same stays. */
  take(panel: Panel): void {
    if (same(this.panel, panel)) return;
    this.fill(panel);
  }

  private fill(panel: Panel): void {
    this.panel = panel;
    this.lines = panel.curves.map((curve) => lineOf(curve, panel));
    this.largest = Math.max(0, ...this.lines.flatMap((line) => extent(line.values).map(Math.abs)).filter(Number.isFinite));
    this.scale();
    this.corner.replaceChildren(...(panel.corner.length ? [html("figcaption", { class: "corner" }, ...panel.corner.flatMap((one) => [said(one), html("br")]))] : []));
    const below = [...panel.below.map(([, words]) => words), ...panel.marks.filter((one) => one.words && one.sort !== "angle").map((one) => one.words)];
    this.below.replaceChildren(...(below.some(Boolean) ? [html("figcaption", { class: "below" }, ...below.flatMap((words, place) => (place ? [" · ", said(words)] : [said(words)])))] : []));
    this.plot?.setData(this.data());
    this.numbers.renew();
  }

  /** Show curves of other pistons behind its own, with the word for them, or none. */
  takeOthers(others: readonly OtherCurve[], word: string): void {
    if (!others.length && !this.others.length) return;
    this.others = others;
    this.otherLines = others.map((one) => lineOf(one, this.panel));
    this.otherItem.hidden = others.length === 0;
    write(this.otherWord, word);
    this.otherWord.title = [...new Set(others.flatMap((one) => one.names))].join(BETWEEN);
    this.point(-1);
    this.scale();
    this.plot?.setData(this.data());
  }

  /** Tell whose the next of the other lines is, or one before, where it is farthest from 0; after the last one of none. */
  private tellNext(by: 1 | -1): void {
    const n = this.otherLines.length + 1;
    const which = ((this.pointed + 1 + by + n) % n) - 1;
    const line = this.otherLines[which];
    if (!line || !this.plot) return this.point(-1);
    const sizes = line.values.map((value) => (Number.isFinite(value) ? Math.abs(value) : -1));
    const most = sizes.indexOf(Math.max(...sizes));
    this.point(which, this.plot.valToPos(line.across[most] ?? NaN, "x"), this.plot.valToPos(line.values[most] ?? NaN, "y"));
  }

  private scale(): void {
    this.reach = this.findReach();
    this.limits = this.findLimits();
  }

  /** Tell whose line it is at which somebody points. */
  private point(which: number, left = 0, top = 0): void {
    const one = this.others[which];
    this.whose.hidden = !one;
    if (one) {
      this.whose.replaceChildren(...(one.symbol ? [symbol(one.symbol), " "] : []), one.names.join(BETWEEN));
      this.whose.classList.toggle("left", left > this.room.clientWidth / 2);
      Object.assign(this.whose.style, { left: `${left}px`, top: `${top}px` });
    }
    if (this.pointed === which) return;
    this.pointed = which;
    this.plot?.redraw(false);
  }

  show(at: number): void {
    this.place = at;
    if (!this.hasCursor) return;
    const [start, end] = this.reach;
    const place = at > end ? at % end : at;
    this.readings.forEach((reading, which) => {
      const line = this.lines[which];
      if (line) reading.textContent = figures(read(line.across, line.values, place), this.largest);
    });
    this.cursor.style.left = `${((100 * (place - start)) / (end - start)).toFixed(3)}%`;
  }

  fit(): void {
    const width = Math.floor(this.room.clientWidth);
    if (width < 40) return;
    this.plot?.destroy();
    this.inks.clear();
    this.finer = fineness();
    this.plot = new uPlot(this.options(width), this.data(), this.room);
    this.plot.over.append(this.whose);
    if (this.hasCursor) {
      this.plot.over.append(this.cursor);
      this.show(this.place);
    }
  }

  /** The letters of the page, as the canvas takes them. */
  private font(ratio: number): string {
    return `${LETTERS * ratio}px ${getComputedStyle(this.element).fontFamily}`;
  }

  /** A colour as the canvas takes it. */
  private ink(ink: Ink): string {
    const known = this.inks.get(ink) ?? canvasColour(ink, this.element);
    this.inks.set(ink, known);
    return known;
  }

  /** Names of curves with samples of their lines, and their values at the crank angle. */
  private legend(): HTMLElement {
    const list = html("ul", { class: "legend" });
    this.panel.curves.forEach((curve) => {
      const item = html("li", { class: `ink-${inkOf(curve.letter)}` }, lineSample(curve.role), nameOf(curve));
      const reading = html("output", { "aria-live": "off" });
      this.readings.push(reading);
      if (this.hasCursor) item.append(reading);
      if (this.isNamed(curve)) list.append(item);
    });
    this.otherWord.addEventListener("click", () => { this.tellNext(1); });
    this.otherWord.addEventListener("blur", () => { this.point(-1); });
    this.otherWord.addEventListener("keydown", (event) => {
      const by = event.key === "ArrowDown" ? 1 : event.key === "ArrowUp" ? -1 : 0;
      if (by) this.tellNext(by);
      else if (event.key === "Escape") this.point(-1);
      else return;
      event.preventDefault();
    });
    list.append(this.otherItem);
    return list;
  }

  private isNamed(curve: Curve): boolean {
    const hasName = curve.name !== "" || (this.manner.isStacked && (curve.symbol !== "" || this.panel.curves.length === 1));
    return hasName && !UNNAMED.has(curve.role);
  }

  /** Values of the curves that have a name, or of the first: at each 30°, or at points that are even along a curve. */
  private figures(): Figures {
    const { panel, lines } = this;
    const named = panel.curves.map((_curve, which) => which).filter((which) => this.isNamed(panel.curves[which] as Curve));
    const shown = (named.length ? named : [0]).filter((which) => lines[which]?.across.length);
    const over = plain(this.manner.over || panel.across_unit);
    const value = (one: number): string => figures(one, this.largest);
    const headOf = (which: number): DocumentFragment => {
      const head = nameOf(panel.curves[which] as Curve);
      head.append(panel.unit && ` ${plain(panel.unit)}`);
      return head;
    };
    if (this.hasCursor) {
      const places = panel.across_unit === "°" ? each(...this.reach, STEP) : ticks(...this.reach, MOST_ROWS);
      const row = (place: number): string[] => shown.map((which) => lines[which] as Line).map((line) => value(read(line.across, line.values, place)));
      return { heads: [over, ...shown.map(headOf)], rows: places.map((place) => [figure(place, (places[1] ?? 1) - (places[0] ?? 0)), ...row(place)]) };
    }
    const most = Math.min(MOST_ROWS, Math.max(0, ...shown.map((which) => lines[which]?.across.length ?? 0)));
    const pairs = (row: number): string[] => shown.flatMap((which) => {
      const { across, values } = lines[which] as Line;
      const place = most > 1 ? Math.round((row * (across.length - 1)) / (most - 1)) : 0;
      return [figures(across[place] ?? NaN, extent(across)[1]), value(values[place] ?? NaN)];
    });
    return { heads: shown.flatMap((which) => [over, headOf(which)]), rows: Array.from({ length: most }, (_one, row) => pairs(row)) };
  }

  private findLimits(): readonly [number, number] {
    if (this.panel.limits) return [number(this.panel.limits[0]), number(this.panel.limits[1])];
    const lines = [...this.lines, ...this.otherLines];
    let [low, high] = extent(lines.flatMap((line) => extent(line.values)));
    if (lines.some((line) => hasGap(line.values))) {
      const known = lines.flatMap((line) => Array.from(line.values).filter(Number.isFinite)).sort((one, other) => one - other);
      const [start, end] = MIDDLE.map((part) => known[Math.floor(part * (known.length - 1))] ?? NaN) as [number, number];
      [low, high] = [start - 0.3 * (end - start), end + 0.3 * (end - start)];
    }
    for (const level of this.panel.levels) if (!level.is_upright) [low, high] = extent([low, high, number(level.at)]);
    for (const mark of this.panel.marks) [low, high] = extent([low, high, number(mark.value)]);
    if (low > 0 && low <= NEAR * high) low = 0;
    if (high < 0 && high >= NEAR * low) high = 0;
    const room = BESIDE * (high - low || Math.abs(high) || 1);
    const isNothing = low === 0 && high === 0;
    return [low === 0 && !isNothing ? 0 : low - room, high === 0 && !isNothing ? 0 : high + room];
  }

  private findReach(): readonly [number, number] {
    if (this.panel.reach) return [number(this.panel.reach[0]), number(this.panel.reach[1])];
    const [low, high] = extent([...this.lines, ...this.otherLines].flatMap((line) => [...extent(line.across)]));
    if (this.manner.isStacked) return [Math.min(0, low), high];
    const room = 0.03 * (high - low);
    return [low === 0 ? 0 : low - room, high + room];
  }

  private data(): uPlot.AlignedData {
    const x = Array.from(this.reach);
    return [x, x.map(() => null)];
  }

  /** The library has axes, scales and the grid; curves are drawn as they are, over any points. */
  private options(width: number): uPlot.Options {
    const muted = this.ink("muted");
    const { finer } = this;
    const grid = { stroke: this.ink("grid"), width: finer };
    const font = this.font(finer);
    const isTurn = this.hasCursor && this.panel.across_unit === "°";
    const across = (): number[] => (isTurn ? angles(...this.reach, width - AXIS) : ticks(...this.reach, Math.max(3, Math.floor(width / 75))));
    const up = (): number[] => ticks(...this.limits, this.manner.isStacked ? 4 : 5);
    const height = (this.manner.isStacked ? this.manner.height() : ALONE) + (this.manner.isLast ? LAST : 8);
    const steps = (found: readonly number[]): number => (found[1] ?? 1) - (found[0] ?? 0);
    return {
      width: width * finer,
      height: height * finer,
      legend: { show: false },
      padding: [8 * finer, 12 * finer, this.manner.isLast ? 0 : 4 * finer, 0],
      cursor: { show: this.hasCursor, x: false, y: false, points: { show: false }, drag: { x: false, y: false } },
      scales: { x: { time: false, range: () => [...this.reach] }, y: { range: () => [...this.limits] } },
      axes: [
        {
          size: (this.manner.isLast ? 24 : 6) * finer, gap: 2 * finer, font, stroke: muted, grid, ticks: { show: false },
          splits: across, values: (_plot, found) => found.map((one) => (this.manner.isLast ? figure(one, steps(found)) : "")),
        },
        {
          size: AXIS * finer, gap: 4 * finer, font, stroke: muted, grid, ticks: { show: false },
          splits: up, values: (_plot, found) => found.map((one) => figure(one, steps(found))),
        },
      ],
      series: [{}, { show: true, points: { show: false } }],
      hooks: { draw: [(plot) => { this.draw(plot); }], ready: [(plot) => { this.listen(plot); }] },
    };
  }

  private listen(plot: uPlot): void {
    const aim = (event: PointerEvent): void => {
      if (!this.others.length) return;
      const box = plot.over.getBoundingClientRect();
      const [left, top] = [event.clientX - box.left, event.clientY - box.top];
      const x = (value: number): number => plot.valToPos(value, "x");
      const y = (value: number): number => plot.valToPos(value, "y");
      const found = nearest([...this.lines, ...this.otherLines], x, y, [left, top], AIMED) - this.lines.length;
      this.point(Math.max(found, -1), left, top);
    };
    plot.over.addEventListener("pointermove", aim);
    plot.over.addEventListener("pointerdown", aim);
    // A finger leaves where it has pointed: what it has found stays until the next one.
    plot.over.addEventListener("pointerleave", (event) => { if (event.pointerType !== "touch") this.point(-1); });
    if (!this.hasCursor) return;
    const turn = (event: PointerEvent): void => {
      const box = plot.over.getBoundingClientRect();
      const [left, right] = this.reach;
      this.manner.turned(Math.min(Math.max(plot.posToVal(event.clientX - box.left, "x"), left), right));
    };
    plot.over.addEventListener("pointerdown", (event) => {
      plot.over.setPointerCapture(event.pointerId);
      turn(event);
    });
    plot.over.addEventListener("pointermove", (event) => { if (event.buttons) turn(event); });
  }

  private draw(plot: uPlot): void {
    const ink = plot.ctx;
    const ratio = devicePixelRatio * this.finer;
    const x = linear(this.reach, (value) => plot.valToPos(value, "x", true));
    const y = linear(this.limits, (value) => plot.valToPos(value, "y", true));
    const box = plot.bbox;
    ink.save();
    ink.beginPath();
    ink.rect(box.left, box.top, box.width, box.height);
    ink.clip();
    const [low, high] = this.limits;
    if (low < 0 && high > 0) stroke(ink, this.ink("muted"), ratio, [], () => { ink.moveTo(box.left, y(0)); ink.lineTo(box.left + box.width, y(0)); });
    this.shadeOpen(ink, x, box);
    for (const level of this.panel.levels) {
      const look = LEVELS[level.role];
      const place = number(level.at);
      stroke(ink, this.ink(look.ink), look.width * ratio, look.dashes.map((one) => one * ratio), () => {
        if (level.is_upright) { ink.moveTo(x(place), box.top); ink.lineTo(x(place), box.top + box.height); }
        else { ink.moveTo(box.left, y(place)); ink.lineTo(box.left + box.width, y(place)); }
      });
    }
    this.otherLines.forEach((line, place) => { this.drawOther(ink, line, place === this.pointed, x, y, ratio); });
    const inOrder = [...this.panel.curves.entries()].sort(([, one], [, other]) => Number(other.role === "saved") - Number(one.role === "saved"));
    for (const [place, curve] of inOrder) {
      const line = this.lines[place];
      if (line) this.drawCurve(ink, curve, line, x, y, ratio);
    }
    ink.restore();
    for (const mark of this.panel.marks) {
      const [across, up] = [x(number(mark.across)), y(number(mark.value))];
      ink.beginPath();
      ink.arc(across, up, (mark.sort === "dot" ? 2 + 2.5 * number(mark.size) ** 0.5 : mark.sort === "angle" ? 2 : 3.5) * ratio, 0, 2 * Math.PI);
      ink.fillStyle = this.ink(mark.sort === "dot" ? "ink" : mark.sort === "angle" ? "v" : "ground");
      ink.fill();
      if (mark.sort === "ring" || mark.sort === "change") stroke(ink, this.ink("ink"), 1.2 * ratio, [], () => { ink.arc(across, up, 3.5 * ratio, 0, 2 * Math.PI); });
      if (mark.sort === "angle") this.write(ink, `${+number(mark.angle).toFixed(1)}°`, across + 5 * ratio, up - 5 * ratio, ratio);
    }
    for (const level of this.panel.levels) if (level.number) this.write(ink, `${level.number}`, x(number(level.at)) - 3 * ratio, box.top - 1 * ratio, ratio);
  }

  private write(ink: CanvasRenderingContext2D, text: string, x: number, y: number, ratio: number): void {
    ink.font = this.font(ratio);
    ink.fillStyle = this.ink("muted");
    ink.fillText(text, x, y);
  }

  private drawCurve(ink: CanvasRenderingContext2D, curve: Curve, line: Line, x: (one: number) => number, y: (one: number) => number, ratio: number): void {
    const pen = PENS[curve.role];
    const colour = this.ink(curve.role === "textbook" ? "ink" : inkOf(curve.letter));
    if (curve.is_cloud) {
      ink.fillStyle = colour;
      line.across.forEach((across, place) => {
        ink.beginPath();
        ink.arc(x(across), y(line.values[place] ?? NaN), 2 * ratio, 0, 2 * Math.PI);
        ink.fill();
      });
      return;
    }
    stroke(ink, colour, pen.width * ratio, pen.dashes.map((one) => one * ratio), () => { along(ink, line, x, y); });
    if (curve.role !== "second") return;
    for (let angle = 15; angle < 720; angle += 30) {
      const value = interpolated(line.across, line.values, angle);
      if (!Number.isFinite(value)) continue;
      ink.beginPath();
      ink.arc(x(angle), y(value), 2.6 * ratio, 0, 2 * Math.PI);
      ink.fillStyle = this.ink("ground");
      ink.fill();
      stroke(ink, colour, ratio, [], () => { ink.arc(x(angle), y(value), 2.6 * ratio, 0, 2 * Math.PI); });
    }
  }

  private drawOther(ink: CanvasRenderingContext2D, line: Line, isPointed: boolean, x: (one: number) => number, y: (one: number) => number, ratio: number): void {
    ink.globalAlpha = isPointed ? 1 : FAINT;
    stroke(ink, this.ink(isPointed ? "ink" : "muted"), (isPointed ? POINTED : PENS.each.width) * ratio, [], () => { along(ink, line, x, y); });
    ink.globalAlpha = 1;
  }

  /** Shade where the links cannot close, and where nothing can be. */
  private shadeOpen(ink: CanvasRenderingContext2D, x: (one: number) => number, box: uPlot.BBox): void {
    ink.fillStyle = this.ink("grid");
    const shade = (from: number, to: number): void => { ink.fillRect(x(from), box.top, x(to) - x(from), box.height); };
    for (const [from, to] of this.panel.hatched) shade(number(from), number(to));
    const line = this.lines[0];
    if (!this.hasCursor || !line) return;
    let start = NaN;
    line.across.forEach((across, place) => {
      const isOpen = !Number.isFinite(line.values[place] ?? NaN);
      if (isOpen && Number.isNaN(start)) start = across;
      if (!isOpen && !Number.isNaN(start)) { shade(start, across); start = NaN; }
    });
    if (!Number.isNaN(start)) shade(start, line.across[line.across.length - 1] ?? start);
  }
}

/** The points of a curve in its panel. */
const lineOf = (curve: Curve | OtherCurve, panel: Panel): Line => ({ across: (curve.across ?? panel.across).values, values: curve.values.values });

/** What takes values between two ends to where these stand, as `place` does; for many of them in less time. */
function linear([low, high]: readonly [number, number], place: (value: number) => number): (value: number) => number {
  const start = place(low);
  const step = (place(high) - start) / (high - low);
  return (value) => start + step * (value - low);
}

/** Crank angles at an axis so wide: each 30°, or fewer, so that their figures stand clear. */
function angles(low: number, high: number, width: number): number[] {
  const step = [1, 2, 3, 6].map((times) => times * STEP).find((one) => (one * width) / (high - low) >= CLEAR) ?? 360;
  return each(low, high, step);
}

/** Places from low to high, so far apart. */
const each = (low: number, high: number, step: number): number[] =>
  Array.from({ length: Math.floor((high - low) / step + 1e-6) + 1 }, (_one, place) => low + place * step);

/** The symbol of a curve, or its name. */
function nameOf(curve: Curve): DocumentFragment {
  if (!curve.symbol) return said(curve.name);
  const name = document.createDocumentFragment();
  name.append(symbol(curve.symbol));
  return name;
}

function stroke(ink: CanvasRenderingContext2D, colour: string, width: number, dashes: readonly number[], draw: () => void): void {
  ink.beginPath();
  draw();
  ink.setLineDash([...dashes]);
  ink.lineWidth = width;
  ink.lineJoin = "round";
  ink.strokeStyle = colour;
  ink.stroke();
  ink.setLineDash([]);
}

/** A piece of a curve's line. */
export function lineSample(role: Curve["role"]): SVGSVGElement {
  const pen = PENS[role];
  const line = { x1: 1, y1: 5, x2: 25, y2: 5, stroke: "currentColor", "stroke-width": pen.width, "stroke-dasharray": pen.dashes.join(" ") };
  const ring = role === "second" ? [svg("circle", { cx: 13, cy: 5, r: 2.6, fill: "var(--ground)", stroke: "currentColor" })] : [];
  return svg("svg", { class: "sample", viewBox: "0 0 26 10" }, svg("line", line), ...ring);
}
