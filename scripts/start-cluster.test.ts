import { spawn } from "node:child_process";
import { once } from "node:events";
import { mkdtempSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { describe, expect, it, onTestFinished } from "vitest";
import { findRedis } from "./redis-server.ts";

const SCRIPT = join(import.meta.dirname, "start-cluster.ts");

describe.skipIf(findRedis() === null)("npm run start:cluster", () => {
  it("says where everything is, serves behind the balancer, and ends all that it started", async () => {
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
    const pids = [...text.matchAll(/kill -9 (\d+)/g)].map(([, pid]) => Number(pid));
    expect(pids).toHaveLength(2);

    cluster.kill("SIGINT");
    expect(await end).toEqual([0, null]);
    for (const pid of pids) expect(() => process.kill(pid, 0)).toThrow(/ESRCH/);
    const [, redis = ""] = /redis:\/\/(\S+?),/.exec(text) ?? [];
    await expect(fetch(`http://${redis}`)).rejects.toThrow(/fetch failed/);
  });
});
