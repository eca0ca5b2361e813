// The crank angle that all pictures share, and its turning.

/** One turn in so many seconds. */
const TURN = 4;

/** Asks for a call at the next picture. [ms] */
export type Frame = (next: (time: number) => void) => void;

export const soon: Frame = (next) => { requestAnimationFrame(next); };

/** A crank angle within a cycle, which turns or stands. */
export class Turning {
  angle = 0;
  isPlaying = false;
  /** After which all begins again. [deg] */
  cycle: number;
  private readonly changed: (angle: number, isPlaying: boolean) => void;
  private readonly frame: Frame;
  private last = 0;

  constructor(cycle: number, changed: (angle: number, isPlaying: boolean) => void, frame: Frame = soon) {
    this.cycle = cycle;
    this.changed = changed;
    this.frame = frame;
  }

  get place(): number {
    return this.angle;
  }

  get end(): number {
    return this.cycle;
  }

  /** Stand at an angle. [deg] */
  stand(angle: number): void {
    this.angle = angle === this.cycle ? angle : ((angle % this.cycle) + this.cycle) % this.cycle;
    this.changed(this.angle, this.isPlaying);
  }

  /** Go on by an angle, over the end of the cycle. [deg] */
  step(by: number): void {
    this.stop();
    this.stand(this.angle === this.cycle ? by : this.angle + by);
  }

  home(): void {
    this.step(-this.angle);
  }

  /** Go on by an angle, as it is. [deg] */
  turn(by: number): void {
    this.stop();
    this.stand(this.angle + by);
  }

  play(): void {
    if (this.isPlaying) return;
    this.isPlaying = true;
    this.last = NaN;
    this.frame((time) => { this.next(time); });
    this.changed(this.angle, true);
  }

  /** Stand, at a whole degree. */
  stop(): void {
    if (!this.isPlaying) return;
    this.isPlaying = false;
    this.stand(Math.round(this.angle));
  }

  toggle(): void {
    if (this.isPlaying) this.stop();
    else this.play();
  }

  private next(time: number): void {
    if (!this.isPlaying) return;
    const passed = Number.isNaN(this.last) ? 0 : Math.min(time - this.last, 100);
    this.last = time;
    this.stand(this.angle + (0.36 * passed) / TURN);
    this.frame((later) => { this.next(later); });
  }
}
