/** Rejects an upgrade request with an ordinary HTTP response on the raw connection. */
import { STATUS_CODES } from "node:http";
import type { Duplex } from "node:stream";
import type { Refusal } from "../errors/problems.ts";

export function refuseUpgrade(socket: Duplex, { problem }: Refusal): void {
  const body = JSON.stringify(problem);
  // Fails if the client has already disconnected.
  socket.on("error", () => socket.destroy());
  socket.end(
    [
      `HTTP/1.1 ${problem.status} ${STATUS_CODES[problem.status] ?? ""}`,
      "Content-Type: application/problem+json",
      `Content-Length: ${Buffer.byteLength(body)}`,
      "Connection: close",
      "",
      body,
    ].join("\r\n"),
  );
}
