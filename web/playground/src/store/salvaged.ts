// What a browser has kept, checked with the validator of its schema. Another version of the page may
// have written it, so what is wrong in it is left out, and the rest is of use.
// Tested by test/salvaged.test.ts.

import type { ValidateFunction } from "ajv";

/** What is right in a value of JSON, which is changed; undefined if that is nothing. */
export function salvaged<Type>(isType: ValidateFunction<Type>, value: unknown): Type | undefined {
  while (!isType(value)) {
    const steps = (isType.errors?.[0]?.instancePath ?? "").split("/").slice(1);
    if (steps.length === 0) return undefined;
    remove(value, steps);
  }
  return value;
}

/** @param steps of a JSON Pointer to a part of the value */
function remove(value: unknown, [step = "", ...rest]: string[]): void {
  const key = step.replaceAll("~1", "/").replaceAll("~0", "~");
  const whole = value as Record<string, unknown>;
  if (rest.length > 0) remove(whole[key], rest);
  else if (Array.isArray(whole)) whole.splice(Number(key), 1);
  else Reflect.deleteProperty(whole, key);
}
