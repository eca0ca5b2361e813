// The choice of a machine: each with a small drawing, found by any words.

import type { Gallery, GalleryItem } from "./data.ts";
import { html } from "./elements.ts";
import { Mechanism } from "./mechanism.ts";

/** What may be chosen. */
export interface Choices {
  readonly example: (item: GalleryItem) => void;
  readonly kind: (item: GalleryItem) => void;
  readonly file: () => void;
}

/** At which crank angle machines stand in their pictures. [deg] */
const ANGLE = 50;

/** A dialog of machines to begin with. */
export class GalleryDialog {
  readonly element = html("dialog", { class: "gallery" });
  private readonly cards: { card: HTMLElement; words: string }[] = [];

  constructor({ examples, kinds, words }: Gallery, choices: Choices) {
    const search = html("input", { type: "text", placeholder: words.search, "aria-label": words.search });
    const none = html("p", { class: "note", hidden: "" }, words.none);
    const close = html("button", { type: "button" }, words.close);
    const open = html("button", { type: "button" }, words.open);
    const sections = [html("h2", {}, words.examples), this.list(examples, choices.example), html("h2", {}, words.kinds), this.list(kinds, choices.kind)];
    search.addEventListener("input", () => {
      const asked = search.value.toLowerCase().split(/\s+/);
      for (const { card, words: own } of this.cards) card.hidden = !asked.every((word) => own.includes(word));
      none.hidden = this.cards.some(({ card }) => !card.hidden);
    });
    close.addEventListener("click", () => { this.element.close(); });
    open.addEventListener("click", () => {
      this.element.close();
      choices.file();
    });
    this.element.append(html("div", { class: "gallery-head" }, search, open, close), none, ...sections);
  }

  private list(items: readonly GalleryItem[], choose: (item: GalleryItem) => void): HTMLElement {
    return html("div", { class: "cards" }, ...items.map((item) => {
      const drawing = new Mechanism(item.drawing, item.title);
      drawing.show(ANGLE);
      const card = html("button", { type: "button", class: "card", value: item.name, title: item.made_of }, drawing.element, html("b", {}, item.title), html("span", {}, item.kind));
      card.addEventListener("click", () => {
        this.element.close();
        choose(item);
      });
      this.cards.push({ card, words: `${item.name} ${item.title} ${item.kind} ${item.made_of}`.toLowerCase() });
      return card;
    }));
  }
}
