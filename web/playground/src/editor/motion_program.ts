// The words of motion programs for the editor: which are keywords, types, numbers, labels and comments.
// The compiler reads them for what they mean; a table of expressions is enough for their colours.

import { StreamLanguage } from "@codemirror/language";
import { type Rule, simpleMode } from "@codemirror/legacy-modes/mode/simple-mode";

const comments: Rule[] = [
  { regex: /\/\/.*/, token: "comment" },
  { regex: /\/\*/, token: "comment", push: "comment" },
];

const words: Rule[] = [
  { regex: /(goto)(\s+)(\w+)/, token: ["keyword", "", "labelName"] },
  {
    regex: /(?:if|else|goto|return|while|for|do|break|continue|switch|case|default)\b/,
    token: "keyword",
  },
  { regex: /(?:const|static|extern|typedef|struct|union|enum|sizeof)\b/, token: "keyword" },
  { regex: /(?:int|long|short|void|double|float|char|unsigned|signed)\b/, token: "typeName" },
  { regex: /0[xX][\dA-Fa-f]+[uUlL]*/, token: "number" },
  { regex: /(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?[uUlL]*/, token: "number" },
  { regex: /"(?:[^"\\]|\\.)*"?/, token: "string" },
  { regex: /'(?:[^'\\]|\\.)*'?/, token: "string" },
  { regex: /\w+/, token: "variableName" },
];

export const motionProgram = StreamLanguage.define(
  simpleMode({
    start: [
      ...comments,
      {
        sol: true,
        regex: /(\s*#\s*include)(\s*)(<[^>]*>)/,
        token: ["processingInstruction", "", "string"],
      },
      { sol: true, regex: /\s*#\s*\w*/, token: "processingInstruction" },
      { sol: true, regex: /(\s*)((?!default\b)[A-Za-z_]\w*)(?=\s*:)/, token: ["", "labelName"] },
      ...words,
      { regex: /\{/, token: "brace", indent: true },
      { regex: /\}/, token: "brace", dedent: true },
    ],
    comment: [
      { regex: /.*?\*\//, token: "comment", pop: true },
      { regex: /.+/, token: "comment" },
    ],
    languageData: {
      name: "motion program",
      commentTokens: { line: "//", block: { open: "/*", close: "*/" } },
      indentOnInput: /^\s*\}$/,
      dontIndentStates: ["comment"],
    },
  }),
);
