// Parts that are added to a machine by clicks on its drawing: it is said what each click may take, and asked for the rest.

import type { AddingWords, DrawnAddition, DrawnClick, DrawnTarget } from "./data.ts";
import { html, svg } from "./elements.ts";
import type { Mechanism } from "./mechanism.ts";
import { roomier, type View } from "./placing.ts";
import { polyline, type Point } from "./points.ts";
import { said } from "./words.ts";

/** How near a click is to what it takes, where it may take the ground as well, or lies beside a link. [px] */
const NEAR = 14;

/** So many times as far a click takes no pin. */
const FAR_OFF = 5;

/** How far a key moves the cross, and with shift. [px] */
const STEP = 2;
const FAR = 20;

/** Room for what is said beside the cross. [px] */
const LABEL = 160;

/** Radius of the ring round a pin that is taken. */
const RING = 11;

const ARROWS: Readonly<Record<string, Point>> = { ArrowLeft: { x: -1, y: 0 }, ArrowRight: { x: 1, y: 0 }, ArrowUp: { x: 0, y: -1 }, ArrowDown: { x: 0, y: 1 } };

/** A part as the service takes it. */
export interface AddedPart {
  readonly mechanism: string;
  readonly name: string;
  /** Crank angle that is shown. [deg] */
  readonly angle: number;
  /** What each click took, by its name, and where it is from the main shaft. [m] */
  readonly clicks: readonly { readonly name: string; readonly right: number; readonly up: number }[];
}

/** Who adds parts. */
interface Adder {
  readonly add: (part: AddedPart) => Promise<string>;
  readonly adding: AddingWords;
}

/** Of the page on which parts are added. */
interface Around {
  readonly stage: HTMLElement;
  readonly mechanism: () => Mechanism;
  readonly angle: () => number;
  readonly stop: () => void;
  /** Draw all anew, in a view or as it fits. */
  readonly redraw: (view?: View) => void;
}

/** What a click takes, and where. */
export interface Taken<Target> {
  readonly target: Target;
  readonly at: Point;
}

/** Give what of some targets a click at a place takes: the nearest, of pins none that is far; the ground, if it may, where none is near. */
export function taken<Target extends Pick<DrawnTarget, "pins">>(targets: readonly Target[], at: Point, place: (pin: string) => Point, near: number): Taken<Target> | null {
  const ground = targets.find((one) => one.pins.length === 0);
  let best: Taken<Target> | null = null;
  let least = Infinity;
  for (const target of targets) {
    const pins = target.pins.map(place);
    const spans = pins.length > 1 ? pins.slice(1).map((end, before) => [pins[before] as Point, end] as const) : pins.map((pin) => [pin, pin] as const);
    for (const [start, end] of spans) {
      const foot = footOf(at, start, end);
      const away = Math.hypot(foot.x - at.x, foot.y - at.y);
      if (!(away < least)) continue;
      least = away;
      best = { target, at: pins.length === 1 || away < near ? foot : at };
    }
  }
  if (ground && !(least < near)) return { target: ground, at };
  return best?.target.pins.length === 1 && least > FAR_OFF * near ? null : best;
}

/** The nearest point of a span. */
function footOf(at: Point, start: Point, end: Point): Point {
  const [x, y] = [end.x - start.x, end.y - start.y];
  const part = ((at.x - start.x) * x + (at.y - start.y) * y) / (x * x + y * y || 1);
  const along = Math.min(Math.max(part, 0), 1);
  return { x: start.x + along * x, y: start.y + along * y };
}

export class Adding {
  readonly element = html("div", { class: "adding" });
  private readonly around: Around;
  private readonly changed: () => void;
  private readonly cross = html("button", { type: "button", class: "cross" });
  private readonly label = html("div", { class: "moved" });
  private readonly prompt = html("div", { class: "prompt" });
  private readonly asks = html("p", { role: "status" });
  private readonly targets = html("div", { class: "targets" });
  private adder: Adder | undefined;
  private additions: readonly DrawnAddition[] = [];
  private begun: DrawnAddition | null = null;
  /** What was taken so far, where that is in the machine. [m] */
  private clicks: Taken<DrawnTarget>[] = [];
  /** What the next click would take, likewise. */
  private aimed: Taken<DrawnTarget> | null = null;
  private isBusy = false;
  private isPressed = false;

  constructor(around: Around, changed: () => void) {
    this.around = around;
    this.changed = changed;
    const { stage } = around;
    stage.addEventListener("pointerdown", (event) => {
      if (!this.begun) return;
      event.stopPropagation();
      this.isPressed = true;
    }, { capture: true });
    for (const move of ["pointerdown", "pointermove"] as const) stage.addEventListener(move, (event) => { this.aim(event.clientX, event.clientY); }, { capture: true });
    stage.addEventListener("pointercancel", () => { this.isPressed = false; });
    // A finger aims while it is down.
    stage.addEventListener("pointerup", (event) => {
      if (!this.isPressed) return;
      this.isPressed = false;
      this.aim(event.clientX, event.clientY);
      void this.take(this.aimed);
    });
    this.cross.addEventListener("keydown", (event) => { this.move(event); });
    this.cross.addEventListener("click", () => { void this.take(this.aimed); });
    document.addEventListener("keydown", (event) => {
      if (event.key === "Escape") this.end();
      if (!this.clicks.length || !this.begun || event.target instanceof HTMLInputElement) return;
      const isUndo = event.key === "z" && (event.ctrlKey || event.metaKey);
      if (!isUndo && event.key !== "Backspace") return;
      // What was clicked is undone before what was changed.
      event.preventDefault();
      event.stopPropagation();
      this.back();
    }, { capture: true });
  }

  /** Whether a part is being added. */
  get isBegun(): boolean {
    return this.begun !== null;
  }

  /** The click that is asked for; what the last took says which it is. */
  private get asked(): DrawnClick | undefined {
    return this.begun?.clicks[this.clicks.at(-1)?.target.then ?? 0];
  }

  /** Offer parts that may be added to what is shown, and no others. */
  offer(additions: readonly DrawnAddition[], adder?: Adder): void {
    if (adder === this.adder && additions === this.additions) {
      this.show();
      return;
    }
    this.adder = adder;
    this.additions = additions;
    this.begun = null;
    this.fill();
  }

  /** Mark on the drawing what is taken, and what the next click would take. */
  show(): void {
    const { begun, aimed } = this;
    const mechanism = this.around.mechanism();
    this.label.hidden = this.cross.hidden = !begun;
    if (!begun) {
      mechanism.mark([]);
      return;
    }
    const all = [...this.clicks, ...(aimed ? [aimed] : [])];
    const places = all.map((one) => this.pictured(one));
    const band = this.lines(places).map((line) => svg("path", { class: "band", d: polyline(line) }));
    mechanism.mark([...band, ...all.flatMap((one, place) => this.marks(one, places[place] as Point, one === aimed))]);
    this.stand();
  }

  /** Lines from click to click, as far as what was begun goes on. */
  private lines(places: readonly Point[]): Point[][] {
    const lines: Point[][] = [];
    let click = 0;
    for (const [number, place] of places.entries()) {
      if (number === 0 || this.begun?.clicks[click]?.begins) lines.push([]);
      lines.at(-1)?.push(place);
      click = this.clicks[number]?.target.then ?? click;
    }
    return lines.filter((line) => line.length > 1);
  }

  private marks({ target }: Taken<DrawnTarget>, at: Point, isAimed: boolean): SVGElement[] {
    const pins = target.pins.map((pin) => this.pin(pin));
    const mark = isAimed ? "aimed" : "taken";
    if (pins.length === 1) return [svg("circle", { class: mark, cx: at.x, cy: at.y, r: RING })];
    const point = svg("circle", { class: `${mark} point`, cx: at.x, cy: at.y, r: 4 });
    if (pins.length > 1) return [svg("path", { class: `${mark} link`, d: polyline(pins) }), point];
    return [svg("path", { class: mark, d: `M${at.x - RING} ${at.y}h${2 * RING}M${at.x} ${at.y - RING}v${2 * RING}` }), point];
  }

  /** Where what is taken is in the picture: a pin goes with the crank. */
  private pictured({ target, at }: Taken<DrawnTarget>): Point {
    const [pin, other] = target.pins;
    return pin !== undefined && other === undefined ? this.pin(pin) : this.around.mechanism().point(at.x, at.y);
  }

  private pin(pin: string): Point {
    const { mechanism, angle } = this.around;
    return mechanism().pinOf({ mechanism: this.begun?.mechanism ?? "", pin }, angle());
  }

  /** Aim at a point of the window. */
  private aim(x: number, y: number): void {
    const targets = this.asked?.targets;
    if (!targets) return;
    const mechanism = this.around.mechanism();
    const at = mechanism.place(x, y);
    const found = taken(targets, at, (pin) => this.pin(pin), mechanism.place(x + NEAR, y).x - at.x);
    this.aimed = found && { target: found.target, at: mechanism.inMetres(found.at) };
    this.show();
  }

  /** Put the cross where it aims, and say what that takes. */
  private stand(): void {
    const { stage, mechanism } = this.around;
    const { left, top } = stage.getBoundingClientRect();
    const { aimed } = this;
    this.label.hidden = !aimed;
    if (!aimed) return;
    const at = mechanism().onWindow(this.pictured(aimed));
    for (const [element, by, most] of [[this.cross, 0, Infinity], [this.label, RING, stage.clientWidth - LABEL]] as const) {
      element.style.left = `${Math.min(at.x - left + by, most)}px`;
      element.style.top = `${at.y - top + by}px`;
    }
    this.label.replaceChildren(said(aimed.target.words));
  }

  private move(event: KeyboardEvent): void {
    const by = ARROWS[event.key];
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    const { left, top } = this.around.stage.getBoundingClientRect();
    const far = event.shiftKey ? FAR : STEP;
    this.free = { x: this.free.x + far * by.x, y: this.free.y + far * by.y };
    this.aim(left + this.free.x, top + this.free.y);
  }

  /** Where keys have the cross, from the corner of the stage: what it takes may be beside it. [px] */
  private free: Point = { x: 0, y: 0 };

  private begin(addition: DrawnAddition): void {
    const { stop, redraw, mechanism } = this.around;
    stop();
    if (!this.begun) redraw(roomier(mechanism().view));
    this.begun = addition;
    this.clicks = [];
    this.next();
    this.changed();
  }

  /** End it, and go back to where it was begun. */
  end(begun = this.begun): void {
    if (!begun) return;
    this.begun = null;
    this.around.redraw();
    this.fill();
    this.changed();
    this.buttons[this.additions.findIndex((one) => one.mechanism === begun?.mechanism && one.name === begun.name)]?.focus({ preventScroll: true });
  }

  /** Ask for the click before anew. */
  private back(): void {
    if (this.isBusy) return;
    this.clicks = this.clicks.slice(0, -1);
    this.next();
  }

  private get buttons(): HTMLElement[] {
    return [...this.element.querySelectorAll<HTMLElement>(".begin")];
  }

  /** Ask for the next click, and say why there is no such part if there was none. */
  private next(why = ""): void {
    const last = this.clicks.at(-1);
    const { stage } = this.around;
    const { left, top } = stage.getBoundingClientRect();
    const at = last ? this.around.mechanism().onWindow(this.pictured(last)) : { x: left + stage.clientWidth / 2, y: top + stage.clientHeight / 2 };
    this.free = { x: at.x - left, y: at.y - top };
    this.aimed = null;
    this.fill(why);
    const first = this.targets.querySelector<HTMLElement>(".target");
    if (!first) this.aim(at.x, at.y);
    (first ?? this.cross).focus({ preventScroll: true });
    for (const element of [stage, this.prompt]) element.scrollIntoView({ block: "nearest" });
  }

  /** Take what a click took, and add the part with the last. */
  private async take(one: Taken<DrawnTarget> | null): Promise<void> {
    const { begun, adder } = this;
    if (!begun || !adder || !one || this.isBusy) return;
    this.clicks = [...this.clicks, one];
    if (this.asked) {
      this.next();
      return;
    }
    this.isBusy = true;
    const clicks = this.clicks.map((click) => {
      const { x, y } = this.around.mechanism().inMetres(this.pictured(click));
      // Where links cannot close a pin is nowhere, and the service says so by its name.
      return { name: click.target.name, right: x || 0, up: y || 0 };
    });
    this.prompt.classList.add("computing");
    const why = await adder.add({ mechanism: begun.mechanism, name: begun.name, angle: this.around.angle(), clicks });
    this.prompt.classList.remove("computing");
    this.isBusy = false;
    if (!why) {
      this.end(begun);
      return;
    }
    if (this.begun !== begun) return;
    this.clicks = this.clicks.slice(0, -1);
    this.next(why);
  }

  private fill(why = ""): void {
    const { begun, adder } = this;
    const begin = this.additions.map((one) => {
      const button = html("button", { type: "button", class: "begin choice", "aria-pressed": `${one === begun}` }, html("span", {}, said(one.title)));
      button.addEventListener("click", () => {
        if (this.begun === one) this.end();
        else this.begin(one);
      });
      return button;
    });
    const focused = this.buttons.findIndex((one) => one === document.activeElement);
    this.element.hidden = !begin.length;
    const name = adder?.adding.add ?? "";
    this.element.replaceChildren(html("div", { class: "choices", role: "group", "aria-label": name }, html("span", { class: "note" }, name), ...begin), ...(begun ? [this.prompt] : []));
    begin[focused]?.focus({ preventScroll: true });
    if (begun) {
      const click = this.asked;
      this.asks.replaceChildren(said(click?.asks ?? ""), ...(why ? [html("span", { class: "problems" }, ` ✗ ${why}`)] : []));
      const cancel = html("button", { type: "button", title: "Escape" }, adder?.adding.cancel ?? "");
      cancel.addEventListener("click", () => { this.end(); });
      const back = html("button", { type: "button", title: "Backspace" }, adder?.adding.back ?? "");
      back.addEventListener("click", () => { this.back(); });
      this.targets.replaceChildren(...listed(click?.targets ?? []).map((target) => this.choice(target)), ...(this.clicks.length ? [back] : []), cancel);
      this.prompt.replaceChildren(this.asks, this.targets);
      this.cross.setAttribute("aria-label", adder?.adding.cross ?? "");
      this.around.stage.append(this.cross, this.label);
    } else {
      this.cross.remove();
      this.label.remove();
    }
    this.show();
  }

  /** A target as a button: of a link the middle is taken, of the ground where the cross is put. */
  private choice(target: DrawnTarget): HTMLButtonElement {
    const button = html("button", { type: "button", class: "target" }, said(target.words));
    const middle = (): Taken<DrawnTarget> | null => {
      const [start, end] = target.pins.slice(0, 2).map((pin) => this.pin(pin));
      if (!start) return null;
      const [x, y] = [(start.x + (end ?? start).x) / 2, (start.y + (end ?? start).y) / 2];
      return { target, at: this.around.mechanism().inMetres({ x, y }) };
    };
    button.addEventListener("click", () => {
      const found = middle();
      if (found) {
        void this.take(found);
        return;
      }
      const { left, top } = this.around.stage.getBoundingClientRect();
      this.aim(left + this.free.x, top + this.free.y);
      this.cross.focus();
    });
    for (const seen of ["focus", "pointerenter"] as const) {
      button.addEventListener(seen, () => {
        this.aimed = middle() ?? this.aimed;
        this.show();
      });
    }
    return button;
  }
}

/** Targets that are chosen from a list: where a click takes any place alone, the cross is all there is. */
const listed = (targets: readonly DrawnTarget[]): readonly DrawnTarget[] => (targets.some((one) => one.pins.length) ? targets : []);
