// Lines through many points, drawn with as few of them as show.

import type { Line } from "./nearest.ts";

/** By how much a line may pass over or under a point that is left out: no eye tells it. [px] */
export const UNSEEN = 0.05;

/** What draws: a canvas. */
type Drawing = Pick<CanvasRenderingContext2D, "moveTo" | "lineTo">;

/** Draw along a line, in pieces where it has gaps; points that a straight piece passes unseen are left out. */
export function along(ink: Drawing, { across, values }: Line, x: (one: number) => number, y: (one: number) => number): void {
  let isDown = false;
  let isPassed = false;
  let startX = NaN;
  let startY = NaN;
  let lastX = NaN;
  let lastY = NaN;
  // Slopes from the start that pass all points since.
  let low = -Infinity;
  let high = Infinity;
  for (let place = 0; place < values.length; place++) {
    const value = values[place] as number;
    if (!Number.isFinite(value)) {
      if (isPassed) ink.lineTo(lastX, lastY);
      isDown = isPassed = false;
      continue;
    }
    const nextX = x(across[place] ?? NaN);
    const nextY = y(value);
    if (!isDown) {
      ink.moveTo(nextX, nextY);
      startX = nextX;
      startY = nextY;
      low = -Infinity;
      high = Infinity;
      isDown = true;
      continue;
    }
    const slope = (nextY - startY) / (nextX - startX);
    if (isPassed && !(nextX > startX && low <= slope && slope <= high)) {
      ink.lineTo(lastX, lastY);
      startX = lastX;
      startY = lastY;
      low = -Infinity;
      high = Infinity;
    }
    const far = nextX - startX;
    // What goes back or straight up is passed by nothing.
    low = far > 0 ? Math.max(low, (nextY - UNSEEN - startY) / far) : Infinity;
    high = far > 0 ? Math.min(high, (nextY + UNSEEN - startY) / far) : -Infinity;
    lastX = nextX;
    lastY = nextY;
    isPassed = true;
  }
  if (isPassed) ink.lineTo(lastX, lastY);
}
