// Points of a picture, and what is drawn from one to the other.

/** A point, in the units of the picture: to the right and down. */
export interface Point {
  readonly x: number;
  readonly y: number;
}

export const xy = (point: Point): string => `${point.x.toFixed(2)} ${point.y.toFixed(2)}`;

/** A line from point to point. */
export const polyline = (points: readonly Point[]): string => points.map((one, place) => `${place ? "L" : "M"}${xy(one)}`).join("");

/** The two lines of an arrow's head, in a direction on the screen, clockwise. */
export function barbs(end: Point, direction: number): string {
  const size = 8;
  const side = (turn: number): Point => ({
    x: end.x - size * Math.cos(direction + turn),
    y: end.y - size * Math.sin(direction + turn),
  });
  return `M${xy(side(0.4))}L${xy(end)}L${xy(side(-0.4))}`;
}
