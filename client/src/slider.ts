// What slides: a piston in its cylinder, a crosshead, a ram, a block on a guide, in axes along its line.

import type { OutputDrawing } from "./data.ts";
import { svg } from "./elements.ts";
import { at, extent, number } from "./numbers.ts";
import type { Point } from "./points.ts";

/** Crown above and skirt below a piston's pin, and room above it, in parts of the bore. */
const CROWN = 0.45;
const SKIRT = 0.38;
const CLEARANCE = 0.02;

/** A slider as it is: a piston in its cylinder, a crosshead with piston rod and piston, a ram, a block on a guide. */
export class Slider {
  private readonly of: OutputDrawing;
  private readonly scale: number;
  private readonly isShared: boolean;
  private readonly travel: readonly [number, number];
  private readonly bore: number | null;
  private readonly toward: 1 | -1;

  constructor(of: OutputDrawing, scale: number, isShared: boolean) {
    this.of = of;
    this.scale = scale;
    this.isShared = isShared;
    this.travel = [at(of.travel, 0) * scale, at(of.travel, 1) * scale];
    this.bore = of.bore === null || of.is_valve ? null : of.bore * scale;
    this.toward = of.is_far ? -1 : 1;
  }

  get hasGas(): boolean {
    return this.bore !== null && !this.of.crosshead && !this.isShared;
  }

  /** Where the head's inner face is. */
  private get head(): number {
    const bore = this.bore ?? 0;
    return this.toward > 0 ? this.travel[1] + (CROWN + CLEARANCE) * bore : this.travel[0] - (CROWN + CLEARANCE) * bore;
  }

  still(): SVGElement[] {
    const { of, scale, travel, bore } = this;
    if (of.ram) {
      const half = (number(of.ram.width) * scale) / 2;
      const bed = number(of.ram.bed) * scale;
      const back = number(of.ram.back) * scale;
      const [start, end] = [travel[0] - back, travel[1] - 0.4 * back];
      return [wall(start, end, half + 2, -1), wall(start, end, half + 2, 1), svg("path", { class: "bed", d: `M${bed} ${-2.2 * half}V${2.2 * half}` })];
    }
    if (of.crosshead && bore !== null) {
      const [near, far] = [at(of.crosshead.covers, 0) * scale, at(of.crosshead.covers, 1) * scale];
      const gland = number(of.crosshead.gland) * scale;
      const rod = (number(of.crosshead.rod_diameter) * scale) / 2;
      const [start, end] = [at(of.crosshead.bars, 0) * scale, at(of.crosshead.bars, 1) * scale];
      const half = (at(of.crosshead.shoe, 1) * scale) / 2;
      return [
        wall(start, end, half, -1),
        wall(start, end, half, 1),
        svg("path", {
          class: "cover",
          d: `M${far} ${-bore / 2}V${bore / 2}M${near} ${-bore / 2}V${-rod - 1}M${near} ${rod + 1}V${bore / 2}M${gland} ${-2.2 * rod}H${near}M${gland} ${2.2 * rod}H${near}`,
        }),
        wall(near, far, bore / 2, -1),
        wall(near, far, bore / 2, 1),
      ];
    }
    if (bore !== null) {
      const head = this.head;
      const open = this.toward > 0 ? travel[0] - SKIRT * bore : travel[1] + SKIRT * bore;
      const walls = [wall(open, head, bore / 2, -1), wall(open, head, bore / 2, 1)];
      return this.isShared ? walls : [...walls, svg("path", { class: "cover", d: `M${head} ${-bore / 2}V${bore / 2}` })];
    }
    const half = 10;
    return [wall(travel[0] - 20, travel[1] + 20, half, -1), wall(travel[0] - 20, travel[1] + 20, half, 1)];
  }

  moving(): SVGElement[] {
    const { of, scale, bore, toward } = this;
    if (of.ram) {
      const half = (number(of.ram.width) * scale) / 2;
      const [back, face] = [number(of.ram.back) * scale, number(of.ram.face) * scale];
      return [svg("rect", { class: "piston", x: -back, y: -half, width: back + face, height: 2 * half })];
    }
    if (of.crosshead && bore !== null) {
      const length = number(of.crosshead.rod_length) * scale;
      const thick = number(of.crosshead.piston) * scale;
      const rod = (number(of.crosshead.rod_diameter) * scale) / 2;
      const [shoe, height] = [at(of.crosshead.shoe, 0) * scale, at(of.crosshead.shoe, 1) * scale];
      return [
        svg("rect", { class: "piston", x: 0, y: -rod, width: length, height: 2 * rod }),
        svg("rect", { class: "piston", x: -shoe / 2, y: -height / 2, width: shoe, height }),
        svg("rect", { class: "piston", x: length - thick / 2, y: -bore / 2, width: thick, height: bore }),
      ];
    }
    if (bore !== null) {
      const [low, high] = toward > 0 ? [-SKIRT * bore, CROWN * bore] : [-CROWN * bore, SKIRT * bore];
      const rings = [0.06, 0.12, 0.18].map((one) => toward * (CROWN - one) * bore);
      return [
        svg("rect", { class: "piston", x: low, y: -bore / 2, width: high - low, height: bore }),
        svg("path", { class: "piston-rings", d: rings.map((one) => `M${one} ${-bore / 2}V${bore / 2}`).join("") }),
      ];
    }
    return [svg("rect", { class: "block", x: -14, y: -9, width: 28, height: 18, rx: 1.5 })];
  }

  /** Set the room of the gas with the piston's pin at a place. */
  fill(gas: SVGRectElement, along: number): void {
    if (!this.hasGas || this.bore === null) return;
    const crown = along + this.toward * CROWN * this.bore;
    const [low, high] = extent([crown, this.head]);
    gas.setAttribute("x", low.toFixed(2));
    gas.setAttribute("width", Math.max(0, high - low).toFixed(2));
    gas.setAttribute("y", `${-this.bore / 2}`);
    gas.setAttribute("height", `${this.bore}`);
  }
}

/** A wall along the line, hatched on its outer side. */
function wall(from: number, to: number, half: number, side: 1 | -1): SVGPathElement {
  const [low, high] = extent([from, to]);
  let d = `M${low} ${side * half}H${high}`;
  for (let x = low + 4; x <= high; x += 7) d += `M${x.toFixed(1)} ${side * half}l-4 ${side * 5}`;
  return svg("path", { class: "wall", d });
}

/** Corners of what a slider needs. [m] */
export function corners(output: OutputDrawing, shift: Point): Point[] {
  if (output.is_valve && output.bore === null && !output.ram) return [];
  const bore = output.bore ?? output.ram?.width ?? 0;
  const ends = [at(output.travel, 0), at(output.travel, 1) + (CROWN + CLEARANCE) * (output.bore ?? 0)];
  if (output.crosshead) ends.push(at(output.crosshead.covers, 1), at(output.crosshead.covers, 0));
  if (output.ram) ends.push(number(output.ram.bed), at(output.travel, 0) - number(output.ram.back));
  if (output.is_far) ends.push(at(output.travel, 0) - (CROWN + CLEARANCE) * (output.bore ?? 0));
  const [x, y] = [at(output.along, 0), at(output.along, 1)];
  return ends.flatMap((end) =>
    [-0.56, 0.56].map((side) => ({
      x: at(output.foot, 0) + shift.x + end * x - side * bore * y,
      y: at(output.foot, 1) + shift.y + end * y + side * bore * x,
    })),
  );
}
