import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { along, UNSEEN } from "../src/lines.ts";

type Point = readonly [number, number];

/** The pieces of a line as they are drawn. */
function pieces(points: readonly Point[]): Point[][] {
  const line = { across: Float32Array.from(points, ([x]) => x), values: Float32Array.from(points, ([, y]) => y) };
  const found: Point[][] = [];
  along({ moveTo: (x, y) => { found.push([[x, y]]); }, lineTo: (x, y) => { found.at(-1)?.push([x, y]); } }, line, (x) => x, (y) => y);
  return found;
}

/** Height of a drawn piece at a place. */
function height(piece: readonly Point[], x: number): number {
  const next = piece.findIndex(([at], place) => place > 0 && at >= x);
  const [[x0, y0], [x1, y1]] = [piece[next - 1] as Point, piece[next] as Point];
  return y0 + ((x - x0) / (x1 - x0)) * (y1 - y0);
}

describe("lines through many points", () => {
  const wave = Array.from({ length: 721 }, (_one, k): Point => [0.6 * k, 60 * Math.sin(k / 80) + 5 * Math.sin(k / 30)]);
  it("pass no point unseen that is left out", () => {
    const [drawn = []] = pieces(wave);
    assert.ok(drawn.length < wave.length / 3);
    for (const [x, y] of wave) assert.ok(Math.abs(height(drawn, x) - y) < UNSEEN + 1e-4);
  });
  it("have both ends, and of straight ones nothing else", () => {
    assert.deepEqual(pieces([[0, 0], [1, 2], [2, 4], [3, 6]]), [[[0, 0], [3, 6]]]);
    assert.deepEqual(pieces([[0, 0]]), [[[0, 0]]]);
    assert.deepEqual(pieces([]), []);
  });
  it("have corners, steps and ways back", () => {
    const bent: Point[] = [[0, 0], [1, 0], [2, 0], [2, 5], [3, 5], [2, 5], [1, 5], [1, 0]];
    assert.deepEqual(pieces(bent), [[[0, 0], [2, 0], [2, 5], [3, 5], [2, 5], [1, 5], [1, 0]]]);
  });
  it("stop at gaps", () => {
    assert.deepEqual(pieces([[0, 1], [1, 1], [2, NaN], [3, 4], [4, NaN], [5, 2], [6, 2]]), [[[0, 1], [1, 1]], [[3, 4]], [[5, 2], [6, 2]]]);
  });
});
