/** Answers an upgrade request that is refused: an ordinary HTTP answer on the bare connection. */
import { STATUS_CODES } from "node:http";
import type { Duplex } from "node:stream";
import type { Refusal } from "../problems.ts";

export function refuseUpgrade(socket: Duplex, { problem }: Refusal): void {
  const body = JSON.stringify(problem);
  // A client that is gone already makes this fail; there is nobody left to tell.
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
