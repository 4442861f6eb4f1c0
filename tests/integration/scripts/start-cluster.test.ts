import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { registrationSchema } from "@corridor/protocol";
import { describe, expect, it, onTestFinished, vi } from "vitest";
import { findRedis } from "../../../scripts/redis-server.ts";
import { textsInFiles } from "../../support/stored-files.ts";

const SCRIPT = join(import.meta.dirname, "../../../scripts/start-cluster.ts");

describe.skipIf(findRedis() === null)("npm run start:cluster", () => {
  it("prints all addresses, serves through the balancer, and ends every process it started", async () => {
    const folder = mkdtempSync(join(tmpdir(), "corridor-"));
    const cluster = spawn(process.execPath, [SCRIPT], {
      env: { PATH: process.env["PATH"] ?? "", PORT: "0", DATA_DIR: folder },
      stdio: ["ignore", "pipe", "inherit"],
    });
    const end = once(cluster, "close");
    onTestFinished(async () => {
      cluster.kill("SIGTERM");
      await end;
      rmSync(folder, { recursive: true, force: true });
    });
    let text = "";
    while (!text.includes("Corridor is ready")) {
      text += String((await once(cluster.stdout, "data"))[0]);
    }
    const origin = /Corridor is ready: (http\S+)/.exec(text)?.[1] ?? "";
    const ready = await fetch(`${origin}/readyz`);
    expect(await ready.json()).toEqual({ status: "ready" });
    const relays = [...text.matchAll(/^Relay.*kill -9 (\d+)/gm)].map(([, pid]) => Number(pid));
    expect(relays).toHaveLength(2);

    // A killed Redis restarts with the same data, and the relays reconnect to it.
    const robot = await fetch(`${origin}/api/v1/robots`, { method: "POST" });
    const { id, ownerKey } = registrationSchema.parse(await robot.json());
    // While Redis writes to a slow disk, it confirms what it has not written yet.
    await vi.waitFor(() => expect(textsInFiles(folder, [id])).toEqual([id]), { timeout: 10_000 });
    const before = text.length;
    process.kill(Number(/^Redis.*kill -9 (\d+)/m.exec(text)?.[1]), "SIGKILL");
    const restarted = /^Redis.*kill -9 (\d+)/m;
    while (!restarted.test(text.slice(before))) {
      text += String((await once(cluster.stdout, "data"))[0]);
    }
    await vi.waitFor(
      async () => {
        const headers = { Authorization: `Bearer ${ownerKey}` };
        const keys = await fetch(`${origin}/api/v1/robots/${id}/keys`, { headers });
        expect(keys.status).toBe(200);
      },
      { timeout: 30_000, interval: 200 },
    );
    const redisPid = Number(restarted.exec(text.slice(before))?.[1]);

    cluster.kill("SIGINT");
    expect(await end).toEqual([0, null]);
    for (const pid of [...relays, redisPid]) expect(() => process.kill(pid, 0)).toThrow(/ESRCH/);
    const [, redis = ""] = /redis:\/\/(\S+?),/.exec(text) ?? [];
    await expect(fetch(`http://${redis}`)).rejects.toThrow(/fetch failed/);
  });
});
