// The tab on which numbers are varied: facts as curves over one, as maps over two; a click loads a design.

import type { Asked } from "./address.ts";
import { ask, look, opened } from "./asking.ts";
import type { DesignWords, OfferedFact, NumbersOfTable, PageCurves, PanelLine, SweptDesignsOfPage } from "./data.ts";
import { ShownCurves } from "./curves.ts";
import { html, offer, write } from "./elements.ts";
import { lines, type Problem } from "./form.ts";
import { maps, nearestTo } from "./maps.ts";
import { same, typed } from "./numbers.ts";
import { said } from "./words.ts";

/** So far beside a number its range begins and ends, in parts of it; how many values it has, alone and with another. */
const BESIDE = 0.2;
const ALONE = 21;
const BOTH = 15;
/** Facts that are asked for at once, and so many of the first unless others are chosen. */
const MOST_FACTS = 4;
const FIRST_FACTS = 3;
/** Between questions how far a sweep is. [ms] */
const PAUSE = 250;

/** What may be done from the tab. */
export interface DesignDoings {
  /** Set numbers anew: texts by path. */
  readonly load: (settings: ReadonlyMap<string, string>) => void;
  readonly language: () => string;
  /** What is wrong where something failed. */
  readonly wrong: (error: unknown) => readonly Problem[];
}

class Axis {
  readonly element = html("div", { class: "axis" });
  readonly path = html("select", {});
  private readonly start = html("input", { type: "text", class: "end" });
  private readonly end = html("input", { type: "text", class: "end" });
  private readonly count = html("input", { type: "number", min: 2, max: 200, class: "end" });
  private texts = new Map<string, string>();
  private readonly words = Array.from({ length: 4 }, () => html("span", {}));
  private readonly usual: number;

  constructor(usual: number) {
    this.usual = usual;
    const [path, start, end, count] = this.words as [HTMLElement, HTMLElement, HTMLElement, HTMLElement];
    this.element.append(
      html("label", {}, path, " ", this.path),
      html("label", {}, start, " ", this.start),
      html("label", {}, end, " ", this.end),
      html("label", {}, this.count, " ", count),
    );
    this.path.addEventListener("change", () => { this.propose(); });
  }

  /** Offer the numbers: one of them first, or, of "", nothing. */
  take(words: DesignWords, label: string, tables: readonly NumbersOfTable[], first: string): void {
    const before = this.path.value;
    const inputs = tables.flatMap((table) => table.inputs.map((one) => ({ ...one, of: table.name })).filter((one) => typed(one.text)));
    this.texts = new Map(inputs.map((one) => [one.path, one.text]));
    const paths = inputs.map((one) => [one.path, `${one.of} ${one.name}`.trim()] as const);
    const offered = [...(first ? [] : [["", words.nothing] as const]), ...paths];
    offer(this.path, offered, this.texts.has(before) ? before : this.texts.has(first) ? first : (offered[0]?.[0] ?? ""));
    [label, words.start, words.end, words.count].forEach((word, place) => { write(this.words[place] as HTMLElement, word); });
    if (this.path.value !== before || !this.start.value) this.propose();
  }

  /** The present number, in the unit of the range. */
  get now(): number {
    return typed(this.texts.get(this.path.value) ?? "")?.number ?? NaN;
  }

  /** Values as they are typed; nothing where nothing is varied. */
  get values(): string {
    if (!this.path.value) return "";
    const [start, end] = [typed(this.start.value), typed(this.end.value)];
    const unit = end?.unit || start?.unit || "";
    const isOfTwoUnits = start?.unit && start.unit !== unit;
    const ends = [isOfTwoUnits ? this.start.value.trim() : start?.number ?? this.start.value, end?.number ?? this.end.value] as const;
    const isBackwards = !isOfTwoUnits && Number(ends[0]) > Number(ends[1]);
    return `${(isBackwards ? [...ends].reverse() : ends).join("..")} ${unit}:${this.count.value}`.replace(" :", ":");
  }

  /** Propose a range about the present number. */
  private propose(): void {
    const now = typed(this.texts.get(this.path.value) ?? "");
    for (const input of [this.start, this.end, this.count]) (input.parentElement ?? input).hidden = !now;
    if (!now) return;
    const by = BESIDE * Math.abs(now.number) || 1;
    const text = (value: number): string => `${+value.toPrecision(4)} ${now.unit}`.trim();
    this.start.value = text(now.number - by);
    this.end.value = text(now.number + by);
    this.count.value = `${this.usual}`;
  }
}

export class DesignTab {
  readonly element = html("div", { class: "design" });
  private readonly doings: DesignDoings;
  private readonly axes = [new Axis(ALONE), new Axis(BOTH)] as const;
  private readonly facts = html("div", { class: "facts", role: "group" });
  private readonly wantedWord = html("span", {});
  private readonly compute = html("button", { type: "submit" });
  private readonly cancel = html("button", { type: "button", hidden: "" });
  private readonly progress = html("progress", { hidden: "" });
  private readonly refused = html("div", { class: "problems", role: "alert" });
  private readonly found = html("div", { class: "swept" });
  private readonly hint = html("p", { class: "note", hidden: "" });
  private asked: Asked | null = null;
  private words: DesignWords | null = null;
  private curves: readonly ShownCurves[] = [];
  /** The sweep that is computed. */
  private going = "";
  /** What was asked for last, or stopped: of what was before nothing is shown. */
  private round = 0;

  constructor(doings: DesignDoings) {
    this.doings = doings;
    this.facts.addEventListener("change", () => {
      const isFull = this.wanted.length >= MOST_FACTS;
      for (const one of this.boxes) one.disabled = isFull && !one.checked;
    });
    this.cancel.addEventListener("click", () => { void this.stop(); });
  }

  /** Offer the numbers of what is shown, one of them first. */
  take(asked: Asked, tables: readonly NumbersOfTable[], varied: string, words: DesignWords): void {
    this.asked = asked;
    this.words = words;
    this.axes[0].take(words, words.varied, tables, varied);
    this.axes[1].take(words, words.second, tables, "");
    this.facts.setAttribute("aria-label", words.wanted);
    write(this.wantedWord, words.wanted);
    write(this.compute, words.compute);
    write(this.cancel, words.cancel);
    write(this.hint, words.hint);
    if (this.element.firstChild) return;
    const form = html("form", {}, this.axes[0].element, this.axes[1].element, html("div", { class: "wanted" }, this.wantedWord, this.facts), html("div", {}, this.compute, " ", this.cancel, " ", this.progress), this.refused);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      void this.sweep();
    });
    this.element.append(form, this.hint, this.found);
  }

  /** Offer facts; those that were chosen stay so. */
  offer(facts: readonly OfferedFact[]): void {
    if (same(facts.map(({ name }) => name), this.boxes.map((one) => one.value))) return;
    const before = new Set(this.wanted);
    const wanted = facts.some(({ name }) => before.has(name)) ? before : new Set(facts.slice(0, FIRST_FACTS).map(({ name }) => name));
    const boxes = facts.map(({ name, title }) => {
      const box = html("input", { type: "checkbox", value: name });
      box.checked = wanted.has(name);
      return html("label", {}, box, " ", title);
    });
    this.facts.replaceChildren(...boxes);
  }

  private get boxes(): HTMLInputElement[] {
    return [...this.facts.querySelectorAll("input")];
  }

  /** Names of the facts that are wanted. */
  private get wanted(): string[] {
    return this.boxes.filter((one) => one.checked).map((one) => one.value);
  }

  private async sweep(): Promise<void> {
    const { asked } = this;
    if (!asked) return;
    await this.stop();
    const { round } = this;
    const vary = Object.fromEntries(this.axes.filter((one) => one.values).map((one) => [one.path.value, one.values]));
    this.wait(true);
    this.refused.replaceChildren();
    try {
      const { beside: _beside, ...own } = asked;
      const { number } = (await (await ask("api/sweep", own, { language: this.doings.language(), vary, wanted: this.wanted })).json()) as { number: string };
      if (round !== this.round) {
        await ended(number);
        return;
      }
      this.going = number;
      const found = await this.computed(number);
      if (found && round === this.round) this.show(found);
    } catch (error) {
      if (round === this.round) this.refused.replaceChildren(...lines(this.doings.wrong(error)));
    } finally {
      if (round === this.round) this.wait(false);
    }
  }

  /** Wait for a sweep; nothing of one that was stopped. */
  private async computed(number: string): Promise<SweptDesignsOfPage | null> {
    for (;;) {
      const answer = await look(`api/sweep/${number}`);
      if (this.going !== number) return null;
      if (answer.status !== 202) return (await opened(answer)) as SweptDesignsOfPage;
      const { done, designs } = (await answer.json()) as { done: number; designs: number };
      if (designs) {
        this.progress.max = designs;
        this.progress.value = done;
      }
      await new Promise((resolve) => { setTimeout(resolve, PAUSE); });
    }
  }

  private async stop(): Promise<void> {
    const { going } = this;
    this.round += 1;
    this.going = "";
    this.wait(false);
    if (going) await ended(going);
  }

  private wait(isWaiting: boolean): void {
    this.progress.removeAttribute("value");
    this.progress.hidden = !isWaiting;
    this.cancel.hidden = !isWaiting;
    this.compute.disabled = isWaiting;
  }

  /** Take the width and the colours of what it stands in. */
  fit(): void {
    for (const one of this.curves) one.fit();
  }

  private show({ varied, sheet, minded }: SweptDesignsOfPage): void {
    const [first] = varied;
    const [now, up] = this.axes.map((one) => one.now) as [number, number];
    let loaded = "";
    const load = (...places: readonly number[]): void => {
      if (loaded === places.join()) return;
      loaded = places.join();
      this.doings.load(new Map(varied.map((one, which) => [one.path, one.texts[places[which] ?? 0] ?? ""])));
    };
    const isOverOne = varied.length === 1 && first?.numbers;
    this.hint.hidden = !isOverOne && !sheet.columns.flat().some((part) => part.is === "PageMaps");
    this.found.replaceChildren(...minded.map((one) => html("p", { class: "note" }, said(one))));
    const curves: ShownCurves[] = [];
    for (const part of sheet.columns.flat()) {
      if (part.is === "PageMaps") this.found.append(maps(part, load, { across: now, up }).element);
      else if (part.is === "Notes") this.found.append(...part.sentences.map((one) => html("p", { class: "note" }, said(one))));
      else if (part.is === "PageCurves") {
        const shown = new ShownCurves(withPresent(part, now), this.words?.numbers ?? "", (place) => { if (isOverOne) load(nearestTo(isOverOne.values, place)); }, "");
        curves.push(shown);
        this.found.append(shown.element);
        shown.show(now);
      }
    }
    this.curves = curves;
    this.fit();
  }
}

/** Have a sweep ended. */
async function ended(number: string): Promise<void> {
  try {
    await fetch(`api/sweep/${number}`, { method: "DELETE" });
  } catch {
    // A service that does not answer computes nothing either; the next question says so.
  }
}

/** Curves with a line at the present design. */
function withPresent(part: PageCurves, now: number): PageCurves {
  const line: PanelLine = { is: "PanelLine", at: now, role: "declared", symbol: "", number: 0, is_upright: true };
  return Number.isNaN(now) ? part : { ...part, panels: part.panels.map((one) => ({ ...one, levels: [...one.levels, line] })) };
}
