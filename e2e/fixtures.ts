/**
 * What every journey starts with: the real relay that serves the built page, browser windows that
 * fail the test when the page reports an error, and the page as its user sees it.
 */
import { test as base, type BrowserContext, type BrowserContextOptions } from "playwright/test";
import { CorridorPage } from "./pages/corridor-page.ts";
import { PageWatch } from "./support/page-watch.ts";
import { RelayProcess } from "./support/relay-process.ts";

interface TestFixtures {
  watch: PageWatch;
  /** the page, opened by a reader who has never been here */
  corridor: CorridorPage;
  /** opens a window of another reader, or of the same one on another device */
  openWindow: (options?: BrowserContextOptions) => Promise<CorridorPage>;
}

interface WorkerFixtures {
  /** address of the relay, without a slash at its end */
  relay: string;
}

export const test = base.extend<TestFixtures, WorkerFixtures>({
  relay: [
    // oxlint-disable-next-line no-empty-pattern -- Playwright reads the names of what is needed here
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
  // oxlint-disable-next-line no-empty-pattern -- Playwright reads the names of what is needed here
  watch: async ({}, use) => {
    const watch = new PageWatch();
    await use(watch);
    base.expect(watch.complaints, "errors that the page reported").toEqual([]);
  },
  context: async ({ context, watch }, use) => {
    await watch.watch(context);
    await use(context);
  },
  corridor: async ({ page }, use) => {
    const corridor = new CorridorPage(page);
    await corridor.open();
    await use(corridor);
  },
  openWindow: async ({ browser, watch }, use) => {
    const contexts: BrowserContext[] = [];
    await use(async (options) => {
      const context = await browser.newContext(options);
      contexts.push(context);
      await watch.watch(context);
      return new CorridorPage(await context.newPage());
    });
    for (const context of contexts) await context.close();
  },
});

export { expect } from "playwright/test";
