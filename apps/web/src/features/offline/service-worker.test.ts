import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import { startServiceWorker } from "./service-worker.ts";

class FakeWorker extends EventTarget {
  state = "installing";

  finishInstallation(): void {
    this.state = "installed";
    this.dispatchEvent(new Event("statechange"));
  }
}

class FakeRegistration extends EventTarget {
  active: FakeWorker | null = new FakeWorker();
  waiting: FakeWorker | null = null;
  installing: FakeWorker | null = null;
}

/** Opens a page. @returns how many versions it has offered */
async function openPage(registration: FakeRegistration): Promise<() => number> {
  const container = Object.assign(new EventTarget(), {
    controller: null,
    register: () => Promise.resolve(registration),
  });
  vi.stubGlobal("navigator", { serviceWorker: container });
  let offers = 0;
  await startServiceWorker({ onReady: () => (offers += 1), onTaken: () => undefined });
  return () => offers;
}

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

describe("a new version is offered", () => {
  test("that this page finds", async () => {
    const registration = new FakeRegistration();
    const offers = await openPage(registration);
    const worker = new FakeWorker();
    registration.installing = worker;
    registration.dispatchEvent(new Event("updatefound"));
    expect(offers()).toBe(0);
    worker.finishInstallation();
    expect(offers()).toBe(1);
  });

  test("that was waiting before the page opened", async () => {
    const registration = new FakeRegistration();
    registration.waiting = new FakeWorker();
    const offers = await openPage(registration);
    expect(offers()).toBe(1);
  });

  test("that another page was installing when this page opened", async () => {
    const registration = new FakeRegistration();
    const worker = new FakeWorker();
    registration.installing = worker;
    const offers = await openPage(registration);
    worker.finishInstallation();
    expect(offers()).toBe(1);
  });

  test("but not the first version of a device", async () => {
    const registration = new FakeRegistration();
    registration.active = null;
    const worker = new FakeWorker();
    registration.installing = worker;
    const offers = await openPage(registration);
    worker.finishInstallation();
    expect(offers()).toBe(0);
  });
});
