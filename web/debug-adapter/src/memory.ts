// Data pages as memory: a page is a row of slots, 8 bytes each, the least significant byte first.
// Tested by test/code.test.ts.

import type { Engine } from "@oncard/engine";
import type { DebugProtocol } from "@vscode/debugprotocol";

import { UserError } from "./texts.js";

const slotBytes = 8;

interface Place {
  page: number;
  /** In bytes from the beginning of the page. */
  offset: number;
}

/** Reads `page3` or `page3:16`, a slot of that page. */
function readPlace(reference: string): Place | undefined {
  const found = /^page(\d+)(?::(\d+))?$/.exec(reference);
  if (!found) return undefined;
  return { page: Number(found[1]), offset: Number(found[2] ?? 0) * slotBytes };
}

/** The part of a page from `offset` on: fewer than `count` bytes at its end, none outside. */
function bytesOf(slots: BigInt64Array, offset: number, count: number): Buffer {
  const bytes = Buffer.alloc(slots.length * slotBytes);
  slots.forEach((slot, i) => bytes.writeBigInt64LE(slot, i * slotBytes));
  return offset < 0 ? Buffer.alloc(0) : bytes.subarray(offset, offset + count);
}

/** @throws UserError if the reference is none of a page */
export async function readMemory(
  engine: Engine,
  { memoryReference, offset, count }: DebugProtocol.ReadMemoryArguments,
): Promise<NonNullable<DebugProtocol.ReadMemoryResponse["body"]>> {
  const place = readPlace(memoryReference);
  if (!place) {
    throw new UserError({
      en: `'${memoryReference}' is no data page: page0 to page31`,
      zh: `“${memoryReference}”不是数据页：应为 page0 至 page31`,
    });
  }
  const from = place.offset + (offset ?? 0);
  const bytes = bytesOf(await engine.slots(place.page), from, count);
  return {
    address: `0x${Math.max(0, from).toString(16)}`,
    data: bytes.toString("base64"),
    unreadableBytes: count - bytes.length,
  };
}
