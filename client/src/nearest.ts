// Which of several lines is nearest to where somebody points.

import type { Point } from "./points.ts";

/** Points of a curve: along and up. */
export interface Line {
  readonly across: Float32Array;
  readonly values: Float32Array;
}

/** Place of the line that passes nearest to a point, in pixels, and no farther than that; −1 where none does. */
export function nearest(lines: readonly Line[], x: (value: number) => number, y: (value: number) => number, [left, top]: readonly [number, number], most: number): number {
  let found = -1;
  let least = most;
  const pointed = { x: left, y: top };
  lines.forEach(({ across, values }, place) => {
    let before: Point = { x: NaN, y: NaN };
    for (let point = 0; point < values.length; point++) {
      const here = { x: x(across[point] ?? NaN), y: y(values[point] ?? NaN) };
      const far = apart(pointed, before, here);
      if (far < least) [found, least] = [place, far];
      before = here;
    }
  });
  return found;
}

/** Distance of a point from a piece of a line; NaN where that has an end that is not there. */
export function apart(point: Point, start: Point, end: Point): number {
  const [width, height] = [end.x - start.x, end.y - start.y];
  const square = width * width + height * height;
  const part = square === 0 ? 0 : Math.min(Math.max(((point.x - start.x) * width + (point.y - start.y) * height) / square, 0), 1);
  return Math.hypot(point.x - start.x - part * width, point.y - start.y - part * height);
}
