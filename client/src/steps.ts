// What was asked for, one after the other, and which of it is shown.

import type { Asked } from "./address.ts";

/** Steps back and on: what is behind the one that is shown may be done again. */
export class Steps {
  private readonly all: Asked[];
  private place = 0;

  constructor(first: Asked) {
    this.all = [first];
  }

  get now(): Asked {
    return this.all[this.place] as Asked;
  }

  /** Whether there is a step back, or on. */
  has(by: number): boolean {
    return this.all[this.place + by] !== undefined;
  }

  go(by: number): void {
    if (this.has(by)) this.place += by;
  }

  /** Put another in the place of the one that is shown. */
  change(asked: Asked): void {
    this.all.splice(this.place, Infinity, asked);
  }

  add(asked: Asked): void {
    this.all.splice(this.place + 1, Infinity, asked);
    this.place += 1;
  }
}
