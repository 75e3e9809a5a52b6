// What is said about a failing run, by the page and by the extension for Visual Studio Code.

import type { FailingRunWords } from "../interleaving/view.js";

export const interleaving: Record<"en" | "zh", FailingRunWords> = {
  en: {
    label: "Failing run, step by step",
    step: "step",
    shared: "shared",
    reads: (value) => `reads ${value}`,
    statements: (count) => (count === 1 ? "1 statement" : `${count} statements`),
    nothingShared: ", nothing shared",
    fatal: "From here on, every continuation fails.",
    keeps: (thread, value) => `Thread ${thread} keeps the old ${value}`,
    meanwhile: (thread, value) => `while thread ${thread} makes it ${value}.`,
    orders: "Orders",
    thisOrder: "This order",
    bothOrders: "Both",
    first: (thread) => `Thread ${thread} first`,
    end: (values) => `at the end ${values}`,
    sameEnd: "the ends are the same",
    forever: "And then for ever:",
    skipped: (statements) =>
      statements === 1
        ? "1 statement before is not shown."
        : `${statements} statements before are not shown.`,
  },
  zh: {
    label: "失败的运行，逐步列出",
    step: "步",
    shared: "共享变量",
    reads: (value) => `读到 ${value}`,
    statements: (count) => `${count} 条语句`,
    nothingShared: "，不涉及共享变量",
    fatal: "从这里起，怎样继续都会失败。",
    keeps: (thread, value) => `线程 ${thread} 一直拿着旧的 ${value}`,
    meanwhile: (thread, value) => `而线程 ${thread} 已把它改为 ${value}。`,
    orders: "次序",
    thisOrder: "此次序",
    bothOrders: "对照",
    first: (thread) => `线程 ${thread} 在先`,
    end: (values) => `最终 ${values}`,
    sameEnd: "最终结果相同",
    forever: "然后永远重复：",
    skipped: (statements) => `此前的 ${statements} 条语句未列出。`,
  },
};
