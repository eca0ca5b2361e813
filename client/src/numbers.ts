// Numbers of a page: one block, of which each array knows its place.

import type { Float, Numbers } from "./data.ts";

interface Place {
  readonly at: number;
  readonly shape: readonly number[];
}

/** Read data: a length, so much JSON, and the numbers of its arrays. */
export function unpacked(bytes: ArrayBuffer): unknown {
  const length = new DataView(bytes).getUint32(0, true);
  const data: unknown = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length)));
  return revived(data, ofBytes(new Uint8Array(bytes, 4 + length)));
}

/** Give data, which is changed for that, with arrays in place of what says where their numbers are. */
export function revived(data: unknown, block: Float32Array): unknown {
  if (Array.isArray(data)) return data.map((one) => revived(one, block));
  if (typeof data !== "object" || data === null) return data;
  if (isPlace(data)) {
    const size = data.shape.reduce((product, one) => product * one, 1);
    return { values: block.subarray(data.at, data.at + size), shape: data.shape } satisfies Numbers;
  }
  const named = data as Record<string, unknown>;
  for (const name of Object.keys(named)) named[name] = revived(named[name], block);
  return named;
}

function isPlace(data: object): data is Place {
  return "at" in data && "shape" in data && typeof data.at === "number" && Array.isArray(data.shape);
}

/** Whether two pieces of data are the same, number by number. */
export function same(one: unknown, other: unknown): boolean {
  if (Object.is(one, other)) return true;
  if (typeof one !== "object" || typeof other !== "object" || one === null || other === null) return false;
  if (one instanceof Float32Array || other instanceof Float32Array) {
    if (!(one instanceof Float32Array && other instanceof Float32Array) || one.length !== other.length) return false;
    for (let place = 0; place < one.length; place++) if (!Object.is(one[place], other[place])) return false;
    return true;
  }
  const [first, second] = [Object.entries(one), other as Record<string, unknown>];
  return first.length === Object.keys(second).length && first.every(([name, value]) => name in second && same(value, second[name]));
}

/** Numbers of which all first bytes stand first, then all second ones, and so on. */
export function ofBytes(bytes: Uint8Array): Float32Array {
  const count = bytes.length / Float32Array.BYTES_PER_ELEMENT;
  const whole = new Uint32Array(count);
  const byte = (which: number, place: number): number => bytes[which * count + place] ?? 0;
  for (let place = 0; place < count; place++) {
    whole[place] = byte(0, place) | (byte(1, place) << 8) | (byte(2, place) << 16) | (byte(3, place) << 24);
  }
  return new Float32Array(whole.buffer);
}

/** A number, NaN where there is none. */
export const number = (one: Float | undefined): number => one ?? NaN;

/** A value of an array by its place, NaN behind its end. */
export const at = (numbers: Numbers, place: number): number => numbers.values[place] ?? NaN;

/** A row of an array of two dimensions. */
export function row(numbers: Numbers, place: number): Float32Array {
  const length = numbers.shape[numbers.shape.length - 1] ?? 0;
  return numbers.values.subarray(place * length, (place + 1) * length);
}

/** Least and largest of the values that are known; none of these are two NaN. */
export function extent(values: ArrayLike<number>): readonly [number, number] {
  let low = Infinity;
  let high = -Infinity;
  for (let place = 0; place < values.length; place++) {
    const one = values[place] as number;
    if (one < low) low = one;
    if (one > high) high = one;
  }
  return low <= high ? [low, high] : [NaN, NaN];
}

/** Whether some of the numbers are not there. */
export function hasGap(values: Float32Array): boolean {
  for (let place = 0; place < values.length; place++) if (!Number.isFinite(values[place] as number)) return true;
  return false;
}

/** Value at a place between points that stand evenly from 0 to `end`; NaN where either beside it is. */
export function between(values: Float32Array, end: number, place: number): number {
  const steps = values.length - 1;
  const exact = Math.min(Math.max((place / end) * steps, 0), steps);
  const before = Math.min(Math.floor(exact), steps - 1);
  const part = exact - before;
  const first = values[before] ?? NaN;
  return part === 0 ? first : first + part * ((values[before + 1] ?? NaN) - first);
}

/** Of points on whose polynomial values are read; and how many of them stand before. */
const SIX = 6;
const BEFORE = 2;
/** By which part of a step points may stand otherwise that stand evenly: they come with seven figures. */
const EVEN = 1e-3;

/** The same on the polynomial of the six points about a place; straight where one of them is not there. */
export function smooth(values: Float32Array, end: number, place: number): number {
  const steps = values.length - 1;
  const exact = Math.min(Math.max((place / end) * steps, 0), steps);
  const first = Math.min(Math.max(Math.floor(exact) - BEFORE, 0), steps + 1 - SIX);
  const found = polynomial(values, first, SIX, exact);
  return Number.isFinite(found) ? found : between(values, end, place);
}

/** Value at a place, counted in points, of the polynomial through so many of them from a first one on. */
function polynomial(values: Float32Array, first: number, count: number, exact: number): number {
  let sum = 0;
  for (let one = first; one < first + count; one++) {
    let weight = 1;
    for (let other = first; other < first + count; other++) if (other !== one) weight *= (exact - other) / (one - other);
    sum += weight * (values[one] ?? NaN);
  }
  return sum;
}

/** Value at a place between points that rise along `across`; NaN outside. */
export function interpolated(across: Float32Array, values: Float32Array, place: number): number {
  let low = 0;
  let high = across.length - 1;
  if (!(place >= (across[low] ?? NaN) && place <= (across[high] ?? NaN))) return NaN;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if ((across[middle] ?? NaN) <= place) low = middle;
    else high = middle;
  }
  const start = across[low] ?? NaN;
  const width = (across[high] ?? NaN) - start;
  const first = values[low] ?? NaN;
  return width === 0 ? first : first + ((place - start) / width) * ((values[high] ?? NaN) - first);
}

/** A polynomial is taken for a curve where two more points change it by less than this part of what it differs from a chord. */
const SETTLED = 0.05;

/** The same on a polynomial where points stand evenly and a curve is smooth, as the kernels' are: nothing is read over a jump or a kink. */
export function read(across: Float32Array, values: Float32Array, place: number): number {
  const chord = interpolated(across, values, place);
  const end = across.length - 1;
  const [start, width] = [across[0] ?? NaN, ((across[end] ?? NaN) - (across[0] ?? NaN)) / end];
  const exact = (place - start) / width;
  const first = Math.min(Math.max(Math.floor(exact) - BEFORE, 0), end + 1 - SIX);
  if (!Number.isFinite(chord) || first < 0 || !Number.isInteger(first)) return chord;
  for (const one of [first, first + SIX - 1]) if (Math.abs((across[one] ?? NaN) - start - one * width) > EVEN * width) return chord;
  const six = polynomial(values, first, SIX, exact);
  const four = polynomial(values, first + 1, SIX - 2, exact);
  return Math.abs(six - four) <= SETTLED * Math.abs(four - chord) ? six : chord;
}

/** Round numbers from low to high, some five of them. */
export function ticks(low: number, high: number, most = 5): number[] {
  const rough = (high - low) / most;
  if (!(rough > 0) || !Number.isFinite(rough)) return [];
  const power = 10 ** Math.floor(Math.log10(rough));
  const step = power * ([1, 2, 5, 10].find((one) => one * power >= rough * (1 - 1e-9)) ?? 10);
  const found: number[] = [];
  for (let k = Math.ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k++) found.push(k * step + 0);
  return found;
}

/** A number as axes have it: as few decimals as a step needs, a true minus. */
export function figure(value: number, step: number): string {
  const decimals = Math.max(0, -Math.floor(Math.log10(Math.abs(step)) + 1e-9));
  return signed(value.toFixed(Math.min(decimals, 12)));
}

/** What is less than this part of the largest beside it is nothing: numbers come with seven figures. */
const ROUNDING = 1e-6;

/** A number with four figures, as read-outs have it; what is rounding beside the largest is 0. */
export function figures(value: number, largest: number): string {
  if (!Number.isFinite(value)) return "–";
  const size = Math.abs(value) <= ROUNDING * largest ? 0 : Math.abs(value);
  if (size === 0) return "0";
  const decimals = Math.max(0, 3 - Math.floor(Math.log10(size) + 1e-12));
  return signed(value.toFixed(Math.min(decimals, 12)));
}

const signed = (text: string): string => (/^-0(\.0*)?$/.test(text) ? text.slice(1) : text.replace("-", "−"));

/** A number of the file with its unit, as it is typed. */
export interface Typed {
  readonly number: number;
  readonly unit: string;
}

/** Take a text apart; nothing where it begins with no number. */
export function typed(text: string): Typed | null {
  const found = /^\s*([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)\s*(.*)$/.exec(text);
  return found?.[1] === undefined ? null : { number: Number(found[1]), unit: found[2]?.trim() ?? "" };
}
