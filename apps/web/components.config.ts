/**
 * Tests of components in a browser: `*.component.test.tsx` beside the component. They start no
 * relay and need no build. `npm run test:components` runs them.
 */
import react from "@vitejs/plugin-react";
import { playwright } from "@vitest/browser-playwright";
import type { TestProjectInlineConfiguration } from "vitest/config";
import { chromiumArguments, findHeadlessChromium } from "../../scripts/chromium.ts";

const executablePath = findHeadlessChromium();

export const components: TestProjectInlineConfiguration = {
  plugins: [react({ compiler: { compilationMode: "annotation" } })],
  worker: { format: "es" },
  optimizeDeps: {
    // A dependency that Vite finds during a test reloads the page of that test.
    include: [
      "axe-core",
      "fast-check",
      "i18next",
      "lucide",
      "matter-js/src/body/Body.js",
      "matter-js/src/collision/Collision.js",
      "matter-js/src/geometry/Bounds.js",
      "react",
      "react-dom",
      "react-dom/client",
      "react-i18next",
      "react/jsx-dev-runtime",
      "uqr",
      "vitest-browser-react",
      "zod",
      "zundo",
      "zustand",
      "zustand/react/shallow",
      "zustand/vanilla",
    ],
  },
  test: {
    name: "components",
    include: ["apps/web/src/**/*.component.test.tsx"],
    testTimeout: 120_000,
    // Only a failure takes this long, or a machine that is busy with other work.
    expect: { poll: { timeout: 30_000 } },
    browser: {
      enabled: true,
      headless: true,
      screenshotFailures: false,
      viewport: { width: 1280, height: 800 },
      provider: playwright({
        actionTimeout: 30_000,
        launchOptions: {
          args: [...chromiumArguments],
          ...(executablePath === null ? {} : { executablePath }),
        },
        contextOptions: { reducedMotion: "reduce", locale: "en-GB" },
      }),
      instances: [{ browser: "chromium" }],
    },
  },
};
