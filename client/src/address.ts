// What of a page stands in its address, so that a link gives the same screen: its tab, its crank angle.

export interface Place {
  /** Which tab, from 0. */
  readonly tab: number;
  /** Crank angle at which it stands; NaN of one that turns. [deg] */
  readonly angle: number;
}

/** Read a place from the part of an address behind #; what is wrong there is left out. */
export function placeIn(hash: string): Place {
  const found = new URLSearchParams(hash.replace(/^#/, ""));
  const tab = Number.parseInt(found.get("tab") ?? "", 10);
  const angle = Number.parseFloat(found.get("phi") ?? "");
  return { tab: Number.isInteger(tab) && tab >= 0 ? tab : 0, angle: Number.isFinite(angle) ? angle : NaN };
}

/** Write a place as the part of an address behind #. */
export function hashOf(place: Place): string {
  const parts = { ...(place.tab ? { tab: `${place.tab}` } : {}), ...(Number.isNaN(place.angle) ? {} : { phi: `${+place.angle.toFixed(2)}` }) };
  return `#${new URLSearchParams(parts).toString()}`;
}

/** Keep a place in the address, without a step back; a page in the frame of a notebook has no address. */
export function remember(place: Place): void {
  if (location.protocol !== "about:") history.replaceState(null, "", hashOf(place));
}
