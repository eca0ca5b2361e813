// Words that go along with what moves on a picture: where they stand clear of each other, of words that stand still, and of the edges.

/** Edges of a picture, or of words on it. */
export interface Edges {
  readonly left: number;
  readonly right: number;
  readonly top: number;
  readonly bottom: number;
}

/** Where words may stand: at their beginning, middle or end; on a line, or about its middle. */
export interface Place {
  readonly x: number;
  readonly y: number;
  readonly anchor: "start" | "middle" | "end";
  readonly isCentral: boolean;
}

/** Of letters, in pixels: width of one, about; how far they go over the line and under it, and from their middle. */
const WIDTH = 7.8;
const OVER = 10;
const UNDER = 3;
const HALF = 7;

/** What no eye sees. */
const HIDDEN = /\u200b/g;

export class Labels {
  /** What a pixel of the window is in the picture since words were put last. */
  pixel = 1;
  private readonly edges: Edges;
  private readonly measured: () => number;
  private readonly still: (readonly [string, Place])[] = [];
  private others: readonly (readonly [string, Place])[] = [];
  private taken: Edges[] = [];

  /** Words within edges; `measured` gives what a pixel of the window is in the picture. */
  constructor(edges: Edges, measured: () => number) {
    this.edges = edges;
    this.measured = measured;
  }

  /** Keep clear of words that always stand where they are. */
  keepClear(words: string, place: Place): void {
    this.still.push([words, place]);
  }

  /** Keep clear of other words too, in place of those before. */
  keepClearOf(others: readonly (readonly [string, Place])[]): void {
    this.others = others;
  }

  /** Begin anew, before what moves is put where it is now. */
  begin(): void {
    this.pixel = this.measured();
    this.taken = [...this.still, ...this.others].map(([words, place]) => boxOf(words, place, this.pixel));
  }

  /** Choose where words stand: the first of several places, moved within the edges, where nothing else is, or where least is. */
  put(words: string, places: Iterable<Place>): Place | null {
    const { pixel } = this;
    let [found, box, least]: [Place | null, Edges | null, number] = [null, null, Infinity];
    for (const one of places) {
      const place = within(this.edges, one, boxOf(words, one, pixel));
      const own = boxOf(words, place, pixel);
      const covered = this.taken.reduce((sum, other) => sum + shared(own, other), 0);
      if (covered < least) [found, box, least] = [place, own, covered];
      if (covered === 0) break;
    }
    if (box) this.taken.push(box);
    return found;
  }
}

function boxOf(words: string, { x, y, anchor, isCentral }: Place, pixel: number): Edges {
  const width = words.replace(HIDDEN, "").length * WIDTH * pixel;
  const left = x - width * { start: 0, middle: 0.5, end: 1 }[anchor];
  const [over, under] = isCentral ? [HALF, HALF] : [OVER, UNDER];
  return { left, right: left + width, top: y - over * pixel, bottom: y + under * pixel };
}

/** A place moved so far that what stands there is within edges. */
function within(edges: Edges, place: Place, box: Edges): Place {
  const x = Math.max(edges.left - box.left, 0) || Math.min(edges.right - box.right, 0);
  const y = Math.max(edges.top - box.top, 0) || Math.min(edges.bottom - box.bottom, 0);
  return { ...place, x: place.x + x, y: place.y + y };
}

/** Area that two boxes share. */
const shared = (one: Edges, other: Edges): number =>
  Math.max(Math.min(one.right, other.right) - Math.max(one.left, other.left), 0) * Math.max(Math.min(one.bottom, other.bottom) - Math.max(one.top, other.top), 0);
