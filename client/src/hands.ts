// What keys do, and dragging round the shaft.

import type { Mechanism } from "./mechanism.ts";
import type { Turning } from "./turning.ts";

/** Keys turn the crank, or do something else by where they are, unless somebody types. */
export function pressed(event: KeyboardEvent, turning: Turning, others: Readonly<Record<string, () => void>>): void {
  const { target } = event;
  if (event.ctrlKey || event.metaKey || event.altKey) return;
  if (target instanceof HTMLElement && (target.isContentEditable || /^(TEXTAREA|SELECT|SUMMARY)$/.test(target.tagName))) return;
  if (target instanceof HTMLInputElement && target.type !== "range") return;
  const by = event.shiftKey ? 10 : 1;
  if (event.key === "ArrowRight") turning.step(by);
  else if (event.key === "ArrowLeft") turning.step(-by);
  else if (event.key === "Home") turning.step(-turning.angle);
  else if (event.key === " " && !(target instanceof HTMLButtonElement)) turning.toggle();
  else if (others[event.code]) others[event.code]?.();
  else return;
  event.preventDefault();
}

/** Dragging round the first shaft turns the crank. */
export function dragged(stage: HTMLElement, mechanism: () => Mechanism, turning: Turning): void {
  let before = NaN;
  const direction = (event: PointerEvent): number => mechanism().directionOf(event.clientX, event.clientY);
  stage.addEventListener("pointerdown", (event) => {
    turning.stop();
    stage.setPointerCapture(event.pointerId);
    before = direction(event);
  });
  stage.addEventListener("pointermove", (event) => {
    if (Number.isNaN(before)) return;
    const now = direction(event);
    const by = ((now - before + 540) % 360) - 180;
    before = now;
    turning.stand(turning.angle + by);
  });
  for (const end of ["pointerup", "pointercancel"]) stage.addEventListener(end, () => { before = NaN; });
}
