// A page that stands alone: its data lie beside it in the file.

import "uplot/dist/uPlot.min.css";
import "./style.css";
import "./paper.css";

import { Address } from "./address.ts";
import { Colours } from "./colours.ts";
import type { ShownMachine } from "./data.ts";
import { unpacked } from "./numbers.ts";
import { MachinePage } from "./page.ts";

async function opened(): Promise<ArrayBuffer> {
  const text = document.getElementById("data")?.textContent ?? "";
  const bytes = Uint8Array.from(atob(text.trim()), (letter) => letter.charCodeAt(0));
  return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"))).arrayBuffer();
}

async function start(): Promise<void> {
  const page = unpacked(await opened()) as ShownMachine;
  const into = document.getElementById("page");
  if (!into) return;
  const colours = new Colours();
  new MachinePage(page, into, new Address(location.hash), colours).head.append(colours.element);
}

void start();
