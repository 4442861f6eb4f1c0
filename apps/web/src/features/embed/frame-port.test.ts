import { describe, expect, it } from "vitest";
import type { FrameRequest } from "@corridor/protocol";
import { FramePort, type FrameWindow } from "./frame-port.ts";

type Listener = Parameters<FrameWindow["addEventListener"]>[1];

function openFrame(isFramed: boolean) {
  const posted: unknown[] = [];
  const listeners: Listener[] = [];
  const parent = { postMessage: (message: unknown) => void posted.push(message) };
  const window = {
    postMessage: (message: unknown) => void posted.push(message),
    addEventListener: (_type: "message", listener: Listener) => void listeners.push(listener),
  };
  const frame = Object.assign(window, { parent: parent as Pick<Window, "postMessage"> });
  if (!isFramed) frame.parent = frame;
  const port = new FramePort(frame);
  const requests: FrameRequest[] = [];
  port.listen((request) => requests.push(request));
  const receive = (source: unknown, data: unknown) => {
    for (const listener of listeners) listener({ source: source as MessageEventSource, data });
  };
  return { port, posted, requests, receive, parent, frame };
}

describe("a page in a frame", () => {
  it("reports to the site around it, also its size as learning platforms expect it", () => {
    const { port, posted } = openFrame(true);
    port.send({ type: "ready" });
    port.sendSize(720, 431);
    expect(posted).toEqual([
      { corridor: 1, type: "ready" },
      { corridor: 1, type: "size", width: 720, height: 431 },
      { subject: "lti.frameResize", height: 431 },
    ]);
  });

  it("follows requests of that site only", () => {
    const { requests, receive, parent, frame } = openFrame(true);
    receive(frame, { corridor: 1, type: "run" });
    receive(null, { corridor: 1, type: "run" });
    receive({ postMessage: () => undefined }, { corridor: 1, type: "run" });
    receive(parent, "run");
    expect(requests).toEqual([]);
    receive(parent, { corridor: 1, type: "run" });
    expect(requests).toEqual([{ corridor: 1, type: "run" }]);
  });
});

describe("a page in no frame", () => {
  it("reports nothing, and follows no message", () => {
    const { port, posted, requests, receive, frame } = openFrame(false);
    port.send({ type: "ready" });
    port.sendSize(1, 1);
    receive(frame, { corridor: 1, type: "run" });
    expect([posted, requests]).toEqual([[], []]);
  });
});
