// Which piston's throw and curves are shown: chosen in the order of firing, or on a star of the throws.

import type { PagePiston, PageThrow, PageWords } from "./data.ts";
import { html, picture, svg } from "./elements.ts";
import { number, same } from "./numbers.ts";

/** Length of a ray, and where its name begins; in the units of a star of this size. */
const WIDTH = 104;
const HEIGHT = 82;
const RAY = 24;
const NAME = 33;
/** From which part of a ray's length across on its name stands beside its end, and not over or under it. */
const BESIDE = 0.4;
/** Names of throws that stand at one ray. */
const BETWEEN = ", ";

export class Throws {
  private readonly stars = html("div", { class: "stars" });
  private readonly list = html("div", { class: "pistons", role: "radiogroup" });
  readonly element = html("div", { class: "throws" }, this.stars, this.list);
  private readonly pick: (piston: string) => void;
  private of: unknown = null;
  private pistons: readonly PagePiston[] = [];
  private shown = "";

  constructor(pick: (piston: string) => void) {
    this.pick = pick;
    this.list.addEventListener("change", (event) => { if (event.target instanceof HTMLInputElement) this.pick(event.target.value); });
    this.list.addEventListener("keydown", (event) => {
      if (event.key !== "Home" && event.key !== "End") return;
      event.preventDefault();
      this.go(event.key === "Home" ? 0 : -1);
    });
  }

  /** Choose a piston by its place in the list, as arrow keys do. */
  private go(place: number): void {
    const input = [...this.list.querySelectorAll("input")].at(place);
    if (!input) return;
    input.focus();
    if (input.checked) return;
    input.checked = true;
    this.pick(input.value);
  }

  /** Offer pistons, of which one is shown; what is offered already stays. */
  take(pistons: readonly PagePiston[], throws: readonly PageThrow[], words: PageWords, shown: string): void {
    const of = [pistons, throws, words.pistons, words.throws];
    const isNew = !same(this.of, of);
    const isOther = isNew || this.shown !== shown;
    this.pistons = pistons;
    this.shown = shown;
    this.list.setAttribute("aria-label", words.pistons);
    if (isNew) {
      this.of = of;
      this.list.replaceChildren(...pistons.map(choice));
      const shafts = [...new Set(throws.map((one) => one.shaft))];
      this.stars.replaceChildren(...shafts.map((shaft) => this.star(throws.filter((one) => one.shaft === shaft), words.throws)));
    }
    for (const one of this.list.querySelectorAll("input")) {
      one.checked = one.value === shown;
      if (one.checked && isOther) this.reveal(one.parentElement as HTMLElement);
    }
    const on = pistons.find((one) => one.name === shown);
    for (const ray of this.stars.querySelectorAll("g")) ray.classList.toggle("chosen", on !== undefined && names(ray).includes(keyOf(on.shaft, on.throw)));
  }

  /** The throws of a shaft: a click chooses one, another the next piston on it. */
  private star(throws: readonly PageThrow[], title: string): SVGSVGElement {
    const rays = new Map<string, PageThrow[]>();
    for (const one of throws) {
      const turned = Math.round((number(one.direction) * 180) / Math.PI + 360) % 360;
      rays.set(`${turned}`, [...(rays.get(`${turned}`) ?? []), one]);
    }
    const drawn = picture("crank-star", [-WIDTH / 2, -HEIGHT / 2, WIDTH, HEIGHT], svg("title", {}, title), svg("circle", { class: "ring", r: RAY }));
    for (const own of rays.values()) {
      const direction = number(own[0]?.direction);
      const [x, y] = [Math.cos(direction), -Math.sin(direction)];
      const ray = svg(
        "g", { "data-throws": own.map((one) => keyOf(one.shaft, one.number)).join(" ") },
        svg("line", { x2: RAY * x, y2: RAY * y }), svg("circle", { class: "tip", cx: RAY * x, cy: RAY * y, r: 3 }),
        svg("text", { x: NAME * x, y: NAME * y, "text-anchor": x > BESIDE ? "start" : x < -BESIDE ? "end" : "middle" }, own.map((one) => one.number).join(BETWEEN)), svg("circle", { class: "target", cx: RAY * x, cy: RAY * y, r: 13 }),
      );
      ray.addEventListener("click", () => { this.next(names(ray)); });
      drawn.append(ray);
    }
    return drawn;
  }

  /** Scroll the list, and nothing else, so far that one is seen. */
  private reveal(one: HTMLElement): void {
    const { list } = this;
    const below = one.offsetTop + one.offsetHeight - list.clientHeight;
    if (one.offsetTop < list.scrollTop) list.scrollTop = one.offsetTop;
    else if (below > list.scrollTop) list.scrollTop = below;
  }

  private next(throws: readonly string[]): void {
    const on = this.pistons.filter((one) => throws.includes(keyOf(one.shaft, one.throw)));
    const next = on[(on.findIndex((one) => one.name === this.shown) + 1) % on.length];
    if (next) this.pick(next.name);
  }
}

const keyOf = (shaft: string, throw_: number): string => `${encodeURIComponent(shaft)}/${throw_}`;

const names = (ray: SVGElement): string[] => (ray.getAttribute("data-throws") ?? "").split(" ");

/** A piston, before it the maker's number, and when it fires. */
function choice(piston: PagePiston): HTMLElement {
  const input = html("input", { type: "radio", name: "piston", value: piston.name });
  const called = piston.number && piston.number !== piston.name ? `${piston.number} · ${piston.name}` : piston.name;
  return html("label", {}, input, html("b", {}, called), ...(piston.firing ? [" ", html("span", {}, piston.firing)] : []));
}
