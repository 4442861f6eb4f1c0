/** Measures the memory of a page and its workers after a garbage collection. */
import type { CDPSession, Page } from "playwright";

/** Bytes in use by the page's main thread and by its workers. */
export interface PageMemory {
  main: number;
  workers: number;
}

/** The result of `Runtime.getHeapUsage`. */
interface HeapUsage {
  usedSize: number;
  /** objects of the browser engine: nodes, styles, canvases */
  embedderHeapUsedSize?: number;
  /** typed arrays */
  backingStorageSize?: number;
}

export async function measurePageMemory(page: Page): Promise<PageMemory> {
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
  let workerBytes = 0;
  for (const worker of workers) {
    await callWorker(session, worker, "HeapProfiler.collectGarbage");
    workerBytes += bytesOf(
      (await callWorker(session, worker, "Runtime.getHeapUsage")) as HeapUsage,
    );
  }
  await session.detach();
  return { main, workers: workerBytes };
}

function bytesOf({
  usedSize,
  embedderHeapUsedSize = 0,
  backingStorageSize = 0,
}: HeapUsage): number {
  return usedSize + embedderHeapUsedSize + backingStorageSize;
}

let lastId = 0;

/** Calls a CDP method of a worker, whose session is nested in the session of its page. */
async function callWorker(session: CDPSession, worker: string, method: string): Promise<unknown> {
  const id = ++lastId;
  const result = new Promise((resolve) => {
    const onMessage = ({ message }: { message: string }): void => {
      const response = JSON.parse(message) as { id?: number; result?: unknown };
      if (response.id !== id) return;
      session.off("Target.receivedMessageFromTarget", onMessage);
      resolve(response.result);
    };
    session.on("Target.receivedMessageFromTarget", onMessage);
  });
  const message = JSON.stringify({ id, method });
  await session.send("Target.sendMessageToTarget", { sessionId: worker, message });
  return result;
}
