// What turns the crank on a page: a bar with play, steps and a slider, over the crank angle or over time.

import type { CourseWords, PageWords } from "./data.ts";
import { Passing } from "./course.ts";
import { html, write } from "./elements.ts";
import { figure, number } from "./numbers.ts";
import type { Turning } from "./turning.ts";

/** Where a machine stands: at a crank angle in its cycle, or at a time in its course. */
export type Cursor = Turning | Passing;

/** Decimals of a time beyond those of its step. */
const FINER = 10;

/** The bar. */
export class Controls {
  readonly element: HTMLElement;
  readonly keys = html("p", { class: "keys" });
  private readonly slider = html("input", { type: "range", min: 0, value: 0 });
  private readonly reading = html("output", { class: "angle", "aria-live": "off" });
  private readonly play = html("button", { type: "button", class: "play" });
  private readonly steps: readonly [HTMLButtonElement, HTMLButtonElement];
  private readonly pace = html("select", { class: "pace" });
  private cursor: Cursor;
  private words: PageWords | CourseWords;

  constructor(cursor: Cursor, words: PageWords) {
    this.cursor = cursor;
    this.words = words;
    this.steps = [this.stepping(-1), this.stepping(1)];
    this.play.addEventListener("click", () => { this.cursor.toggle(); });
    this.slider.addEventListener("input", () => {
      const place = Number(this.slider.value); // which what stops moves to where it stops
      this.cursor.stop();
      this.cursor.stand(place);
    });
    this.pace.addEventListener("change", () => {
      if (this.cursor instanceof Passing) this.cursor.rate = number(this.cursor.course.paces[this.pace.selectedIndex]?.rate);
    });
    this.element = html("div", { class: "turning-controls" }, this.play, this.steps[0], this.slider, this.steps[1], this.pace, this.reading);
  }

  /** Move another cursor, or the same with other words and ends. */
  take(cursor: Cursor, words: PageWords): void {
    this.cursor = cursor;
    const isPassing = cursor instanceof Passing;
    this.words = isPassing ? cursor.course.words : words;
    this.element.classList.toggle("timed", isPassing);
    this.slider.step = isPassing ? "any" : "1";
    this.slider.max = `${cursor.end}`;
    this.slider.setAttribute("aria-label", isPassing ? cursor.course.words.time : words.angle);
    const step = isPassing ? `${number(cursor.course.step)}` : "1°";
    for (const [button, sign, word] of [[this.steps[0], "−", this.words.back], [this.steps[1], "+", this.words.on]] as const) {
      write(button, sign + step);
      button.title = word;
      button.setAttribute("aria-label", word);
    }
    write(this.keys, this.words.keys);
    this.pace.hidden = !isPassing;
    if (isPassing) {
      this.pace.replaceChildren(...cursor.course.paces.map((one) => html("option", {}, one.words)));
      this.pace.selectedIndex = cursor.course.paces.findIndex((one) => one.rate === cursor.rate);
      this.pace.setAttribute("aria-label", cursor.course.words.pace);
      this.pace.title = cursor.course.words.pace;
    }
    this.show();
  }

  /** Show where the cursor stands. */
  show(): void {
    const { cursor, words } = this;
    this.slider.value = `${cursor.place}`;
    const angle = cursor.isPlaying ? Math.round(cursor.angle) : +cursor.angle.toFixed(1);
    this.reading.textContent = cursor instanceof Passing
      ? `t = ${figure(cursor.time, number(cursor.course.step) / FINER)} ${cursor.course.unit}\nφ = ${figure(cursor.angle, 0.1)}°`
      : `φ = ${angle}°`;
    const word = cursor.isPlaying ? words.stop : words.play;
    if (this.play.title === word) return;
    this.play.title = word;
    this.play.setAttribute("aria-label", word);
    this.play.textContent = cursor.isPlaying ? "❚❚" : "▶";
  }

  private stepping(by: number): HTMLButtonElement {
    const button = html("button", { type: "button" });
    button.addEventListener("click", () => { this.cursor.step(by); });
    return button;
  }
}
