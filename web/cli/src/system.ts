// What the module asks of a system, as WASI (preview 1) has it. Node's own WASI needs a flag in
// Node 18, warns in later ones, and knows only paths below folders that are named in advance.

import { webcrypto } from "node:crypto";

import { numberOf, SystemError } from "./errors.js";
import { type FileStatus, Files, FileType, type Opening } from "./files.js";
import * as files from "./files.js";

/** The module has ended by itself. */
export class Exit extends Error {
  readonly exitCode: number;

  constructor(exitCode: number) {
    super(`exit code ${exitCode}`);
    this.exitCode = exitCode;
  }
}

// Bits and sizes of WASI.
const opens = { creates: 1, exclusive: 4, truncates: 8 };
const rights = { reads: 2n, writes: 64n, seeks: 4n, tells: 32n };
const allRights = (1n << 29n) - 1n;
const appends = 1;
const followsLinks = 1;
const statusSize = 64;
const entrySize = 24;
const realTime = 0;

const utf8Encoder = new TextEncoder();
const utf8Decoder = new TextDecoder();

export class System {
  readonly #args: readonly Uint8Array[];
  readonly #environment: readonly Uint8Array[];
  readonly #files = new Files();
  #memory: WebAssembly.Memory | undefined;

  /** @param args the name of the command, and its arguments */
  constructor(args: readonly string[], environment: Readonly<Record<string, string>>) {
    this.#args = args.map(terminated);
    this.#environment = Object.entries(environment).map(([name, value]) =>
      terminated(`${name}=${value}`),
    );
  }

  /** The memory of the instance, which does not exist before its imports. */
  set memory(memory: WebAssembly.Memory) {
    this.#memory = memory;
  }

  bytes(at: number, size: number): Uint8Array {
    return new Uint8Array(this.#buffer, at >>> 0, size >>> 0);
  }

  readonly imports = {
    args_get: (places: number, texts: number) => this.#put(this.#args, places, texts),
    args_sizes_get: (count: number, size: number) => this.#putSizes(this.#args, count, size),
    environ_get: (places: number, texts: number) => this.#put(this.#environment, places, texts),
    environ_sizes_get: (count: number, size: number) =>
      this.#putSizes(this.#environment, count, size),

    clock_time_get: (clock: number, _precision: bigint, time: number) => {
      const now = clock === realTime ? BigInt(Date.now()) * 1_000_000n : process.hrtime.bigint();
      this.#view.setBigUint64(time, now, true);
      return 0;
    },
    random_get: (at: number, size: number) => {
      webcrypto.getRandomValues(this.bytes(at, size));
      return 0;
    },
    proc_exit: (exitCode: number) => {
      throw new Exit(exitCode);
    },

    // All paths are below one folder, which has no name.
    fd_prestat_get: () => numberOf(refuse),
    fd_prestat_dir_name: () => numberOf(refuse),

    fd_close: (number: number) =>
      numberOf(() => {
        this.#files.close(number);
      }),
    fd_sync: (number: number) =>
      numberOf(() => {
        this.#files.sync(number);
      }),
    fd_fdstat_set_flags: () => 0,
    fd_fdstat_get: (number: number, at: number) =>
      numberOf(() => {
        const inFolder = number === 3;
        const type = inFolder ? FileType.folder : this.#files.statusOf(number).type;
        const terminal = !inFolder && this.#files.isTerminal(number);
        const view = this.#view;
        view.setUint8(at, terminal ? FileType.character : type);
        view.setUint16(at + 2, 0, true);
        // The C library recognises a terminal by what it cannot do.
        const able = terminal ? allRights & ~(rights.seeks | rights.tells) : allRights;
        view.setBigUint64(at + 8, able, true);
        view.setBigUint64(at + 16, allRights, true);
      }),
    fd_filestat_get: (number: number, at: number) =>
      numberOf(() => {
        this.#putStatus(at, this.#files.statusOf(number));
      }),
    fd_read: (number: number, pieces: number, count: number, total: number) =>
      numberOf(() => {
        this.#eachPiece(pieces, count, total, (b) => this.#files.read(number, b));
      }),
    fd_write: (number: number, pieces: number, count: number, total: number) =>
      numberOf(() => {
        this.#eachPiece(pieces, count, total, (b) => this.#files.write(number, b));
      }),
    fd_seek: (number: number, by: bigint, from: number, place: number) =>
      numberOf(() => {
        const position = this.#files.seek(number, Number(by), from);
        this.#view.setBigUint64(place, BigInt(position), true);
      }),
    fd_readdir: (number: number, at: number, size: number, first: bigint, used: number) =>
      numberOf(() => {
        this.#putEntries(number, at, size >>> 0, Number(first), used);
      }),

    path_open: (
      _folder: number,
      _follows: number,
      path: number,
      size: number,
      how: number,
      able: bigint,
      _inherited: bigint,
      flags: number,
      result: number,
    ) =>
      numberOf(() => {
        const opening: Opening = {
          reads: (able & rights.reads) !== 0n,
          writes: (able & rights.writes) !== 0n,
          creates: (how & opens.creates) !== 0,
          exclusive: (how & opens.exclusive) !== 0,
          truncates: (how & opens.truncates) !== 0,
          appends: (flags & appends) !== 0,
        };
        this.#view.setUint32(result, this.#files.open(this.#text(path, size), opening), true);
      }),
    path_filestat_get: (_folder: number, how: number, path: number, size: number, at: number) =>
      numberOf(() => {
        const follows = (how & followsLinks) !== 0;
        this.#putStatus(at, files.statusAt(this.#text(path, size), follows));
      }),
    path_readlink: (
      _folder: number,
      path: number,
      size: number,
      at: number,
      room: number,
      used: number,
    ) =>
      numberOf(() => {
        const target = files.targetOf(this.#text(path, size)).subarray(0, room);
        this.bytes(at, target.length).set(target);
        this.#view.setUint32(used, target.length, true);
      }),
    path_rename: (
      _folder: number,
      from: number,
      size: number,
      _to: number,
      to: number,
      n: number,
    ) =>
      numberOf(() => {
        files.rename(this.#text(from, size), this.#text(to, n));
      }),
    path_create_directory: (_folder: number, path: number, size: number) =>
      numberOf(() => {
        files.makeFolder(this.#text(path, size));
      }),
    path_unlink_file: (_folder: number, path: number, size: number) =>
      numberOf(() => {
        files.removeFile(this.#text(path, size));
      }),
    path_remove_directory: (_folder: number, path: number, size: number) =>
      numberOf(() => {
        files.removeFolder(this.#text(path, size));
      }),
  };

  get #buffer(): ArrayBuffer {
    if (this.#memory === undefined) throw new Error("the module has no memory yet");
    return this.#memory.buffer;
  }

  get #view(): DataView {
    return new DataView(this.#buffer);
  }

  #text(at: number, size: number): string {
    return utf8Decoder.decode(this.bytes(at, size));
  }

  #put(texts: readonly Uint8Array[], places: number, at: number): number {
    const view = this.#view;
    texts.forEach((text, i) => {
      view.setUint32(places + 4 * i, at, true);
      this.bytes(at, text.length).set(text);
      at += text.length;
    });
    return 0;
  }

  #putSizes(texts: readonly Uint8Array[], count: number, size: number): number {
    this.#view.setUint32(count, texts.length, true);
    const total = texts.reduce((sum, text) => sum + text.length, 0);
    this.#view.setUint32(size, total, true);
    return 0;
  }

  #putStatus(at: number, status: FileStatus): void {
    this.bytes(at, statusSize).fill(0);
    const view = this.#view;
    view.setBigUint64(at, BigInt.asUintN(64, status.device), true);
    view.setBigUint64(at + 8, BigInt.asUintN(64, status.node), true);
    view.setUint8(at + 16, status.type);
    view.setBigUint64(at + 24, status.links, true);
    view.setBigUint64(at + 32, status.size, true);
    for (const time of [40, 48, 56]) {
      view.setBigUint64(at + time, BigInt.asUintN(64, status.changed), true);
    }
  }

  /** Reads or writes pieces of memory, until one is not used up. */
  #eachPiece(
    pieces: number,
    count: number,
    total: number,
    move: (bytes: Uint8Array) => number,
  ): void {
    let sum = 0;
    for (let i = 0; i < count; ++i) {
      const view = this.#view;
      const at = view.getUint32(pieces + 8 * i, true);
      const size = view.getUint32(pieces + 8 * i + 4, true);
      if (size === 0) continue;
      const moved = move(this.bytes(at, size));
      sum += moved;
      if (moved < size) break;
    }
    this.#view.setUint32(total, sum, true);
  }

  /** Fills the room with entries of a folder; one that does not fit is cut. */
  #putEntries(number: number, at: number, room: number, first: number, used: number): void {
    let filled = 0;
    const entries = this.#files.entries(number);
    for (let i = first; i < entries.length && filled < room; ++i) {
      const { name, type } = entries[i] as { name: string; type: number };
      const text = utf8Encoder.encode(name);
      const entry = new Uint8Array(entrySize + text.length);
      const view = new DataView(entry.buffer);
      view.setBigUint64(0, BigInt(i + 1), true);
      view.setBigUint64(8, BigInt(i + 1), true); // 0 would make the C library ask again
      view.setUint32(16, text.length, true);
      view.setUint8(20, type);
      entry.set(text, entrySize);
      const part = entry.subarray(0, room - filled);
      this.bytes(at + filled, part.length).set(part);
      filled += part.length;
    }
    this.#view.setUint32(used, filled, true);
  }
}

function terminated(text: string): Uint8Array {
  return utf8Encoder.encode(`${text}\0`);
}

function refuse(): void {
  throw new SystemError("EBADF");
}
