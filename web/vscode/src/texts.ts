// What the extension itself says, in the language of the editor. Labels of commands and settings are
// in package.nls.json and package.nls.zh-cn.json.

import { env } from "vscode";

import { type Language, languageOf } from "@oncard/engine";

export interface Text {
  en: string;
  zh: string;
}

export function language(): Language {
  return languageOf(env.language);
}

export function say(text: Text): string {
  return text[language()];
}
