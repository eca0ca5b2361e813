// What happens in time: over the curves, and in a list whose lines lead to their moments.

import type { Shown } from "./curves.ts";
import type { EventStrip, PageEvent, PageEvents } from "./data.ts";
import { html } from "./elements.ts";
import { number } from "./numbers.ts";

/** Width of a letter in a name over the curves. [px] */
const LETTER = 6.3;

type Turned = (time: number) => void;

/** List events: what is over stands in ink, what is to come is muted. */
export function events(part: PageEvents, turned: Turned): Shown {
  const lines = part.events.map((one) => {
    const time = html("button", { type: "button" }, one.time);
    time.addEventListener("click", () => { turned(number(one.at)); });
    return html("tr", {}, html("td", { class: "number" }, one.number ? `${one.number}` : ""), html("td", { class: "number" }, time), html("th", { scope: "row" }, one.name), html("td", { class: "number" }, one.angle), html("td", { class: "number" }, one.speed));
  });
  const element = html("div", { class: "table events" }, html("h3", {}, part.title), html("table", {}, html("tbody", {}, ...lines)));
  return { element, show: (time) => { pass(lines, part.events, time); }, fit: () => undefined };
}

/**
 * Show events over curves: rare ones with their numbers, and their names where there is room; a stroke for all others.
 * They are for whoever points at them; keys and touch have the list, and the slider.
 */
export function strip(part: EventStrip, turned: Turned): Shown {
  const end = number(part.end);
  const names = part.events.map((one) => (one.number ? `${one.number} ${one.name}` : ""));
  const marks = part.events.map((one, place) => {
    const mark = html("span", { title: `${one.time}  ${one.name}, ${one.angle}, ${one.speed}`, class: one.number ? "rare" : "" });
    mark.style.left = `${(100 * number(one.at)) / end}%`;
    mark.textContent = names[place] ?? "";
    mark.addEventListener("click", () => { turned(number(one.at)); });
    return mark;
  });
  const element = html("div", { class: "strip", "aria-hidden": "true" }, ...marks);
  const fit = (): void => {
    const rare = part.events.map((one, place) => ({ at: (number(one.at) / end) * element.clientWidth, place })).filter(({ place }) => names[place]);
    rare.forEach(({ at, place }, k) => {
      const mark = marks[place];
      const name = names[place] ?? "";
      const room = (rare[k + 1]?.at ?? element.clientWidth) - at;
      if (mark) mark.textContent = name.length * LETTER < room ? name : `${part.events[place]?.number ?? ""}`;
    });
  };
  return { element, show: (time) => { pass(marks, part.events, time); }, fit };
}

/** Tell what is over from what is to come. */
function pass(elements: readonly HTMLElement[], all: readonly PageEvent[], time: number): void {
  elements.forEach((one, place) => { one.classList.toggle("to-come", number(all[place]?.at) > time); });
}
