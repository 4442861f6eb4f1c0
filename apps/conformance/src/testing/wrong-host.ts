/** A host that stands before a right one and does one thing wrong. */
import { once } from "node:events";
import { createServer, type IncomingMessage } from "node:http";
import type { AddressInfo } from "node:net";
import { onTestFinished } from "vitest";

export interface Passing {
  method: string;
  path: string;
  headers: Record<string, string>;
  body: string;
}

export interface Answered {
  status: number;
  headers: Record<string, string>;
  text: string;
}

/** What it does wrong, on the way there or on the way back. */
export interface Fault {
  there?: (passing: Passing) => Passing;
  back?: (answered: Answered, passing: Passing) => Answered;
}

/** @returns the address of the same robot at the wrong host */
export async function wrongHost(address: string, fault: Fault): Promise<string> {
  const origin = new URL(address).origin;
  const server = createServer((request, response) => {
    void pass(origin, request, fault).then(
      ({ status, headers, text }) => response.writeHead(status, headers).end(text),
      () => response.destroy(),
    );
  });
  server.listen(0, "127.0.0.1");
  await once(server, "listening");
  onTestFinished(() => {
    server.closeAllConnections();
    server.close();
  });
  const { port } = server.address() as AddressInfo;
  return address.replace(origin, `http://127.0.0.1:${port}`);
}

async function pass(origin: string, request: IncomingMessage, fault: Fault): Promise<Answered> {
  let body = "";
  for await (const chunk of request.setEncoding("utf8")) body += String(chunk);
  const headers: Record<string, string> = {};
  for (const name of ["authorization", "content-type", "idempotency-key"]) {
    const value = request.headers[name];
    if (typeof value === "string") headers[name] = value;
  }
  const came = { method: request.method ?? "GET", path: request.url ?? "/", headers, body };
  const passing = fault.there?.(came) ?? came;
  // A stream has no end to wait for; what it tells is no matter here.
  const isStream = passing.path.endsWith("/events");
  const answer = await fetch(origin + passing.path, {
    method: passing.method,
    headers: passing.headers,
    ...(passing.body !== "" && { body: passing.body }),
    ...(isStream && { signal: AbortSignal.timeout(500) }),
  });
  const kept = ["content-type", "location", "allow", "www-authenticate", "retry-after"];
  const answered = {
    status: answer.status,
    headers: Object.fromEntries(
      kept.flatMap((name) => {
        const value = answer.headers.get(name);
        return value === null ? [] : [[name, value]];
      }),
    ),
    text: isStream && answer.ok ? "" : await answer.text(),
  };
  return fault.back?.(answered, passing) ?? answered;
}
