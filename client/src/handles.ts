// Pins of the drawing that are moved by hand: a machine with other numbers follows, and the old one stays as a ghost.

import { Adding, type AddedPart } from "./adding.ts";
import type { AddingWords, DrawnHandle, PageHandles } from "./data.ts";
import { html, write } from "./elements.ts";
import type { Mechanism } from "./mechanism.ts";
import { between, number, row } from "./numbers.ts";
import type { View } from "./placing.ts";
import type { Point } from "./points.ts";

/** Over which crank angle slopes repeat. [deg] */
const TURN = 360;

/** Times that numbers are found again without a move of the pointer: a pin goes on no straight line, or only part of the way. */
const MOST_TIMES = 6;

/** Room for what is said beside the pointer. [px] */
const LABEL = 220;

/** Who changes numbers of the machine. */
export interface Editing {
  readonly handles: () => Promise<PageHandles>;
  /** Show the machine with other texts, by their paths, or say why there is none; in the same step as before, or in one of its own. */
  readonly change: (texts: ReadonlyMap<string, string>, isNext: boolean) => Promise<string>;
  /** Show the machine with another part, in a step of its own, or say why there is none. */
  readonly add: (part: AddedPart) => Promise<string>;
  readonly nameOf: (path: string) => string;
  readonly adding: AddingWords;
  /** What the button that begins it is called. */
  readonly word: string;
}

/** Of the page on which pins are moved. */
export interface Around {
  readonly stage: HTMLElement;
  readonly mechanism: () => Mechanism;
  readonly angle: () => number;
  readonly stop: () => void;
  readonly redraw: (view?: View) => void;
}

interface Drag {
  readonly handle: DrawnHandle;
  readonly view: View;
  readonly old: SVGElement[];
  /** Where on the window the pointer is, and by how much it missed the pin, in the units of the picture. */
  pointer: Point;
  readonly missed: Point;
  /** Of the way to the pointer that is tried: less where there is no such machine. */
  part: number;
  asked: string;
  times: number;
  isFirst: boolean;
  isOver: boolean;
}

/** A number as it is typed, to a step. */
export function stepped(value: number, step: number): string {
  const decimals = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  return (Math.round(value / step) * step).toFixed(decimals).replace(/^-(0(\.0*)?)$/, "$1");
}

/** By how much numbers change so that a pin goes as near to where it is wanted as they let it. */
export function changes(slopes: readonly Point[], by: Point): number[] {
  const [one, other] = slopes;
  if (!one) return [];
  const across = other ? one.x * other.y - one.y * other.x : 0;
  const size = Math.hypot(one.x, one.y) * (other ? Math.hypot(other.x, other.y) : 0);
  if (!other || Math.abs(across) < 0.02 * size) {
    const along = (one.x * by.x + one.y * by.y) / (one.x * one.x + one.y * one.y);
    return other ? [along, 0] : [along];
  }
  return [(by.x * other.y - by.y * other.x) / across, (one.x * by.y - one.y * by.x) / across];
}

export class Handles {
  private readonly word = html("span", {});
  readonly button = html("button", { type: "button", class: "choice", title: "E", "aria-pressed": "false" }, this.word);
  readonly adding: Adding;
  private readonly around: Around;
  private readonly label = html("div", { class: "moved", role: "status" });
  private editing: Editing | undefined;
  private found: readonly DrawnHandle[] = [];
  private drag: Drag | null = null;
  private taken: Promise<void> = Promise.resolve();
  private isBusy = false;

  constructor(around: Around) {
    this.around = around;
    this.adding = new Adding(around, () => { this.show(this.found); });
    this.button.hidden = this.label.hidden = true;
    this.button.addEventListener("click", () => { this.toggle(); });
    const { stage } = around;
    stage.addEventListener("pointerdown", (event) => { this.grip(event); }, { capture: true });
    stage.addEventListener("pointermove", (event) => { this.follow(event); });
    for (const end of ["pointerup", "pointercancel"]) stage.addEventListener(end, () => { this.leave(); });
  }

  /** How the drawing lies while a pin is moved: as it did at first. */
  get view(): View | undefined {
    return this.drag?.view;
  }

  toggle(): void {
    if (!this.editing) return;
    this.adding.end();
    this.button.setAttribute("aria-pressed", `${!this.isOn}`);
    this.take(this.editing);
  }

  /** Take who changes numbers of what is shown now. */
  take(editing: Editing | undefined): void {
    this.taken = this.find(editing);
  }

  private async find(editing: Editing | undefined): Promise<void> {
    this.editing = editing;
    this.button.hidden = !editing;
    write(this.word, editing?.word ?? "");
    if (!editing || !this.isOn) {
      this.adding.offer([]);
      this.show([]);
      return;
    }
    const found = await editing.handles();
    if (this.editing !== editing) return;
    this.adding.offer(found.additions, editing);
    this.show(found.handles);
  }

  private get isOn(): boolean {
    return this.button.getAttribute("aria-pressed") === "true";
  }

  private show(found: readonly DrawnHandle[]): void {
    this.found = found;
    const mechanism = this.around.mechanism();
    mechanism.showHandles(this.adding.isBegun ? [] : found);
    if (!this.drag) return;
    mechanism.showOld(this.drag.old);
    this.around.stage.append(this.label);
  }

  private grip(event: PointerEvent): void {
    const ring = event.target instanceof Element ? event.target.closest(".handle") : null;
    const handle = this.found[Number(ring?.getAttribute("data-place") ?? NaN)];
    if (!handle) return;
    event.stopPropagation();
    event.preventDefault();
    const { stage, mechanism, angle, stop } = this.around;
    stop();
    stage.setPointerCapture(event.pointerId);
    const pin = mechanism().placeOf(handle, angle());
    const at = mechanism().place(event.clientX, event.clientY);
    this.drag = {
      handle,
      view: mechanism().view,
      old: mechanism().ghost(angle()),
      pointer: { x: event.clientX, y: event.clientY },
      missed: { x: at.x - pin.x, y: at.y - pin.y },
      part: 1,
      asked: "",
      times: 0,
      isFirst: true,
      isOver: false,
    };
    mechanism().showOld(this.drag.old);
    this.say("");
  }

  private follow(event: PointerEvent): void {
    if (!this.drag) return;
    this.drag.pointer = { x: event.clientX, y: event.clientY };
    this.drag.times = 0;
    this.drag.part = 1;
    void this.move();
  }

  private leave(): void {
    if (!this.drag) return;
    this.drag.isOver = true;
    this.drag.times = 0;
    void this.move();
  }

  /** Change numbers until the pin is at the pointer, as far as they let it. */
  private async move(): Promise<void> {
    if (this.isBusy) return;
    this.isBusy = true;
    while (this.drag && (await this.step(this.drag))) continue;
    this.isBusy = false;
    if (!this.drag?.isOver) return;
    this.drag = null;
    this.label.hidden = true;
    this.around.redraw();
    this.show(this.found);
  }

  /** Change numbers once; say whether that may be done again. */
  private async step(drag: Drag): Promise<boolean> {
    const { mechanism, angle } = this.around;
    const handle = this.found.find((one) => one.mechanism === drag.handle.mechanism && one.pin === drag.handle.pin);
    if (!handle || !this.editing || drag.times++ >= MOST_TIMES) return false;
    const at = mechanism().place(drag.pointer.x, drag.pointer.y);
    const pin = mechanism().placeOf(handle, angle());
    const by = mechanism().inMetres({ x: at.x - drag.missed.x - pin.x, y: at.y - drag.missed.y - pin.y });
    const turned = ((angle() % TURN) + TURN) % TURN;
    const slopes = handle.numbers.map((one) => ({ x: between(row(one.slope, 0), TURN, turned), y: between(row(one.slope, 1), TURN, turned) }));
    const texts = changes(slopes, by).map((whole, place) => {
      const one = handle.numbers[place];
      const step = number(one?.step);
      const change = drag.part * whole;
      return Math.abs(change) < 0.5 * step ? null : `${stepped(number(one?.number) + change, step)} ${one?.unit ?? ""}`.trim();
    });
    const found = handle.numbers.flatMap((one, place) => {
      const text = texts[place];
      return text ? one.paths.map((path) => [path, text] as const) : [];
    });
    const key = JSON.stringify(found);
    if (!found.length || key === drag.asked) return false;
    drag.asked = key;
    const words = found.filter(([path]) => handle.numbers.some((one) => one.paths[0] === path)).map(([path, text]) => `${this.editing?.nameOf(path) ?? ""} ${text}`);
    if (drag.part === 1) this.say(words.join(" · "));
    const why = await this.editing.change(new Map(found), !drag.isFirst);
    await this.taken;
    if (why) {
      if (drag.part === 1) this.say(words.join(" · "), why);
      drag.part /= 2;
    } else {
      drag.isFirst = false;
    }
    return true;
  }

  /** Write beside the pointer what is changed, and why it is not. */
  private say(words: string, why = ""): void {
    const { stage } = this.around;
    if (!this.drag) return;
    const { left, top } = stage.getBoundingClientRect();
    this.label.replaceChildren(words, ...(why ? [html("span", { class: "problems" }, ` ✗ ${why}`)] : []));
    this.label.hidden = !words;
    this.label.style.left = `${Math.min(Math.max(this.drag.pointer.x, 0) - left + 14, stage.clientWidth - LABEL)}px`;
    this.label.style.top = `${Math.max(this.drag.pointer.y, 0) - top + 14}px`;
    stage.append(this.label);
  }
}
