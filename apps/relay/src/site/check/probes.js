/* Tests each network feature as Corridor uses it. A probe resolves to true if the feature works. */

const WAIT_S = 20;
const IDLE_MS = 25_000;
const QUICK_MS = 8_000;

// Trusted Types: the browser calls this policy for the URL of the worker.
globalThis.trustedTypes?.createPolicy("default", {
  createScriptURL: (address) => (address === "/check/check.worker.js" ? address : null),
});

/** Text that filters are likely to change. */
const BODY = JSON.stringify({ text: '<script> {"move": 100} äé漢🤖 '.repeat(40) });

async function request(path, options = {}, ms = QUICK_MS) {
  const response = await fetch(`/check/${path}`, {
    cache: "no-store",
    ...options,
    signal: AbortSignal.timeout(ms),
  });
  if (!response.ok) throw new Error(String(response.status));
  return response;
}

const KEY = "Bearer not-a-key";

async function echoOf(method, body) {
  const headers = { Authorization: KEY, "Content-Type": "application/json" };
  const response = await request("echo", { method, headers, ...(body && { body }) });
  return response.json();
}

/** Opens the socket that echoes each message. */
function openSocket() {
  const socket = new WebSocket(`${location.origin.replace(/^http/, "ws")}/check/socket`);
  return new Promise((resolve, reject) => {
    socket.addEventListener("open", () => resolve(socket));
    socket.addEventListener("close", () => reject(new Error("closed")));
    setTimeout(() => reject(new Error("timeout")), QUICK_MS);
  });
}

function echoes(socket, text) {
  return new Promise((resolve) => {
    socket.addEventListener("message", ({ data }) => resolve(data === text), { once: true });
    socket.addEventListener("close", () => resolve(false));
    setTimeout(() => resolve(false), QUICK_MS);
    socket.send(text);
  });
}

const pause = (ms) => new Promise((resolve) => setTimeout(resolve, ms));

/** Probes by name, in display order. */
export const probes = {
  get: async () => (await (await request("echo")).json()).method === "GET",
  post: async () => (await echoOf("POST", BODY)).body === BODY,
  authorization: async () => (await echoOf("POST", BODY)).authorization === KEY,
  remove: async () => (await echoOf("DELETE")).method === "DELETE",
  compressed: async () => (await (await request("compressed")).text()) === "Corridor ".repeat(500),
  events: async () => {
    const times = [];
    const { body } = await request("events", {}, 2 * QUICK_MS);
    const reader = body.pipeThrough(new TextDecoderStream()).getReader();
    for (let part = await reader.read(); !part.done; part = await reader.read()) {
      for (const _event of part.value.matchAll(/data:/g)) times.push(performance.now());
    }
    // The relay sends five events within 1.6 s. Buffered events arrive at the same time.
    return times.length === 5 && times.at(-1) - times[0] > 800;
  },
  wait: async () => {
    const response = await request(`wait?seconds=${WAIT_S}`, {}, WAIT_S * 1_000 + QUICK_MS);
    return (await response.json()).waited === WAIT_S;
  },
  socket: async () => {
    const socket = await openSocket();
    const isEcho = await echoes(socket, "forward");
    socket.close();
    return isEcho;
  },
  idle: async () => {
    const socket = await openSocket();
    await pause(IDLE_MS);
    const isEcho = await echoes(socket, "still here");
    socket.close();
    return isEcho;
  },
  worker: async () => {
    const worker = new Worker("/check/check.worker.js");
    const { promise, resolve } = Promise.withResolvers();
    worker.addEventListener("message", () => resolve(true));
    worker.addEventListener("error", () => resolve(false));
    const isHere = await Promise.race([promise, pause(QUICK_MS).then(() => false)]);
    worker.terminate();
    return isHere;
  },
  offline: async () => isSecureContext && "serviceWorker" in navigator,
};
