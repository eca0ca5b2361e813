// The bar over a page: which machine, steps back and on, files, and what stands beside.

import type { Asked } from "./address.ts";
import type { CaseWords, ExportForm } from "./data.ts";
import { html, offer, write } from "./elements.ts";

/** What may be done from the bar. */
export interface Doings {
  readonly machine: (name: string) => void;
  readonly gallery: () => void;
  readonly open: () => void;
  readonly walk: (by: number) => void;
  readonly save: () => void;
  /** Take a file away, by how its name ends. */
  readonly export: (suffix: string) => void;
  /** Put a saved case beside what is shown, what is shown itself, or nothing. */
  readonly beside: (saved: Asked | "this" | null) => void;
}

/** The value of a machine that is known by its text. */
const SENT = "*";

export class Bar {
  readonly element: HTMLElement;
  private readonly machines = html("select", {});
  private readonly ownMachine = html("option", { value: SENT, hidden: "" });
  private readonly machinesWord = html("span", {});
  private readonly machinesLabel = html("label", {}, this.machinesWord, " ", this.machines);
  private readonly exports = html("select", { class: "exports" });
  private readonly beside = html("select", { class: "beside" });
  private readonly besideWord = html("span", {});
  private readonly besideLabel = html("label", {}, this.besideWord, " ", this.beside);
  /** What a narrow window shows when it is asked for. */
  private readonly others = html("button", { type: "button", class: "others", "aria-expanded": "false" }, "⋯");
  private readonly buttons: Readonly<Record<"gallery" | "open" | "undo" | "redo" | "save" | "keep", HTMLButtonElement>>;
  private forms: readonly ExportForm[] = [];
  private exportWord = "";
  /** Cases to compare with, by what they are called. */
  private readonly cases = new Map<string, Asked>();

  constructor(file: string, examples: readonly string[], doings: Doings, ...more: readonly HTMLElement[]) {
    const button = (click: () => void): HTMLButtonElement => {
      const made = html("button", { type: "button" });
      made.addEventListener("click", click);
      return made;
    };
    this.buttons = {
      gallery: button(doings.gallery),
      open: button(doings.open),
      undo: button(() => { doings.walk(-1); }),
      redo: button(() => { doings.walk(1); }),
      save: button(doings.save),
      keep: button(() => { doings.beside("this"); }),
    };
    this.machines.append(this.ownMachine, ...(file ? [html("option", { value: "" }, file)] : []), ...examples.map((name) => html("option", { value: name }, name)));
    this.machines.addEventListener("change", () => { doings.machine(this.machines.value); });
    this.exports.addEventListener("change", () => {
      doings.export(this.exports.value);
      this.exports.value = "";
    });
    this.beside.addEventListener("change", () => { doings.beside(this.cases.get(this.beside.value) ?? null); });
    const { gallery, open, undo, redo, save, keep } = this.buttons;
    const rest = html("div", { class: "rest" }, gallery, open, save, this.exports, this.besideLabel, keep, ...more);
    this.element = html("header", { class: "bar" }, html("b", {}, "cranktrain"), this.machinesLabel, undo, redo, this.others, rest);
    this.others.addEventListener("click", () => {
      this.others.setAttribute("aria-expanded", `${this.others.getAttribute("aria-expanded") !== "true"}`);
    });
  }

  /** Say what is shown, and whether there is a step back and on. */
  take(asked: Asked, words: CaseWords, has: (by: number) => boolean): void {
    this.ownMachine.hidden = !asked.sent;
    write(this.ownMachine, asked.sent?.name ?? "");
    this.machines.value = asked.sent ? SENT : asked.machine;
    write(this.machinesWord, words.machine);
    for (const name of ["gallery", "open", "undo", "redo", "save", "keep"] as const) write(this.buttons[name], words[name]);
    this.others.setAttribute("aria-label", words.others);
    this.exports.setAttribute("aria-label", words.export);
    this.exportWord = words.export;
    this.offer(this.forms);
    this.steps(has);
    this.fillCases(asked, words);
  }

  /** Offer files to take away. */
  offer(forms: readonly ExportForm[]): void {
    this.forms = forms;
    offer(this.exports, [["", this.exportWord], ...forms.map(({ suffix, words }) => [suffix, `${suffix} – ${words}`] as const)], "");
  }

  /** Say whether there is a step back and on. */
  steps(has: (by: number) => boolean): void {
    this.buttons.undo.disabled = !has(-1);
    this.buttons.redo.disabled = !has(1);
  }

  /** Offer what may stand beside: the file as it is, what was kept, and what stands there. */
  private fillCases(asked: Asked, words: CaseWords): void {
    const own = { machine: asked.machine, ...(asked.sent ? { sent: asked.sent } : {}), settings: new Map<string, string>() };
    const called = (one: Asked): string => one.sent?.name ?? one.machine;
    const name = (one: Asked): string =>
      [...(called(one) === called(asked) ? [] : [called(one)]), [...one.settings].map((setting) => setting.join(" = ")).join(", ") || words.as_in_file].join(": ");
    const before = [...this.cases.values()];
    this.cases.clear();
    for (const one of [...before, own, ...(asked.beside ? [asked.beside] : [])]) this.cases.set(name(one), one);
    offer(this.beside, [["", "–"], ...[...this.cases.keys()].map((one) => [one, one] as const)], asked.beside ? name(asked.beside) : "");
    write(this.besideWord, words.compare);
  }
}
