// The crank angle that all pictures share, and its turning.

/** One turn in so many seconds. */
const TURN = 4;

/** Asks for a call at the next picture. [ms] */
export type Frame = (next: (time: number) => void) => void;

export const soon: Frame = (next) => { requestAnimationFrame(next); };

/** So much passes at most between two pictures: a page that was hidden does not leap. [ms] */
const MOST = 100;

/** What goes on by itself from picture to picture, or stands. */
export abstract class Running {
  isPlaying = false;
  private readonly frame: Frame;
  private last = NaN;

  constructor(frame: Frame) {
    this.frame = frame;
  }

  play(): void {
    if (this.isPlaying) return;
    this.isPlaying = true;
    this.last = NaN;
    this.ask();
    this.tell();
  }

  stop(): void {
    if (!this.isPlaying) return;
    this.isPlaying = false;
    this.rest();
  }

  toggle(): void {
    if (this.isPlaying) this.stop();
    else this.play();
  }

  /** Say where it is now. */
  protected abstract tell(): void;

  /** Stand, where it has just stopped. */
  protected abstract rest(): void;

  /** Go on. [ms] */
  protected abstract pass(passed: number): void;

  private ask(): void {
    this.frame((time) => { this.next(time); });
  }

  private next(time: number): void {
    if (!this.isPlaying) return;
    const passed = Number.isNaN(this.last) ? 0 : Math.min(time - this.last, MOST);
    this.last = time;
    this.pass(passed);
    if (this.isPlaying) this.ask();
  }
}

/** A crank angle within a cycle, which turns or stands. */
export class Turning extends Running {
  angle = 0;
  /** After which all begins again. [deg] */
  cycle: number;
  private readonly changed: (angle: number, isPlaying: boolean) => void;

  constructor(cycle: number, changed: (angle: number, isPlaying: boolean) => void, frame: Frame = soon) {
    super(frame);
    this.cycle = cycle;
    this.changed = changed;
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
    this.tell();
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

  protected tell(): void {
    this.changed(this.angle, this.isPlaying);
  }

  /** Stand at a whole degree. */
  protected rest(): void {
    this.stand(Math.round(this.angle));
  }

  protected pass(passed: number): void {
    this.stand(this.angle + (0.36 * passed) / TURN);
  }
}
