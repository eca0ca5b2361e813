// The choice of a language, where there are several.

import type { PageCase } from "./data.ts";
import { html, offer } from "./elements.ts";

export class Languages {
  readonly element = html("select", { class: "language" });

  constructor(chosen: (code: string) => void) {
    this.element.addEventListener("change", () => { chosen(this.element.value); });
  }

  /** Offer the languages that there are, and say in which the page is; whether it was in another before. */
  take({ language, languages, words }: PageCase): boolean {
    offer(this.element, languages.map((one) => [one.code, one.name]), language);
    for (const one of this.element.options) if (one.lang !== one.value) one.lang = one.value;
    this.element.title = words.language;
    this.element.setAttribute("aria-label", words.language);
    this.element.hidden = languages.length < 2;
    const before = document.documentElement.lang;
    // Written anew, the same language would have the browser lay out the whole page again.
    if (before !== language) document.documentElement.lang = language;
    return before !== language;
  }
}
