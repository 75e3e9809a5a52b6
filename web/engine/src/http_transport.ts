// An engine behind HTTP on this computer: a session of `oncard serve`.
// Tested by test/http_transport.test.ts.

import type { Receiver, Transport } from "./transport.js";

/** The part of `fetch` that is used. */
export type Fetch = (
  address: URL,
  request: { method: string; body?: string; keepalive?: boolean; signal?: AbortSignal },
) => Promise<{ ok: boolean; status: number; text(): Promise<string> }>;

/** What the server says of itself; a refusal has an error. */
interface Said {
  session?: number;
  error?: string;
}

export class HttpTransport implements Transport {
  readonly #sessions: URL;
  readonly #fetch: Fetch;
  readonly #abort = new AbortController();
  #receiver: Receiver | undefined;
  #closed = false;
  /** The address of the session, as soon as there is one. */
  #session: Promise<URL> | undefined;
  /** Ends when the last request has been answered. */
  #answered: Promise<void> = Promise.resolve();

  /**
   * @param base the address of the page, which ends in `/` or a query
   * @param fetch that of the global object, or of a test
   */
  constructor(
    base: string | URL,
    fetch: Fetch = (address, request) => globalThis.fetch(address, request),
  ) {
    this.#sessions = new URL("sessions", base);
    this.#fetch = fetch;
  }

  connect(receiver: Receiver): void {
    this.#receiver = receiver;
    this.#session = this.#open();
    this.#session.catch((why: unknown) => {
      this.#end(why);
    });
  }

  send(line: string): void {
    // The next request is sent when this one has been answered: the server may take them in another
    // order otherwise.
    this.#answered = this.#answered.then(() => this.#exchange(line));
  }

  close(): void {
    if (this.#closed) return;
    this.#closed = true;
    this.#session?.then(
      (address) => {
        // Also while the page is being left.
        this.#fetch(address, { method: "DELETE", keepalive: true }).catch(() => undefined);
        this.#abort.abort();
      },
      () => undefined, // there is no session to be ended
    );
  }

  async #open(): Promise<URL> {
    const { session } = JSON.parse(await this.#post(this.#sessions)) as Said;
    return new URL(`${this.#sessions.href}/${session ?? ""}`);
  }

  async #exchange(line: string): Promise<void> {
    try {
      const address = await this.#session;
      if (this.#closed || !address) return;
      const answer = await this.#post(address, line, this.#abort.signal);
      for (const each of answer.split("\n")) {
        if (each !== "" && this.#hears()) this.#receiver?.line(each);
      }
    } catch (why) {
      this.#end(why);
    }
  }

  /** The text of the answer. */
  async #post(address: URL, body = "", signal?: AbortSignal): Promise<string> {
    const request = { method: "POST", body, ...(signal && { signal }) };
    let answer;
    let text;
    try {
      answer = await this.#fetch(address, request);
      text = await answer.text();
    } catch {
      throw new Error(`oncard serve does not answer any more at ${address.host}`);
    }
    if (answer.ok) return text;
    throw new Error(errorIn(text) ?? `oncard serve refuses a request with ${answer.status}`);
  }

  /** Whether anybody still waits for lines; each line can change that. */
  #hears(): boolean {
    return !this.#closed;
  }

  #end(why: unknown): void {
    if (this.#closed) return;
    this.#closed = true;
    this.#receiver?.ended(why instanceof Error ? why : new Error(String(why)));
  }
}

function errorIn(text: string): string | undefined {
  try {
    return (JSON.parse(text) as Said).error;
  } catch {
    return undefined;
  }
}
