// The texts of the page in the reader's language, and numbers as people read them.

import { computed } from "@preact/signals";

import { settings } from "../store/settings.js";
import { en } from "./en.js";
import { zh } from "./zh.js";

export const texts = computed(() => (settings.language.value === "zh" ? zh : en));

/** At most this many digits after the point, without zeros at the end. */
export function number(value: number, digits = 3): string {
  const rounded = Number(value.toFixed(digits));
  return Object.is(rounded, -0) ? "0" : String(rounded);
}
