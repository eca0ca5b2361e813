// Where a mechanism's pins are in the picture: to scale, with room for all that is drawn about them.

import type { MachineDrawing, MechanismDrawing, Numbers, OutputDrawing } from "./data.ts";
import { at, between, extent, number, row } from "./numbers.ts";
import { xy, type Point } from "./points.ts";
import { corners } from "./slider.ts";
import { NARROW, SCALE_ROOM } from "./vectors.ts";

/** Size of the picture, in its own units, along its longer side. */
export const LONG = 600;
const MARGIN = 26;
/** What reaches so many times as far as all else is broken, so that it ends at this part of their reach. */
const BREAK = 8;
const BROKEN = 0.8;

/** How far the ring of degrees and its figures reach, in parts of the crank's radius. */
const ABOUT_RING = 1.9;

/** Length of the arrow of the largest load in parts of the picture's longer side. */
export const ARROW = 0.16;

/** A length, in the units of the picture, that is none. */
export const LESS = 1e-9;

/** How a drawing lies: units of the picture for a metre, and its box. */
export interface View {
  readonly scale: number;
  readonly box: readonly [number, number, number, number];
}

/** Room about a drawing for what is added to it, in parts of its longer side. */
const ROOM = 0.25;

/** A view with room about what it shows. */
export function roomier({ scale, box: [left, top, width, height] }: View): View {
  const by = ROOM * Math.max(width, height);
  return { scale, box: [left - by, top - by, width + 2 * by, height + 2 * by] };
}

/** Where the pins of a drawing are. */
export class Placing {
  readonly view: View;
  /** Crank angle at which all begins again. [deg] */
  readonly cycle: number;
  private readonly drawing: MachineDrawing;
  private readonly shifts: ReadonlyMap<string, Point>;
  /** Where each pin goes that was asked for, which is asked again and again. */
  private readonly known = new Map<Numbers, { readonly x: Float32Array; readonly y: Float32Array; readonly shift: Point }>();

  constructor(drawing: MachineDrawing, held?: View) {
    this.drawing = drawing;
    this.cycle = at(drawing.crank_angle, drawing.crank_angle.values.length - 1);
    this.shifts = brokenShifts(drawing);
    this.view = held ?? this.fitting();
  }

  /** Units of the picture for a metre. */
  get scale(): number {
    return this.view.scale;
  }

  /** By how much a pin is drawn nearer to the shaft. [m] */
  shift(of: MechanismDrawing, name: string): Point {
    return this.shifts.get(`${of.name} ${name}`) ?? { x: 0, y: 0 };
  }

  /** Where a pin is at a crank angle. */
  pin(of: MechanismDrawing, name: string, angle: number): Point {
    const places = of.pins[name];
    if (!places) return { x: NaN, y: NaN };
    let known = this.known.get(places);
    if (!known) {
      known = { x: row(places, 0), y: row(places, 1), shift: this.shift(of, name) };
      this.known.set(places, known);
    }
    const { x, y, shift } = known;
    return this.point(between(x, this.cycle, angle) + shift.x, between(y, this.cycle, angle) + shift.y);
  }

  /** Where a pin of one of its mechanisms is. */
  pinOf(one: { readonly mechanism: string; readonly pin: string }, angle: number): Point {
    const of = this.drawing.mechanisms.find((other) => other.name === one.mechanism);
    return of ? this.pin(of, one.pin, angle) : { x: NaN, y: NaN };
  }

  /** Where a point of the machine is in the picture. [m] */
  point(x: number, y: number): Point {
    return { x: x * this.scale, y: -y * this.scale };
  }

  /** The line of a slider: axes along it, the foot at 0, and how far along it a point is. */
  lineOf(of: MechanismDrawing, output: OutputDrawing): { frame: string; along: (pin: Point) => number } {
    const shift = this.shift(of, output.pin);
    const foot = this.point(at(output.foot, 0) + shift.x, at(output.foot, 1) + shift.y);
    const [x, y] = [at(output.along, 0), -at(output.along, 1)];
    return { frame: `matrix(${x} ${y} ${-y} ${x} ${xy(foot)})`, along: (pin) => (pin.x - foot.x) * x + (pin.y - foot.y) * y };
  }

  private fitting(): View {
    const bounds = this.bounds();
    const width = bounds.right - bounds.left;
    const height = bounds.top - bounds.bottom;
    const scale = (LONG - 2 * MARGIN) / Math.max(width, height, LESS);
    const across = width * scale + 2 * MARGIN;
    const strip = across < NARROW ? SCALE_ROOM : 0;
    return { scale, box: [bounds.left * scale - MARGIN, -bounds.top * scale - MARGIN, across, height * scale + 2 * MARGIN + strip] };
  }

  /** Edges of all that is drawn. [m] */
  private bounds(): { left: number; right: number; bottom: number; top: number } {
    const x: number[] = [];
    const y: number[] = [];
    for (const one of this.drawing.mechanisms) {
      for (const [name, places] of Object.entries(one.pins)) {
        const shift = this.shift(one, name);
        x.push(...Array.from(row(places, 0), (value) => value + shift.x));
        y.push(...Array.from(row(places, 1), (value) => value + shift.y));
      }
      const [shaft, crank] = (one.links[0]?.pins ?? []).map((name) => one.pins[name]);
      if (shaft && crank) {
        const [left, up] = first(shaft);
        const [across, high] = first(crank);
        const reach = ABOUT_RING * Math.hypot(across - left, high - up);
        if (Number.isFinite(reach)) {
          x.push(left - reach, left + reach);
          y.push(up - reach, up + reach);
        }
      }
      if (one.output) {
        for (const corner of corners(one.output, this.shift(one, one.output.pin))) {
          x.push(corner.x);
          y.push(corner.y);
        }
      }
    }
    // A load may act beyond all pins, as that of a horsehead; at what is drawn shorter it would be far away.
    if (this.shifts.size === 0) {
      const long = ARROW * Math.max(...[x, y].map(extent).map(([low, high]) => high - low));
      for (const load of this.drawing.loads) {
        load.size.values.forEach((size, which) => {
          const back = load.is_torque ? 0 : (long * size) / (number(load.largest) || 1);
          const [across, up] = [0, 1].map((axis) => (row(load.place, axis)[which] ?? NaN) - back * (row(load.way, axis)[which] ?? 0)) as [number, number];
          if (Number.isFinite(across) && Number.isFinite(up)) {
            x.push(across);
            y.push(up);
          }
        });
      }
    }
    const [left, right] = extent(x);
    const [bottom, top] = extent(y);
    return Number.isFinite(left) ? { left, right, bottom, top } : { left: -1, right: 1, bottom: -1, top: 1 };
  }
}

/** By how much pins are drawn nearer to the shaft that reach much farther than all else: by mechanism and pin. [m] */
function brokenShifts(drawing: MachineDrawing): ReadonlyMap<string, Point> {
  const reach = (of: MechanismDrawing): number =>
    Math.max(0, ...Object.values(of.pins).map((pin) => Math.max(...extent(pin.values.map(Math.abs)))).filter(Number.isFinite));
  const all = drawing.mechanisms.map(reach);
  const shifts = new Map<string, Point>();
  drawing.mechanisms.forEach((one, place) => {
    const own = all[place] ?? 0;
    const others = Math.max(0, ...all.filter((value) => BREAK * value < own));
    if (!one.output || others === 0) return;
    const by = own - BROKEN * others;
    const pins = one.links.flatMap((link) => link.pins).filter((name) => Math.max(...extent((one.pins[name]?.values ?? new Float32Array()).map(Math.abs))) > BREAK * others);
    for (const name of pins) shifts.set(`${one.name} ${name}`, { x: -by * at(one.output.along, 0), y: -by * at(one.output.along, 1) });
  });
  return shifts;
}

/** Where a pin is at first. [m] */
const first = (pin: Numbers): readonly [number, number] => [row(pin, 0)[0] ?? NaN, row(pin, 1)[0] ?? NaN];
