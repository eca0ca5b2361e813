// What keys do, and dragging round the shaft.

import type { Cursor } from "./controls.ts";
import type { Mechanism } from "./mechanism.ts";


/** Keys turn the crank, or do something else by where they are, unless somebody types. */
export function pressed(event: KeyboardEvent, cursor: Cursor, others: Readonly<Record<string, () => void>>): void {
  const { target } = event;
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (target instanceof HTMLElement && (target.isContentEditable || /^(TEXTAREA|SELECT)$/.test(target.tagName))) return;
  if (target instanceof HTMLInputElement && target.type !== "range") return;
  const by = event.shiftKey ? 10 : 1;
  if (event.key === "ArrowRight") cursor.step(by);
  else if (event.key === "ArrowLeft") cursor.step(-by);
  else if (event.key === "Home") cursor.home();
  else if (event.key === " " && !isOpenedBySpace(target)) cursor.toggle();
  else if (others[event.code]) others[event.code]?.();
  else return;
  event.preventDefault();
}

/** Whether the space key does something to an element of its own accord. */
const isOpenedBySpace = (target: EventTarget | null): boolean => target instanceof HTMLElement && /^(BUTTON|SUMMARY)$/.test(target.tagName);

/** Dragging round the first shaft turns the crank. */
export function dragged(stage: HTMLElement, mechanism: () => Mechanism, cursor: () => Cursor): void {
  let before = NaN;
  const direction = (event: PointerEvent): number => mechanism().directionOf(event.clientX, event.clientY);
  stage.addEventListener("pointerdown", (event) => {
    cursor().stop();
    stage.setPointerCapture(event.pointerId);
    before = direction(event);
  });
  stage.addEventListener("pointermove", (event) => {
    if (Number.isNaN(before)) return;
    const now = direction(event);
    const by = ((now - before + 540) % 360) - 180;
    before = now;
    cursor().turn(by);
  });
  for (const end of ["pointerup", "pointercancel"]) stage.addEventListener(end, () => { before = NaN; });
}
