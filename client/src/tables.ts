// Tables: rows of an answer, tables of a sheet, checks.

import { plain } from "./charts.ts";
import type { Notes, PageCheck, PageSection, PageTable, WrittenGroup, WrittenRow } from "./data.ts";
import { html, scrolling, svg } from "./elements.ts";
import { colour, methodPen } from "./ink.ts";
import { said } from "./words.ts";

/** Characters behind several numbers, beyond which they stand under these where there is little room. */
const LONG_WORDS = 40;

/** Show the rows of an answer, as the terminal has them; where it can be asked whence, their names are buttons for that. */
export function answer(group: WrittenGroup, isAsked: boolean): HTMLElement {
  const n = Math.max(1, group.heads.length);
  const isWordy = n > 1 && group.rows.some((row) => row.words.length > LONG_WORDS);
  const table = html("table", { class: isWordy ? "answer wordy" : "answer" });
  if (group.heads.length) {
    table.append(html("thead", {}, html("tr", {}, html("th", {}), ...group.heads.map((head) => html("th", { scope: "col" }, said(head))), html("th", {}))));
  }
  const body = html("tbody", {});
  for (const row of group.rows) {
    const line = html("tr", {}, html("th", { scope: "row" }, named(row, isAsked)));
    if (row.cells.length === 0) line.append(html("td", { class: "words", colspan: n + 1 }, said(row.words.trim())));
    else {
      if (row.cells.length < n) line.append(html("td", { class: "number", colspan: n }, row.cells[0] ?? ""));
      else for (const cell of row.cells) line.append(html("td", { class: "number" }, cell));
      const words = row.words.replace(/^[ ,]*/, (start) => (start.includes(",") ? ", " : ""));
      line.append(html("td", { class: "words" }, row.label, row.label && words && !words.startsWith(",") ? " " : "", said(words)));
    }
    body.append(line);
  }
  table.append(body);
  return table;
}

function named({ name, quantities: [quantity] }: WrittenRow, isAsked: boolean): Node {
  return isAsked && quantity !== undefined ? html("button", { type: "button", class: "way", value: quantity }, html("span", {}, said(name))) : said(name);
}

/** Show a table of a sheet. */
export function table(part: PageTable): HTMLElement {
  const element = html("div", { class: "table" });
  scrolling(element, plain(part.title || part.heads.join(" ")));
  if (part.title) element.append(html("h3", {}, said(part.title)));
  const whole = html("table", {});
  const head = html("thead", {});
  if (part.groups.some(Boolean)) {
    const line = html("tr", {});
    part.groups.forEach((group, place) => {
      if (place && group === part.groups[place - 1]) return;
      const width = part.groups.slice(place).findIndex((one) => one !== group);
      line.append(html("th", { colspan: width < 0 ? part.groups.length - place : width, class: "group" }, group));
    });
    head.append(line);
  }
  if (part.heads.some(Boolean)) head.append(html("tr", {}, ...part.heads.map((one) => html("th", { scope: "col" }, said(one)))));
  const rows = part.rows.map((cells, place) => {
    const method = part.methods[place];
    const line = html("tr", {});
    cells.forEach((cell, column) => {
      const own = html(column ? "td" : "th", !column ? { scope: "row" } : part.of_words.includes(column) ? {} : { class: "number" });
      if (column === 0 && method !== undefined) own.append(sampleOf(method), " ");
      own.append(said(cell));
      line.append(own);
    });
    return line;
  });
  whole.append(head, html("tbody", {}, ...rows));
  element.append(whole, ...part.notes.map((note) => html("p", { class: "note" }, said(note))));
  return element;
}

/** Show tables and sentences under a heading. */
export function section(part: PageSection): HTMLElement {
  const heads = part.heading ? [html("h3", {}, said(part.heading))] : [];
  return html("div", { class: "section" }, ...heads, ...part.parts.map((one) => (one.is === "PageTable" ? table(one) : notes(one))));
}

/** Show sentences. */
export function notes(part: Notes): HTMLElement {
  return html("div", { class: "notes" }, ...part.sentences.map((one) => html("p", {}, said(one))));
}

function sampleOf(method: number): SVGSVGElement {
  const pen = methodPen(method);
  return svg("svg", { class: "sample", viewBox: "0 0 26 10" }, svg("line", { x1: 1, y1: 5, x2: 25, y2: 5, stroke: colour(pen.ink), "stroke-width": pen.width, "stroke-dasharray": pen.dashes.join(" ") }));
}

/** Show checks: what does not hold stands first. */
export function checks(found: readonly PageCheck[], title: string): HTMLElement {
  const inOrder = [...found].sort((one, other) => Number(one.holds !== false) - Number(other.holds !== false));
  const items = inOrder.map((check) => {
    const mark = check.holds === null ? "–" : check.holds ? "✓" : "✗";
    return html("li", { class: check.holds === false ? "failed" : "" }, html("span", { class: "mark" }, mark), said(check.sentence), " ", html("span", { class: "verdict" }, said(check.verdict)));
  });
  const n = found.filter((one) => one.holds).length;
  const list = html("details", { class: "checks" }, html("summary", {}, `${title} `, html("span", { class: "count" }, `${n}/${found.filter((one) => one.holds !== null).length} ✓`)), html("ul", {}, ...items));
  list.open = found.some((one) => one.holds === false);
  return list;
}
