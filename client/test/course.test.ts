import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { Passing } from "../src/course.ts";
import type { PageCourse } from "../src/data.ts";

const numbers = (...values: number[]) => ({ values: new Float32Array(values), shape: [values.length] });

const words = { is: "CourseWords", drawing: "", time: "", play: "", stop: "", back: "", on: "", keys: "", pace: "" } as const;

/** Two seconds forth to 90°, one back to 60°. */
const course: PageCourse = {
  is: "PageCourse", unit: "s", time: numbers(0, 2, 3), crank_angle: numbers(0, 90, 60), step: 0.1,
  paces: [{ is: "PagePace", rate: 1, words: "" }, { is: "PagePace", rate: 0.5, words: "" }], at_first: 1, words,
};

function passing() {
  const frames: ((time: number) => void)[] = [];
  const one = new Passing(course, () => undefined, (next) => { frames.push(next); });
  return { one, pass: (time: number) => { frames.shift()?.(time); } };
}

const near = (one: number, other: number): void => { assert.ok(Math.abs(one - other) < 1e-4, `${one} ${other}`); };

describe("time that passes", () => {
  it("turns the crank as the course does", () => {
    const { one } = passing();
    for (const [time, angle] of [[0, 0], [1, 45], [2, 90], [2.5, 75], [3, 60]] as const) {
      one.stand(time);
      near(one.angle, angle);
    }
  });
  it("stays within the course", () => {
    const { one } = passing();
    one.stand(9);
    assert.equal(one.time, 3);
    one.stand(-9);
    assert.equal(one.time, 0);
  });
  it("goes on by whole steps", () => {
    const { one } = passing();
    one.stand(1.234);
    one.step(1);
    near(one.time, 1.3);
    one.step(-10);
    near(one.time, 0.3);
    one.home();
    assert.equal(one.time, 0);
  });
  it("passes at its pace, ends at the end, and begins again", () => {
    const { one, pass } = passing();
    one.stand(2.98);
    one.play();
    pass(1000);
    pass(1020);
    near(one.time, 2.99);
    pass(1120);
    assert.equal(one.time, 3);
    assert.equal(one.isPlaying, false);
    one.toggle();
    assert.equal(one.isPlaying, true);
    assert.equal(one.time, 0);
  });
  it("goes to where the crank is dragged, over the nearest moment at which it stood there", () => {
    const { one } = passing();
    one.stand(1);
    one.turn(15);
    near(one.time, 4 / 3);
    one.turn(-30);
    near(one.time, 2 / 3);
    one.stand(2.9);
    one.turn(7);
    near(one.angle, 70);
    near(one.time, 2 + 2 / 3);
    one.turn(1000);
    near(one.angle, 70);
  });
});
