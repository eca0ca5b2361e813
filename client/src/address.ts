// What of a page stands in its address, so that a link gives the same screen: its tab and angle, the machine and numbers.

import { sentIn, type Sent } from "./sent.ts";

/** Where a page stands. */
export interface Place {
  /** Which tab, by its name; none is the first. */
  readonly tab: string;
  /** Crank angle at which it stands; NaN of one that turns. [deg] */
  readonly angle: number;
  /** Time at which it stands; NaN where there is none. [s] */
  readonly time: number;
}

/** A machine, and which of its numbers are set anew: texts by path. */
export interface Asked {
  readonly machine: string;
  readonly settings: ReadonlyMap<string, string>;
  /** The machine as text, in place of its name. */
  readonly sent?: Sent;
  /** Whose throw and curves are shown. */
  readonly piston?: string;
  /** A saved case that stands beside it. */
  readonly beside?: Asked;
}

const TAB = "tab";
const ANGLE = "phi";
const TIME = "t";
const MACHINE = "machine";
const BESIDE = "beside";
const SENT = "file";
const PISTON = "piston";
const LANGUAGE = "lang";
const PARTS: ReadonlySet<string> = new Set([TAB, ANGLE, TIME, MACHINE, BESIDE, SENT, PISTON, LANGUAGE]);
/** What stays when another machine is asked for. */
const STAYING: ReadonlySet<string> = new Set([TAB, ANGLE, TIME, LANGUAGE]);

const parts = (hash: string): URLSearchParams => new URLSearchParams(hash.replace(/^#/, ""));

/** Read a place from the part of an address behind #; what is wrong there is left out. */
export function placeIn(hash: string): Place {
  const found = parts(hash);
  return { tab: found.get(TAB) ?? "", angle: numberIn(found.get(ANGLE)), time: numberIn(found.get(TIME)) };
}

function numberIn(text: string | null): number {
  const found = Number.parseFloat(text ?? "");
  return Number.isFinite(found) ? found : NaN;
}

/** Read a machine and its numbers. */
export async function askedIn(hash: string): Promise<Asked> {
  const found = parts(hash);
  const settings = new Map([...found].filter(([name]) => !PARTS.has(name)));
  const beside = found.get(BESIDE);
  const sent = await sentIn(found.get(SENT) ?? "");
  return { machine: found.get(MACHINE) ?? "", settings, ...(sent && { sent }), ...(found.get(PISTON) && { piston: found.get(PISTON) ?? "" }), ...(beside !== null && { beside: await askedIn(beside) }) };
}

/** Write a place into the part of an address behind #, all else as it was. */
export function withPlace(hash: string, place: Place): string {
  const found = parts(hash);
  set(found, TAB, place.tab);
  set(found, ANGLE, Number.isNaN(place.angle) ? "" : `${+place.angle.toFixed(2)}`);
  set(found, TIME, Number.isNaN(place.time) ? "" : `${+place.time.toPrecision(6)}`);
  return `#${found.toString()}`;
}

/** Write a machine and its numbers into the part of an address behind #; the place stays. */
export function withAsked(hash: string, asked: Asked): string {
  const found = parts(hash);
  for (const name of [...found.keys()]) if (!STAYING.has(name)) found.delete(name);
  set(found, MACHINE, asked.machine);
  set(found, SENT, asked.sent?.letters ?? "");
  set(found, PISTON, asked.piston ?? "");
  for (const [path, text] of asked.settings) found.set(path, text);
  if (asked.beside) found.set(BESIDE, withAsked("", asked.beside).slice(1));
  return `#${found.toString()}`;
}

/** Read the code of a language; none is that of the service. */
export const languageIn = (hash: string): string => parts(hash).get(LANGUAGE) ?? "";

/** Write a language into the part of an address behind #, all else as it was. */
export function withLanguage(hash: string, code: string): string {
  const found = parts(hash);
  set(found, LANGUAGE, code);
  return `#${found.toString()}`;
}

function set(found: URLSearchParams, name: string, value: string): void {
  if (value) found.set(name, value);
  else found.delete(name);
}

/** Under which name the browser keeps the address that was shown last. */
const LAST = "cranktrain-last";

/** How long the address, and what is kept of it, wait for what is shown: browsers take some milliseconds to write them. [ms] */
const BEHIND = 60;

/** What stands in the address of the page, or will soon. */
export class Address {
  private waiting: ReturnType<typeof setTimeout> | null = null;
  private hash: string;
  /** What the browser had when it was written or read last. */
  private known = location.hash;

  constructor(hash: string) {
    this.hash = hash;
  }

  get place(): Place {
    return placeIn(this.hash);
  }

  get language(): string {
    return languageIn(this.hash);
  }

  /** Stand where another address says. */
  go(hash: string): void {
    this.hash = hash;
    this.known = location.hash;
  }

  speak(code: string): void {
    this.write(withLanguage(this.hash, code));
  }

  /** Whose throw and curves are shown. */
  get piston(): string {
    return parts(this.hash).get(PISTON) ?? "";
  }

  stand(place: Place): void {
    this.write(withPlace(this.hash, place));
  }

  ask(asked: Asked): void {
    const hash = withAsked(this.hash, asked);
    this.write(hash);
    setTimeout(() => { kept(hash); }, BEHIND);
  }

  /** Write it, without a step back; a page in the frame of a notebook has no address. */
  private write(hash: string): void {
    this.hash = hash;
    if (location.protocol === "about:") return;
    this.waiting ??= setTimeout(() => {
      this.waiting = null;
      if (location.hash !== this.known) return; // somebody has gone elsewhere meanwhile, which is heard of soon
      history.replaceState(null, "", this.hash);
      this.known = location.hash;
    }, BEHIND);
  }
}

/** What was shown last in this browser; nothing where it keeps nothing. */
export function last(): string {
  try {
    return localStorage.getItem(LAST) ?? "";
  } catch {
    return "";
  }
}

function kept(hash: string): void {
  try {
    localStorage.setItem(LAST, hash);
  } catch {
    // It is kept nowhere then.
  }
}
