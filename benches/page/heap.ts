/** What a page and its workers keep alive, as the engine counts it after a collection. */
import type { CDPSession, Page } from "playwright";

/** Bytes that are in use on the page's main thread and in its workers. */
export interface Held {
  main: number;
  workers: number;
}

/** As `Runtime.getHeapUsage` gives it. */
interface HeapUsage {
  usedSize: number;
  /** the engine's objects of the page: nodes, styles, canvases */
  embedderHeapUsedSize?: number;
  /** typed arrays */
  backingStorageSize?: number;
}

export async function heldByPage(page: Page): Promise<Held> {
  const session = await page.context().newCDPSession(page);
  const workers: string[] = [];
  session.on("Target.attachedToTarget", ({ sessionId, targetInfo }) => {
    if (targetInfo.type === "worker") workers.push(sessionId);
  });
  await session.send("Target.setAutoAttach", {
    autoAttach: true,
    waitForDebuggerOnStart: false,
    flatten: false,
  });
  await session.send("HeapProfiler.collectGarbage");
  const main = bytesOf((await session.send("Runtime.getHeapUsage")) as HeapUsage);
  let ofWorkers = 0;
  for (const worker of workers) {
    await ask(session, worker, "HeapProfiler.collectGarbage");
    ofWorkers += bytesOf((await ask(session, worker, "Runtime.getHeapUsage")) as HeapUsage);
  }
  await session.detach();
  return { main, workers: ofWorkers };
}

function bytesOf({
  usedSize,
  embedderHeapUsedSize = 0,
  backingStorageSize = 0,
}: HeapUsage): number {
  return usedSize + embedderHeapUsedSize + backingStorageSize;
}

let lastId = 0;

/** Asks a worker, whose session lies inside that of its page. */
async function ask(session: CDPSession, worker: string, method: string): Promise<unknown> {
  const id = ++lastId;
  const answered = new Promise((resolve) => {
    const hear = ({ message }: { message: string }): void => {
      const answer = JSON.parse(message) as { id?: number; result?: unknown };
      if (answer.id !== id) return;
      session.off("Target.receivedMessageFromTarget", hear);
      resolve(answer.result);
    };
    session.on("Target.receivedMessageFromTarget", hear);
  });
  const message = JSON.stringify({ id, method });
  await session.send("Target.sendMessageToTarget", { sessionId: worker, message });
  return answered;
}
