/** Collects the errors that pages report. No test may end with one. */
import type { BrowserContext } from "playwright/test";

export class PageErrors {
  /** console errors, uncaught errors and Content-Security-Policy violations, as text */
  readonly messages: string[] = [];

  /** Drops what the browser reports of each request or connection that failed, as a test expects. */
  ignoreFailedRequests(): void {
    const failed = /^console: (Failed to load resource|WebSocket connection)/;
    const others = this.messages.filter((each) => !failed.test(each));
    this.messages.splice(0, this.messages.length, ...others);
  }

  /** Collects the errors of all pages of a context, including those opened later. */
  async observe(context: BrowserContext): Promise<void> {
    context.on("console", (message) => {
      if (message.type() === "error") this.messages.push(`console: ${message.text()}`);
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
