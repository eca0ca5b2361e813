// Elements of a page and of pictures on it.

type Attributes = Readonly<Record<string, string | number>>;
type Child = Node | string;

/** Make an element of HTML. */
export function html<Tag extends keyof HTMLElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[Tag] {
  const element = document.createElement(tag);
  return filled(element, attributes, children);
}

/** Make an element of SVG. */
export function svg<Tag extends keyof SVGElementTagNameMap>(
  tag: Tag,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[Tag] {
  const element = document.createElementNS("http://www.w3.org/2000/svg", tag);
  return filled(element, attributes, children);
}

/** Make a picture whose text is of one size, however large it is shown. */
export function picture(name: string, box: readonly [number, number, number, number], ...children: Child[]): SVGSVGElement {
  const attributes = { class: name, viewBox: box.map((one) => +one.toFixed(2)).join(" "), role: "img" };
  const made = svg("svg", attributes, ...children);
  new ResizeObserver(() => {
    const { width, height } = made.getBoundingClientRect();
    const shown = made.viewBox.baseVal;
    const scale = Math.min(width / shown.width, height / shown.height);
    const pixel = `${(1 / scale).toFixed(4)}px`;
    if (scale > 0 && made.style.getPropertyValue("--pixel") !== pixel) made.style.setProperty("--pixel", pixel);
  }).observe(made);
  return made;
}

/** Let keys scroll an element of a name where it is wider than its room. */
export function scrolling(element: HTMLElement, name: string): void {
  new ResizeObserver(() => {
    const isWider = element.scrollWidth > element.clientWidth;
    if (isWider === element.hasAttribute("tabindex")) return;
    for (const [attribute, value] of [["tabindex", "0"], ["role", "region"], ["aria-label", name]] as const) {
      if (isWider) element.setAttribute(attribute, value);
      else element.removeAttribute(attribute);
    }
  }).observe(element);
}

/** Write words where others stand. */
export function write(into: HTMLElement, words: string): void {
  if (into.textContent !== words) into.textContent = words;
}

/** An element of a picture that is not made yet: its tag, its attributes, its text. */
export type Sketch = readonly [tag: keyof SVGElementTagNameMap, attributes: Attributes, text?: string];

/** What is drawn in a picture by sketches, of which others may take the place: only what differs is written. */
export class Sketched {
  private readonly into: Element;
  private shown: { readonly element: SVGElement; readonly sketch: Sketch }[] = [];

  constructor(into: Element, sketches: readonly Sketch[]) {
    this.into = into;
    this.take(sketches);
  }

  take(sketches: readonly Sketch[]): void {
    const before = this.shown;
    this.shown = sketches.map((sketch, place) => {
      const one = before[place];
      const element = one?.sketch[0] === sketch[0] ? one.element : svg(sketch[0]);
      if (element !== one?.element) {
        if (one) one.element.replaceWith(element);
        else this.into.append(element);
      }
      rewrite(element, element === one?.element ? one.sketch : [sketch[0], {}], sketch);
      return { element, sketch };
    });
    for (const { element } of before.slice(sketches.length)) element.remove();
  }
}

function rewrite(element: SVGElement, [, before, wordsBefore = ""]: Sketch, [, now, words = ""]: Sketch): void {
  for (const name of Object.keys(before)) if (!(name in now)) element.removeAttribute(name);
  for (const [name, value] of Object.entries(now)) if (before[name] !== value) element.setAttribute(name, String(value));
  if (words !== wordsBefore) element.textContent = words;
}

/** Let children of an element read as others do; what is the same stays where it is, so that less is laid out anew. */
export function renewChildren(shown: Element, next: readonly Node[]): void {
  const before = [...shown.childNodes];
  if (before.length !== next.length) {
    shown.replaceChildren(...next);
    return;
  }
  next.forEach((one, place) => { renew(before[place] as ChildNode, one); });
}

/** Let a node that hears of no events read as another one does. */
function renew(shown: ChildNode, next: Node): void {
  if (shown.nodeName !== next.nodeName) {
    shown.replaceWith(next);
  } else if (shown instanceof Element && next instanceof Element) {
    for (const name of shown.getAttributeNames()) if (!next.hasAttribute(name)) shown.removeAttribute(name);
    for (const name of next.getAttributeNames()) {
      const value = next.getAttribute(name) as string;
      if (shown.getAttribute(name) !== value) shown.setAttribute(name, value);
    }
    renewChildren(shown, [...next.childNodes]);
  } else if (shown.nodeValue !== next.nodeValue) {
    shown.nodeValue = next.nodeValue;
  }
}

/** Offer a choice, each value with its words, of which one is chosen; what is offered already stays. */
export function offer(choice: HTMLSelectElement, options: readonly (readonly [value: string, words: string])[], chosen: string): void {
  const isOffered = options.length === choice.options.length && options.every(([value, words], place) => {
    const option = choice.options[place];
    return option?.value === value && option.textContent === words;
  });
  if (!isOffered) choice.replaceChildren(...options.map(([value, words]) => html("option", { value }, words)));
  if (choice.value !== chosen) choice.value = chosen;
}

function filled<Made extends Element>(element: Made, attributes: Attributes, children: readonly Child[]): Made {
  for (const [name, value] of Object.entries(attributes)) element.setAttribute(name, String(value));
  element.append(...children);
  return element;
}
