// The page of a service: a machine is chosen, its numbers are changed, and all that is shown follows.

import "uplot/dist/uPlot.min.css";
import "./style.css";
import "./paper.css";

import { Address, type Asked, askedIn, last } from "./address.ts";
import { ask, look, opened, Refused } from "./asking.ts";
import { Bar } from "./bar.ts";
import { Colours } from "./colours.ts";
import type { CaseWords, Gallery, PageCase, PageGoingOn, PageHandles, PageMembers, PageOffer, PageOthers, PageWhence, TabContent } from "./data.ts";
import { DesignTab } from "./design.ts";
import { html } from "./elements.ts";
import { Form, lines, sentence, type Problem } from "./form.ts";
import { GalleryDialog } from "./gallery.ts";
import type { Editing } from "./handles.ts";
import { Languages } from "./languages.ts";
import { MachinePage, type Source } from "./page.ts";
import { sentOf } from "./sent.ts";
import { Steps } from "./steps.ts";
import { WhenceDialog } from "./whence.ts";
import { said } from "./words.ts";

/** Where a problem lies that is none of the machine: a link may name a language that is not there. */
const LANGUAGE = "language";

/** From when on it is shown that something is computed. [ms] */
const PATIENCE = 150;

/** What is shown where no file is served and nobody asks for anything. */
const FIRST = "3d12";

/** What the tab on which numbers are varied is called in addresses. */
const DESIGN = "Design";

/** How the name of a machine file ends. */
const MACHINE_FILE = ".toml";

class App {
  private readonly steps: Steps;
  /** What is shown where nobody asks for anything. */
  private readonly first: string;
  private readonly side = html("aside", { class: "side" });
  private readonly offered = html("div", { class: "offers" });
  private readonly view = html("div", { class: "view" });
  private readonly files = html("input", { type: "file", multiple: "", accept: ".toml,.csv,.txt,.dat", hidden: "", tabindex: -1 });
  private readonly bar: Bar;
  private readonly address: Address;
  private readonly colours = new Colours();
  private readonly design: DesignTab;
  private readonly languages = new Languages((code) => { this.speak(code); });
  private noAnswer = "";
  private readonly whence = new WhenceDialog((path) => { this.form?.go(path); });
  private form: Form | null = null;
  private shown: Asked | null = null;
  private page: MachinePage | null = null;
  private gallery: GalleryDialog | null = null;
  private words: CaseWords | null = null;
  private asking = new AbortController();
  /** Handles of what was asked for last. */
  private handles: { readonly of: Asked; readonly found: PageHandles } | null = null;

  constructor(into: HTMLElement, file: string, examples: readonly string[], address: Address, asked: Asked) {
    this.address = address;
    this.first = file ? "" : FIRST;
    this.steps = new Steps(asked.machine || asked.sent ? asked : { ...asked, machine: this.first });
    this.bar = new Bar(file, examples, {
      machine: (name) => { this.ask({ machine: name, settings: new Map() }); },
      gallery: () => { void this.choose(); },
      open: () => { this.files.click(); },
      walk: (by) => { this.walk(by); },
      save: () => { void this.save(); },
      export: (suffix) => { void this.export(suffix); },
      beside: (saved) => { this.compare(saved); },
    }, this.languages.element, this.colours.element);
    this.design = new DesignTab({
      load: (settings) => { this.ask({ ...this.steps.now, settings: new Map([...this.steps.now.settings, ...settings]) }); },
      language: () => this.address.language,
      wrong: (error) => this.problemsOf(error),
    });
    this.files.addEventListener("change", () => { void this.open([...(this.files.files ?? [])]); });
    document.addEventListener("dragover", (event) => { event.preventDefault(); });
    document.addEventListener("drop", (event) => {
      event.preventDefault();
      void this.open([...(event.dataTransfer?.files ?? [])]);
    });
    addEventListener("hashchange", () => { void this.follow(location.hash); });
    document.addEventListener("keydown", (event) => {
      if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
      event.preventDefault();
      this.walk(event.shiftKey ? 1 : -1);
    });
    into.replaceChildren(this.bar.element, html("div", { class: "app" }, this.side, this.view), this.files, this.whence.element);
  }

  private speak(code: string): void {
    this.address.speak(code);
    void this.show();
  }

  /** Show what an address has that is typed, pasted or gone back to where the page is open. */
  private async follow(hash: string): Promise<void> {
    this.address.go(hash);
    const asked = await askedIn(hash);
    this.page?.go(this.address.place);
    this.ask(asked.machine || asked.sent ? asked : { ...asked, machine: this.first });
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
  private compare(saved: Asked | "this" | null): void {
    const { beside: _before, ...now } = this.steps.now;
    const beside = saved === "this" ? now : saved;
    this.ask(beside ? { ...now, beside } : now);
  }

  private ask(asked: Asked): void {
    this.steps.add(asked);
    void this.show();
  }

  /** Show machines to begin with. */
  private async choose(): Promise<void> {
    if (!this.gallery) {
      let found: Gallery;
      try {
        found = (await opened(await look(`api/gallery?language=${encodeURIComponent(this.address.language)}`))) as Gallery;
      } catch (error) {
        this.fail(error);
        return;
      }
      this.gallery = new GalleryDialog(found, {
        example: ({ name }) => { this.ask({ machine: name, settings: new Map() }); },
        kind: ({ name, text }) => { void this.take(name, text); },
        file: () => { this.files.click(); },
      });
      document.body.append(this.gallery.element);
    }
    this.gallery.element.showModal();
  }

  /** Take a machine as text. */
  private async take(name: string, text: string, files: Readonly<Record<string, string>> = {}): Promise<void> {
    this.ask({ machine: "", sent: await sentOf(name, text, files), settings: new Map() });
  }

  /** Open a machine file with the files that it names; of these alone for the machine that is shown. */
  private async open(files: readonly File[]): Promise<void> {
    this.files.value = "";
    if (!files.length) return;
    const texts = await Promise.all(files.map(async (file) => [file.name, await file.text()] as const));
    const [machine, second] = texts.filter(([name]) => name.toLowerCase().endsWith(MACHINE_FILE));
    const others = texts.filter((one) => one !== machine && one !== second);
    const { sent } = this.steps.now;
    const [name, text, before] = machine ? [...machine, {}] : sent ? [sent.name, sent.text, sent.files] : [this.steps.now.machine, await this.fileText(), {}];
    if (text === null) return;
    const stray = [...(second ? [[second[0], this.words?.second] as const] : []), ...others.filter(([other]) => !text.includes(other)).map(([other]) => [other, this.words?.unnamed] as const)];
    if (stray.length) this.blame(stray.map(([path, allowed]) => ({ path, given: null, allowed: allowed ?? "", repair: null, instead: [] })));
    else await this.take(name, text, { ...before, ...Object.fromEntries(others) });
  }

  /** Ask for what is to be shown, and show it; of several that are asked for the last alone. */
  async show(): Promise<void> {
    this.asking.abort();
    this.asking = new AbortController();
    const { signal } = this.asking;
    const asked = this.steps.now;
    const late = setTimeout(() => { this.view.classList.add("computing"); }, PATIENCE);
    try {
      const found = (await opened(await ask("api/case", asked, { language: this.address.language, tab: this.address.place.tab }, signal))) as PageCase;
      if (!signal.aborted) this.fill(found, asked);
    } catch (error) {
      if (signal.aborted) return;
      if (this.address.language && error instanceof Refused && error.problems.some((one) => one.path === LANGUAGE)) this.speak("");
      else {
        const instead = this.page || !(error instanceof Refused) ? null : this.insteadOf(asked);
        if (instead) {
          this.steps.change(instead);
          await this.show();
        } else {
          this.form?.mark(asked.settings);
        }
        this.fail(error);
      }
    } finally {
      clearTimeout(late);
      if (!signal.aborted) this.view.classList.remove("computing");
    }
  }

  /** What is shown where the first that was asked for cannot be: the machine as in its file, or else the first of all. */
  private insteadOf({ machine, sent, settings, beside }: Asked): Asked | null {
    if (settings.size || beside) return { machine, ...(sent && { sent }), settings: new Map() };
    return sent || machine !== this.first ? { machine: this.first, settings: new Map() } : null;
  }

  private fill(found: PageCase, asked: Asked): void {
    const { words } = found;
    this.words = words;
    this.address.ask(asked);
    this.bar.take(asked, words, (by) => this.steps.has(by));
    this.noAnswer = words.no_answer;
    const isInAnother = this.languages.take(found);
    if (isInAnother) {
      this.gallery?.element.remove();
      this.gallery = null;
    }
    if (isInAnother || !this.form?.fits(found.tables) || this.shown?.machine !== asked.machine || this.shown.sent !== asked.sent) {
      this.form = new Form(words.numbers, found.tables, (path, text) => { this.set(path, text); }, words.as_in_file);
      this.offered.replaceChildren();
      this.side.replaceChildren(this.form.element, this.offered);
    }
    this.shown = asked;
    this.form.fill(found.tables, asked.settings);
    this.form.blame([]);
    const { signal } = this.asking;
    const source: Source = {
      tab: async (name) => (await this.more("api/tab", asked, signal, name)) as TabContent,
      others: async (name) => (await this.more("api/others", asked, signal, name)) as PageOthers,
      trust: async () => {
        const { trust, offers, facts, exports } = (await this.more("api/trust", asked, signal)) as PageGoingOn;
        this.offer(offers, words.more);
        this.design.offer(facts);
        this.bar.offer(exports);
        return trust;
      },
      members: async () => (await this.more("api/members", asked, signal)) as PageMembers,
      pick: (piston) => { this.ask({ ...this.steps.now, piston }); },
      whence: (quantity) => { void this.tellWhence(quantity, found); },
      editing: this.editing(found, asked, signal),
    };
    this.design.take(asked, found.tables, found.varied, words.design);
    const own = [{ name: DESIGN, title: words.design.title, element: this.design.element, fit: () => { this.design.fit(); } }];
    if (this.page) this.page.take(found.machine, source, own);
    else this.page = new MachinePage(found.machine, this.view, this.address, this.colours, source, own);
  }

  /** How pins are moved and parts are added on the drawing: first it is asked whether there is such a machine. */
  private editing(shown: PageCase, asked: Asked, signal: AbortSignal): Editing {
    const inputs = shown.tables.flatMap((table) => table.inputs);
    return {
      word: shown.words.move,
      nameOf: (path) => inputs.find((one) => one.path === path)?.name ?? path,
      handles: async () => {
        if (this.handles?.of !== asked) this.handles = { of: asked, found: (await this.more("api/handles", asked, signal)) as PageHandles };
        return this.handles.found;
      },
      adding: shown.words.adding,
      change: (texts, isNext) => this.go(() => Promise.resolve({ ...asked, settings: new Map([...asked.settings, ...texts]) }), isNext),
      add: (addition) => this.go(async () => {
        const text = await (await ask("api/file", asked, { language: this.address.language, addition })).text();
        const sent = await sentOf(asked.sent?.name ?? asked.machine, text, asked.sent?.files);
        return { ...asked, machine: "", sent, settings: new Map() };
      }, false),
    };
  }

  /** Go on to another machine, in the same step as before or in one of its own, or say why there is none. */
  private async go(made: () => Promise<Asked>, isNext: boolean): Promise<string> {
    try {
      const next = await made();
      const found = (await opened(await ask("api/handles", next, { language: this.address.language }))) as PageHandles;
      if (found.open.length) return found.open[0] as string;
      this.handles = { of: next, found };
      if (isNext) this.steps.change(next);
      else this.steps.add(next);
    } catch (error) {
      if (!(error instanceof Refused)) return String(error);
      return sentence(error.problems.find((one) => one.path !== "") ?? (error.problems[0] as Problem));
    }
    await this.show();
    return "";
  }

  /** Show where a number is from. */
  private async tellWhence(quantity: string, { tables, words }: PageCase): Promise<void> {
    try {
      const found = (await opened(await ask("api/whence", this.steps.now, { language: this.address.language, quantity }))) as PageWhence;
      this.whence.show(found, tables, words);
    } catch (error) {
      this.fail(error);
    }
  }

  /** Ask for more of what is shown; of what is shown no longer nothing comes. */
  private async more(where: string, asked: Asked, signal: AbortSignal, tab = ""): Promise<unknown> {
    try {
      return await opened(await ask(where, asked, { language: this.address.language, tab }, signal));
    } catch (error) {
      if (!signal.aborted) this.fail(error);
      return new Promise(() => undefined);
    }
  }

  /** Offer tables that the file has not. */
  private offer(offers: readonly PageOffer[], title: string): void {
    const chips = offers.map(({ key, words }) => {
      const chip = html("button", { type: "button", class: "chip" }, html("b", {}, `[${key}]`), " ", said(words));
      chip.addEventListener("click", () => { void this.add(key); });
      return chip;
    });
    this.offered.replaceChildren(...(chips.length ? [html("h2", {}, title), ...chips] : []));
  }

  /** Add a table to the file. */
  private async add(key: string): Promise<void> {
    const { machine, sent } = this.steps.now;
    const text = await this.fileText(key);
    if (text !== null) await this.take(sent?.name ?? machine, text, sent?.files);
  }

  /** The text of the machine file with all numbers in place, and with another table; nothing where it cannot be. */
  private async fileText(key = ""): Promise<string | null> {
    try {
      return await (await ask("api/file", this.steps.now, { language: this.address.language, key })).text();
    } catch (error) {
      this.fail(error);
      return null;
    }
  }

  /** What is wrong where something failed. */
  private problemsOf(error: unknown): readonly Problem[] {
    return error instanceof Refused ? error.problems : [{ path: "", given: null, allowed: this.noAnswer || String(error), repair: null, instead: [] }];
  }

  private fail(error: unknown): void {
    this.blame(this.problemsOf(error));
  }

  private blame(problems: readonly Problem[]): void {
    const file = this.steps.now.sent?.name;
    if (this.form) this.form.blame(problems, file);
    else this.view.replaceChildren(html("div", { class: "problems", role: "alert" }, ...lines(problems, file)));
    this.bar.steps((by) => this.steps.has(by));
  }

  private async save(): Promise<void> {
    const text = await this.fileText();
    if (text !== null) this.hand(MACHINE_FILE, new Blob([text]));
  }

  /** Take a file of what is computed away. */
  private async export(suffix: string): Promise<void> {
    const late = setTimeout(() => { this.view.classList.add("computing"); }, PATIENCE);
    try {
      const answer = await ask("api/export", this.steps.now, { language: this.address.language, tab: this.address.place.tab, suffix });
      this.hand(suffix, await answer.blob());
    } catch (error) {
      this.fail(error);
    } finally {
      clearTimeout(late);
      this.view.classList.remove("computing");
    }
  }

  /** Have the browser keep a file. */
  private hand(suffix: string, content: Blob): void {
    const { machine, sent } = this.steps.now;
    const name = (sent?.name ?? (machine || "machine")).replace(/\.toml$/, "");
    const link = html("a", { href: URL.createObjectURL(content), download: name + suffix });
    link.click();
    URL.revokeObjectURL(link.href);
  }
}

async function start(): Promise<void> {
  // The browser keeps the token: it need not stand where others look on.
  if (location.search) history.replaceState(null, "", location.pathname + location.hash);
  const into = document.getElementById("page");
  if (!into) return;
  const examples = (await (await fetch("api/examples")).json()) as { name: string }[];
  const file = into.dataset["file"] ?? "";
  const hash = location.hash || (file ? "" : last());
  await new App(into, file, examples.map((one) => one.name), new Address(hash), await askedIn(hash)).show();
}

void start();
