// Drives the page in Debian's Chromium. `./x web` has built it.

import { defineConfig, devices } from "@playwright/test";

const port = 4173;

export default defineConfig({
  testDir: "e2e",
  outputDir: "dist/e2e",
  fullyParallel: true,
  workers: 2,
  // A busy computer takes its time; a page that does what it should waits for none of this.
  timeout: 120_000,
  expect: { timeout: 20_000 },
  reporter: "list",
  use: {
    ...devices["Desktop Chrome"],
    baseURL: `http://127.0.0.1:${port}/some/path/`,
    viewport: { width: 1440, height: 900 },
    locale: "en-US",
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
    command: `node tools/serve.js dist/page ${port} /some/path/`,
    port,
  },
});
