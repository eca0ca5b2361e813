// A page of one machine: the mechanism beside its curves, tab by tab, all at one crank angle.

import { placeIn, remember, withPlace } from "./address.ts";
import { curves, lineSample, type Shown } from "./curves.ts";
import type { PageTrust, Ruler, PageSheet, ShownMachine, TabContent } from "./data.ts";
import { html } from "./elements.ts";
import { Mechanism } from "./mechanism.ts";
import { number } from "./numbers.ts";
import { bars, polars, shapes, stars, wear } from "./plane.ts";
import { answer, checks, table } from "./tables.ts";
import { Turning } from "./turning.ts";
import { said } from "./words.ts";

/** Characters from which on a sentence with a list is folded. */
const LONG = 180;

/** Width of a drawing in parts of its height from which on it stands over all else. */
const WIDE = 1.8;

type Part = PageSheet["columns"][number][number];

/** Where more of a page is from, that it did not come with. */
export interface Source {
  readonly tab: (place: number) => Promise<TabContent>;
  readonly trust: () => Promise<PageTrust>;
}

/** Show a machine in an element; give what ends that. */
export function showPage(page: ShownMachine, into: HTMLElement, source?: Source): () => void {
  const { words } = page;
  const ended = new AbortController();
  const mechanism = new Mechanism(page.drawing, words.drawing);
  const cycle = number(page.cycle);
  const start = placeIn(location.hash);
  let shown: Shown[] = [];
  let chosen = Math.min(start.tab, page.tabs.length - 1);
  const slider = html("input", { type: "range", min: 0, max: cycle, step: 1, value: 0, "aria-label": words.angle });
  const reading = html("output", { class: "angle" });
  const play = html("button", { type: "button", class: "play" });
  const turning = new Turning(cycle, (angle, isPlaying) => {
    mechanism.show(angle);
    for (const one of shown) one.show(angle);
    slider.value = `${angle}`;
    reading.textContent = `φ = ${isPlaying ? Math.round(angle) : +angle.toFixed(1)}°`;
    const word = isPlaying ? words.stop : words.play;
    if (!isPlaying || play.title !== word) keep();
    if (play.title !== word) {
      play.title = word;
      play.setAttribute("aria-label", word);
      play.textContent = isPlaying ? "❚❚" : "▶";
    }
  });
  const keep = (): void => { remember(withPlace(location.hash, { tab: chosen, angle: turning.isPlaying ? NaN : turning.angle })); };
  const turned = (angle: number): void => { turning.stop(); turning.stand(angle); };
  const step = (by: number, word: string): HTMLButtonElement => {
    const button = html("button", { type: "button", title: word, "aria-label": word }, by < 0 ? "−1°" : "+1°");
    button.addEventListener("click", () => { turning.step(by); });
    return button;
  };
  play.addEventListener("click", () => { turning.toggle(); });
  slider.addEventListener("input", () => { turned(Number(slider.value)); });

  const left = html("div", { class: "answers" });
  const right = html("div", { class: "sheets", role: "tabpanel" });
  const tabs = page.tabs.map((tab, place) => {
    const button = html("button", { type: "button", role: "tab", id: `tab-${place}` }, said(tab.title));
    button.addEventListener("click", () => { choose(place); });
    return button;
  });
  const contents: (TabContent | null)[] = page.tabs.map((tab) => tab.content);
  const choose = (place: number): void => {
    if (!page.tabs[place]) return;
    chosen = place;
    tabs.forEach((button, other) => {
      button.setAttribute("aria-selected", `${other === place}`);
      button.tabIndex = other === place ? 0 : -1;
    });
    right.setAttribute("aria-labelledby", `tab-${place}`);
    keep();
    right.classList.toggle("computing", !contents[place]);
    const content = contents[place];
    if (content) fill(content);
    else {
      void source?.tab(place).then((found) => {
        contents[place] = found;
        if (chosen === place && !ended.signal.aborted) fill(found);
      });
    }
  };
  const fill = (content: TabContent): void => {
    right.classList.remove("computing");
    shown = [];
    left.replaceChildren(answer(content.answer));
    right.replaceChildren(...sheetsOf(content, turned, shown));
    for (const one of shown) one.fit();
    turning.stand(turning.angle);
  };
  const list = html("nav", { class: "tabs", role: "tablist" }, ...tabs);
  list.addEventListener("keydown", (event) => {
    const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    const now = tabs.findIndex((one) => one.tabIndex === 0);
    const next = (now + by + tabs.length) % tabs.length;
    choose(next);
    tabs[next]?.focus();
  });

  const toMind = html("div", {});
  const checked = html("div", {});
  const trusted = (found: PageTrust): void => {
    toMind.replaceChildren(...minded(found.to_mind));
    checked.replaceChildren(checks(found.checks, words.checks));
  };
  if (page.trust) trusted(page.trust);
  else void source?.trust().then((found) => { if (!ended.signal.aborted) trusted(found); });

  into.replaceChildren(
    html("header", { class: "head" }, html("h1", {}, page.name || page.made_of), ...(page.name ? [html("p", {}, page.made_of)] : [])),
    list,
    html(
      "div", { class: `columns ${mechanism.aspect > WIDE ? "wide" : ""}` },
      html(
        "section", { class: "drawing" },
        mechanism.element,
        html("div", { class: "turning-controls" }, play, step(-1, words.back), slider, step(1, words.on), reading),
        html("p", { class: "keys" }, words.keys),
        ...(page.drawing.left_out.length ? [html("p", { class: "note" }, `${words.left_out} ${page.drawing.left_out.join(", ")}`)] : []),
      ),
      html("section", { class: "left" }, left, checked),
      html("section", { class: "right" }, toMind, right),
    ),
  );
  dragged(mechanism, turning);
  document.addEventListener("keydown", (event) => { pressed(event, turning); }, { signal: ended.signal });
  const fit = (): void => { for (const one of shown) one.fit(); };
  let width = right.clientWidth;
  const room = new ResizeObserver(() => {
    if (right.clientWidth === width) return;
    width = right.clientWidth;
    fit();
  });
  room.observe(right);
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", fit, { signal: ended.signal });
  turning.stand(Number.isNaN(start.angle) ? 0 : start.angle);
  choose(chosen);
  if (Number.isNaN(start.angle) && !matchMedia("(prefers-reduced-motion: reduce)").matches) turning.play();
  return () => {
    turning.end();
    room.disconnect();
    ended.abort();
  };
}

/** What is to be minded: of a long list its head, and all of it where somebody asks. */
function minded(sentences: readonly string[]): HTMLElement[] {
  if (!sentences.length) return [];
  const items = sentences.map((sentence) => {
    const [head, ...rest] = sentence.split(": ");
    if (sentence.length < LONG || !rest.length) return html("li", {}, said(sentence));
    return html("li", {}, html("details", {}, html("summary", {}, said(head ?? ""), " …"), said(rest.join(": "))));
  });
  return [html("ul", { class: "to-mind" }, ...items)];
}

/** Keys turn the crank, unless somebody types. */
function pressed(event: KeyboardEvent, turning: Turning): void {
  const { target } = event;
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (target instanceof HTMLElement && (target.isContentEditable || /^(TEXTAREA|SELECT|SUMMARY)$/.test(target.tagName))) return;
  if (target instanceof HTMLInputElement && target.type !== "range") return;
  const by = event.shiftKey ? 10 : 1;
  if (event.key === "ArrowRight") turning.step(by);
  else if (event.key === "ArrowLeft") turning.step(-by);
  else if (event.key === "Home") turning.step(-turning.angle);
  else if (event.key === " " && !(target instanceof HTMLButtonElement)) turning.toggle();
  else return;
  event.preventDefault();
}

/** Dragging round the first shaft turns the crank. */
function dragged(mechanism: Mechanism, turning: Turning): void {
  const { element } = mechanism;
  let before = NaN;
  const direction = (event: PointerEvent): number => mechanism.directionOf(event.clientX, event.clientY);
  element.addEventListener("pointerdown", (event) => {
    turning.stop();
    element.setPointerCapture(event.pointerId);
    before = direction(event);
  });
  element.addEventListener("pointermove", (event) => {
    if (Number.isNaN(before)) return;
    const now = direction(event);
    const by = ((now - before + 540) % 360) - 180;
    before = now;
    turning.stand(turning.angle + by);
  });
  for (const end of ["pointerup", "pointercancel"]) element.addEventListener(end, () => { before = NaN; });
}

function sheetsOf(tab: TabContent, turned: (angle: number) => void, shown: Shown[]): HTMLElement[] {
  return tab.sheets.map((sheet) => {
    const columns = sheet.columns.filter((parts) => parts.length).map((parts) => html("div", { class: "column" }, ...parts.map((part) => drawn(part, turned, shown))));
    const heads = sheet.title ? [html("h2", {}, said(sheet.title))] : [];
    return html("section", { class: "sheet" }, ...heads, html("div", { class: `sheet-columns of-${columns.length}` }, ...columns));
  });
}

/** Draw a part of a sheet; what stands at the crank angle is among what is shown. */
function drawn(part: Part, turned: (angle: number) => void, shown: Shown[]): HTMLElement {
  switch (part.is) {
    case "PageCurves":
      return moving(curves(part, turned), shown);
    case "PagePolars":
      return moving(polars(part), shown);
    case "Bars":
      return bars(part);
    case "Stars":
      return stars(part);
    case "PageWear":
      return wear(part);
    case "ShaftShapes":
      return shapes(part);
    case "PageTable":
      return table(part);
    case "Notes":
      return html("div", { class: "notes" }, ...part.sentences.map((one) => html("p", {}, said(one))));
    case "Ruler":
      return ruler(part);
  }
}

function ruler(part: Ruler): HTMLElement {
  const marks = part.marks.map((mark) => {
    const words = `${mark.is_top ? "▼" : "▽"} ${mark.name} ${number(mark.angle).toFixed(2)}°`;
    return html("span", { title: mark.word }, words);
  });
  const beside = part.textbook ? [html("span", {}, lineSample("textbook"), " ", said(part.textbook))] : [];
  return html("p", { class: "ruler" }, html("b", {}, said(part.heading)), ...marks, ...beside);
}

function moving(one: Shown, shown: Shown[]): HTMLElement {
  shown.push(one);
  return one.element;
}
