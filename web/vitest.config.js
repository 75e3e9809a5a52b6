import { fileURLToPath } from "node:url";

import { defineConfig } from "vitest/config";

// The editor gives this module to its extensions.
const vscode = fileURLToPath(new URL("vscode/test/fake_vscode.ts", import.meta.url));

export default defineConfig({
  resolve: { alias: [{ find: /^vscode$/, replacement: vscode }] },
  test: { include: ["*/test/**/*.test.ts"], testTimeout: 20_000 },
});
