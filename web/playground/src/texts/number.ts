// Numbers as people read them.

/** At most this many digits after the point, without zeros at the end. */
export function number(value: number, digits = 3): string {
  const rounded = Number(value.toFixed(digits));
  return Object.is(rounded, -0) ? "0" : String(rounded);
}
