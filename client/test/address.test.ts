import { describe, expect, it } from "vitest";

import { hashOf, placeIn } from "../src/address";

describe("an address", () => {
  it("gives the same place again", () => {
    for (const place of [{ tab: 3, angle: 428 }, { tab: 0, angle: 0 }, { tab: 2, angle: NaN }]) expect(placeIn(hashOf(place))).toEqual(place);
  });
  it("leaves out what is none", () => {
    expect(placeIn("#tab=x&phi=NaN&tab=-3")).toEqual({ tab: 0, angle: NaN });
    expect(placeIn("#tab=-3")).toEqual({ tab: 0, angle: NaN });
    expect(placeIn("")).toEqual({ tab: 0, angle: NaN });
  });
});
