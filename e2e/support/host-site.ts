/**
 * A site of another origin that shows addresses of Corridor in a frame, and records the messages of
 * the frame. Any HTTP server can embed Corridor like this.
 */
import { createServer, type Server } from "node:http";
import type { AddressInfo } from "node:net";
import type { FrameLocator, Page } from "playwright/test";

/** A message of the frame; each has some of the fields. */
export interface FrameMessage {
  corridor?: number;
  type?: string;
  subject?: string;
  width?: number;
  height?: number;
  [field: string]: unknown;
}

const script = `
window.messages = [];
addEventListener("message", ({ data, source }) => {
  const frame = document.querySelector("iframe");
  if (source !== frame.contentWindow) return;
  window.messages.push(data);
  if (data.subject === "lti.frameResize" && frame.dataset.fits !== undefined) {
    frame.height = data.height;
  }
});`;

export class HostSite {
  readonly #server: Server;
  readonly #bodies = new Map<string, string>();

  private constructor() {
    this.#server = createServer((request, response) => {
      const path = request.url ?? "/";
      if (path === "/host.js") {
        response.writeHead(200, { "content-type": "text/javascript" }).end(script);
        return;
      }
      const body = this.#bodies.get(path);
      response.writeHead(body === undefined ? 404 : 200, { "content-type": "text/html" });
      response.end(body ?? "");
    });
  }

  static async start(): Promise<HostSite> {
    const site = new HostSite();
    await new Promise<void>((listening) => site.#server.listen(0, "127.0.0.1", listening));
    return site;
  }

  get #origin(): string {
    return `http://127.0.0.1:${(this.#server.address() as AddressInfo).port}`;
  }

  /** Opens a page with HTML of the site's author. */
  async openHtml(page: Page, html: string): Promise<FrameLocator> {
    const path = `/page-${this.#bodies.size}`;
    const head =
      '<!doctype html><html lang="en"><title>A course</title><script src="/host.js"></script>';
    this.#bodies.set(path, `${head}<h1>A course</h1>${html}`);
    await page.goto(this.#origin + path);
    return page.frameLocator("iframe");
  }

  /** Opens a page with a frame that has the height of its content. */
  async open(page: Page, address: string, width = 720): Promise<FrameLocator> {
    const frame = `<iframe src="${address}" title="Robot" width="${width}" height="300" data-fits></iframe>`;
    return this.openHtml(page, frame);
  }

  close(): void {
    this.#server.close();
    this.#server.closeAllConnections();
  }
}

/** The messages of the frame so far, except its sizes. */
export async function messagesOf(page: Page): Promise<FrameMessage[]> {
  const all = await page.evaluate(() => Reflect.get(window, "messages") as FrameMessage[]);
  return all.filter(({ type, subject }) => type !== "size" && subject === undefined);
}

/** The newest height that the frame has reported. */
export async function heightOf(page: Page): Promise<number> {
  const all = await page.evaluate(() => Reflect.get(window, "messages") as FrameMessage[]);
  return all.findLast(({ type }) => type === "size")?.height ?? 0;
}

/** Sends a message to the frame. */
export async function sendTo(page: Page, message: unknown): Promise<void> {
  await page.evaluate((data) => {
    document.querySelector("iframe")?.contentWindow?.postMessage(data, "*");
  }, message);
}
