import assert from "node:assert/strict";
import { describe, it } from "node:test";

import { Labels, type Place } from "../src/labels.ts";

const EDGES = { left: 0, right: 200, top: 0, bottom: 100 };
const place = (x: number, y: number, anchor: Place["anchor"] = "start"): Place => ({ x, y, anchor, isCentral: true });

describe("words that go along", () => {
  const labels = new Labels(EDGES, () => 1);
  labels.keepClear("100 mm", place(10, 90));

  it("stand at the first place where nothing is", () => {
    labels.begin();
    assert.deepEqual(labels.put("v", [place(100, 50), place(20, 20)]), place(100, 50));
    assert.deepEqual(labels.put("v", [place(20, 90), place(104, 52), place(100, 20)]), place(100, 20));
  });
  it("stay within the edges, however long they are", () => {
    labels.begin();
    const found = labels.put("a name", [place(2, 3, "middle")]);
    assert.ok(found && found.x > 20 && found.y >= 7);
    const other = labels.put("another", [place(199, 99)]);
    assert.ok(other && other.x < 150 && other.y < 94);
  });
  it("forget where they stood when they are put anew, and words that stand no longer", () => {
    labels.keepClearOf([["5 m/s", place(100, 50)]]);
    labels.begin();
    assert.deepEqual(labels.put("v", [place(100, 50), place(20, 20)]), place(20, 20));
    labels.keepClearOf([]);
    labels.begin();
    assert.deepEqual(labels.put("v", [place(100, 50), place(20, 20)]), place(100, 50));
  });
  it("cover least where there is no room", () => {
    labels.begin();
    assert.deepEqual(labels.put("v", [place(20, 90), place(20, 78)]), place(20, 78));
  });
  it("stand nowhere where nobody knows where they would", () => {
    labels.begin();
    assert.equal(labels.put("v", [place(NaN, NaN)]), null);
  });
});
