// Where a number is from: its equation, its stages, and the numbers of the file behind it, each a way to its field.

import type { CaseWords, NumbersOfTable, PageWhence } from "./data.ts";
import { html } from "./elements.ts";
import { said } from "./words.ts";

/** A dialog beside the page; one at a time. */
export class WhenceDialog {
  readonly element = html("dialog", { class: "whence" });
  private readonly go: (path: string) => void;

  constructor(go: (path: string) => void) {
    this.go = go;
    this.element.addEventListener("click", (event) => { if (event.target === this.element) this.element.close(); });
  }

  show(found: PageWhence, tables: readonly NumbersOfTable[], words: CaseWords): void {
    const inputs = tables.flatMap((table) => table.inputs.filter((one) => found.inputs.includes(one.path)).map((one) => ({ ...one, of: table.name })));
    const close = html("button", { type: "button" }, words.close);
    close.addEventListener("click", () => { this.element.close(); });
    const rows = inputs.map((one) => {
      const way = html("button", { type: "button", class: "way" }, `${one.of} ${one.name}`.trim());
      way.addEventListener("click", () => {
        this.element.close();
        this.go(one.path);
      });
      return html("tr", {}, html("th", { scope: "row" }, way), html("td", { class: "number" }, one.text), html("td", {}, [one.status, one.note].filter(Boolean).join(": ")));
    });
    this.element.setAttribute("aria-label", `${words.whence}: ${found.title}`);
    this.element.replaceChildren(
      html("div", { class: "whence-head" }, html("h2", {}, said(found.title)), close),
      ...found.sentences.map((one) => html("p", {}, said(one))),
      html("details", {}, html("summary", {}, words.stages), html("p", { class: "note" }, found.stages.join(" → "))),
      html("h3", {}, words.rests_on),
      html("table", {}, html("tbody", {}, ...rows)),
    );
    this.element.showModal();
  }
}
