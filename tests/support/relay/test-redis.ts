/** A real Redis with its own folder, for one test. */
import { onTestFinished } from "vitest";
import { findRedis, startRedis } from "../../../scripts/redis-server.ts";
import { testFolder } from "../../../apps/relay/src/testing/test-relay.ts";
import { textsInFiles } from "../stored-files.ts";

/** Whether Redis is installed. Tests that need it are skipped otherwise. */
export const hasRedis = findRedis() !== null;
if (!hasRedis) process.stderr.write("skipped tests: there is no redis-server here\n");

/** Starts a Redis that ends with the test. @param settings such as ["--appendonly", "no"] */
export async function startTestRedis(settings: string[] = []) {
  const folder = testFolder();
  let server = await startRedis(folder, { settings });
  onTestFinished(() => server.stop("SIGKILL"));
  const { url, port } = server;
  return {
    url,
    port,
    stop: () => server.stop(),
    /** Halts it without closing its connections, as a slow disk does. */
    stall: () => process.kill(server.pid, "SIGSTOP"),
    resume: () => process.kill(server.pid, "SIGCONT"),
    /** Restarts it with the same files on the same port. */
    restart: async () => {
      server = await startRedis(folder, { port, settings });
    },
    /** Whether its files contain the text. */
    holds: (text: string): boolean => textsInFiles(folder, [text]).length > 0,
  };
}
