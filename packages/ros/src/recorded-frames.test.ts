/**
 * Replays what other ROS clients have sent. In a transcript, `>` is a message of the client, `<` the
 * answer, `=` an order to the robot, and `wait` a number of milliseconds.
 */
import { readdirSync, readFileSync } from "node:fs";
import { describe, expect, it } from "vitest";
import { settled } from "@corridor/protocol/testing";
import { RosClient } from "./testing/ros-client.ts";

const folder = new URL("./testing/transcripts/", import.meta.url);
const transcripts = readdirSync(folder);

describe("a recorded client", () => {
  it("has a transcript", () => {
    expect(transcripts).toContain("roslib-1.4.1.txt");
  });

  it.each(transcripts)("receives the answers of its transcript: %s", async (name) => {
    const transcript = readFileSync(new URL(name, folder), "utf8");
    expect(await replay(transcript)).toBe(transcript);
  });
});

/** @returns the transcript with the answers and orders of this replay */
async function replay(transcript: string): Promise<string> {
  const lines: string[] = [];
  let client: RosClient | null = null;
  for (const line of transcript.split("\n")) {
    if (/^[<=]/.test(line)) continue;
    lines.push(line);
    if (line === "connect") {
      client?.session.close();
      client = await RosClient.connect();
    }
    if (client === null) continue;
    const [frames, orders] = [client.frames.length, client.port.orders.length];
    if (line.startsWith("> ")) client.session.receive(line.slice(2));
    if (line.startsWith("wait ")) await client.timers.pass(Number(line.slice(5)));
    await settled();
    lines.push(...client.port.orders.slice(orders).map((order) => `= ${JSON.stringify(order)}`));
    // Velocities have a lease; of the commands, services wait for an end.
    for (const [index, { action }] of client.port.orders.entries()) {
      if (index < orders || action === "drive") continue;
      client.port.end(index + 1, { state: "completed" });
      await settled();
    }
    lines.push(...client.frames.slice(frames).map((frame) => `< ${JSON.stringify(frame)}`));
    expect(client.failures).toEqual([]);
  }
  return lines.join("\n");
}
