import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { askedIn, languageIn, placeIn, withAsked, withLanguage, withPlace } from "../src/address.ts";
import { sentIn, sentOf } from "../src/sent.ts";

describe("an address", () => {
  it("gives the same place again", () => {
    for (const place of [{ tab: "Torque and evenness", angle: 428, time: NaN }, { tab: "Start", angle: 0, time: 2.125 }, { tab: "Balance", angle: NaN, time: NaN }]) {
      assert.deepEqual(placeIn(withPlace("#tab=7&phi=1", place)), place);
    }
  });
  it("leaves out what is none", () => {
    assert.deepEqual(placeIn("#tab=x&phi=NaN"), { tab: "x", angle: NaN, time: NaN });
    assert.deepEqual(placeIn(""), { tab: "", angle: NaN, time: NaN });
  });
  it("gives the same machine with the same numbers again, whatever stands in them", async () => {
    const settings = new Map([["shaft.main.speed", "1800 rpm"], ['load."a & b".size', "1 kN·m = ?"]]);
    const hash = withAsked("#tab=Balance&phi=70&machine=vaz_21213&cylinder.bore=1 mm", { machine: "3d12", settings });
    assert.deepEqual(await askedIn(hash), { machine: "3d12", settings });
    assert.deepEqual(placeIn(hash), { tab: "Balance", angle: 70, time: NaN });
  });
  it("keeps its language whatever else is asked for", async () => {
    const hash = withPlace(withAsked(withLanguage("", "ru"), { machine: "3d12", settings: new Map() }), { tab: "Gas", angle: 3, time: NaN });
    assert.equal(languageIn(hash), "ru");
    assert.deepEqual((await askedIn(hash)).settings, new Map());
    assert.equal(languageIn(withLanguage(hash, "")), "");
  });
  it("gives the saved case beside it again", async () => {
    const beside = { machine: "", settings: new Map([["cylinder.bore", "1 & 2 mm"]]) };
    const asked = { machine: "3d12", settings: new Map([["cylinder.bore", "3 mm"]]), beside };
    assert.deepEqual(await askedIn(withAsked("", asked)), asked);
  });
  it("has a machine as text, with the files that it names", async () => {
    const sent = await sentOf("мотор.toml", "# Ω\n[mechanism]\n".repeat(200), { "card.csv": "1;2\n" });
    assert.ok(sent.letters.length < 300);
    assert.deepEqual(await sentIn(sent.letters), sent);
    const asked = { machine: "", settings: new Map([["cylinder.bore", "3 mm"]]), sent, beside: { machine: "3d12", settings: new Map<string, string>() } };
    assert.deepEqual(await askedIn(withAsked("", asked)), asked);
  });
  it("has no machine where its letters are broken", async () => {
    for (const letters of ["", "x", "AAAA", (await sentOf("a", "b")).letters.slice(0, -3)]) assert.equal(await sentIn(letters), null);
  });
});
