// Data pages as memory: a page is a row of slots, 8 bytes each, the least significant byte first.

const slotBytes = 8;

export interface Place {
  page: number;
  /** In bytes from the beginning of the page. */
  offset: number;
}

/** Reads `page3` or `page3:16`, a slot of that page. */
export function readPlace(reference: string): Place | undefined {
  const found = /^page(\d+)(?::(\d+))?$/.exec(reference);
  if (!found) return undefined;
  return { page: Number(found[1]), offset: Number(found[2] ?? 0) * slotBytes };
}

/** The part of a page from `offset` on: fewer than `count` bytes at its end, none outside. */
export function bytesOf(slots: BigInt64Array, offset: number, count: number): Buffer {
  const bytes = Buffer.alloc(slots.length * slotBytes);
  slots.forEach((slot, i) => bytes.writeBigInt64LE(slot, i * slotBytes));
  return offset < 0 ? Buffer.alloc(0) : bytes.subarray(offset, offset + count);
}
