import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { hashOf, placeIn } from "../src/address.ts";

describe("an address", () => {
  it("gives the same place again", () => {
    for (const place of [{ tab: 3, angle: 428 }, { tab: 0, angle: 0 }, { tab: 2, angle: NaN }]) assert.deepEqual(placeIn(hashOf(place)), place);
  });
  it("leaves out what is none", () => {
    assert.deepEqual(placeIn("#tab=x&phi=NaN&tab=-3"), { tab: 0, angle: NaN });
    assert.deepEqual(placeIn("#tab=-3"), { tab: 0, angle: NaN });
    assert.deepEqual(placeIn(""), { tab: 0, angle: NaN });
  });
});
