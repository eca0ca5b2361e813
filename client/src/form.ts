// Numbers of a machine file, any of which may be set anew.

import type { NumbersOfTable, PageInput } from "./data.ts";
import { html } from "./elements.ts";

/** Letters from which on a number has a line of its own. */
const LONG = 12;

/** What is wrong with a number or a machine. */
export interface Problem {
  readonly path: string;
  readonly given: string | null;
  readonly allowed: string;
  readonly repair: string | null;
  /** Where it stands in the text of the machine file, from 1. */
  readonly line?: number | null;
  readonly column?: number | null;
  /** Texts that would be right there. */
  readonly instead: readonly string[];
}

/** A form of the numbers of a file; it says when one is to be set anew. */
export class Form {
  readonly element = html("form", { class: "numbers" });
  private readonly fields = new Map<string, { input: HTMLInputElement; said: HTMLElement }>();
  private readonly rest = html("div", { class: "problems", role: "alert" });
  private readonly set: (path: string, text: string) => void;

  constructor(title: string, tables: readonly NumbersOfTable[], set: (path: string, text: string) => void, asInFile: string) {
    this.set = set;
    this.element.addEventListener("submit", (event) => { event.preventDefault(); });
    this.element.append(html("h2", {}, title), this.rest);
    for (const table of tables) {
      const group = html("fieldset", {}, html("legend", {}, table.name));
      group.append(...table.inputs.map((one) => this.row(one, asInFile)));
      this.element.append(group);
    }
  }

  /** Whether it has the same numbers, so that texts alone have to change. */
  fits(tables: readonly NumbersOfTable[]): boolean {
    const paths = tables.flatMap((table) => table.inputs.map((one) => one.path));
    return paths.length === this.fields.size && paths.every((path) => this.fields.has(path));
  }

  /** Show texts, but where somebody types; bold where they are set anew. */
  fill(tables: readonly NumbersOfTable[], settings: ReadonlyMap<string, string>): void {
    for (const one of tables.flatMap((table) => table.inputs)) {
      const field = this.fields.get(one.path);
      if (!field) continue;
      if (document.activeElement !== field.input || !field.input.classList.contains("typing")) {
        if (field.input.value !== one.text) field.input.value = one.text;
      }
      field.input.closest(".field")?.classList.toggle("long", one.text.length > LONG);
    }
    this.mark(settings);
  }

  /** Show bold which numbers are set anew, also where there is no such machine. */
  mark(settings: ReadonlyMap<string, string>): void {
    for (const [path, { input }] of this.fields) input.closest(".field")?.classList.toggle("changed", settings.has(path));
  }

  /** Go to the field of a number. */
  go(path: string): void {
    this.fields.get(path)?.input.focus();
    this.fields.get(path)?.input.select();
  }

  /** Show what is wrong, each beside its number; what is of none stands above all, with the name of the file that was sent. */
  blame(problems: readonly Problem[], file = ""): void {
    for (const { input, said } of this.fields.values()) {
      if (input.hasAttribute("aria-invalid")) input.removeAttribute("aria-invalid");
      if (said.hasChildNodes()) said.replaceChildren();
    }
    const others: Problem[] = [];
    for (const problem of problems) {
      const field = this.fields.get(problem.path);
      if (!field) {
        others.push(problem);
        continue;
      }
      field.input.setAttribute("aria-invalid", "true");
      field.said.append(sentence(problem), ...problem.instead.map((text) => {
        const button = html("button", { type: "button", class: "instead" }, text);
        button.addEventListener("click", () => { this.set(problem.path, text); });
        return button;
      }));
    }
    this.rest.replaceChildren(...lines(others, file));
    if (others.length && !this.element.contains(document.activeElement)) this.rest.scrollIntoView({ block: "center" });
  }

  private row(one: PageInput, asInFile: string): HTMLElement {
    const id = `number-${this.fields.size}`;
    const input = html("input", { id, type: "text", value: one.text, spellcheck: "false", autocomplete: "off", "aria-describedby": `${id}-said ${id}-status` });
    const said = html("div", { class: "said", id: `${id}-said`, role: "alert" });
    const send = (): void => {
      input.classList.remove("typing");
      this.set(one.path, input.value.trim());
    };
    input.addEventListener("input", () => { input.classList.add("typing"); });
    input.addEventListener("change", send);
    input.addEventListener("keydown", (event) => {
      const way = event.key === "ArrowUp" ? 1 : event.key === "ArrowDown" ? -1 : 0;
      const stepped = way && stepOf(input.value, way * (event.shiftKey ? 10 : event.altKey ? 0.1 : 1));
      if (!stepped) return;
      event.preventDefault();
      input.value = stepped;
      send();
    });
    const known = [one.status, one.note].filter(Boolean).join(": ");
    const status = html("span", { class: "status", id: `${id}-status`, title: known, ...(known ? { role: "img", "aria-label": known } : {}) }, one.status.slice(0, 1).toUpperCase());
    const back = html("button", { type: "button", class: "back", title: asInFile, "aria-label": `${one.name}: ${asInFile}` }, "↺");
    back.addEventListener("click", () => { this.set(one.path, ""); });
    this.fields.set(one.path, { input, said });
    return html("div", { class: "field" }, html("label", { for: id, title: one.path }, one.name), input, status, back, said);
  }
}

/** A text with its number by so much larger, to the decimals that either has; nothing where it has no number. */
export function stepOf(text: string, by: number): string {
  const found = /^\s*([+-]?(?:\d+\.?\d*|\.\d+))(?![\d/e])/i.exec(text);
  if (!found?.[1]) return "";
  const decimals = Math.max(found[1].split(".")[1]?.length ?? 0, Math.abs(by) < 1 ? 1 : 0);
  return text.replace(found[1], (Number(found[1]) + by).toFixed(decimals));
}

/** Problems that stand beside no field, a line each: where in which file, what, and why. */
export function lines(problems: readonly Problem[], file = ""): HTMLElement[] {
  return problems.map((one) => {
    const where = [file, one.line, one.column].filter(Boolean).join(":");
    return html("p", {}, ["✗", where, one.path, sentence(one)].filter(Boolean).join(" "));
  });
}

/** Say a problem. */
export function sentence(problem: Problem): string {
  const said = problem.given === null ? problem.allowed : `${problem.given}: ${problem.allowed}`;
  return problem.repair === null ? said : `${said}; ${problem.repair}`;
}
