// The page of a service: a machine is chosen, its numbers are changed, and all that is shown follows.

import "uplot/dist/uPlot.min.css";
import "./style.css";
import "./paper.css";

import { Address, type Asked } from "./address.ts";
import { Colours } from "./colours.ts";
import type { CaseWords, PageCase, PageTrust, TabContent } from "./data.ts";
import { html } from "./elements.ts";
import { Form, type Problem } from "./form.ts";
import { revived } from "./numbers.ts";
import { MachinePage, type Source } from "./page.ts";

/** From when on it is shown that something is computed. [ms] */
const PATIENCE = 150;

/** Asked for, one after the other, and which of them is shown: what is behind it may be done again. */
class Steps {
  private readonly all: Asked[];
  private place = 0;

  constructor(first: Asked) {
    this.all = [first];
  }

  get now(): Asked {
    return this.all[this.place] as Asked;
  }

  /** Whether there is a step back, or on. */
  has(by: number): boolean {
    return this.all[this.place + by] !== undefined;
  }

  go(by: number): void {
    if (this.has(by)) this.place += by;
  }

  add(asked: Asked): void {
    this.all.splice(this.place + 1, Infinity, asked);
    this.place += 1;
  }
}

class App {
  private readonly steps: Steps;
  private readonly side = html("aside", { class: "side" });
  private readonly view = html("div", { class: "view" });
  private readonly machines = html("select", {});
  private readonly undo = html("button", { type: "button" });
  private readonly redo = html("button", { type: "button" });
  private readonly save = html("button", { type: "button" });
  private readonly beside = html("select", {});
  private readonly besideLabel = html("label", {});
  private readonly keep = html("button", { type: "button" });
  /** Cases to compare with, by what they are called. */
  private readonly cases = new Map<string, Asked>();
  private readonly label = html("label", {});
  private form: Form | null = null;
  private shownMachine = "";
  private page: MachinePage | null = null;
  private readonly address = new Address();
  private readonly colours = new Colours();
  private asking = new AbortController();

  constructor(into: HTMLElement, file: string, examples: readonly string[]) {
    const { asked } = this.address;
    const first = asked.machine || file ? asked : { machine: "3d12", settings: asked.settings };
    this.steps = new Steps(first);
    this.machines.append(...(file ? [html("option", { value: "" }, file)] : []), ...examples.map((name) => html("option", { value: name }, name)));
    this.machines.addEventListener("change", () => {
      this.ask({ machine: this.machines.value, settings: new Map() });
    });
    this.beside.addEventListener("change", () => { this.compare(this.cases.get(this.beside.value)); });
    this.keep.addEventListener("click", () => { this.compare(this.steps.now); });
    this.undo.addEventListener("click", () => { this.walk(-1); });
    this.redo.addEventListener("click", () => { this.walk(1); });
    this.save.addEventListener("click", () => { void this.download(); });
    document.addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
      event.preventDefault();
      this.walk(event.shiftKey ? 1 : -1);
    });
    this.label.append(this.machines);
    const bar = html("header", { class: "bar" }, html("b", {}, "cranktrain"), this.label, this.undo, this.redo, this.save, this.besideLabel, this.keep, this.colours.element);
    into.replaceChildren(bar, html("div", { class: "app" }, this.side, this.view));
  }

  private walk(by: number): void {
    this.steps.go(by);
    void this.show();
  }

  private set(path: string, text: string): void {
    const settings = new Map(this.steps.now.settings);
    if (text) settings.set(path, text);
    else settings.delete(path);
    this.ask({ ...this.steps.now, settings });
  }

  /** Put a saved case beside what is shown, or nothing. */
  private compare(saved: Asked | undefined): void {
    const { machine, settings } = this.steps.now;
    this.ask({ machine, settings, ...(saved ? { beside: { machine: saved.machine, settings: saved.settings } } : {}) });
  }

  private ask(asked: Asked): void {
    this.steps.add(asked);
    void this.show();
  }

  /** Ask for what is to be shown, and show it; of several that are asked for the last alone. */
  async show(): Promise<void> {
    this.asking.abort();
    this.asking = new AbortController();
    const { signal } = this.asking;
    const asked = this.steps.now;
    const late = setTimeout(() => { this.view.classList.add("computing"); }, PATIENCE);
    try {
      const answer = await ask("api/case", asked, signal, this.address.place.tab);
      const found = answer.ok ? opened(await answer.arrayBuffer()) : ((await answer.json()) as Problem[]);
      if (signal.aborted) return;
      if (Array.isArray(found)) this.blame(found as Problem[]);
      else this.fill(found as PageCase, asked);
    } catch (error) {
      if (!signal.aborted) this.blame([{ path: "", given: null, allowed: String(error), repair: null }]);
    } finally {
      clearTimeout(late);
      if (!signal.aborted) this.view.classList.remove("computing");
    }
  }

  private fill(found: PageCase, asked: Asked): void {
    const { words } = found;
    this.address.ask(asked);
    this.machines.value = asked.machine;
    this.label.replaceChildren(`${words.machine} `, this.machines);
    for (const [button, word, by] of [[this.undo, words.undo, -1], [this.redo, words.redo, 1]] as const) {
      button.textContent = word;
      button.disabled = !this.steps.has(by);
    }
    this.save.textContent = words.save;
    this.fillCases(asked, words);
    if (!this.form?.fits(found.tables) || this.shownMachine !== asked.machine) {
      this.form = new Form(words.numbers, found.tables, (path, text) => { this.set(path, text); }, words.as_in_file);
      this.side.replaceChildren(this.form.element);
    }
    this.shownMachine = asked.machine;
    this.form.fill(found.tables, asked.settings);
    this.form.blame([]);
    const { signal } = this.asking;
    const source: Source = {
      tab: async (name) => (await this.more("api/tab", asked, signal, name)) as TabContent,
      trust: async () => (await this.more("api/trust", asked, signal)) as PageTrust,
    };
    if (this.page) this.page.take(found.machine, source);
    else this.page = new MachinePage(found.machine, this.view, this.address, this.colours, source);
  }

  /** Offer what may stand beside: the file as it is, what was kept, and what stands there. */
  private fillCases(asked: Asked, words: CaseWords): void {
    const name = (one: Asked): string =>
      [...(one.machine === asked.machine ? [] : [one.machine]), [...one.settings].map((setting) => setting.join(" = ")).join(", ") || words.as_in_file].join(": ");
    const own = { machine: asked.machine, settings: new Map<string, string>() };
    for (const one of [own, ...(asked.beside ? [asked.beside] : [])]) this.cases.set(name(one), one);
    this.beside.replaceChildren(html("option", { value: "" }, "–"), ...[...this.cases].map(([called]) => html("option", { value: called }, called)));
    this.beside.value = asked.beside ? name(asked.beside) : "";
    this.besideLabel.replaceChildren(`${words.compare} `, this.beside);
    this.keep.textContent = words.keep;
  }

  /** Ask for more of what is shown; of what is shown no longer nothing comes. */
  private async more(where: string, asked: Asked, signal: AbortSignal, tab?: string): Promise<unknown> {
    try {
      const answer = await ask(where, asked, signal, tab);
      if (answer.ok) return opened(await answer.arrayBuffer());
      this.blame((await answer.json()) as Problem[]);
    } catch (error) {
      if (!signal.aborted) this.blame([{ path: "", given: null, allowed: String(error), repair: null }]);
    }
    return new Promise(() => undefined);
  }

  private blame(problems: readonly Problem[]): void {
    if (this.form) this.form.blame(problems);
    else this.view.replaceChildren(...problems.map((one) => html("p", { class: "problems" }, `✗ ${one.path} ${one.allowed}`)));
    this.undo.disabled = !this.steps.has(-1);
  }

  private async download(): Promise<void> {
    const asked = this.steps.now;
    const answer = await ask("api/file", asked);
    if (!answer.ok) {
      this.blame((await answer.json()) as Problem[]);
      return;
    }
    const link = html("a", { href: URL.createObjectURL(await answer.blob()), download: `${asked.machine || "machine"}.toml` });
    link.click();
    URL.revokeObjectURL(link.href);
  }
}

async function ask(where: string, asked: Asked, signal: AbortSignal | null = null, tab?: string): Promise<Response> {
  const sent = ({ machine, settings }: Asked): object => ({ machine, settings: [...settings].map(([path, text]) => `${path}=${text}`) });
  const body = JSON.stringify({ ...sent(asked), tab, ...(asked.beside ? { beside: sent(asked.beside) } : {}) });
  return fetch(where, { method: "POST", headers: { "Content-Type": "application/json" }, body, signal });
}

/** Read data: a length, so much JSON, and numbers. */
function opened(answer: ArrayBuffer): unknown {
  const length = new DataView(answer).getUint32(0, true);
  const data: unknown = JSON.parse(new TextDecoder().decode(new Uint8Array(answer, 4, length)));
  return revived(data, new Float32Array(answer, 4 + length));
}

async function start(): Promise<void> {
  const into = document.getElementById("page");
  if (!into) return;
  // The browser keeps the token: it need not stand where others look on.
  if (location.search) history.replaceState(null, "", location.pathname + location.hash);
  const examples = (await (await fetch("api/examples")).json()) as { name: string }[];
  await new App(into, into.dataset["file"] ?? "", examples.map((one) => one.name)).show();
}

void start();
