// What of a page stands in its address, so that a link gives the same screen: its tab and angle, the machine and numbers.

/** Where a page stands. */
export interface Place {
  /** Which tab, from 0. */
  readonly tab: number;
  /** Crank angle at which it stands; NaN of one that turns. [deg] */
  readonly angle: number;
}

/** A machine, and which of its numbers are set anew: texts by path. */
export interface Asked {
  readonly machine: string;
  readonly settings: ReadonlyMap<string, string>;
}

const TAB = "tab";
const ANGLE = "phi";
const MACHINE = "machine";
const PARTS: ReadonlySet<string> = new Set([TAB, ANGLE, MACHINE]);

const parts = (hash: string): URLSearchParams => new URLSearchParams(hash.replace(/^#/, ""));

/** Read a place from the part of an address behind #; what is wrong there is left out. */
export function placeIn(hash: string): Place {
  const found = parts(hash);
  const tab = Number.parseInt(found.get(TAB) ?? "", 10);
  const angle = Number.parseFloat(found.get(ANGLE) ?? "");
  return { tab: Number.isInteger(tab) && tab >= 0 ? tab : 0, angle: Number.isFinite(angle) ? angle : NaN };
}

/** Read a machine and its numbers. */
export function askedIn(hash: string): Asked {
  const found = parts(hash);
  const settings = new Map([...found].filter(([name]) => !PARTS.has(name)));
  return { machine: found.get(MACHINE) ?? "", settings };
}

/** Write a place into the part of an address behind #, all else as it was. */
export function withPlace(hash: string, place: Place): string {
  const found = parts(hash);
  set(found, TAB, place.tab ? `${place.tab}` : "");
  set(found, ANGLE, Number.isNaN(place.angle) ? "" : `${+place.angle.toFixed(2)}`);
  return `#${found.toString()}`;
}

/** Write a machine and its numbers into the part of an address behind #; the place stays. */
export function withAsked(hash: string, asked: Asked): string {
  const found = parts(hash);
  for (const name of [...found.keys()]) if (name !== TAB && name !== ANGLE) found.delete(name);
  set(found, MACHINE, asked.machine);
  for (const [path, text] of asked.settings) found.set(path, text);
  return `#${found.toString()}`;
}

function set(found: URLSearchParams, name: string, value: string): void {
  if (value) found.set(name, value);
  else found.delete(name);
}

/** Keep the part of an address behind #, without a step back; a page in the frame of a notebook has no address. */
export function remember(hash: string): void {
  if (location.protocol !== "about:") history.replaceState(null, "", hash);
}
