/** Notes everything that a page complains about: no journey may leave an error behind. */
import type { BrowserContext } from "playwright/test";

export class PageWatch {
  /** console errors, uncaught errors and violations of the Content-Security-Policy, in words */
  readonly complaints: string[] = [];

  /** Watches every page of a context, those that open later too. */
  async watch(context: BrowserContext): Promise<void> {
    context.on("console", (message) => {
      if (message.type() === "error") this.complaints.push(`console: ${message.text()}`);
    });
    context.on("weberror", (error) => {
      this.complaints.push(`uncaught: ${String(error.error())}`);
    });
    // Some violations are told to the page only, not to the console.
    await context.addInitScript(() => {
      document.addEventListener("securitypolicyviolation", (event) => {
        // oxlint-disable-next-line no-console -- the console is where the watch listens
        console.error(`${event.violatedDirective} forbids ${event.blockedURI}`);
      });
    });
  }
}
