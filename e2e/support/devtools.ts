/**
 * Chromium driven over the DevTools protocol. Playwright keeps every page visible and turns
 * throttling off, so tests of hidden pages cannot use Playwright.
 */
import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { chromiumArguments, requireChromium } from "../../scripts/chromium.ts";

type ProtocolMessage = Record<string, unknown>;

export class RawChromium {
  readonly #process: ChildProcess;
  readonly #folder: string;
  readonly #socket: WebSocket;
  readonly #waiting = new Map<number, (answer: ProtocolMessage) => void>();
  /** by session: resolves when the page of the session has crashed */
  readonly #crashing = new Map<string, () => void>();
  #lastId = 0;

  private constructor(process: ChildProcess, folder: string, socket: WebSocket) {
    this.#process = process;
    this.#folder = folder;
    this.#socket = socket;
    socket.onmessage = ({ data }: MessageEvent<string>) => {
      const answer: ProtocolMessage & { id?: number; sessionId?: string } = JSON.parse(data);
      if (answer["method"] === "Inspector.targetCrashed") {
        this.#crashing.get(answer.sessionId ?? "")?.();
      }
      if (answer.id === undefined) return;
      this.#waiting.get(answer.id)?.(answer);
      this.#waiting.delete(answer.id);
    };
  }

  static async start(): Promise<RawChromium> {
    const folder = mkdtempSync(join(tmpdir(), "corridor-chromium-"));
    const browser = spawn(
      requireChromium(),
      [
        ...chromiumArguments,
        "--headless=new",
        "--remote-debugging-port=0",
        `--user-data-dir=${folder}`,
        "about:blank",
      ],
      { stdio: ["ignore", "ignore", "pipe"] },
    );
    for await (const line of createInterface({ input: browser.stderr })) {
      const address = /DevTools listening on (ws:\S+)/.exec(line)?.[1];
      if (address === undefined) continue;
      // Later output must not fill the pipe.
      browser.stderr.resume();
      const socket = new WebSocket(address);
      await once(socket, "open");
      return new RawChromium(browser, folder, socket);
    }
    throw new Error("Chromium ended before its DevTools were ready");
  }

  /** Opens a page in the foreground. All other pages become hidden. */
  async open(url: string): Promise<RawPage> {
    const { targetId } = await this.send("Target.createTarget", { url });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    await this.send("Target.activateTarget", { targetId });
    return new RawPage(this, String(sessionId), String(targetId));
  }

  /** Calls a protocol method. @returns its result */
  send(method: string, params: ProtocolMessage, sessionId?: string): Promise<ProtocolMessage> {
    const id = ++this.#lastId;
    this.#socket.send(
      JSON.stringify({ id, method, params, ...(sessionId === undefined ? {} : { sessionId }) }),
    );
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, ({ result, error }) => {
        if (error === undefined) resolve(result as ProtocolMessage);
        else reject(new Error(`${method}: ${JSON.stringify(error)}`));
      });
    });
  }

  /** Crashes the page of a session. Resolves when the page has crashed. */
  async crash(sessionId: string): Promise<void> {
    await this.send("Inspector.enable", {}, sessionId);
    const crashed = new Promise<void>((resolve) => this.#crashing.set(sessionId, resolve));
    // A crashed page never answers.
    void this.send("Page.crash", {}, sessionId).catch(() => undefined);
    await crashed;
    this.#crashing.delete(sessionId);
  }

  async close(): Promise<void> {
    const ended = once(this.#process, "exit");
    this.#process.kill();
    await ended;
    rmSync(this.#folder, { recursive: true, force: true, maxRetries: 5 });
  }
}

/** One page of a RawChromium. */
export class RawPage {
  readonly #browser: RawChromium;
  readonly #session: string;
  readonly #target: string;

  constructor(browser: RawChromium, session: string, target: string) {
    this.#browser = browser;
    this.#session = session;
    this.#target = target;
  }

  /** Brings the page to the foreground. */
  async bringToFront(): Promise<void> {
    await this.#browser.send("Target.activateTarget", { targetId: this.#target });
  }

  /** Reloads the page, also after a crash. */
  async reload(): Promise<void> {
    await this.#browser.send("Page.reload", {}, this.#session);
  }

  /** Ends the page's process without notice, as the system does when memory is low. */
  async crash(): Promise<void> {
    await this.#browser.crash(this.#session);
  }

  /** Runs a script in each document that the page loads from now on, before all other scripts. */
  async addInitScript(source: string): Promise<void> {
    await this.#browser.send("Page.enable", {}, this.#session);
    await this.#browser.send("Page.addScriptToEvaluateOnNewDocument", { source }, this.#session);
  }

  /** Freezes the page as a browser does with a long-hidden tab, or resumes it. */
  async setFrozen(isFrozen: boolean): Promise<void> {
    const state = isFrozen ? "frozen" : "active";
    await this.#browser.send("Page.setWebLifecycleState", { state }, this.#session);
  }

  /**
   * A screenshot of a region in CSS pixels, as a base64 PNG. The page must be in the foreground.
   */
  async screenshot(part: unknown): Promise<string> {
    const clip = { ...(part as ProtocolMessage), scale: 1 };
    const { data } = await this.#browser.send("Page.captureScreenshot", { clip }, this.#session);
    return String(data);
  }

  /** Evaluates an expression in the page and awaits it. @returns the value as JSON */
  async evaluate(expression: string): Promise<unknown> {
    const { result, exceptionDetails } = await this.#browser.send(
      "Runtime.evaluate",
      { expression, awaitPromise: true, returnByValue: true, userGesture: true },
      this.#session,
    );
    if (exceptionDetails !== undefined) throw new Error(JSON.stringify(exceptionDetails));
    return (result as { value?: unknown }).value;
  }

  /** Waits until an expression evaluates to something other than null, undefined or false. */
  async waitFor(expression: string): Promise<unknown> {
    let lastError = "";
    for (const end = Date.now() + 20_000; Date.now() < end;) {
      // A page that is still opening cannot evaluate yet.
      const value = await this.evaluate(expression).catch((error: unknown) => {
        lastError = `; ${String(error)}`;
        return null;
      });
      if (value !== null && value !== undefined && value !== false) return value;
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
    throw new Error(`timed out waiting for: ${expression}${lastError}`);
  }
}
