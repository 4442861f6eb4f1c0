import { spawn } from "node:child_process";
import { once } from "node:events";
import { createServer } from "node:net";
import type { AddressInfo } from "node:net";
import { join } from "node:path";
import { describe, expect, it, onTestFinished } from "vitest";
import { WebSocket } from "ws";
import { launchRelayProcess, startRelayProcess } from "../../support/test-relay-process.ts";
import { testFolder } from "../../../apps/relay/src/testing/test-relay.ts";

const READY = /Corridor is ready: (http:\S+)/;

describe("starting the relay", () => {
  it("prints one working address and exits cleanly on SIGTERM", async () => {
    const relay = await startRelayProcess();
    expect((await fetch(`${relay.url}/healthz`)).status).toBe(200);
    relay.signal("SIGTERM");
    expect(await relay.exitCode()).toBe(0);
    expect(relay.log.trim().split("\n")).toHaveLength(1);
  });

  it("reports wrong settings and exits with 2", async () => {
    const relay = launchRelayProcess({ environment: { PORT: "eighty", LOG_LEVEL: "loud" } });
    expect(await relay.exitCode()).toBe(2);
    expect(relay.log).toContain("PORT");
    expect(relay.log).toContain("LOG_LEVEL");
  });

  it("reports that the port is in use and how to fix it", async () => {
    const other = createServer().listen(0);
    onTestFinished(() => void other.close());
    await once(other, "listening");
    const { port } = other.address() as AddressInfo;
    const relay = launchRelayProcess({ environment: { PORT: String(port) } });
    expect(await relay.exitCode()).toBe(1);
    expect(relay.log).toContain(`port ${port} is in use`);
    expect(relay.log).not.toMatch(/\n\s+at /);
  });

  it("reports that the metrics port is in use", async () => {
    const other = createServer().listen(0, "127.0.0.1");
    onTestFinished(() => void other.close());
    await once(other, "listening");
    const { port } = other.address() as AddressInfo;
    const relay = launchRelayProcess({ environment: { METRICS_PORT: String(port) } });
    expect(await relay.exitCode()).toBe(1);
    expect(relay.log).toContain(`port ${port} is in use`);
    expect(relay.log).toContain(`METRICS_PORT=${port + 1}`);
  });

  it("exits when npm, its parent process, has exited", async () => {
    // npm runs the relay through a shell that does not forward signals.
    const main = join(import.meta.dirname, "../../../apps/relay/src/main.ts");
    const shell = spawn("sh", ["-c", `"${process.execPath}" "${main}"; true`], {
      env: { PORT: "0", DATA_DIR: testFolder(), npm_lifecycle_event: "start" },
      stdio: ["ignore", "pipe", "inherit"],
    });
    let text = "";
    while (!READY.test(text)) text += String((await once(shell.stdout, "data"))[0]);
    shell.kill("SIGKILL");
    // The pipe closes when the relay, the last process that holds it, exits.
    await once(shell.stdout, "end");
    const address = READY.exec(text)?.[1] ?? "";
    await expect(fetch(`${address}/healthz`)).rejects.toThrow(/fetch failed/);
  });

  it("logs no key at level debug", async () => {
    const relay = await startRelayProcess({ environment: { LOG_LEVEL: "debug" } });
    const answer = await fetch(`${relay.url}/api/v1/robots`, { method: "POST" });
    const robot = (await answer.json()) as { id: string; driverKey: string };
    const socket = new WebSocket(
      `${relay.url.replace("http", "ws")}/api/v1/robots/${robot.id}/socket`,
    );
    await once(socket, "open");
    socket.send("x".repeat(20_000));
    await once(socket, "close");
    await relay.says(/WebSocket error/);
    expect(relay.log).not.toContain(robot.driverKey);
  });
});

describe("npm run dev", () => {
  it("serves the page from its sources with hot reload, and the API, on one port", async () => {
    const { url } = await startRelayProcess({ arguments: ["--dev"] });
    const page = await fetch(`${url}/r/AAAAAAAAAAAAAAAAAAAAAA`);
    expect(await page.text()).toContain("/@vite/client");
    expect((await fetch(`${url}/healthz`)).status).toBe(200);
    const client = await (await fetch(`${url}/@vite/client`)).text();
    const token = /wsToken = "([^"]+)"/.exec(client)?.[1] ?? "";
    const base = url.replace("http", "ws");
    const reload = new WebSocket(`${base}/?token=${token}`, "vite-hmr", {
      origin: url,
    });
    const [hello] = (await once(reload, "message")) as [Buffer];
    expect(hello.toString()).toContain("connected");
    reload.terminate();
  });
});
