/**
 * Adds a WebSocket to a host without one, to test the checks of WebSockets. The bridge forwards
 * commands as requests, and events from the event stream. Faults can be injected into its messages.
 */
import { createHash } from "node:crypto";
import { createServer, request, type IncomingMessage, type ServerResponse } from "node:http";
import type { AddressInfo } from "node:net";
import type { Duplex } from "node:stream";
import {
  featureListSchema,
  hasEnded,
  type CommandRecord,
  type EventPage,
  type ProblemDocument,
  type Snapshot,
} from "@corridor/protocol";
import { MAX_BYTES } from "../../../packages/conformance/src/connection.ts";

export interface Message {
  type: string;
  version?: number;
  key?: string | null;
  since?: string;
  sentAt?: number;
  n?: number | null;
  record?: CommandRecord;
  [field: string]: unknown;
}

export interface BridgeFault {
  /** changes a message from the script; `connection` is the number of its connection */
  toHost?: (message: Message, connection: number) => Message;
  /** changes a message to the script; null drops it */
  toScript?: (message: Message, connection: number) => Message | null;
  /** the close code that replaces 4401 */
  closeCode?: number;
  /** accepts a hello of any version */
  acceptsAnyVersion?: boolean;
  /** polls the host while a connection is open */
  pollsHost?: boolean;
  /** sends snapshots without waiting for acknowledgements */
  ignoresSeen?: boolean;
  /** the limit that replaces 16 KiB */
  maxBytes?: number;
}

interface Bridge {
  /** the address of the same robot, through the bridge */
  address: string;
  stop: () => void;
}

const GUID = "258EAFA5-E914-47DA-95CA-C5AB0DC85B11";
const REJECTED = 4401;
const TOO_LARGE = 1009;
const HEARTBEAT_MS = 20_000;
const CREDIT = 2;

/** @param address of a robot whose host offers no WebSocket */
export async function startBridge(address: string, fault: BridgeFault = {}): Promise<Bridge> {
  const { origin, pathname, hash } = new URL(address);
  const api = `${origin}/api/v1/robots/${pathname.slice(3)}`;
  const sockets = new Set<Duplex>();
  let connections = 0;
  const server = createServer((incoming, response) => void forward(origin, incoming, response));
  server.on("upgrade", (incoming: IncomingMessage, socket: Duplex) => {
    const key = String(incoming.headers["sec-websocket-key"]);
    const accept = createHash("sha1")
      .update(key + GUID)
      .digest("base64");
    socket.write(
      `HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${accept}\r\n\r\n`,
    );
    new BridgedSocket(socket, api, fault, ++connections);
    sockets.add(socket.once("close", () => sockets.delete(socket)));
  });
  await new Promise<void>((resolve) => server.listen(0, "127.0.0.1", resolve));
  const { port } = server.address() as AddressInfo;
  return {
    address: `http://127.0.0.1:${port}${pathname}${hash}`,
    stop: () => {
      server.close();
      server.closeAllConnections();
      for (const socket of sockets) socket.destroy();
    },
  };
}

/** Forwards an HTTP request, and removes the WebSocket from the list of missing features. */
async function forward(origin: string, incoming: IncomingMessage, response: ServerResponse) {
  const { method = "GET", url = "/", headers } = incoming;
  if (url.endsWith("/features")) {
    const authorization = headers.authorization ?? "";
    const forwarded = await fetch(origin + url, { headers: { authorization } });
    response.writeHead(forwarded.status, { "Content-Type": "application/json" });
    if (!forwarded.ok) return response.end(await forwarded.text());
    const { notOffered } = featureListSchema.parse(await forwarded.json());
    const others = notOffered.filter(({ feature }) => feature !== "websocket");
    return response.end(JSON.stringify({ notOffered: others }));
  }
  const outgoing = request(origin + url, { method, headers }, (forwarded) => {
    response.writeHead(forwarded.statusCode ?? 502, forwarded.headers);
    forwarded.pipe(response);
  });
  response.on("close", () => outgoing.destroy());
  outgoing.on("error", () => response.destroy());
  return incoming.pipe(outgoing);
}

class BridgedSocket {
  readonly #socket: Duplex;
  readonly #api: string;
  readonly #fault: BridgeFault;
  readonly #connection: number;
  readonly #clock: string;
  readonly #closed = new AbortController();
  #bytes: Buffer = Buffer.alloc(0);
  #key: string | null = null;
  /** numbers of the snapshots that the script has not acknowledged */
  #unacknowledged: number[] = [];
  #acknowledges = false;
  /** the newest snapshot, held until the script acknowledges an earlier one */
  #heldSnapshot: Snapshot | null = null;
  /** serial queue: messages are processed one at a time */
  #work: Promise<void> = Promise.resolve();

  constructor(socket: Duplex, api: string, fault: BridgeFault, connection: number) {
    this.#socket = socket;
    this.#api = api;
    this.#fault = fault;
    this.#connection = connection;
    this.#clock = `bridge-${connection}-${Math.random().toString(36).slice(2, 10)}`;
    socket.on("data", (bytes: Buffer) => this.#read(bytes));
    socket.on("close", () => this.#closed.abort());
    socket.on("error", () => this.#closed.abort());
  }

  #read(bytes: Buffer): void {
    this.#bytes = Buffer.concat([this.#bytes, bytes]);
    for (;;) {
      const frame = takeFrame(this.#bytes);
      if (frame === null) return;
      this.#bytes = frame.rest;
      if (frame.opcode === 8) return this.#close(1000);
      if (frame.opcode !== 1) continue;
      const { maxBytes = MAX_BYTES } = this.#fault;
      if (frame.payload.length > maxBytes) return this.#close(TOO_LARGE);
      const message = JSON.parse(frame.payload.toString()) as Message;
      const { toHost } = this.#fault;
      const changed = toHost === undefined ? message : toHost(message, this.#connection);
      this.#work = this.#work
        .then(() => (this.#key === null ? this.#hello(changed) : this.#receive(changed)))
        .catch(() => this.#close(1011));
    }
  }

  async #hello({ version, key, since, sentAt }: Message): Promise<void> {
    const { closeCode = REJECTED, acceptsAnyVersion = false, pollsHost = false } = this.#fault;
    this.#key = key ?? "";
    const query = since === undefined ? "" : `&since=${since}`;
    const response = await this.#request(`/events?wait=0${query}`, sentAt);
    if (response.status === 401) return this.#close(closeCode);
    if (version !== 1 && !acceptsAnyVersion) return this.#close(closeCode);
    const page = (await response.json()) as EventPage;
    const [stream, n] = (page.gap === null && since !== undefined ? since : page.since).split("-");
    const snapshot = await (await this.#request("/sensors")).json();
    const resumedAt = page.gap === null ? Number(n) : null;
    this.#send({ type: "welcome", version: 1, stream, n: resumedAt, snapshot });
    if (page.gap !== null) this.#send({ ...page.gap, type: "gap" });
    for (const state of page.states) this.#send({ ...state, type: "state" });
    void this.#follow(page.since).catch(() => this.#close(1011));
    this.#every(HEARTBEAT_MS, () => this.#send({ type: "heartbeat" }));
    const request = () => this.#request("/commands?after=0").catch(() => this.#close(1011));
    if (pollsHost) this.#every(500, () => void request());
  }

  #every(ms: number, act: () => void): void {
    const { signal } = this.#closed;
    if (signal.aborted) return;
    const timer = setInterval(act, ms);
    signal.addEventListener("abort", () => clearInterval(timer));
  }

  async #receive(message: Message): Promise<void> {
    if (message.type !== "seen") return this.#command(message);
    this.#acknowledges = true;
    this.#unacknowledged = this.#unacknowledged.filter((seq) => seq > Number(message["seq"]));
    const held = this.#heldSnapshot;
    this.#heldSnapshot = null;
    if (held !== null) this.#offer(held);
  }

  /** Sends a snapshot, or holds it until earlier ones are acknowledged. */
  #offer(snapshot: Snapshot): void {
    const isFull = this.#acknowledges && this.#unacknowledged.length >= CREDIT;
    if (isFull && this.#fault.ignoresSeen !== true) this.#heldSnapshot = snapshot;
    else this.#sendSnapshot(snapshot);
  }

  #sendSnapshot(snapshot: Snapshot): void {
    this.#heldSnapshot = null;
    this.#unacknowledged.push(snapshot.seq);
    this.#send({ type: "snapshot", snapshot });
  }

  async #command({ key, command, sentAt }: Message): Promise<void> {
    const response = await this.#request("/commands", sentAt, {
      method: "POST",
      body: JSON.stringify(command),
      headers: {
        "Content-Type": "application/json",
        ...(typeof key === "string" && { "Idempotency-Key": key }),
      },
    });
    if (response.status === 202) {
      return this.#send({ type: "ack", record: (await response.json()) as CommandRecord });
    }
    const problem = (await response.json()) as ProblemDocument;
    this.#send({ type: "problem", problem, key: key ?? null });
  }

  /** Reads the event stream, which does not count as a request of the script. */
  async #follow(since: string): Promise<void> {
    const headers = { Authorization: `Bearer ${this.#key}`, "Last-Event-ID": since };
    const { signal } = this.#closed;
    const { body } = await fetch(`${this.#api}/events`, { headers, signal });
    let text = "";
    for await (const chunk of body?.pipeThrough(new TextDecoderStream()) ?? []) {
      const blocks = (text + chunk).split("\n\n");
      text = blocks.pop() ?? "";
      for (const block of blocks) await this.#publish(block);
    }
  }

  async #publish(block: string): Promise<void> {
    const event = /^event: ?(.*)$/m.exec(block)?.[1];
    const value: unknown = JSON.parse(/^data: ?(.*)$/m.exec(block)?.[1] ?? "null");
    if (event === "snapshot") this.#offer(value as Snapshot);
    if (event !== "state") return;
    const record = value as CommandRecord;
    if (hasEnded(record.state)) {
      this.#offer((await (await this.#request("/sensors")).json()) as Snapshot);
    }
    const n = Number(/^id: ?.*-(\d+)$/m.exec(block)?.[1]);
    this.#send({ type: "state", n, record });
  }

  async #request(path: string, sentAt?: number, options: RequestInit = {}): Promise<Response> {
    const headers = {
      Authorization: `Bearer ${this.#key}`,
      ...(sentAt !== undefined && { "Script-Clock": `${this.#clock} ${sentAt}` }),
      ...(options.headers as Record<string, string>),
    };
    return fetch(this.#api + path, { ...options, headers });
  }

  #send(message: Message): void {
    const { toScript } = this.#fault;
    const changed = toScript === undefined ? message : toScript(message, this.#connection);
    if (changed !== null) this.#write(1, Buffer.from(JSON.stringify(changed)));
  }

  #close(code: number): void {
    const reason = Buffer.alloc(2);
    reason.writeUInt16BE(code);
    this.#write(8, reason);
    this.#socket.end();
  }

  #write(opcode: number, payload: Buffer): void {
    if (!this.#socket.writable) return;
    const { length } = payload;
    const head = Buffer.alloc(length < 126 ? 2 : 4);
    head[0] = 0x80 + opcode;
    head[1] = Math.min(length, 126);
    if (length >= 126) head.writeUInt16BE(length, 2);
    this.#socket.write(Buffer.concat([head, payload]));
  }
}

/**
 * The first complete frame of a client, unmasked; null until all of its bytes have arrived.
 * Messages here are short and not fragmented.
 */
function takeFrame(bytes: Buffer) {
  if (bytes.length < 2) return null;
  const [first = 0, second = 0] = bytes;
  const isLong = (second & 127) === 126;
  if (isLong && bytes.length < 4) return null;
  const start = isLong ? 8 : 6;
  const end = start + (isLong ? bytes.readUInt16BE(2) : second & 127);
  if (bytes.length < end) return null;
  const mask = bytes.subarray(start - 4, start);
  const payload = Buffer.from(
    bytes.subarray(start, end).map((byte, at) => byte ^ (mask[at % 4] ?? 0)),
  );
  return { opcode: first & 15, payload, rest: bytes.subarray(end) };
}
