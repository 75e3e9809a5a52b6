import type { Language } from "@oncard/engine";
export interface Text {
    en: string;
    zh: string;
}
export declare function language(): Language;
export declare function say(text: Text): string;
