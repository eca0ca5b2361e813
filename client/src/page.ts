// A page of one machine: the mechanism beside its curves, tab by tab, all at one crank angle.

import type { Address, Place } from "./address.ts";
import type { Colours } from "./colours.ts";
import { Controls, type Cursor } from "./controls.ts";
import { Passing } from "./course.ts";
import type { PageCourse, PageMembers, PageOthers, PagePiston, PageTab, PageTrust, ShownMachine, TabContent } from "./data.ts";
import { html, renewChildren, write } from "./elements.ts";
import { Handles, type Editing } from "./handles.ts";
import { dragged, pressed } from "./hands.ts";
import { Mechanism } from "./mechanism.ts";
import { Members } from "./members.ts";
import { number, same } from "./numbers.ts";
import type { View } from "./placing.ts";
import { hasDifferences, Sheets } from "./sheets.ts";
import { answer, checks, table } from "./tables.ts";
import { Throws } from "./throws.ts";
import { Turning } from "./turning.ts";
import { VectorChoice } from "./vectors.ts";
import { said } from "./words.ts";

/** Characters from which on a sentence with a list is folded. */
const LONG = 180;

/** Width of a drawing in parts of its height from which on it stands over all else. */
const WIDE = 1.8;

/** For so long nobody changes anything, before what needs everything is asked for. [ms] */
const PAUSE = 250;

/** Where more of a page is from, that it did not come with. */
export interface Source {
  readonly tab: (name: string) => Promise<TabContent>;
  readonly trust: () => Promise<PageTrust>;
  /** Give what curves of one piston on a tab are of the others. */
  readonly others: (tab: string) => Promise<PageOthers>;
  readonly members: () => Promise<PageMembers>;
  /** Show the throw and the curves of a piston. */
  readonly pick: (piston: string) => void;
  /** Show where a number is from. */
  readonly whence: (quantity: string) => void;
  readonly editing?: Editing;
}

/** A tab that is not asked for: it makes what stands on it itself. */
export interface OwnTab {
  readonly name: string;
  readonly title: string;
  readonly element: HTMLElement;
  readonly fit: () => void;
}

/** A machine on a page; another, or the same with other numbers, takes its place where it stands. */
export class MachinePage {
  readonly turning: Turning;
  readonly head: HTMLElement;
  private readonly address: Address;
  private readonly colours: Colours;
  private readonly title = html("h1", {});
  private readonly made = html("p", {});
  private readonly tabs = html("nav", { class: "tabs", role: "tablist" });
  private readonly columns: HTMLElement;
  private readonly stage = html("div", { class: "stage" });
  private readonly controls: Controls;
  private readonly throws = new Throws((piston) => { this.source?.pick(piston); });
  private readonly members = new Members();
  private readonly leftOut = html("p", { class: "note" });
  private readonly answers = html("div", { class: "answers" });
  private readonly restsOn = html("p", { class: "rests-on" });
  private readonly sentence = html("p", { class: "sentence", "aria-live": "polite" });
  private readonly checked = html("div", {});
  private readonly toMind = html("div", {});
  private readonly differ = html("button", { type: "button", class: "differ", "aria-pressed": "false" });
  private readonly others = html("button", { type: "button", class: "differ all-pistons", "aria-pressed": "false" });
  private readonly othersHint = html("p", { class: "note others-hint", hidden: "" });
  /** Curves of other pistons that were asked for last, and beside which content. */
  private otherCurves: { readonly beside: TabContent; readonly found: PageOthers } | null = null;
  private readonly sheets: Sheets;
  private readonly vectors = new VectorChoice((shown) => { this.mechanism.takeVectors(this.passing ? [] : shown); }, (tab) => { this.load(tab); });
  private readonly panel: HTMLElement;
  private readonly ghostsWord = html("span", {});
  private readonly ghosts = html("button", { type: "button", class: "choice", title: "G", "aria-pressed": "false" }, this.ghostsWord);
  private readonly handles: Handles;
  private mechanism: Mechanism;
  /** Time that the open tab is over, if it is. */
  private passing: Passing | null = null;
  /** Time that the address asked for. [s] */
  private asked = NaN;
  private said = "";
  private restsOnSaid = "";
  private page: ShownMachine;
  private own: readonly OwnTab[];
  private readonly ownPanel = html("div", { class: "sheets", role: "tabpanel", hidden: "" });
  private source: Source | undefined;
  private contents = new Map<string, TabContent | null>();
  private trust: PageTrust | null = null;

  constructor(page: ShownMachine, into: HTMLElement, address: Address, colours: Colours, source?: Source, own: readonly OwnTab[] = []) {
    this.page = page;
    this.own = own;
    this.address = address;
    this.colours = colours;
    this.mechanism = new Mechanism(page.drawing, page.words.drawing);
    this.turning = new Turning(number(page.cycle), () => { this.stand(); });
    this.handles = new Handles({
      stage: this.stage,
      mechanism: () => this.mechanism,
      angle: () => this.cursor.angle,
      stop: () => { this.cursor.stop(); },
      redraw: (view) => { this.redraw(view); },
    });
    this.controls = new Controls(this.turning, page.words);
    this.sheets = new Sheets((place) => {
      this.cursor.stop();
      this.cursor.stand(place);
    });
    this.panel = html("div", { class: "sheets", role: "tabpanel" }, html("div", { class: "tools" }, this.othersHint, this.others, this.differ), this.sheets.element);
    this.differ.addEventListener("click", () => {
      this.differ.setAttribute("aria-pressed", `${!this.isOfDifferences}`);
      this.choose(this.chosen);
    });
    this.others.addEventListener("click", () => {
      this.others.setAttribute("aria-pressed", `${!this.isWithOthers}`);
      this.choose(this.chosen);
    });
    this.tabs.addEventListener("keydown", (event) => { this.walk(event); });
    this.vectors.element.addEventListener("click", () => { this.stand(); });
    this.answers.addEventListener("click", ({ target }) => {
      const way = target instanceof Element ? target.closest<HTMLButtonElement>(".way") : null;
      if (way) this.source?.whence(way.value);
    });
    const right = html("section", { class: "right" }, this.toMind, this.panel, this.ownPanel);
    this.columns = html(
      "div", { class: "columns" },
      html("section", { class: "drawing" }, this.stage, this.controls.element, this.throws.element, html("div", { class: "choices" }, this.vectors.element, this.ghosts, this.handles.button), this.handles.adding.element, this.controls.keys, this.leftOut),
      html("section", { class: "left" }, this.answers, this.members.element, this.checked),
      right,
    );
    this.head = html("header", { class: "head" }, this.title, this.made);
    into.replaceChildren(this.head, this.tabs, this.sentence, this.restsOn, this.columns);
    dragged(this.stage, () => this.mechanism, () => this.cursor);
    this.ghosts.addEventListener("click", () => { this.haunt(true); });
    document.addEventListener("keydown", (event) => { pressed(event, this.cursor, { KeyG: () => { this.haunt(true); }, KeyE: () => { this.handles.toggle(); } }); });
    let width = right.clientWidth;
    new ResizeObserver(() => {
      if (right.clientWidth === width) return;
      width = right.clientWidth;
      this.fit();
    }).observe(right);
    colours.follow(() => { this.fit(); });
    const { angle, time } = address.place;
    this.asked = time;
    this.turning.stand(Number.isNaN(angle) ? 0 : angle);
    this.fill(page, source);
    if (Number.isNaN(angle) && !matchMedia("(prefers-reduced-motion: reduce)").matches) this.cursor.play();
  }

  /** Stand at the crank angle or the time of an address; its tab comes with its machine. */
  go({ angle, time }: Place): void {
    this.asked = time;
    const place = this.passing ? time : angle;
    if (Number.isNaN(place)) return;
    this.cursor.stop();
    this.cursor.stand(place);
  }

  /** Show a machine in place of what is shown; its tab, its crank angle and all that stays the same stay. */
  take(page: ShownMachine, source?: Source, own: readonly OwnTab[] = []): void {
    this.own = own;
    const { drawing, words } = this.page;
    if (!same([drawing, words.drawing], [page.drawing, page.words.drawing])) this.mechanism = new Mechanism(page.drawing, page.words.drawing, this.handles.view);
    if (!same(words, page.words)) this.trust = null;
    this.fill(page, source);
  }

  private fill(page: ShownMachine, source: Source | undefined): void {
    const { words } = page;
    this.page = page;
    this.source = source;
    this.contents = new Map(page.tabs.map((tab) => [tab.name, tab.content]));
    const [title, made] = page.name ? [page.name, page.made_of] : [page.made_of, ""];
    this.colours.take(words);
    write(this.title, title);
    write(this.made, made);
    this.fillTabs();
    this.turning.cycle = number(page.cycle);
    this.controls.take(this.cursor, words);
    write(this.differ, words.differences);
    write(this.others, words.others);
    write(this.othersHint, words.others_hint);
    write(this.ghostsWord, words.ghosts);
    this.haunt();
    this.fillPistons(page);
    this.vectors.element.setAttribute("aria-label", words.vectors);
    write(this.leftOut, page.drawing.left_out.length ? `${words.left_out} ${page.drawing.left_out.join(", ")}` : "");
    if (this.stage.firstChild !== this.mechanism.element) this.stage.replaceChildren(this.mechanism.element);
    this.columns.classList.toggle("wide", this.mechanism.aspect > WIDE);
    const { members } = page;
    const ask = members ? () => Promise.resolve(members) : source?.members;
    if (ask) this.members.take(ask, number(page.cycle), words.members);
    if (page.trust) this.rely(page.trust);
    else if (source) {
      setTimeout(() => {
        if (this.source === source) void source.trust().then((found) => { if (this.source === source) this.rely(found); });
      }, this.trust ? PAUSE : 0);
    }
    this.choose(this.chosen);
    this.handles.take(source?.editing);
  }

  /** Draw the mechanism anew, in a view or as it fits. */
  private redraw(view?: View): void {
    this.mechanism = new Mechanism(this.page.drawing, this.page.words.drawing, view);
    this.stage.replaceChildren(this.mechanism.element);
    if (!view) this.columns.classList.toggle("wide", this.mechanism.aspect > WIDE);
    this.haunt();
    this.vectors.take(this.contents, this.chosen?.name ?? "");
    this.stand();
  }

  /** Offer the pistons whose throw may be shown, where it can be asked for. */
  private fillPistons({ pistons, throws, drawing, words }: ShownMachine): void {
    this.throws.element.hidden = !this.source || pistons.length === 0;
    const { piston } = this.address;
    const isDrawn = (one: PagePiston): boolean => drawing.mechanisms.some(({ name }) => name === one.name);
    const shown = pistons.find((one) => one.name === piston) ?? pistons.find((one) => one.name === drawing.mechanisms[0]?.name) ?? pistons.find(isDrawn);
    this.throws.take(pistons, throws, words, shown?.name ?? "");
  }

  /** Show a tab, as soon as it is there. */
  private choose(tab: PageTab | OwnTab | undefined): void {
    if (!tab) return;
    const { name } = tab;
    const own = "element" in tab ? tab : null;
    const panel = own ? this.ownPanel : this.panel;
    for (const button of this.buttons) {
      const isChosen = button.value === name;
      const isOther = isChosen && button.getAttribute("aria-selected") !== "true";
      button.setAttribute("aria-selected", `${isChosen}`);
      if (isOther) inView(this.tabs, button);
      button.tabIndex = isChosen ? 0 : -1;
      if (isChosen) panel.setAttribute("aria-labelledby", button.id);
    }
    this.keep(name);
    this.panel.hidden = own !== null;
    this.ownPanel.hidden = own === null;
    this.sentence.hidden = own !== null;
    this.restsOn.hidden = own !== null;
    if (own) {
      if (this.ownPanel.firstChild !== own.element) this.ownPanel.replaceChildren(own.element);
      own.fit();
      const first = this.page.tabs.find((one) => one.content);
      if (first?.content) this.show(first.content);
      return;
    }
    const content = this.contents.get(name);
    this.panel.classList.toggle("computing", !content);
    if (content) {
      this.show(content);
      return;
    }
    this.load(name);
  }

  /** Ask for what is on a tab. */
  private load(name: string): void {
    const { source } = this;
    void source?.tab(name).then((found) => {
      if (this.source !== source) return;
      this.contents.set(name, found);
      const open = this.chosen?.name ?? "";
      if (open === name) this.show(found);
      else {
        this.vectors.take(this.contents, open);
        this.stand();
      }
    });
  }

  private show(content: TabContent): void {
    this.panel.classList.remove("computing");
    if (this.said !== content.sentence) this.sentence.replaceChildren(said(content.sentence));
    this.said = content.sentence;
    if (this.restsOnSaid !== content.rests_on) this.restsOn.replaceChildren(said(content.rests_on));
    this.restsOnSaid = content.rests_on;
    this.fillAnswers(content);
    this.differ.hidden = !hasDifferences(content);
    this.sheets.take(content, this.page.words.numbers, this.isOfDifferences);
    this.showOthers(content);
    this.follow(content.course);
    this.vectors.take(this.contents, this.chosen?.name ?? "");
    this.vectors.element.hidden = content.course !== null;
    this.members.element.hidden = content.course !== null;
    this.stand();
  }

  /** Show the rows of an answer, where those before stand, and beside a saved case their differences. */
  private fillAnswers({ answer: group, beside }: TabContent): void {
    const made = answer(group, this.source !== undefined);
    if (beside || this.answers.childElementCount > 1) this.answers.replaceChildren(made, ...(beside ? [table(beside)] : []));
    else renewChildren(this.answers, [made]);
  }

  /** Show the curves of the pistons that are not chosen, as soon as they are there, or none; until then those before stay. */
  private showOthers(content: TabContent): void {
    const { source, page: { words } } = this;
    const isThere = content.has_others && !this.isOfDifferences;
    const isOn = isThere && this.isWithOthers;
    this.others.hidden = !isThere;
    this.othersHint.hidden = !isOn;
    const found = content.others ?? (this.otherCurves?.beside === content ? this.otherCurves.found : null);
    if (!isOn || found) {
      this.sheets.takeOthers(isOn ? found : null, words.others);
      return;
    }
    const { name } = this.chosen ?? { name: "" };
    const isWanted = (): boolean => this.source === source && this.contents.get(name) === content;
    setTimeout(() => {
      if (isWanted()) void source?.others(name).then((others) => {
        if (!isWanted()) return;
        this.otherCurves = { beside: content, found: others };
        if (this.chosen?.name === name) this.showOthers(content);
      });
    }, this.sheets.hasOthers ? PAUSE : 0);
  }

  /** Have the crank turn over the time of a tab, or over its cycle: it stays where it stands, and turning goes on. */
  private follow(course: PageCourse | null): void {
    const { cursor, passing } = this;
    if (!course && !passing) return;
    const { isPlaying, angle } = cursor;
    cursor.isPlaying = false;
    if (course) {
      this.passing = new Passing(course, () => { this.stand(); });
      const time = passing?.time ?? this.asked;
      if (!Number.isNaN(time)) this.passing.time = Math.min(Math.max(time, 0), this.passing.end);
      this.asked = NaN;
      if (passing) this.passing.rate = passing.rate;
    } else {
      this.passing = null;
      this.turning.stand(angle);
    }
    this.controls.take(this.cursor, this.page.words);
    if (isPlaying) this.cursor.play();
  }

  /** Show the dead centres, or not. */
  private haunt(isOther = false): void {
    const isOn = (this.ghosts.getAttribute("aria-pressed") === "true") !== isOther;
    this.ghosts.setAttribute("aria-pressed", `${isOn}`);
    this.mechanism.showGhosts(isOn ? this.page.ghosts.values : []);
  }

  /** Say what is to be minded, and how checks came out. */
  private rely(found: PageTrust): void {
    if (same(found, this.trust)) return;
    this.trust = found;
    this.toMind.replaceChildren(...minded(found.to_mind));
    this.checked.replaceChildren(checks(found.checks, this.page.words.checks));
  }

  private get cursor(): Cursor {
    return this.passing ?? this.turning;
  }

  private stand(): void {
    const { cursor } = this;
    this.mechanism.show(cursor.angle);
    if (this.handles.adding.isBegun) this.handles.adding.show();
    this.sheets.show(cursor.place);
    if (!this.passing) this.members.show(cursor.angle);
    this.controls.show();
    if (!cursor.isPlaying || !Number.isNaN(this.address.place.angle)) this.keep(this.address.place.tab);
  }

  private keep(tab: string): void {
    const { cursor, passing } = this;
    const stands = !cursor.isPlaying;
    this.address.stand({ tab, angle: stands ? cursor.angle : NaN, time: stands && passing ? passing.time : NaN });
  }

  /** The tab that the address names, or the first. */
  private get chosen(): PageTab | OwnTab | undefined {
    const { tab } = this.address.place;
    return this.all.find((one) => one.name === tab) ?? this.page.tabs[0];
  }

  /** All tabs in their order. */
  private get all(): readonly (PageTab | OwnTab)[] {
    return [...this.page.tabs, ...this.own];
  }

  private fit(): void {
    this.sheets.fit();
    for (const one of this.own) one.fit();
  }

  /** Whether curves of one piston are to be shown with those of the others. */
  private get isWithOthers(): boolean {
    return this.others.getAttribute("aria-pressed") === "true";
  }

  /** Whether curves are to be shown as differences from a saved case. */
  private get isOfDifferences(): boolean {
    return this.differ.getAttribute("aria-pressed") === "true";
  }

  private get buttons(): HTMLButtonElement[] {
    return [...this.tabs.querySelectorAll("button")];
  }

  private fillTabs(): void {
    const tabs = this.all;
    if (same(this.buttons.map((one) => [one.value, one.title]), tabs.map((one) => [one.name, one.title]))) return;
    const made = tabs.map((tab, place) => {
      const button = html("button", { type: "button", role: "tab", id: `tab-${place}`, value: tab.name, title: tab.title }, said(tab.title));
      button.addEventListener("click", () => { this.choose(this.all.find((one) => one.name === tab.name)); });
      return button;
    });
    this.tabs.replaceChildren(...made);
  }

  /** Arrow keys go from tab to tab. */
  private walk(event: KeyboardEvent): void {
    const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (!by) return;
    event.preventDefault();
    event.stopPropagation();
    const { buttons } = this;
    const now = buttons.findIndex((one) => one.tabIndex === 0);
    const next = (now + by + buttons.length) % buttons.length;
    this.choose(this.all[next]);
    buttons[next]?.focus();
  }
}

/** Scroll a line so far that one of it is seen; the page stays. */
function inView(line: HTMLElement, one: HTMLElement): void {
  const [room, box] = [line.getBoundingClientRect(), one.getBoundingClientRect()];
  line.scrollLeft += Math.max(box.right - room.right, 0) - Math.max(room.left - box.left, 0);
}

/** What is to be minded: of a long list its head, and all of it where somebody asks. */
function minded(sentences: readonly string[]): HTMLElement[] {
  if (!sentences.length) return [];
  const folded = new Map<string, HTMLElement>();
  const items = sentences.map((sentence) => {
    const [head = "", ...rest] = sentence.split(": ");
    const isFolded = sentence.length >= LONG && rest.length > 0;
    if (!isFolded) return html("li", {}, said(sentence));
    // What begins with the same words is told under them once.
    const more = html("p", {}, said(rest.join(": ")));
    const before = folded.get(head);
    before?.append(more);
    if (before) return null;
    const own = html("details", {}, html("summary", {}, said(head), " …"), more);
    folded.set(head, own);
    return html("li", {}, own);
  });
  return [html("ul", { class: "to-mind" }, ...items.filter((one) => one !== null))];
}
