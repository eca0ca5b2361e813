// Sheets of a tab: their parts, which take other values where they stand.

import { lineSample, type Part, ShownCurves, type Shown } from "./curves.ts";
import type { OtherCurve, PageOthers, PageSheet, Ruler, TabContent } from "./data.ts";
import { html } from "./elements.ts";
import { constructed } from "./construction.ts";
import { events, strip } from "./events.ts";
import { maps } from "./maps.ts";
import { number, same } from "./numbers.ts";
import { bars, polars, shapes, stars, wear } from "./plane.ts";
import { notes, section, table } from "./tables.ts";
import { said } from "./words.ts";

type Turned = (place: number) => void;

/** Of a crank angle. */
const DEGREE = "°";

/** The sheets of a tab. */
export class Sheets {
  readonly element = html("div", {});
  private readonly turned: Turned;
  private sheets: readonly PageSheet[] = [];
  /** Of what the cursor is over. */
  private unit = DEGREE;
  private parts: ShownPart[] = [];
  private numbers = "";

  constructor(turned: Turned) {
    this.turned = turned;
  }

  /** Show the sheets of a tab, or differences from a saved case, with the word for numbers; the same parts stay and change. */
  take(content: TabContent, numbers: string, isOfDifferences: boolean): void {
    const sheets = isOfDifferences ? content.sheets.map(differencesOf) : content.sheets;
    const unit = content.course?.unit ?? DEGREE;
    const isOfTheSameParts = this.numbers === numbers && same([this.unit, this.sheets.map(frameOf)], [unit, sheets.map(frameOf)]);
    this.sheets = sheets;
    this.numbers = numbers;
    this.unit = unit;
    if (isOfTheSameParts) {
      partsOf(sheets).forEach((part, place) => this.parts[place]?.take(part));
      return;
    }
    this.parts = [];
    this.element.replaceChildren(...sheets.map((sheet) => this.sheet(sheet)));
    this.fit();
  }

  /** Show the same curves of other pistons behind those of the chosen one, with the word for them; none of null. */
  takeOthers(others: PageOthers | null, word: string): void {
    this.parts.filter((one) => one.hasCurves).forEach((one, place) => { one.takeOthers(others?.parts[place] ?? [], word); });
  }

  /** Whether curves of other pistons are shown. */
  get hasOthers(): boolean {
    return this.parts.some((one) => one.hasOthers);
  }

  /** Stand at a crank angle [deg], or at a time. */
  show(place: number): void {
    for (const one of this.parts) one.show(place);
  }

  /** Take the width and the colours of what they stand in. */
  fit(): void {
    for (const one of this.parts) one.fit();
  }

  private sheet(sheet: PageSheet): HTMLElement {
    const columns = sheet.columns.filter((parts) => parts.length).map((parts) => {
      const shown = parts.map((part) => new ShownPart(part, this.numbers, this.turned, this.unit));
      this.parts.push(...shown);
      return html("div", { class: "column" }, ...shown.map((one) => one.element));
    });
    const heads = sheet.title ? [html("h2", {}, said(sheet.title))] : [];
    return html("section", { class: "sheet" }, ...heads, html("div", { class: `sheet-columns of-${columns.length}` }, ...columns));
  }
}

/** A sheet whose curves are differences, where there are any. */
const differencesOf = (sheet: PageSheet): PageSheet => ({
  ...sheet,
  columns: sheet.columns.map((parts) => parts.map((part) => (part.is === "PageCurves" && part.differences.length ? { ...part, panels: part.differences } : part))),
});

/** Whether there is anything in it that differs from a saved case. */
export const hasDifferences = (content: TabContent): boolean =>
  partsOf(content.sheets).some((part) => part.is === "PageCurves" && part.differences.length > 0);

/** What of a sheet is no value of its parts. */
const frameOf = (sheet: PageSheet): unknown => [sheet.title, sheet.columns.map((parts) => parts.map((part) => part.is))];

const partsOf = (sheets: readonly PageSheet[]): Part[] => sheets.flatMap((sheet) => sheet.columns.flat());

/** A part of a sheet as it is shown. */
class ShownPart {
  private readonly numbers: string;
  private readonly turned: Turned;
  private readonly unit: string;
  private part: Part;
  private shown: Shown;
  private place = 0;
  hasOthers = false;

  constructor(part: Part, numbers: string, turned: Turned, unit: string) {
    this.part = part;
    this.numbers = numbers;
    this.turned = turned;
    this.unit = unit;
    this.shown = drawn(part, numbers, turned, unit);
  }

  get element(): HTMLElement {
    return this.shown.element;
  }

  take(part: Part): void {
    if (same(this.part, part)) return;
    this.part = part;
    if (this.shown.take?.(part)) return;
    this.hasOthers = false;
    const before = this.shown.element;
    this.shown = drawn(part, this.numbers, this.turned, this.unit);
    before.replaceWith(this.shown.element);
    this.shown.fit();
    this.shown.show(this.place);
  }

  get hasCurves(): boolean {
    return this.shown instanceof ShownCurves;
  }

  takeOthers(panels: readonly (readonly OtherCurve[])[], word: string): void {
    if (!(this.shown instanceof ShownCurves)) return;
    this.shown.takeOthers(panels, word);
    this.hasOthers = panels.some((one) => one.length > 0);
  }

  show(place: number): void {
    this.place = place;
    this.shown.show(place);
  }

  fit(): void {
    this.shown.fit();
  }
}

/** Draw a part of a sheet. */
function drawn(part: Part, numbers: string, turned: Turned, unit: string): Shown {
  switch (part.is) {
    case "PageCurves":
      return new ShownCurves(part, numbers, turned, unit);
    case "PageMaps":
      return maps(part, () => undefined, null);
    case "PageSection":
      return standing(section(part));
    case "ConstructionDrawing":
      return constructed(part);
    case "PageEvents":
      return events(part, turned);
    case "EventStrip":
      return strip(part, turned);
    case "PagePolars":
      return polars(part, numbers);
    case "Bars":
      return bars(part, numbers);
    case "Stars":
      return standing(stars(part, numbers));
    case "PageWear":
      return standing(wear(part, numbers));
    case "ShaftShapes":
      return standing(shapes(part, numbers));
    case "PageTable":
      return standing(table(part));
    case "Notes":
      return standing(notes(part));
    case "Ruler":
      return standing(ruler(part));
  }
}

/** What stands still at all crank angles. */
const standing = (element: HTMLElement): Shown => ({ element, show: () => undefined, fit: () => undefined });

function ruler(part: Ruler): HTMLElement {
  const marks = part.marks.map((mark) => {
    const words = `${mark.is_top ? "▼" : "▽"} ${mark.name} ${number(mark.angle).toFixed(2)}°`;
    return html("span", { title: mark.word }, words);
  });
  const beside = part.textbook ? [html("span", {}, lineSample("textbook"), " ", said(part.textbook))] : [];
  return html("p", { class: "ruler" }, html("b", {}, said(part.heading)), ...marks, ...beside);
}
