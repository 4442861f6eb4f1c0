/**
 * Fixtures of every test: the real relay that serves the built page, browser windows that fail the
 * test when a page reports an error, and the page object of the main window.
 */
import { test as base, type BrowserContext, type BrowserContextOptions } from "playwright/test";
import { CorridorPage } from "./pages/corridor-page.ts";
import { PageErrors } from "./support/page-errors.ts";
import { saveData } from "./support/save-data.ts";
import { RelayProcess } from "../tests/support/relay-process.ts";

interface TestFixtures {
  /** whether pages load parts of the screen only when they are needed */
  savesData: boolean;
  pageErrors: PageErrors;
  /** the start page, opened by a first-time visitor */
  corridor: CorridorPage;
  /** opens a window in a new context: another user, or another device of the same user */
  openWindow: (options?: BrowserContextOptions) => Promise<CorridorPage>;
}

interface WorkerFixtures {
  /** address of the relay, without a trailing slash */
  relay: string;
}

export const test = base.extend<TestFixtures, WorkerFixtures>({
  savesData: [true, { option: true }],
  relay: [
    // oxlint-disable-next-line no-empty-pattern -- Playwright reads the fixture names from this pattern
    async ({}, use) => {
      const relay = await RelayProcess.start();
      await use(relay.url);
      await relay.stop();
    },
    { scope: "worker" },
  ],
  baseURL: async ({ relay }, use) => {
    await use(relay);
  },
  // oxlint-disable-next-line no-empty-pattern -- Playwright reads the fixture names from this pattern
  pageErrors: async ({}, use) => {
    const pageErrors = new PageErrors();
    await use(pageErrors);
    base.expect(pageErrors.messages, "errors that the page reported").toEqual([]);
  },
  context: async ({ context, pageErrors, savesData }, use) => {
    await pageErrors.observe(context);
    if (savesData) await saveData(context);
    await use(context);
  },
  corridor: async ({ page }, use) => {
    const corridor = new CorridorPage(page);
    await corridor.open();
    await use(corridor);
  },
  openWindow: async ({ browser, pageErrors, savesData }, use) => {
    const contexts: BrowserContext[] = [];
    await use(async (options) => {
      const context = await browser.newContext(options);
      contexts.push(context);
      await pageErrors.observe(context);
      if (savesData) await saveData(context);
      return new CorridorPage(await context.newPage());
    });
    for (const context of contexts) await context.close();
  },
});

export { expect } from "playwright/test";
