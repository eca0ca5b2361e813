import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { askedIn, placeIn, withAsked, withPlace } from "../src/address.ts";

describe("an address", () => {
  it("gives the same place again", () => {
    for (const place of [{ tab: "Torque and evenness", angle: 428 }, { tab: "", angle: 0 }, { tab: "Balance", angle: NaN }]) {
      assert.deepEqual(placeIn(withPlace("#tab=7&phi=1", place)), place);
    }
  });
  it("leaves out what is none", () => {
    assert.deepEqual(placeIn("#tab=x&phi=NaN"), { tab: "x", angle: NaN });
    assert.deepEqual(placeIn(""), { tab: "", angle: NaN });
  });
  it("gives the same machine with the same numbers again, whatever stands in them", () => {
    const settings = new Map([["shaft.main.speed", "1800 rpm"], ['load."a & b".size', "1 kN·m = ?"]]);
    const hash = withAsked("#tab=Balance&phi=70&machine=vaz_21213&cylinder.bore=1 mm", { machine: "3d12", settings });
    assert.deepEqual(askedIn(hash), { machine: "3d12", settings });
    assert.deepEqual(placeIn(hash), { tab: "Balance", angle: 70 });
  });
  it("gives the saved case beside it again", () => {
    const beside = { machine: "", settings: new Map([["cylinder.bore", "1 & 2 mm"]]) };
    const asked = { machine: "3d12", settings: new Map([["cylinder.bore", "3 mm"]]), beside };
    assert.deepEqual(askedIn(withAsked("", asked)), asked);
  });
});
