// Bundle what pages run, beside the package that sends it.

import { build } from "esbuild";

await build({
  entryPoints: { standalone: "src/standalone.ts" },
  outdir: "../src/cranktrain/web/built",
  bundle: true,
  minify: true,
  format: "iife",
  target: ["es2022"],
  charset: "utf8",
  legalComments: "none",
});
