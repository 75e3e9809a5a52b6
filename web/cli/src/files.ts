// Files and standard streams under the numbers that the module knows them by.

import { Buffer } from "node:buffer";
import {
  chmodSync,
  closeSync,
  constants,
  type Dirent,
  fstatSync,
  fsyncSync,
  lstatSync,
  mkdirSync,
  openSync,
  readdirSync,
  readSync,
  realpathSync,
  renameSync,
  rmdirSync,
  statSync,
  unlinkSync,
  writeSync,
} from "node:fs";
import { isatty } from "node:tty";

import { codeOf, SystemError } from "./errors.js";

/** What a thing of the file system is to WASI. */
export const FileType = { unknown: 0, character: 2, folder: 3, file: 4, link: 7 } as const;

export interface FileStatus {
  device: bigint;
  node: bigint;
  type: number;
  links: bigint;
  size: bigint;
  /** Nanoseconds. */
  changed: bigint;
}

export interface Entry {
  name: string;
  type: number;
}

export interface Opening {
  reads: boolean;
  writes: boolean;
  creates: boolean;
  exclusive: boolean;
  truncates: boolean;
  appends: boolean;
}

/** Something that is open. */
interface Open {
  /** Of the operating system; undefined for a folder. */
  descriptor: number | undefined;
  /** undefined where one cannot go back, as in a stream. */
  position: number | undefined;
  entries: readonly Entry[];
}

/** How long a stream that is not ready is waited for. */
const patienceMs = 5;
const pause = new Int32Array(new SharedArrayBuffer(4));

const streams = ["/dev/stdin", "/dev/stdout", "/dev/stderr"];
const firstNumber = streams.length + 1; // after that of the folder in which all paths are
const onWindows = process.platform === "win32";

/** A path as this computer has it: Windows begins anew where a drive is named, the module does not. */
function local(path: string): string {
  return onWindows ? path.replace(/^.*\/(?=[A-Za-z]:\/)/, "") : path;
}

function typeOf(thing: {
  isFile(): boolean;
  isDirectory(): boolean;
  isSymbolicLink(): boolean;
  isCharacterDevice(): boolean;
}): number {
  if (thing.isFile()) return FileType.file;
  if (thing.isDirectory()) return FileType.folder;
  if (thing.isSymbolicLink()) return FileType.link;
  return thing.isCharacterDevice() ? FileType.character : FileType.unknown;
}

/** Until the system takes or gives something. */
function insist(action: () => number): number {
  for (;;) {
    try {
      return action();
    } catch (error) {
      if (codeOf(error) === "EOF") return 0; // Windows, at the end of a pipe
      if (codeOf(error) !== "EAGAIN") throw error;
      Atomics.wait(pause, 0, 0, patienceMs);
    }
  }
}

export class Files {
  readonly #open = new Map<number, Open>(
    streams.map((_, number) => [
      number,
      { descriptor: number, position: undefined, entries: [] } as Open,
    ]),
  );
  #next = firstNumber;

  open(path: string, how: Opening): number {
    const stream = streams.indexOf(path);
    if (stream >= 0) return this.#add({ descriptor: stream, position: undefined, entries: [] });
    const place = local(path);
    if (!how.writes && statSync(place, { throwIfNoEntry: false })?.isDirectory() === true) {
      return this.#add({ descriptor: undefined, position: undefined, entries: entriesOf(place) });
    }
    const flags =
      (how.writes ? (how.reads ? constants.O_RDWR : constants.O_WRONLY) : constants.O_RDONLY) |
      (how.creates ? constants.O_CREAT : 0) |
      (how.exclusive ? constants.O_EXCL : 0) |
      (how.truncates ? constants.O_TRUNC : 0) |
      (how.appends ? constants.O_APPEND : 0);
    const descriptor = openSync(place, flags);
    const regular = fstatSync(descriptor).isFile();
    return this.#add({ descriptor, position: regular ? 0 : undefined, entries: [] });
  }

  close(number: number): void {
    const { descriptor } = this.#at(number);
    this.#open.delete(number);
    if (descriptor !== undefined && descriptor >= streams.length) closeSync(descriptor);
  }

  read(number: number, into: Uint8Array): number {
    const { open, descriptor } = this.#file(number);
    const count = insist(() => readSync(descriptor, into, 0, into.length, open.position ?? null));
    if (open.position !== undefined) open.position += count;
    return count;
  }

  write(number: number, content: Uint8Array): number {
    const { open, descriptor } = this.#file(number);
    const count = insist(() => writeSync(descriptor, content, 0, content.length, open.position));
    if (open.position !== undefined) open.position += count;
    return count;
  }

  /** @param from 0: the beginning, 1: the present place, 2: the end */
  seek(number: number, by: number, from: number): number {
    const { open, descriptor } = this.#file(number);
    if (open.position === undefined) throw new SystemError("ESPIPE");
    const base = from === 0 ? 0 : from === 1 ? open.position : fstatSync(descriptor).size;
    if (base + by < 0) throw new SystemError("EINVAL");
    return (open.position = base + by);
  }

  sync(number: number): void {
    fsyncSync(this.#file(number).descriptor);
  }

  entries(number: number): readonly Entry[] {
    return this.#at(number).entries;
  }

  /** True for a terminal. */
  isTerminal(number: number): boolean {
    const { descriptor } = this.#at(number);
    return descriptor !== undefined && isatty(descriptor);
  }

  statusOf(number: number): FileStatus {
    const { descriptor } = this.#at(number);
    return descriptor === undefined
      ? { device: 0n, node: 0n, type: FileType.folder, links: 1n, size: 0n, changed: 0n }
      : statusOf(fstatSync(descriptor, { bigint: true }));
  }

  #file(number: number): { open: Open; descriptor: number } {
    const open = this.#at(number);
    if (open.descriptor === undefined) throw new SystemError("EISDIR");
    return { open, descriptor: open.descriptor };
  }

  #at(number: number): Open {
    const open = this.#open.get(number);
    if (open === undefined) throw new SystemError("EBADF");
    return open;
  }

  #add(open: Open): number {
    const number = this.#next++;
    this.#open.set(number, open);
    return number;
  }
}

function entriesOf(folder: string): Entry[] {
  return readdirSync(folder, { withFileTypes: true }).map((each: Dirent) => ({
    name: each.name,
    type: typeOf(each),
  }));
}

function statusOf(status: import("node:fs").BigIntStats): FileStatus {
  return {
    device: status.dev,
    node: status.ino,
    type: typeOf(status),
    links: status.nlink,
    size: status.size,
    changed: status.mtimeNs,
  };
}

export function statusAt(path: string, follows: boolean): FileStatus {
  const place = local(path);
  return statusOf(follows ? statSync(place, { bigint: true }) : lstatSync(place, { bigint: true }));
}

/** The file that a link leads to in the end, as bytes. */
export function targetOf(path: string): Uint8Array {
  return Buffer.from(realpathSync(local(path)).replaceAll("\\", onWindows ? "/" : "\\"));
}

/** A file that takes the place of another one gets its mode. */
export function rename(from: string, to: string): void {
  const before = statSync(local(to), { throwIfNoEntry: false });
  if (before?.isFile() === true) chmodSync(local(from), before.mode & 0o777);
  renameSync(local(from), local(to));
}

export function makeFolder(path: string): void {
  mkdirSync(local(path));
}

export function removeFile(path: string): void {
  unlinkSync(local(path));
}

export function removeFolder(path: string): void {
  rmdirSync(local(path));
}
