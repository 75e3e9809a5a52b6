// The texts of the page in the reader's language.

import { computed } from "@preact/signals";

import { settings } from "../store/settings.js";
import { en } from "./en.js";
import { zh } from "./zh.js";

export const texts = computed(() => (settings.language.value === "zh" ? zh : en));
