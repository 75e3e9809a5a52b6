import js from "@eslint/js";
import tseslint from "typescript-eslint";

export default tseslint.config(
  {
    ignores: [
      "**/dist/**",
      "**/dist-test/**",
      "**/*.d.ts",
      "engine/src/protocol.ts",
      "**/*_schema.ts",
    ],
  },
  js.configs.recommended,
  {
    files: ["**/*.js"],
    languageOptions: {
      globals: { TextDecoder: "readonly", TextEncoder: "readonly", WebAssembly: "readonly" },
    },
  },
  {
    files: ["vitest.config.js", "**/*.mjs", "**/tools/*.js"],
    languageOptions: { globals: { URL: "readonly", console: "readonly", process: "readonly" } },
  },
  {
    // Its functions run in the page.
    files: ["playground/tools/measure.js"],
    languageOptions: {
      globals: { document: "readonly", performance: "readonly", requestAnimationFrame: "readonly" },
    },
  },
  {
    files: ["**/*.ts", "**/*.tsx"],
    extends: [tseslint.configs.strictTypeChecked, tseslint.configs.stylisticTypeChecked],
    languageOptions: {
      parserOptions: {
        projectService: true,
        tsconfigRootDir: import.meta.dirname,
      },
    },
    rules: {
      "@typescript-eslint/restrict-template-expressions": ["error", { allowNumber: true }],
    },
  },
);
