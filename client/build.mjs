// Bundle what pages run, beside the package that sends it.

import { readFile } from "node:fs/promises";

import { build } from "esbuild";

const license = await readFile("node_modules/uplot/LICENSE", "utf8");

await build({
  entryPoints: { standalone: "src/standalone.ts", app: "src/app.ts" },
  outdir: "../src/cranktrain/web/built",
  bundle: true,
  minify: true,
  format: "iife",
  target: ["es2022"],
  charset: "utf8",
  legalComments: "none",
  banner: { js: `/* With uPlot:\n${license.trim()}\n*/` },
});
