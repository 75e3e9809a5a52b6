// How lines of the protocol reach an engine and come back: a child process, a worker, a module.

/** What an engine says. */
export interface Receiver {
  /** A line of an answer, without its end. */
  line(text: string): void;
  /** The engine has ended and answers nothing more. */
  ended(why: Error): void;
}

export interface Transport {
  /** To be called once, before the first line is sent. */
  connect(receiver: Receiver): void;
  /** Sends a request: JSON without line ends. */
  send(line: string): void;
  /** Ends the engine. Its receiver is not told. */
  close(): void;
}
