// Shapes of links, and how they are laid into the picture.

import { xy, type Point } from "./points.ts";

/** Place what is drawn in its own axes: 0 at a point, its x axis toward another. */
export function place(element: SVGElement, start: Point, end: Point): void {
  const length = Math.hypot(end.x - start.x, end.y - start.y);
  const isThere = Number.isFinite(length) && length > 0;
  element.toggleAttribute("hidden", !isThere);
  if (!isThere) return;
  const [cos, sin] = [(end.x - start.x) / length, (end.y - start.y) / length];
  element.setAttribute("transform", `matrix(${cos.toFixed(5)} ${sin.toFixed(5)} ${(-sin).toFixed(5)} ${cos.toFixed(5)} ${xy(start)})`);
}

/** Twice the area of a polygon. */
export function area(points: readonly Point[]): number {
  return points.reduce((sum, one, k) => {
    const next = points[(k + 1) % points.length] as Point;
    return sum + one.x * next.y - next.x * one.y;
  }, 0);
}

/** Outline of two circles and what lies between them. */
export function hull(one: Point, first: number, other: Point, second: number): string {
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
