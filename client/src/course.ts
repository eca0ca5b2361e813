// Time in which the crank turns, as a start has it, and how it passes.

import type { PageCourse } from "./data.ts";
import { at, interpolated, number } from "./numbers.ts";
import { soon, type Frame } from "./turning.ts";

/** A time between the beginning and the end of a course, which passes or stands. */
export class Passing {
  readonly course: PageCourse;
  time = 0;
  isPlaying = false;
  /** How much of it passes in a second of who looks. */
  rate: number;
  private readonly changed: () => void;
  private readonly frame: Frame;
  private last = NaN;

  constructor(course: PageCourse, changed: () => void, frame: Frame = soon) {
    this.course = course;
    this.rate = number(course.paces[course.at_first]?.rate);
    this.changed = changed;
    this.frame = frame;
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
  play(): void {
    if (this.isPlaying) return;
    if (this.time >= this.end) this.time = 0;
    this.isPlaying = true;
    this.last = NaN;
    this.frame((time) => { this.next(time); });
    this.changed();
  }

  stop(): void {
    if (!this.isPlaying) return;
    this.isPlaying = false;
    this.changed();
  }

  toggle(): void {
    if (this.isPlaying) this.stop();
    else this.play();
  }

  private next(time: number): void {
    if (!this.isPlaying) return;
    const passed = Number.isNaN(this.last) ? 0 : Math.min(time - this.last, 100);
    this.last = time;
    const later = this.time + (passed / 1000) * this.rate;
    if (later >= this.end) this.isPlaying = false;
    else this.frame((next) => { this.next(next); });
    this.stand(later);
  }
}
