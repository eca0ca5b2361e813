// Questions to the service, and its answers.

import type { AddedPart } from "./adding.ts";
import type { Asked } from "./address.ts";
import type { Problem } from "./form.ts";
import { unpacked } from "./numbers.ts";

/** What the service says is wrong. */
export class Refused extends Error {
  readonly problems: readonly Problem[];

  constructor(problems: readonly Problem[]) {
    super();
    this.problems = problems;
  }
}

/** What is asked beside a machine: in which language, on which tab, which table or part, which facts over which values. */
interface Beside {
  readonly language: string;
  readonly tab?: string;
  readonly key?: string;
  readonly addition?: AddedPart;
  readonly suffix?: string;
  readonly quantity?: string;
  readonly vary?: Readonly<Record<string, string>>;
  readonly wanted?: readonly string[];
}

/** Ask of a machine; what is wrong with it is thrown as `Refused`. */
export async function ask(where: string, asked: Asked, beside: Beside, signal: AbortSignal | null = null): Promise<Response> {
  const piston = asked.piston ? { piston: asked.piston } : {};
  const body = JSON.stringify({ ...caseOf(asked), ...piston, ...beside, ...(asked.beside ? { beside: caseOf(asked.beside) } : {}) });
  return known(await fetch(where, { method: "POST", headers: { "Content-Type": "application/json" }, body, signal }));
}

/** Ask for what hangs on no machine; what is wrong is thrown as `Refused`. */
export async function look(where: string): Promise<Response> {
  return known(await fetch(where));
}

async function known(answer: Response): Promise<Response> {
  if (answer.ok) return answer;
  throw new Refused((await answer.json()) as Problem[]);
}

function caseOf({ machine, sent, settings }: Asked): object {
  const own = sent ? { text: sent.text, files: sent.files } : { machine };
  return { ...own, settings: [...settings].map(([path, text]) => `${path}=${text}`) };
}

/** Read data. */
export const opened = async (answer: Response): Promise<unknown> => unpacked(await answer.arrayBuffer());
