/**
 * The service worker stores the page's files on the device, so that the page opens without a
 * network. This module registers the service worker and reports when it holds a newer version.
 *
 * A new version waits until the user accepts it. Until then the page and its service worker have
 * the same version, so that every file that the page may still request exists.
 */

/** How often an open page checks for a new version, in ms. */
const LOOK_EVERY_MS = 3_600_000;

/**
 * How long the page waits before it activates a new version, in ms. The click or touch that accepts
 * the version can also be the first on the maze, which then loads a file. Chromium gives up the
 * activation when the old service worker receives a request meanwhile.
 */
const SETTLE_MS = 500;

export interface UpdatePorts {
  /**
   * A new version is ready.
   * @param take activates it; the page must reload when the promise resolves
   */
  onReady: (take: () => Promise<void>) => void;
  /**
   * Another page of this device activated a new version; this page continues with its own until it
   * reloads.
   */
  onTaken: () => void;
}

/**
 * Registers the service worker where browsers allow it: over HTTPS, and on localhost. The page also
 * works without it.
 */
export async function startServiceWorker({ onReady, onTaken }: UpdatePorts): Promise<void> {
  const container = (navigator as Partial<Navigator>).serviceWorker;
  if (container === undefined) return;
  let isTaking = false;
  // The first service worker takes control of a page that had none; that is no new version.
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
  const offerOnceInstalled = (worker: ServiceWorker | null): void => {
    worker?.addEventListener("statechange", () => {
      if (worker.state === "installed") offer(worker);
    });
  };
  offer(registration.waiting);
  // Another page may have found the version before this page listened.
  offerOnceInstalled(registration.installing);
  registration.addEventListener("updatefound", () => offerOnceInstalled(registration.installing));
  setInterval(() => {
    // Offline, or the relay does not respond: the next check is enough.
    registration.update().catch(() => undefined);
  }, LOOK_EVERY_MS);
}

async function takeOver(worker: ServiceWorker): Promise<void> {
  const taken = new Promise<void>((resolve) => {
    const look = (): void => {
      // Redundant: an even newer version came in between, and the reload brings that one.
      if (worker.state === "activated" || worker.state === "redundant") resolve();
    };
    worker.addEventListener("statechange", look);
    look();
  });
  await new Promise((resolve) => setTimeout(resolve, SETTLE_MS));
  worker.postMessage({ type: "SKIP_WAITING" });
  await taken;
}
