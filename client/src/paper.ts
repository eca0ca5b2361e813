// What a page does while it is printed: it takes the width of a sheet, and what is folded stands open.

const ROOT = document.documentElement;
const FOLDED = ".checks, .to-mind details";

/** How much finer than a screen curves are on paper. */
const FINER = 3;

/** Call when printing begins, and when it is over; which of its two signs a browser gives first is no matter. */
export function onPaper(changed: (isOnPaper: boolean) => void): void {
  let before = false;
  let opened: HTMLDetailsElement[] = [];
  const take = (isOnPaper: boolean): void => {
    if (isOnPaper === before) return;
    before = isOnPaper;
    ROOT.classList.toggle("on-paper", isOnPaper);
    for (const one of opened) one.open = false;
    opened = isOnPaper ? [...document.querySelectorAll<HTMLDetailsElement>(FOLDED)].filter((one) => !one.open) : [];
    for (const one of opened) one.open = true;
    changed(isOnPaper);
  };
  addEventListener("beforeprint", () => { take(true); });
  addEventListener("afterprint", () => { take(false); });
  matchMedia("print").addEventListener("change", ({ matches }) => { take(matches); });
}

/** How many times finer than the screen a canvas is drawn. */
export const fineness = (): number => (ROOT.classList.contains("on-paper") ? FINER : 1);
