// Loads of the machine file on its drawing: arrows as long as they are parts of the largest, with what holds them.

import type { LoadDrawing, Numbers } from "./data.ts";
import { svg } from "./elements.ts";
import type { Edges, Labels, Place } from "./labels.ts";
import { between, figures, number, row } from "./numbers.ts";
import { ARROW, LONG, type Placing } from "./placing.ts";
import { barbs, polyline, xy, type Point } from "./points.ts";

/** So far from its link's first pin what holds a force's point is drawn. */
const APART = 6;
/** How far over and under its arrow what is said of a load may stand, in turn. [px] */
const ROWS: readonly number[] = [-4, 14, -18, 28, -32];

/** Loads that are shown at a crank angle. */
export class DrawnLoads {
  private readonly moving: ((angle: number) => void)[] = [];
  private readonly placing: Placing;
  private readonly edges: Edges;
  private readonly labels: Labels;

  constructor(loads: readonly LoadDrawing[], placing: Placing, edges: Edges, labels: Labels, into: SVGGElement, under: SVGGElement) {
    this.placing = placing;
    this.edges = edges;
    this.labels = labels;
    for (const load of loads) this.load(load, into, under);
  }

  /** Show them at a crank angle. [deg] */
  show(angle: number): void {
    for (const move of this.moving) move(angle);
  }

  /** A load: an arrow as long as it is part of the largest. */
  private load(load: LoadDrawing, into: SVGGElement, under: SVGGElement): void {
    const largest = number(load.largest);
    if (!(largest > 0)) return;
    const arrow = svg("path", { class: "load" });
    const held = svg("path", { class: "held" });
    const label = svg("text", { class: "load" });
    under.append(held);
    into.append(arrow, label);
    const long = ARROW * LONG;
    this.moving.push((angle) => {
      const get = (values: Float32Array): number => between(values, this.placing.cycle, angle);
      const part = get(load.size.values) / largest;
      const isThere = Number.isFinite(part) && Math.abs(part) > 0.004;
      arrow.toggleAttribute("hidden", !isThere);
      label.toggleAttribute("hidden", !isThere);
      if (!load.is_torque) held.setAttribute("d", this.heldBy(load, angle));
      if (!isThere) return;
      label.textContent = `${load.name} ${figures((part * largest) / number(load.one), largest / number(load.one))} ${load.unit}`;
      const end = this.placing.point(get(row(load.place, 0)), get(row(load.place, 1)));
      if (load.is_torque) {
        const radius = 0.075 * LONG;
        const turn = -part * 1.5 * Math.PI;
        const [start, stop] = [-Math.PI / 2, -Math.PI / 2 + turn].map((one) => ({
          x: end.x + radius * Math.cos(one),
          y: end.y + radius * Math.sin(one),
        })) as [Point, Point];
        const isFar = Math.abs(turn) > Math.PI ? 1 : 0;
        const onward = -Math.PI / 2 + turn + (Math.sign(turn) * Math.PI) / 2;
        arrow.setAttribute("d", `M${xy(start)}A${radius} ${radius} 0 ${isFar} ${turn > 0 ? 1 : 0} ${xy(stop)}${barbs(stop, onward)}`);
        this.putBeside(label, { x: end.x, y: end.y - radius }, radius + 4);
        return;
      }
      const way = { x: get(row(load.way, 0)), y: -get(row(load.way, 1)) };
      const start = { x: end.x - way.x * part * long, y: end.y - way.y * part * long };
      arrow.setAttribute("d", `M${xy(start)}L${xy(end)}${barbs(end, Math.atan2(end.y - start.y, end.x - start.x))}`);
      this.putBeside(label, start, 5);
    });
  }

  /** What holds a force's point, away from the pins of its link: a line from its first pin, and of a rope the arc off which it comes, as a horsehead has it. */
  private heldBy(load: LoadDrawing, angle: number): string {
    const of = (numbers: Numbers): Point => this.placing.point(between(row(numbers, 0), this.placing.cycle, angle), between(row(numbers, 1), this.placing.cycle, angle));
    const [pin, end] = [of(load.pin), of(load.place)];
    const radius = Math.hypot(end.x - pin.x, end.y - pin.y);
    if (!(radius > APART)) return "";
    if (!load.is_rope) return polyline([pin, end]);
    const middle = Math.atan2(end.y - pin.y, end.x - pin.x);
    const half = Math.min((1.5 * ARROW * LONG) / radius, Math.PI / 2);
    const [from, to] = [middle - half, middle + half].map((one) => ({ x: pin.x + radius * Math.cos(one), y: pin.y + radius * Math.sin(one) })) as [Point, Point];
    return `${polyline([pin, end])}M${xy(from)}A${radius} ${radius} 0 0 1 ${xy(to)}`;
  }

  /** Put what is said of a load to the right or the left of a point, so far away, where there is room. */
  private putBeside(label: SVGTextElement, { x, y }: Point, far: number): void {
    const { left, right } = this.edges;
    const sides = [{ x: x + far, anchor: "start" }, { x: x - far, anchor: "end" }] as const;
    const inTurn = x - left > right - x ? [sides[1], sides[0]] : sides;
    const places = ROWS.flatMap((row) => inTurn.map((side): Place => ({ ...side, y: y + row * this.labels.pixel, isCentral: false })));
    const place = this.labels.put(label.textContent ?? "", places);
    if (!place) return;
    label.setAttribute("text-anchor", place.anchor);
    label.setAttribute("x", place.x.toFixed(2));
    label.setAttribute("y", place.y.toFixed(2));
  }
}
