// Pins and links at the crank angle: a table that is folded, and written where somebody looks at it.

import type { CursorColumn, CursorTable, PageMembers } from "./data.ts";
import { html, scrolling, write } from "./elements.ts";
import { figure, number, row, same, smooth } from "./numbers.ts";
import { plain } from "./charts.ts";
import { said } from "./words.ts";

/** Asks for them, of what is drawn now. */
export type Ask = () => Promise<PageMembers>;

export class Members {
  private readonly word = html("summary", {});
  private readonly tables = html("div", {});
  readonly element = html("details", { class: "members" }, this.word, this.tables);
  private ask: Ask | null = null;
  private found: PageMembers | null = null;
  private cells: readonly (readonly HTMLElement[])[] = [];
  private cycle = NaN;
  private angle = 0;
  private isAsked = false;

  constructor() {
    this.element.addEventListener("toggle", () => { this.show(this.angle); });
  }

  /** Take where they come from, over which cycle [deg], and what they are called. */
  take(ask: Ask, cycle: number, word: string): void {
    this.ask = ask;
    this.cycle = cycle;
    this.isAsked = false;
    write(this.word, word);
    this.show(this.angle);
  }

  /** Write what is at a crank angle. [deg] */
  show(angle: number): void {
    this.angle = angle;
    if (!this.element.open) return;
    if (!this.isAsked) this.load();
    this.found?.tables.forEach((table, which) => {
      let part = 0;
      const next = (): number => smooth(row(table.values, part++), this.cycle, angle);
      this.cells[which]?.forEach((cell, place) => {
        const column = table.columns[place % table.columns.length] as CursorColumn;
        write(cell, written(column.n_parts === 1 ? next() : Math.hypot(...Array.from({ length: column.n_parts }, next)), column));
      });
    });
  }

  private load(): void {
    const { ask } = this;
    this.isAsked = true;
    void ask?.().then((found) => {
      if (this.ask !== ask) return;
      if (!this.found || !same(headOf(this.found), headOf(found))) this.fill(found);
      this.found = found;
      this.show(this.angle);
    });
  }

  private fill(found: PageMembers): void {
    const made = found.tables.map(tableOf);
    this.cells = made.map(({ cells }) => cells);
    this.tables.replaceChildren(...made.map(({ element }) => element), html("p", { class: "note" }, said(found.note)));
  }
}

/** What of them is no number. */
const headOf = (found: PageMembers): unknown => [found.note, found.tables.map(({ head, names, columns }) => [head, names, columns.map((one) => one.head)])];

/** A table without its numbers, and the cells in which these are written, row by row. */
function tableOf(table: CursorTable): { readonly element: HTMLElement; readonly cells: HTMLElement[] } {
  const cells: HTMLElement[] = [];
  const heads = [table.head, ...table.columns.map((one) => one.head)].map((one) => html("th", { scope: "col" }, said(one)));
  const rows = table.names.map((name) => {
    const own = table.columns.map(() => html("td", { class: "number" }));
    cells.push(...own);
    return html("tr", {}, html("th", { scope: "row" }, said(name)), ...own);
  });
  const element = html("div", { class: "table figures" }, html("table", {}, html("thead", {}, html("tr", {}, ...heads)), html("tbody", {}, ...rows)));
  scrolling(element, plain(table.head));
  return { element, cells };
}

/** A number with the decimals of its column. */
export function written(value: number, { step, around }: CursorColumn): string {
  if (!Number.isFinite(value)) return "–";
  const turn = number(around);
  const places = Math.round(value / number(step));
  const steps = Math.round(turn / number(step));
  return figure((Number.isNaN(turn) ? places : ((places % steps) + steps) % steps) * number(step), number(step));
}
