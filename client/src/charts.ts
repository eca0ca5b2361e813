// What of a chart is read, not seen: its name, and its numbers, in a table that is made when somebody asks for it.

import { html, scrolling } from "./elements.ts";
import { said } from "./words.ts";

/** Numbers of a chart: heads of columns, and rows. */
export interface Figures {
  readonly heads: readonly (Node | string)[];
  readonly rows: readonly (readonly string[])[];
}

/** Words without the marks of what is set as mathematics in them. */
export const plain = (words: string): string => said(words).textContent ?? "";

/** A button beside the title of a chart, and the table that it opens. */
export class NumbersOf {
  readonly button: HTMLButtonElement;
  readonly table = html("div", { class: "table figures" });
  private readonly figures: () => Figures;

  constructor(word: string, title: string, figures: () => Figures) {
    const name = `${word}: ${plain(title)}`;
    this.figures = figures;
    this.button = html("button", { type: "button", class: "numbers-of", "aria-expanded": "false", "aria-label": name, title: word }, "▦");
    this.button.addEventListener("click", () => {
      this.button.setAttribute("aria-expanded", `${!this.isOpen}`);
      this.renew();
    });
    scrolling(this.table, name);
    this.renew();
  }

  /** Show other numbers, where they are open. */
  renew(): void {
    this.table.hidden = !this.isOpen;
    this.table.replaceChildren(...(this.isOpen ? [made(this.figures())] : []));
  }

  private get isOpen(): boolean {
    return this.button.getAttribute("aria-expanded") === "true";
  }
}

/** A title with its button. */
export const titled = (title: HTMLElement, numbers: NumbersOf): HTMLElement => html("div", { class: "title" }, title, numbers.button);

function made(figures: Figures): HTMLTableElement {
  const heads = figures.heads.map((head) => html("th", { scope: "col" }, head));
  const rows = figures.rows.map(([first, ...others]) =>
    html("tr", {}, html("th", { scope: "row" }, first ?? ""), ...others.map((one) => html("td", { class: "number" }, one))));
  return html("table", {}, html("thead", {}, html("tr", {}, ...heads)), html("tbody", {}, ...rows));
}
