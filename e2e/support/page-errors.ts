/** Collects the errors that pages report. No test may end with one. */
import type { BrowserContext } from "playwright/test";

export class PageErrors {
  /** console errors, uncaught errors and Content-Security-Policy violations, as text */
  readonly messages: string[] = [];

  #ignored: RegExp | null = null;

  /**
   * Collects no console errors about requests and connections that failed: the test makes them
   * fail. The browser reports some of them late.
   */
  ignoreFailedRequests(): void {
    this.#ignored = /^(Failed to load resource|WebSocket connection)/;
  }

  /** Collects the errors of all pages of a context, including those opened later. */
  async observe(context: BrowserContext): Promise<void> {
    context.on("console", (message) => {
      const text = message.text();
      const isError = message.type() === "error" && this.#ignored?.test(text) !== true;
      if (isError) this.messages.push(`console: ${text}`);
    });
    context.on("weberror", (error) => {
      this.messages.push(`uncaught: ${String(error.error())}`);
    });
    // Some violations reach only the page, not the console.
    await context.addInitScript(() => {
      document.addEventListener("securitypolicyviolation", (event) => {
        // oxlint-disable-next-line no-console -- PageErrors reads the console
        console.error(`${event.violatedDirective} forbids ${event.blockedURI}`);
      });
    });
  }
}
