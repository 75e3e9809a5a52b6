// What is said beside C and what it becomes on the card, by the page and by the extension for Visual
// Studio Code.

import type { TwoColumnsWords } from "../two_columns/view.js";

export const twoColumns: Record<"en" | "zh", TwoColumnsWords> = {
  en: {
    line: "line",
    onCard: "on the card",
    plain:
      "This program is in the card's own C: there is nothing to translate. With //@ structured in its first line, you write C as usual, and see here what it becomes.",
    broken: "There are errors: mend them, and you see here what the program becomes.",
    before: "There are errors: this is from before.",
  },
  zh: {
    line: "行",
    onCard: "卡上",
    plain:
      "此程序已是卡的 C 语言，无需转换。若首行为 //@ structured，即可按通常方式编写 C，并在此查看转换结果。",
    broken: "程序有错误：改正后在此查看转换结果。",
    before: "程序有错误：以下是之前的结果。",
  },
};
