// Drives the packed extension in Visual Studio Code for browsers, in Debian's Chromium.

import { defineConfig, devices } from "@playwright/test";

const port = 4183;
const folder = "../dist/e2e-editor";

export default defineConfig({
  testDir: ".",
  outputDir: "../dist/e2e",
  workers: 1,
  // A busy computer takes its time to start an editor.
  timeout: 600_000,
  expect: { timeout: 90_000 },
  reporter: "list",
  use: {
    ...devices["Desktop Chrome"],
    baseURL: `http://127.0.0.1:${port}/`,
    viewport: { width: 1440, height: 900 },
    locale: "en-US",
    screenshot: "only-on-failure",
    launchOptions: {
      executablePath: process.env["CHROMIUM"] ?? "/usr/bin/chromium",
      args: [
        // Containers often have little shared memory.
        "--disable-dev-shm-usage",
        // Chromium's sandbox refuses to work for root.
        ...(process.getuid?.() === 0 ? ["--no-sandbox"] : []),
      ],
    },
  },
  webServer: {
    command: `node serve.mjs ${process.env["VSIX"] ?? "../../../build/oncard.vsix"} ${port} ${folder}`,
    port,
    timeout: 120_000,
  },
});
