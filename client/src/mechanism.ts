// A mechanism to scale: what stands still is drawn once, what moves is turned and shifted.

import type { DrawnHandle, LinkDrawing, MachineDrawing, MechanismDrawing, OutputDrawing, VectorsToScale } from "./data.ts";
import { picture, svg } from "./elements.ts";
import { Labels, type Edges } from "./labels.ts";
import { DrawnLoads } from "./loads.ts";
import { at, extent, number, row } from "./numbers.ts";
import { area, hull, place } from "./outlines.ts";
import { LESS, LONG, Placing, type View } from "./placing.ts";
import { barbs, polyline, xy, type Point } from "./points.ts";
import { Slider } from "./slider.ts";
import { DrawnVectors } from "./vectors.ts";

/** Radii of a rod's eyes in parts of the crank radius; and of pins where links are lines. */
const BIG_EYE = 0.4;
const SMALL_EYE = 0.22;

/** Radius of the ring of degrees in parts of the crank's. */
const RING = 1.6;

/** Of a pin that may be moved, and room for it where it stands beyond the drawing. */
const RING_OF_HANDLE = 10;
const ROOM_OF_HANDLE = 16;

/** From where to where the arrow of turning goes along the ring, from its zero. [rad] */
const TURNING = [2.2, 2.9] as const;

/** Where in the cycle it is seen whether two things are one, in parts of it. */
const SAMPLES: readonly number[] = [0.1, 0.37, 0.71];

/** What moves: shown at the crank angles of the drawing, or between them. */
type Moving = (angle: number) => void;

/** A machine's drawing, which is shown at a crank angle. */
export class Mechanism {
  readonly element: SVGSVGElement;
  private readonly drawing: MachineDrawing;
  private readonly moving: Moving[] = [];
  private readonly edges: Edges;
  private readonly labels: Labels;
  private readonly ghosts = svg("g", { class: "ghost" });
  private readonly old = svg("g", { class: "ghost old" });
  private readonly held = svg("g", {});
  private readonly marks = svg("g", { class: "marks" });
  private rings: { readonly ring: SVGElement; readonly axis: SVGElement; readonly one: DrawnHandle }[] = [];
  private shown = 0;
  private readonly placing: Placing;
  private readonly loads: DrawnLoads;
  private readonly vectors: DrawnVectors;

  constructor(drawing: MachineDrawing, label: string, held?: View) {
    this.drawing = drawing;
    this.placing = new Placing(drawing, held);
    const { box } = this.placing.view;
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
    this.loads = new DrawnLoads(drawing.loads, this.placing, this.edges, this.labels, loads, paths);
    this.scaleBar(box, still);
    this.vectors = new DrawnVectors((one, angle) => this.placing.pinOf(one, angle), this.cycle, this.edges, this.labels);
    this.element.append(this.vectors.element, this.marks, this.held);
    this.show(0);
    // Words are as large as the window has them: in another size they stand elsewhere.
    new ResizeObserver(() => { this.show(this.shown); }).observe(this.element);
  }

  /** How it lies, with what stands beyond it now. */
  get view(): View {
    const { x, y, width, height } = this.element.viewBox.baseVal;
    return { scale: this.placing.scale, box: [x, y, width, height] };
  }

  /** Crank angle at which all begins again. [deg] */
  get cycle(): number {
    return this.placing.cycle;
  }

  /** Show it at a crank angle. [deg] */
  show(angle: number): void {
    const place = ((angle % this.cycle) + this.cycle) % this.cycle;
    this.labels.begin();
    for (const move of this.moving) move(place);
    this.loads.show(place);
    this.vectors.show(place);
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
      const d = polyline(link.pins.map((name) => this.placing.pin(of, name, angle)));
      return svg("path", { d });
    });
    const sliders = this.drawing.mechanisms.flatMap((of) => {
      if (!of.output) return [];
      const line = this.placing.lineOf(of, of.output);
      const along = line.along(this.placing.pin(of, of.output.pin, angle));
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
    const [left, top, width, height] = this.placing.view.box;
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
      const slides = this.placing.pinOf({ mechanism: one.mechanism, pin: one.slides }, angle);
      axis.setAttribute("d", Number.isFinite(place.x + slides.x) ? polyline([slides, place]) : "");
    }
  }

  /** Where a pin is that may be moved, or what else may. */
  placeOf(one: DrawnHandle, angle: number): Point {
    return one.at ? this.placing.point(at(one.at, 0), at(one.at, 1)) : this.placing.pinOf(one, angle);
  }

  /** Mark what is about to be added, and nothing else. */
  mark(marks: readonly SVGElement[]): void {
    this.marks.replaceChildren(...marks);
  }

  /** Where a pin of one of its mechanisms is. */
  pinOf(one: { readonly mechanism: string; readonly pin: string }, angle: number): Point {
    return this.placing.pinOf(one, angle);
  }

  /** Where a point of the machine is in the picture. [m] */
  point(x: number, y: number): Point {
    return this.placing.point(x, y);
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
    return { x: by.x / this.placing.scale, y: -by.y / this.placing.scale };
  }

  /** Take vectors, and no others, for when it is shown next. */
  takeVectors(sorts: readonly VectorsToScale[]): void {
    this.vectors.take(sorts);
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
    const centre = this.placing.point(at(shaft.centre, 0), at(shaft.centre, 1));
    return (number(shaft.sense) * Math.atan2(centre.y - point.y, point.x - centre.x) * 180) / Math.PI;
  }

  /** Radius of a mechanism's crank, in the units of the picture. */
  private crank(of: MechanismDrawing): number {
    const pins = of.links.find((one) => one.is_crank)?.pins ?? [];
    const [start, end] = pins.map((name) => this.placing.pin(of, name, 0));
    return start && end ? Math.hypot(end.x - start.x, end.y - start.y) : 0;
  }

  /** Radius of the first mechanism's crank, by which eyes and pins are drawn. */
  private get leading(): number {
    const first = this.drawing.mechanisms[0];
    const crank = first ? this.crank(first) : 0;
    return Math.min(Math.max(crank, 0.055 * LONG), 0.2 * LONG);
  }

  /** Degrees of the crank round a shaft, 0 where the first crank on it stands at first, and the sense of turning. */
  private ring(name: string, into: SVGGElement): void {
    const shaft = this.drawing.shafts.find((one) => one.name === name);
    const own = this.drawing.mechanisms.find((one) => one.shaft === name);
    if (!shaft || !own) return;
    const centre = this.placing.point(at(shaft.centre, 0), at(shaft.centre, 1));
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
      const shift = this.placing.shift(of, name);
      const [x, y] = [row(places, 0), row(places, 1)];
      let d = "";
      let isDown = false;
      x.forEach((one, place) => {
        const point = this.placing.point(one + shift.x, (y[place] ?? NaN) + shift.y);
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
        const ends = link.pins.slice(0, 2).flatMap((name) => angles.map((angle) => this.placing.pin(of, name, angle)));
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
    this.moving.push((angle) => place(group, this.placing.pin(of, first, angle), this.placing.pin(of, second, angle)));
  }

  /** Places of a link's pins in its own axes; none where it never closes. */
  private localPins(of: MechanismDrawing, link: LinkDrawing): Point[] | null {
    const angles = this.drawing.crank_angle.values;
    const [first, second] = link.pins as readonly [string, string];
    for (const angle of angles) {
      const [start, end] = [this.placing.pin(of, first, angle), this.placing.pin(of, second, angle)];
      const length = Math.hypot(end.x - start.x, end.y - start.y);
      if (!(length > LESS)) continue;
      const [cos, sin] = [(end.x - start.x) / length, (end.y - start.y) / length];
      const all = link.pins.map((name) => this.placing.pin(of, name, angle));
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
        const point = this.placing.pin(of, name, angle);
        dot.toggleAttribute("hidden", !Number.isFinite(point.x));
        if (Number.isFinite(point.x)) dot.setAttribute("transform", `translate(${xy(point)})`);
      });
    }
  }

  /** Pins that stand still: on a bracket. */
  private standing(of: MechanismDrawing, into: SVGGElement): void {
    for (const name of of.fixed) {
      const point = this.placing.pin(of, name, 0);
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
        const middle = this.placing.pin(of, block.pin, angle);
        const start = this.placing.pin(of, first ?? block.pin, angle);
        const end = second === undefined ? middle : this.placing.pin(of, second, angle);
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
        const [own, its] = [this.placing.pin(of, pin, angle), this.placing.pin(other.one, other.pin, angle)];
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
    const line = this.placing.lineOf(of, output);
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
      const along = line.along(this.placing.pin(of, output.pin, angle));
      group.toggleAttribute("hidden", !Number.isFinite(along));
      if (!Number.isFinite(along)) return;
      sliding.setAttribute("transform", `translate(${along.toFixed(2)} 0)`);
      shape.fill(gas, along);
    });
  }

  private slider(of: MechanismDrawing, output: OutputDrawing): Slider {
    const isShared = this.drawing.mechanisms.some((one) => one !== of && one.cylinder === of.cylinder && one.output?.bore);
    return new Slider(output, this.placing.scale, isShared);
  }

  /** A round length to scale. */
  private scaleBar(box: readonly [number, number, number, number], into: SVGGElement): void {
    const [left, top, , height] = box;
    const one = number(this.drawing.one);
    const most = (0.22 * LONG) / this.placing.scale / one;
    const power = 10 ** Math.floor(Math.log10(most));
    const length = power * ([5, 2, 1].find((one) => one * power <= most) ?? 1);
    const [x, y] = [left + 10, top + height - 9];
    const end = x + length * one * this.placing.scale;
    const words = `${+length.toPrecision(3)} ${this.drawing.unit}`;
    this.labels.keepClear(words, { x: end + 6, y: y + 4, anchor: "start", isCentral: false });
    into.append(
      svg("path", { class: "scale", d: `M${x} ${y - 4}V${y + 4}M${x} ${y}H${end}M${end} ${y - 4}V${y + 4}` }),
      svg("text", { class: "scale", x: end + 6, y: y + 4 }, words),
    );
  }
}
/** Whether a rod is on the crank, so that its first eye is the big one. */
const isOnCrank = (of: MechanismDrawing, link: LinkDrawing): boolean =>
  of.links.some((one) => one.is_crank && one.pins.includes(link.pins[0] ?? ""));
