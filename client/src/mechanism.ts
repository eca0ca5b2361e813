// A mechanism to scale: what stands still is drawn once, what moves is turned and shifted.

import type { DrawnHandle, LinkDrawing, LoadDrawing, MachineDrawing, MechanismDrawing, Numbers, OutputDrawing, PinVector, VectorsToScale } from "./data.ts";
import { picture, svg } from "./elements.ts";
import { at, between, extent, figures, number, row } from "./numbers.ts";
import { barbs, polyline, xy, type Point } from "./points.ts";
import { Labels, type Edges, type Place } from "./labels.ts";
import { DrawnVectors, NARROW, SCALE_ROW } from "./vectors.ts";

/** Size of the picture, in its own units, along its longer side. */
const LONG = 600;
const MARGIN = 26;
/** Radii of a rod's eyes in parts of the crank radius; and of pins where links are lines. */
const BIG_EYE = 0.4;
const SMALL_EYE = 0.22;
/** What reaches so many times as far as all else is broken, so that it ends at this part of their reach. */
const BREAK = 8;
const BROKEN = 0.8;
/** Crown above and skirt below a piston's pin, and room above it, in parts of the bore. */
const CROWN = 0.45;
const SKIRT = 0.38;
const CLEARANCE = 0.02;

/** Radius of the ring of degrees in parts of the crank's, and how far it and its figures reach. */
const RING = 1.6;
const ABOUT_RING = 1.9;

/** Of a pin that may be moved, and room for it where it stands beyond the drawing. */
const RING_OF_HANDLE = 10;
const ROOM_OF_HANDLE = 16;

/** From where to where the arrow of turning goes along the ring, from its zero. [rad] */
const TURNING = [2.2, 2.9] as const;

/** Length of the arrow of the largest load in parts of the picture's longer side. */
const ARROW = 0.16;
/** So far from its link's first pin what holds a force's point is drawn. */
const APART = 6;
/** How far over and under its arrow what is said of a load may stand, in turn. [px] */
const ROWS: readonly number[] = [-4, 14, -18, 28, -32];

const LESS = 1e-9;

/** Where in the cycle it is seen whether two things are one, in parts of it. */
const SAMPLES: readonly number[] = [0.1, 0.37, 0.71];

/** What moves: shown at the crank angles of the drawing, or between them. */
type Moving = (angle: number) => void;

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

/** A machine's drawing, which is shown at a crank angle. */
export class Mechanism {
  readonly element: SVGSVGElement;
  /** Crank angle at which all begins again. [deg] */
  readonly cycle: number;
  private readonly drawing: MachineDrawing;
  private readonly moving: Moving[] = [];
  private readonly edges: Edges;
  private readonly labels: Labels;
  private readonly ghosts = svg("g", { class: "ghost" });
  private readonly old = svg("g", { class: "ghost old" });
  private readonly layer = svg("g", {});
  private readonly held = svg("g", {});
  private readonly marks = svg("g", { class: "marks" });
  private rings: { readonly ring: SVGElement; readonly axis: SVGElement; readonly one: DrawnHandle }[] = [];
  private vectors: DrawnVectors | null = null;
  private shown = 0;
  private readonly fitted: View;
  private readonly scale: number;
  private readonly shifts: ReadonlyMap<string, Point>;

  constructor(drawing: MachineDrawing, label: string, held?: View) {
    this.drawing = drawing;
    this.cycle = at(drawing.crank_angle, drawing.crank_angle.values.length - 1);
    this.shifts = brokenShifts(drawing);
    this.fitted = held ?? this.fitting();
    const { box, scale } = this.fitted;
    this.scale = scale;
    this.element = picture("mechanism", box, svg("title", {}, label));
    this.edges = { left: box[0], right: box[0] + box[2], top: box[1], bottom: box[1] + box[3] };
    this.labels = new Labels(this.edges, () => this.pixel);
    const layer = (): SVGGElement => this.element.appendChild(svg("g"));
    this.element.append(this.ghosts, this.old);
    const [still, paths, bodies, links, standing, pins, loads] = [layer(), layer(), layer(), layer(), layer(), layer(), layer()];
    for (const shaft of drawing.shafts) this.ring(shaft.name, still);
    for (const one of drawing.mechanisms) {
      this.path(one, paths);
      if (one.output) this.output(one, one.output, still, bodies);
      for (const slider of this.otherSliders(one)) this.output(one, slider, still, bodies);
      this.standing(one, standing);
      this.blocks(one, bodies);
      this.joints(one, pins);
    }
    for (const { of, link } of this.ownLinks().reverse()) this.link(of, link, links);
    for (const load of drawing.loads) this.load(load, loads, paths);
    this.scaleBar(box, still);
    this.element.append(this.layer, this.marks, this.held);
    this.show(0);
    // Words are as large as the window has them: in another size they stand elsewhere.
    new ResizeObserver(() => { this.show(this.shown); }).observe(this.element);
  }

  /** How it lies, with what stands beyond it now. */
  get view(): View {
    const { x, y, width, height } = this.element.viewBox.baseVal;
    return { scale: this.scale, box: [x, y, width, height] };
  }

  private fitting(): View {
    const bounds = this.bounds();
    const width = bounds.right - bounds.left;
    const height = bounds.top - bounds.bottom;
    const scale = (LONG - 2 * MARGIN) / Math.max(width, height, LESS);
    const across = width * scale + 2 * MARGIN;
    const strip = across < NARROW ? SCALE_ROW : 0;
    return { scale, box: [bounds.left * scale - MARGIN, -bounds.top * scale - MARGIN, across, height * scale + 2 * MARGIN + strip] };
  }

  /** Show it at a crank angle. [deg] */
  show(angle: number): void {
    const place = ((angle % this.cycle) + this.cycle) % this.cycle;
    this.labels.begin();
    for (const move of this.moving) move(place);
    this.vectors?.show(place);
    this.showRings(place);
    this.shown = place;
  }

  /** Show thin ghosts of it at some crank angles, and no others. [deg] */
  showGhosts(angles: Iterable<number>): void {
    this.ghosts.replaceChildren(...Array.from(angles).flatMap((angle) => this.ghost(angle)));
  }

  /** Draw a ghost of it at a crank angle. [deg] */
  ghost(angle: number): SVGElement[] {
    const bars = this.ownLinks().map(({ of, link }) => {
      const d = polyline(link.pins.map((name) => this.pin(of, name, angle)));
      return svg("path", { d });
    });
    const sliders = this.drawing.mechanisms.flatMap((of) => {
      if (!of.output) return [];
      const line = this.lineOf(of, of.output);
      const along = line.along(this.pin(of, of.output.pin, angle));
      const moved = svg("g", { transform: `translate(${along.toFixed(2)} 0)` }, ...this.slider(of, of.output).moving());
      return Number.isFinite(along) ? [svg("g", { transform: line.frame }, moved)] : [];
    });
    return [...bars.filter((one) => !one.getAttribute("d")?.includes("NaN")), ...sliders];
  }

  /** Show a ghost of what it was. */
  showOld(old: readonly SVGElement[]): void {
    this.old.replaceChildren(...old);
  }

  /** Show rings on pins that may be moved, and no others. */
  showHandles(handles: readonly DrawnHandle[]): void {
    this.rings = handles.map((one, place) => {
      const ring = svg("circle", { class: "handle", r: RING_OF_HANDLE, "data-place": place }, svg("title", {}, `${one.mechanism} ${one.pin}`));
      return { ring, axis: svg("path", { class: "handle-axis" }), one };
    });
    this.held.replaceChildren(...this.rings.map(({ axis }) => axis), ...this.rings.map(({ ring }) => ring));
    this.makeRoom(handles.filter((one) => one.at).map((one) => this.placeOf(one, 0)));
    this.showRings(this.shown);
  }

  /** Show as much more than the drawing as rings beyond it need. */
  private makeRoom(beyond: readonly Point[]): void {
    const [left, top, width, height] = this.fitted.box;
    const about = (of: (place: Point) => number): number[] => beyond.map(of).filter(Number.isFinite).flatMap((one) => [one - ROOM_OF_HANDLE, one + ROOM_OF_HANDLE]);
    const [west, east] = extent([left, left + width, ...about(({ x }) => x)]);
    const [north, south] = extent([top, top + height, ...about(({ y }) => y)]);
    this.element.setAttribute("viewBox", [west, north, east - west, south - north].map((one) => +one.toFixed(2)).join(" "));
  }

  private showRings(angle: number): void {
    for (const { ring, axis, one } of this.rings) {
      const place = this.placeOf(one, angle);
      ring.toggleAttribute("hidden", !Number.isFinite(place.x));
      if (Number.isFinite(place.x)) ring.setAttribute("transform", `translate(${xy(place)})`);
      // A guide's end stands off what slides in it: a line shows whose it is.
      const slides = this.pinOf({ mechanism: one.mechanism, pin: one.slides }, angle);
      axis.setAttribute("d", Number.isFinite(place.x + slides.x) ? polyline([slides, place]) : "");
    }
  }

  /** Where a pin is that may be moved, or what else may. */
  placeOf(one: DrawnHandle, angle: number): Point {
    return one.at ? this.point(at(one.at, 0), at(one.at, 1)) : this.pinOf(one, angle);
  }

  /** Mark what is about to be added, and nothing else. */
  mark(marks: readonly SVGElement[]): void {
    this.marks.replaceChildren(...marks);
  }

  /** Where a pin of one of its mechanisms is. */
  pinOf(one: { readonly mechanism: string; readonly pin: string }, angle: number): Point {
    const of = this.drawing.mechanisms.find((other) => other.name === one.mechanism);
    return of ? this.pin(of, one.pin, angle) : { x: NaN, y: NaN };
  }

  /** Where a point of the window is in the picture. */
  place(x: number, y: number): Point {
    const inverse = this.element.getScreenCTM()?.inverse();
    return inverse ? new DOMPoint(x, y).matrixTransform(inverse) : { x: NaN, y: NaN };
  }

  /** Where a point of the picture is on the window. */
  onWindow(point: Point): Point {
    const matrix = this.element.getScreenCTM();
    return matrix ? new DOMPoint(point.x, point.y).matrixTransform(matrix) : { x: NaN, y: NaN };
  }

  /** A point or a distance in the picture as one of the machine: to the right and up. [m] */
  inMetres(by: Point): Point {
    return { x: by.x / this.scale, y: -by.y / this.scale };
  }

  /** Show vectors, and no others. */
  showVectors(sorts: readonly VectorsToScale[]): void {
    const pin = (one: PinVector, angle: number): Point => this.pinOf(one, angle);
    this.vectors = new DrawnVectors(sorts, pin, this.cycle, this.edges, this.labels);
    this.layer.replaceChildren(...this.vectors.elements);
    this.show(this.shown);
  }

  /** What a pixel of the window is in the picture. */
  private get pixel(): number {
    return parseFloat(this.element.style.getPropertyValue("--pixel")) || 1;
  }

  /** Width in parts of the height. */
  get aspect(): number {
    const { width, height } = this.element.viewBox.baseVal;
    return width / height;
  }

  /** Crank angle toward which a point of the window lies from the first shaft. [deg] */
  directionOf(x: number, y: number): number {
    const shaft = this.drawing.shafts[0];
    if (!shaft) return NaN;
    const point = this.place(x, y);
    const centre = this.point(at(shaft.centre, 0), at(shaft.centre, 1));
    return (number(shaft.sense) * Math.atan2(centre.y - point.y, point.x - centre.x) * 180) / Math.PI;
  }

  /** Where a pin is at a crank angle. */
  pin(of: MechanismDrawing, name: string, angle: number): Point {
    const places = of.pins[name];
    if (!places) return { x: NaN, y: NaN };
    const shift = this.shifts.get(`${of.name} ${name}`) ?? { x: 0, y: 0 };
    return this.point(
      between(row(places, 0), this.cycle, angle) + shift.x,
      between(row(places, 1), this.cycle, angle) + shift.y,
    );
  }

  /** Where a point of the machine is in the picture. [m] */
  point(x: number, y: number): Point {
    return { x: x * this.scale, y: -y * this.scale };
  }

  /** Radius of a mechanism's crank, in the units of the picture. */
  private crank(of: MechanismDrawing): number {
    const pins = of.links.find((one) => one.is_crank)?.pins ?? [];
    const [start, end] = pins.map((name) => this.pin(of, name, 0));
    return start && end ? Math.hypot(end.x - start.x, end.y - start.y) : 0;
  }

  /** Radius of the first mechanism's crank, by which eyes and pins are drawn. */
  private get leading(): number {
    const first = this.drawing.mechanisms[0];
    const crank = first ? this.crank(first) : 0;
    return Math.min(Math.max(crank, 0.055 * LONG), 0.2 * LONG);
  }

  /** Edges of all that is drawn. [m] */
  private bounds(): { left: number; right: number; bottom: number; top: number } {
    const x: number[] = [];
    const y: number[] = [];
    for (const one of this.drawing.mechanisms) {
      for (const [name, places] of Object.entries(one.pins)) {
        const shift = this.shifts.get(`${one.name} ${name}`) ?? { x: 0, y: 0 };
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
        for (const corner of corners(one.output, this.shifts.get(`${one.name} ${one.output.pin}`))) {
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

  /** Degrees of the crank round a shaft, 0 where the first crank on it stands at first, and the sense of turning. */
  private ring(name: string, into: SVGGElement): void {
    const shaft = this.drawing.shafts.find((one) => one.name === name);
    const own = this.drawing.mechanisms.find((one) => one.shaft === name);
    if (!shaft || !own) return;
    const centre = this.point(at(shaft.centre, 0), at(shaft.centre, 1));
    const radius = Math.max(this.crank(own) * RING, 16);
    const sense = number(shaft.sense);
    const zero = number(own.crank_zero);
    into.append(svg("circle", { class: "ring", cx: centre.x, cy: centre.y, r: radius }));
    for (let degree = 0; degree < 360; degree += 30) {
      const direction = zero + sense * (degree * Math.PI) / 180;
      const [x, y] = [Math.cos(direction), -Math.sin(direction)];
      const from = degree % 90 ? 0.97 : 0.93;
      into.append(
        svg("line", {
          class: "ring",
          x1: centre.x + from * radius * x,
          y1: centre.y + from * radius * y,
          x2: centre.x + radius * x,
          y2: centre.y + radius * y,
        }),
      );
      if (degree % 90 === 0 && radius > 40) {
        const place = radius + 11;
        const [across, down] = [centre.x + place * x, centre.y + place * y];
        this.labels.keepClear(`${degree}`, { x: across, y: down, anchor: "middle", isCentral: true });
        into.append(svg("text", { class: degree ? "degree" : "degree zero", x: across, y: down }, `${degree}`));
      }
    }
    const [from, to] = TURNING.map((part) => zero + sense * part) as [number, number];
    const on = (direction: number): Point => ({
      x: centre.x + radius * Math.cos(direction),
      y: centre.y - radius * Math.sin(direction),
    });
    const sweep = sense > 0 ? 0 : 1;
    const arc = `M${xy(on(from))}A${radius} ${radius} 0 0 ${sweep} ${xy(on(to))}`;
    into.append(svg("path", { class: "turning", d: arc + barbs(on(to), -(to + (sense * Math.PI) / 2)) }));
  }

  /** Where pins go. */
  private path(of: MechanismDrawing, into: SVGGElement): void {
    for (const [name, places] of Object.entries(of.paths)) {
      const shift = this.shifts.get(`${of.name} ${name}`) ?? { x: 0, y: 0 };
      const [x, y] = [row(places, 0), row(places, 1)];
      let d = "";
      let isDown = false;
      x.forEach((one, place) => {
        const point = this.point(one + shift.x, (y[place] ?? NaN) + shift.y);
        if (Number.isFinite(point.x) && Number.isFinite(point.y)) d += `${isDown ? "L" : "M"}${xy(point)}`;
        isDown = Number.isFinite(point.x);
      });
      if (d) into.append(svg("path", { class: "path", d }));
    }
  }

  /** Links, each once: mechanisms on one rod have it in common, and it is that of most pins, of whom nothing hangs. */
  private ownLinks(): { of: MechanismDrawing; link: LinkDrawing }[] {
    const found = new Map<string, { of: MechanismDrawing; link: LinkDrawing }>();
    const angles = SAMPLES.map((part) => part * this.cycle);
    for (const of of this.drawing.mechanisms) {
      for (const link of of.links) {
        const ends = link.pins.slice(0, 2).flatMap((name) => angles.map((angle) => this.pin(of, name, angle)));
        const key = ends.map((end) => `${end.x.toFixed(1)} ${end.y.toFixed(1)}`).join() + (link.is_crank ? "" : " rod");
        const before = found.get(key);
        if (!before) found.set(key, { of, link });
        else if (link.pins.length > before.link.pins.length) found.set(key, { of: { ...of, is_slave: before.of.is_slave }, link });
      }
    }
    return [...found.values()];
  }

  /** A link, in its own axes: its first pin at 0, its second to the right. */
  private link(of: MechanismDrawing, link: LinkDrawing, into: SVGGElement): void {
    const local = this.localPins(of, link);
    if (!local) return;
    const isOutlined = of.is_outlined;
    const group = svg("g", { class: `link ${link.is_crank ? "crank" : "rod"} ${isOutlined ? "outlined" : "plain"}` });
    if (of.is_slave && !link.is_crank) group.classList.add("slave");
    group.append(svg("title", {}, link.name));
    if (!isOutlined) {
      const d = polyline(local);
      const isBody = local.length > 2 && Math.abs(area(local)) > 1;
      group.append(svg("path", { class: isBody ? "body" : "bar", d: isBody ? `${d}Z` : d }));
    } else if (link.is_crank) {
      const [start, end] = local as [Point, Point];
      const size = Math.max(Math.abs(end.x - start.x), 6);
      group.append(svg("path", { class: "web", d: hull(start, 0.5 * size, end, 0.44 * size) }));
    } else {
      const eye = this.leading;
      const [start, ...others] = local as [Point, ...Point[]];
      others.forEach((end, place) => {
        const isEnd = of.ends.includes(link.pins[place + 1] ?? "");
        const small = isEnd ? 0.1 : SMALL_EYE;
        const shank = hull(start, 0.17 * eye, end, 0.11 * eye);
        group.append(svg("path", { class: "shank", d: shank }));
        group.append(svg("circle", { class: "eye", cx: end.x, cy: end.y, r: small * eye }));
      });
      group.append(svg("circle", { class: "eye", cx: start.x, cy: start.y, r: (isOnCrank(of, link) ? BIG_EYE : SMALL_EYE) * eye }));
    }
    into.append(group);
    const [first, second] = link.pins as readonly [string, string];
    this.moving.push((angle) => place(group, this.pin(of, first, angle), this.pin(of, second, angle)));
  }

  /** Places of a link's pins in its own axes; none where it never closes. */
  private localPins(of: MechanismDrawing, link: LinkDrawing): Point[] | null {
    const angles = this.drawing.crank_angle.values;
    const [first, second] = link.pins as readonly [string, string];
    for (const angle of angles) {
      const [start, end] = [this.pin(of, first, angle), this.pin(of, second, angle)];
      const length = Math.hypot(end.x - start.x, end.y - start.y);
      if (!(length > LESS)) continue;
      const [cos, sin] = [(end.x - start.x) / length, (end.y - start.y) / length];
      const all = link.pins.map((name) => this.pin(of, name, angle));
      if (!all.every((one) => Number.isFinite(one.x))) continue;
      return all.map((one) => {
        const [x, y] = [one.x - start.x, one.y - start.y];
        return { x: x * cos + y * sin, y: y * cos - x * sin };
      });
    }
    return null;
  }

  /** Pins where links meet, and points that are followed. */
  private joints(of: MechanismDrawing, into: SVGGElement): void {
    const eye = this.leading;
    for (const name of Object.keys(of.pins)) {
      if (of.fixed.includes(name) || of.ends.includes(name)) continue;
      const isPoint = of.points.includes(name);
      const isBig = of.is_outlined && of.links.some((link) => link.is_crank && link.pins.includes(name));
      const radius = isPoint ? 3 : of.is_outlined ? (isBig ? 0.24 : 0.11) * eye : 3.6;
      const dot = svg("circle", { class: isPoint ? "followed" : "pin", r: Math.max(radius, 2.4) }, svg("title", {}, name));
      into.append(dot);
      this.moving.push((angle) => {
        const point = this.pin(of, name, angle);
        dot.toggleAttribute("hidden", !Number.isFinite(point.x));
        if (Number.isFinite(point.x)) dot.setAttribute("transform", `translate(${xy(point)})`);
      });
    }
  }

  /** Pins that stand still: on a bracket. */
  private standing(of: MechanismDrawing, into: SVGGElement): void {
    for (const name of of.fixed) {
      const point = this.pin(of, name, 0);
      if (!Number.isFinite(point.x)) continue;
      const isShaft = of.links[0]?.pins[0] === name;
      const size = 11;
      const group = svg("g", { class: "standing", transform: `translate(${xy(point)})` });
      if (!isShaft) group.append(svg("path", { class: "bracket", d: `M0 0L${-size} ${1.5 * size}H${size}Z` }));
      group.append(svg("circle", { class: "pivot", r: isShaft ? 5 : 4 }), svg("title", {}, name));
      into.append(group);
    }
  }

  /** Blocks that slide along a link. */
  private blocks(of: MechanismDrawing, into: SVGGElement): void {
    for (const block of of.blocks) {
      const [first, second] = block.link;
      const shape = svg("rect", { class: "block", x: -13, y: -7.5, width: 26, height: 15, rx: 1.5 });
      into.append(shape);
      this.moving.push((angle) => {
        const middle = this.pin(of, block.pin, angle);
        const start = this.pin(of, first ?? block.pin, angle);
        const end = second === undefined ? middle : this.pin(of, second, angle);
        const [x, y] = [end.x - start.x, end.y - start.y];
        place(shape, middle, Number.isFinite(x) && Math.hypot(x, y) > LESS ? { x: middle.x + x, y: middle.y + y } : { x: middle.x + 1, y: middle.y });
      });
    }
  }

  /** What slides in guides beside the output, as blocks, but for what is the output of another mechanism. */
  private otherSliders(of: MechanismDrawing): OutputDrawing[] {
    const outputs = this.drawing.mechanisms.flatMap((one) => (one.output ? [{ one, pin: one.output.pin }] : []));
    const angles = SAMPLES.map((part) => part * this.cycle);
    const isOutput = (pin: string): boolean =>
      outputs.some((other) => (other.one === of && other.pin === pin) || angles.every((angle) => {
        const [own, its] = [this.pin(of, pin, angle), this.pin(other.one, other.pin, angle)];
        return !(Math.hypot(own.x - its.x, own.y - its.y) >= 0.1);
      }));
    return of.guides.filter((guide) => !isOutput(guide.pin)).map(({ pin, direction, foot }) => {
      const [cos, sin] = [Math.cos(number(direction)), Math.sin(number(direction))];
      const places = of.pins[pin];
      const x = places ? row(places, 0) : new Float32Array();
      const y = places ? row(places, 1) : new Float32Array();
      const travel = extent(x.map((one, place) => (one - at(foot, 0)) * cos + ((y[place] ?? NaN) - at(foot, 1)) * sin));
      return {
        is: "OutputDrawing", pin, foot, along: { values: Float32Array.of(cos, sin), shape: [2] }, travel: { values: Float32Array.of(...travel), shape: [2] },
        bore: null, is_valve: false, is_far: false, port: null, crosshead: null, ram: null,
      };
    });
  }

  /** The slider with its cylinder or guides, in axes along its line: the foot at 0. */
  private output(of: MechanismDrawing, output: OutputDrawing, still: SVGGElement, moves: SVGGElement): void {
    const line = this.lineOf(of, output);
    const { frame } = line;
    if (frame.includes("NaN")) return;
    const standing = svg("g", { class: "cylinder", transform: frame });
    const sliding = svg("g", { class: "slider" });
    const group = svg("g", { transform: frame }, sliding);
    const gas = svg("rect", { class: "gas" });
    const shape = this.slider(of, output);
    standing.append(...shape.still(), ...(shape.hasGas ? [gas] : []));
    sliding.append(...shape.moving(), svg("title", {}, of.name));
    still.append(standing);
    moves.append(group);
    this.moving.push((angle) => {
      const along = line.along(this.pin(of, output.pin, angle));
      group.toggleAttribute("hidden", !Number.isFinite(along));
      if (!Number.isFinite(along)) return;
      sliding.setAttribute("transform", `translate(${along.toFixed(2)} 0)`);
      shape.fill(gas, along);
    });
  }

  /** The line of a slider: axes along it, the foot at 0, and how far along it a point is. */
  private lineOf(of: MechanismDrawing, output: OutputDrawing): { frame: string; along: (pin: Point) => number } {
    const shift = this.shifts.get(`${of.name} ${output.pin}`) ?? { x: 0, y: 0 };
    const foot = this.point(at(output.foot, 0) + shift.x, at(output.foot, 1) + shift.y);
    const [x, y] = [at(output.along, 0), -at(output.along, 1)];
    return { frame: `matrix(${x} ${y} ${-y} ${x} ${xy(foot)})`, along: (pin) => (pin.x - foot.x) * x + (pin.y - foot.y) * y };
  }

  private slider(of: MechanismDrawing, output: OutputDrawing): Slider {
    const isShared = this.drawing.mechanisms.some((one) => one !== of && one.cylinder === of.cylinder && one.output?.bore);
    return new Slider(output, this.scale, isShared);
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
      const get = (values: Float32Array): number => between(values, this.cycle, angle);
      const part = get(load.size.values) / largest;
      const isThere = Number.isFinite(part) && Math.abs(part) > 0.004;
      arrow.toggleAttribute("hidden", !isThere);
      label.toggleAttribute("hidden", !isThere);
      if (!load.is_torque) held.setAttribute("d", this.heldBy(load, angle));
      if (!isThere) return;
      label.textContent = `${load.name} ${figures((part * largest) / number(load.one), largest / number(load.one))} ${load.unit}`;
      const end = this.point(get(row(load.place, 0)), get(row(load.place, 1)));
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
    const of = (numbers: Numbers): Point => this.point(between(row(numbers, 0), this.cycle, angle), between(row(numbers, 1), this.cycle, angle));
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
    const places = ROWS.flatMap((row) => inTurn.map((side): Place => ({ ...side, y: y + row * this.pixel, isCentral: false })));
    const place = this.labels.put(label.textContent ?? "", places);
    if (!place) return;
    label.setAttribute("text-anchor", place.anchor);
    label.setAttribute("x", place.x.toFixed(2));
    label.setAttribute("y", place.y.toFixed(2));
  }

  /** A round length to scale. */
  private scaleBar(box: readonly [number, number, number, number], into: SVGGElement): void {
    const [left, top, , height] = box;
    const one = number(this.drawing.one);
    const most = (0.22 * LONG) / this.scale / one;
    const power = 10 ** Math.floor(Math.log10(most));
    const length = power * ([5, 2, 1].find((one) => one * power <= most) ?? 1);
    const [x, y] = [left + 10, top + height - 9];
    const end = x + length * one * this.scale;
    const words = `${+length.toPrecision(3)} ${this.drawing.unit}`;
    this.labels.keepClear(words, { x: end + 6, y: y + 4, anchor: "start", isCentral: false });
    into.append(
      svg("path", { class: "scale", d: `M${x} ${y - 4}V${y + 4}M${x} ${y}H${end}M${end} ${y - 4}V${y + 4}` }),
      svg("text", { class: "scale", x: end + 6, y: y + 4 }, words),
    );
  }
}

/** A slider as it is: a piston in its cylinder, a crosshead with piston rod and piston, a ram, a block on a guide. */
class Slider {
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
function corners(output: OutputDrawing, shift: Point | undefined): Point[] {
  if (output.is_valve && output.bore === null && !output.ram) return [];
  const bore = output.bore ?? output.ram?.width ?? 0;
  const ends = [at(output.travel, 0), at(output.travel, 1) + (CROWN + CLEARANCE) * (output.bore ?? 0)];
  if (output.crosshead) ends.push(at(output.crosshead.covers, 1), at(output.crosshead.covers, 0));
  if (output.ram) ends.push(number(output.ram.bed), at(output.travel, 0) - number(output.ram.back));
  if (output.is_far) ends.push(at(output.travel, 0) - (CROWN + CLEARANCE) * (output.bore ?? 0));
  const [x, y] = [at(output.along, 0), at(output.along, 1)];
  return ends.flatMap((end) =>
    [-0.56, 0.56].map((side) => ({
      x: at(output.foot, 0) + (shift?.x ?? 0) + end * x - side * bore * y,
      y: at(output.foot, 1) + (shift?.y ?? 0) + end * y + side * bore * x,
    })),
  );
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

/** Whether a rod is on the crank, so that its first eye is the big one. */
const isOnCrank = (of: MechanismDrawing, link: LinkDrawing): boolean =>
  of.links.some((one) => one.is_crank && one.pins.includes(link.pins[0] ?? ""));

/** Where a pin is at first. [m] */
const first = (pin: Numbers): readonly [number, number] => [row(pin, 0)[0] ?? NaN, row(pin, 1)[0] ?? NaN];

/** Place what is drawn in its own axes: 0 at a point, its x axis toward another. */
function place(element: SVGElement, start: Point, end: Point): void {
  const length = Math.hypot(end.x - start.x, end.y - start.y);
  const isThere = Number.isFinite(length) && length > 0;
  element.toggleAttribute("hidden", !isThere);
  if (!isThere) return;
  const [cos, sin] = [(end.x - start.x) / length, (end.y - start.y) / length];
  element.setAttribute("transform", `matrix(${cos.toFixed(5)} ${sin.toFixed(5)} ${(-sin).toFixed(5)} ${cos.toFixed(5)} ${xy(start)})`);
}

/** Twice the area of a polygon. */
function area(points: readonly Point[]): number {
  return points.reduce((sum, one, k) => {
    const next = points[(k + 1) % points.length] as Point;
    return sum + one.x * next.y - next.x * one.y;
  }, 0);
}

/** Outline of two circles and what lies between them. */
function hull(one: Point, first: number, other: Point, second: number): string {
  const [x, y] = [other.x - one.x, other.y - one.y];
  const length = Math.hypot(x, y);
  if (length <= Math.abs(first - second)) {
    const [middle, radius] = first >= second ? [one, first] : [other, second];
    return `M${middle.x - radius} ${middle.y}a${radius} ${radius} 0 1 0 ${2 * radius} 0a${radius} ${radius} 0 1 0 ${-2 * radius} 0Z`;
  }
  const along = Math.atan2(y, x);
  const lean = Math.acos((first - second) / length);
  const on = (centre: Point, radius: number, angle: number): Point => ({
    x: centre.x + radius * Math.cos(angle),
    y: centre.y + radius * Math.sin(angle),
  });
  const [a, b] = [on(one, first, along - lean), on(other, second, along - lean)];
  const [c, d] = [on(other, second, along + lean), on(one, first, along + lean)];
  const isWide = first >= second ? 1 : 0;
  return `M${xy(a)}L${xy(b)}A${second} ${second} 0 ${1 - isWide} 1 ${xy(c)}L${xy(d)}A${first} ${first} 0 ${isWide} 1 ${xy(a)}Z`;
}
