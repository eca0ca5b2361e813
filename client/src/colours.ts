// Light or dark: as the system has it, or as somebody chose, which the browser remembers; on paper always light.

import type { PageWords } from "./data.ts";
import { html, write } from "./elements.ts";
import { onPaper } from "./paper.ts";

const CHOICES = ["system", "light", "dark"] as const;
type Choice = (typeof CHOICES)[number];

const KEPT = "cranktrain-colours";

/** The choice of colours, which the whole page takes from its root. */
export class Colours {
  readonly element = html("select", { class: "colours" });
  private readonly system = matchMedia("(prefers-color-scheme: dark)");
  private readonly options = CHOICES.map((value) => html("option", { value }));
  private readonly followers: (() => void)[] = [];
  private choice: Choice = remembered();
  private isOnPaper = false;

  constructor() {
    this.element.append(...this.options);
    this.element.value = this.choice;
    this.element.addEventListener("change", () => {
      this.choice = this.element.value as Choice;
      remember(this.choice);
      this.apply();
    });
    this.system.addEventListener("change", () => { this.apply(); });
    onPaper((isOnPaper) => {
      this.isOnPaper = isOnPaper;
      this.apply();
    });
    this.apply();
  }

  /** Say the choices in the words of a page. */
  take(words: PageWords): void {
    this.element.setAttribute("aria-label", words.colours);
    this.element.title = words.colours;
    const said = [words.colours_of_system, words.light, words.dark];
    this.options.forEach((option, place) => { write(option, said[place] ?? ""); });
  }

  /** Tell whenever other colours, or paper, are to be drawn on. */
  follow(changed: () => void): void {
    this.followers.push(changed);
  }

  private apply(): void {
    const isDark = !this.isOnPaper && (this.choice === "dark" || (this.choice === "system" && this.system.matches));
    document.documentElement.dataset["colours"] = isDark ? "dark" : "light";
    for (const changed of this.followers) changed();
  }
}

/** What was chosen before; the frame of a notebook may remember nothing. */
function remembered(): Choice {
  try {
    const kept = localStorage.getItem(KEPT);
    return CHOICES.find((one) => one === kept) ?? "system";
  } catch {
    return "system";
  }
}

function remember(choice: Choice): void {
  try {
    localStorage.setItem(KEPT, choice);
  } catch {
    return; // a frame that may remember nothing
  }
}
