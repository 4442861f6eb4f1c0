/**
 * The service worker keeps the page's files on the device, so that it opens without a network. Here is
 * the page's end of it: start it, and say when it holds a newer version.
 *
 * A new version waits until the reader takes it. Until then the page and its service worker stay a
 * pair, so that every file that the page may still ask for is there.
 */

/** How often a page that stays open looks for a new version, in ms. */
const LOOK_EVERY_MS = 3_600_000;

export interface UpdatePorts {
  /**
   * A new version is ready.
   * @param take lets it take over; the page has to be reloaded when the promise is kept
   */
  onReady: (take: () => Promise<void>) => void;
  /** Another page of this device took a new version; this page goes on with its own until it reloads. */
  onTaken: () => void;
}

/** Starts it where browsers allow it (not on plain http but localhost). Without it the page works as ever. */
export async function startServiceWorker({ onReady, onTaken }: UpdatePorts): Promise<void> {
  const container = (navigator as Partial<Navigator>).serviceWorker;
  if (container === undefined) return;
  let isTaking = false;
  // The first one takes over a page that had none; that is no new version.
  let hadController = container.controller !== null;
  container.addEventListener("controllerchange", () => {
    if (hadController && !isTaking) onTaken();
    hadController = true;
  });

  const registration = await container.register("/sw.js", { updateViaCache: "none" });
  const offer = (worker: ServiceWorker | null): void => {
    if (worker === null || registration.active === null) return;
    onReady(() => {
      isTaking = true;
      return takeOver(worker);
    });
  };
  offer(registration.waiting);
  registration.addEventListener("updatefound", () => {
    const worker = registration.installing;
    worker?.addEventListener("statechange", () => {
      if (worker.state === "installed") offer(worker);
    });
  });
  setInterval(() => {
    // Offline, or the relay is gone: the next time will do.
    registration.update().catch(() => undefined);
  }, LOOK_EVERY_MS);
}

async function takeOver(worker: ServiceWorker): Promise<void> {
  const taken = new Promise<void>((resolve) => {
    const look = (): void => {
      // Redundant: a still newer one came in between, and the reload brings that.
      if (worker.state === "activated" || worker.state === "redundant") resolve();
    };
    worker.addEventListener("statechange", look);
    look();
  });
  worker.postMessage({ type: "SKIP_WAITING" });
  await taken;
}
