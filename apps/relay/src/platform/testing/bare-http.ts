/** Sends one HTTP request as raw bytes, for requests that client libraries cannot send. */
import { connect } from "node:net";

export interface BareRequest {
  method?: string;
  path: string;
  headers?: Record<string, string>;
  body?: string | Uint8Array;
  /** Half-closes the connection before the body is complete, and reads the response. */
  isCutOff?: boolean;
}

export interface BareAnswer {
  status: number;
  /** by lower-case names */
  headers: Map<string, string>;
  text: string;
}

/** Sends a request and reads until the server closes the connection. */
export function askBare(origin: string, request: BareRequest): Promise<BareAnswer> {
  const { method = "GET", path, headers = {}, body = "", isCutOff = false } = request;
  const bytes = Buffer.from(body);
  const hasBody = bytes.length > 0 || isCutOff;
  const lines = [
    `${method} ${path} HTTP/1.1`,
    `Host: ${new URL(origin).host}`,
    "Connection: close",
    ...(hasBody && headers["Content-Type"] === undefined ? ["Content-Type: application/json"] : []),
    ...(hasBody ? [`Content-Length: ${bytes.length + (isCutOff ? 1 : 0)}`] : []),
    ...Object.entries(headers).map(([name, value]) => `${name}: ${value}`),
  ];
  const head = Buffer.from(`${lines.join("\r\n")}\r\n\r\n`, "latin1");
  return sendBare(origin, Buffer.concat([head, bytes]), isCutOff);
}

/** Sends bytes that are not a request. */
export function sendBare(
  origin: string,
  bytes: string | Uint8Array,
  isCutOff = false,
): Promise<BareAnswer> {
  const { hostname, port } = new URL(origin);
  const socket = connect(Number(port), hostname);
  const parts: Buffer[] = [];
  socket.on("data", (part: Buffer) => parts.push(part));
  if (isCutOff) socket.end(bytes);
  else socket.write(bytes);
  return new Promise((resolve, reject) => {
    socket.on("error", (error) => parts.length === 0 && reject(error));
    socket.on("close", () => resolve(read(Buffer.concat(parts).toString("utf8"))));
  });
}

function read(answer: string): BareAnswer {
  const end = answer.indexOf("\r\n\r\n");
  const [first = "", ...lines] = answer.slice(0, end).split("\r\n");
  const headers = lines.map((line): [string, string] => {
    const colon = line.indexOf(":");
    return [line.slice(0, colon).toLowerCase(), line.slice(colon + 1).trim()];
  });
  const status = Number(/^HTTP\/1\.1 (\d{3})/.exec(first)?.[1] ?? 0);
  return { status, headers: new Map(headers), text: answer.slice(end + 4) };
}
