// A machine that is known by the text of its file, and by files that it names: it goes along with each question.

/** A machine as text. */
export interface Sent {
  /** What people call it: the name of its file, or of what it began with. */
  readonly name: string;
  readonly text: string;
  /** Texts of the files that it names. */
  readonly files: Readonly<Record<string, string>>;
  /** All of it, compressed, as an address has it. */
  readonly letters: string;
}

/** Take a machine as text. */
export async function sentOf(name: string, text: string, files: Readonly<Record<string, string>> = {}): Promise<Sent> {
  const bytes = await through(new TextEncoder().encode(JSON.stringify([name, text, files])), new CompressionStream("deflate-raw"));
  const letters = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  return { name, text, files, letters: letters.replaceAll("+", "-").replaceAll("/", "_").replace(/=+$/, "") };
}

/** Read a machine out of an address; nothing where it has none that can be read. */
export async function sentIn(letters: string): Promise<Sent | null> {
  try {
    const bytes = Uint8Array.from(atob(letters.replaceAll("-", "+").replaceAll("_", "/")), (letter) => letter.charCodeAt(0));
    const found: unknown = JSON.parse(new TextDecoder().decode(await through(bytes, new DecompressionStream("deflate-raw"))));
    if (!Array.isArray(found)) return null;
    const [name, text, files] = found as unknown[];
    if (typeof name !== "string" || typeof text !== "string" || typeof files !== "object" || files === null) return null;
    return { name, text, files: files as Record<string, string>, letters };
  } catch {
    return null;
  }
}

async function through(bytes: Uint8Array<ArrayBuffer>, pass: GenericTransformStream): Promise<Uint8Array> {
  const stream = new Blob([bytes]).stream().pipeThrough(pass as ReadableWritablePair<Uint8Array, Uint8Array<ArrayBuffer>>);
  return new Uint8Array(await new Response(stream).arrayBuffer());
}
