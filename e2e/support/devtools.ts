/**
 * Chromium by its own DevTools protocol. Playwright keeps every page visible and switches throttling
 * off, so a hidden page can only be tested without it.
 */
import { spawn, type ChildProcess } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { createInterface } from "node:readline";
import { chromiumArguments, requireChromium } from "../../scripts/chromium.ts";

type Answer = Record<string, unknown>;

export class RawChromium {
  readonly #process: ChildProcess;
  readonly #folder: string;
  readonly #socket: WebSocket;
  readonly #waiting = new Map<number, (answer: Answer) => void>();
  /** by session: who waits until its page has crashed */
  readonly #crashing = new Map<string, () => void>();
  #lastId = 0;

  private constructor(process: ChildProcess, folder: string, socket: WebSocket) {
    this.#process = process;
    this.#folder = folder;
    this.#socket = socket;
    socket.onmessage = ({ data }: MessageEvent<string>) => {
      const answer: Answer & { id?: number; sessionId?: string } = JSON.parse(data);
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
      // What it goes on to say must not fill the pipe.
      browser.stderr.resume();
      const socket = new WebSocket(address);
      await once(socket, "open");
      return new RawChromium(browser, folder, socket);
    }
    throw new Error("Chromium ended before its DevTools were ready");
  }

  /** Opens a page in front of all others, which are hidden from then on. */
  async open(url: string): Promise<RawPage> {
    const { targetId } = await this.send("Target.createTarget", { url });
    const { sessionId } = await this.send("Target.attachToTarget", { targetId, flatten: true });
    await this.send("Target.activateTarget", { targetId });
    return new RawPage(this, String(sessionId), String(targetId));
  }

  /** Calls a method of the protocol. @returns its result */
  send(method: string, params: Answer, sessionId?: string): Promise<Answer> {
    const id = ++this.#lastId;
    this.#socket.send(
      JSON.stringify({ id, method, params, ...(sessionId === undefined ? {} : { sessionId }) }),
    );
    return new Promise((resolve, reject) => {
      this.#waiting.set(id, ({ result, error }) => {
        if (error === undefined) resolve(result as Answer);
        else reject(new Error(`${method}: ${JSON.stringify(error)}`));
      });
    });
  }

  /** Crashes the page of a session. @returns once it has */
  async crash(sessionId: string): Promise<void> {
    await this.send("Inspector.enable", {}, sessionId);
    const crashed = new Promise<void>((resolve) => this.#crashing.set(sessionId, resolve));
    // It does not answer any more.
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

  /** Puts it in front of all others again. */
  async show(): Promise<void> {
    await this.#browser.send("Target.activateTarget", { targetId: this.#target });
  }

  /** Loads it anew, also after a crash. */
  async reload(): Promise<void> {
    await this.#browser.send("Page.reload", {}, this.#session);
  }

  /** Ends its process without a word, as the system does when memory is short. */
  async crash(): Promise<void> {
    await this.#browser.crash(this.#session);
  }

  /** Runs a script in each document that it loads from now on, before all others. */
  async runFirst(source: string): Promise<void> {
    await this.#browser.send("Page.enable", {}, this.#session);
    await this.#browser.send("Page.addScriptToEvaluateOnNewDocument", { source }, this.#session);
  }

  /** Freezes it as a browser does with a tab that was hidden for long, or thaws it. */
  async setFrozen(isFrozen: boolean): Promise<void> {
    const state = isFrozen ? "frozen" : "active";
    await this.#browser.send("Page.setWebLifecycleState", { state }, this.#session);
  }

  /** What a part of it shows, in CSS pixels, as a PNG file in base64. It must be in front. */
  async picture(part: unknown): Promise<string> {
    const clip = { ...(part as Answer), scale: 1 };
    const { data } = await this.#browser.send("Page.captureScreenshot", { clip }, this.#session);
    return String(data);
  }

  /** Runs an expression in the page, and waits for it. @returns its value as JSON has it */
  async evaluate(expression: string): Promise<unknown> {
    const { result, exceptionDetails } = await this.#browser.send(
      "Runtime.evaluate",
      { expression, awaitPromise: true, returnByValue: true, userGesture: true },
      this.#session,
    );
    if (exceptionDetails !== undefined) throw new Error(JSON.stringify(exceptionDetails));
    return (result as { value?: unknown }).value;
  }

  /** Waits until an expression gives something that is not null, undefined or false. */
  async until(expression: string): Promise<unknown> {
    let complaint = "";
    for (const end = Date.now() + 20_000; Date.now() < end;) {
      // A page that is just being opened cannot be asked yet.
      const value = await this.evaluate(expression).catch((error: unknown) => {
        complaint = `; ${String(error)}`;
        return null;
      });
      if (value !== null && value !== undefined && value !== false) return value;
      await new Promise((resolve) => setTimeout(resolve, 100));
    }
    throw new Error(`never came true: ${expression}${complaint}`);
  }
}
