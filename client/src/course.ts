// Time in which the crank turns, as a start has it, and how it passes.

import type { PageCourse } from "./data.ts";
import { at, interpolated, number } from "./numbers.ts";
import { Running, soon, type Frame } from "./turning.ts";

/** A time between the beginning and the end of a course, which passes or stands. */
export class Passing extends Running {
  readonly course: PageCourse;
  time = 0;
  /** How much of it passes in a second of who looks. */
  rate: number;
  private readonly changed: () => void;

  constructor(course: PageCourse, changed: () => void, frame: Frame = soon) {
    super(frame);
    this.course = course;
    this.rate = number(course.paces[course.at_first]?.rate);
    this.changed = changed;
  }

  get place(): number {
    return this.time;
  }

  get end(): number {
    return at(this.course.time, this.course.time.values.length - 1);
  }

  /** Crank angle at this time, counted on. [deg] */
  get angle(): number {
    return interpolated(this.course.time.values, this.course.crank_angle.values, this.time);
  }

  /** Stand at a time. */
  stand(time: number): void {
    this.time = Math.min(Math.max(time, 0), this.end);
    this.changed();
  }

  step(by: number): void {
    this.stop();
    const step = number(this.course.step);
    this.stand((Math.round(this.time / step) + by) * step);
  }

  home(): void {
    this.stop();
    this.stand(0);
  }

  /** Go to where the crank stands nearest to an angle from here on, forth or back in time as it turned. [deg] */
  turn(by: number): void {
    this.stop();
    const [time, angle] = [this.course.time.values, this.course.crank_angle.values];
    const wanted = this.angle + by;
    const here = time.findIndex((one) => one >= this.time);
    for (let far = 0; far < time.length; far++) {
      for (const place of [here + far, here - far]) {
        const [first, next] = [angle[place - 1], angle[place]];
        if (first === undefined || next === undefined || first === next || (first - wanted) * (next - wanted) > 0) continue;
        const start = at(this.course.time, place - 1);
        this.stand(start + ((wanted - first) / (next - first)) * (at(this.course.time, place) - start));
        return;
      }
    }
  }

  /** Let time pass, from the beginning where it has passed. */
  override play(): void {
    if (!this.isPlaying && this.time >= this.end) this.time = 0;
    super.play();
  }

  protected tell(): void {
    this.changed();
  }

  protected rest(): void {
    this.changed();
  }

  protected pass(passed: number): void {
    const later = this.time + (passed / 1000) * this.rate;
    if (later >= this.end) this.isPlaying = false;
    this.stand(later);
  }
}
