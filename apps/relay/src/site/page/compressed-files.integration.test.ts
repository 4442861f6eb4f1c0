import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { brotliCompressSync, gzipSync } from "node:zlib";
import { describe, expect, it } from "vitest";
import { startTestRelay, testFolder } from "../../testing/test-relay.ts";

const script = 'console.log("corridor");'.repeat(50);

function builtWeb(): string {
  const webRoot = testFolder();
  const assets = join(webRoot, "dist", "assets");
  mkdirSync(assets, { recursive: true });
  writeFileSync(join(webRoot, "dist", "index.html"), "<title>Corridor</title>");
  writeFileSync(join(assets, "page-1a2b.js"), script);
  writeFileSync(join(assets, "page-1a2b.js.br"), brotliCompressSync(script));
  writeFileSync(join(assets, "page-1a2b.js.gz"), gzipSync(script));
  return webRoot;
}

describe("a file of the page", () => {
  it.each([
    { accepted: "gzip, deflate, br", encoding: "br" },
    { accepted: "gzip", encoding: "gzip" },
    { accepted: "br;q=0, gzip", encoding: "gzip" },
    { accepted: "identity", encoding: null },
  ])(
    "is sent as $encoding to clients that accept $accepted, with the same content",
    async (row) => {
      const relay = await startTestRelay({ webRoot: builtWeb() });
      const answer = await fetch(`${relay.origin}/assets/page-1a2b.js`, {
        headers: { "Accept-Encoding": row.accepted },
      });
      expect(answer.headers.get("content-encoding")).toBe(row.encoding);
      expect(answer.headers.get("content-type")).toContain("text/javascript");
      expect(answer.headers.get("vary")).toContain("Accept-Encoding");
      expect(answer.headers.get("cache-control")).toContain("immutable");
      expect(await answer.text()).toBe(script);
    },
  );

  it("is revalidated by browsers if a new version matters", async () => {
    const relay = await startTestRelay({ webRoot: builtWeb() });
    const page = await fetch(`${relay.origin}/`);
    expect(page.headers.get("cache-control")).toBe("no-cache");
    const missing = await fetch(`${relay.origin}/assets/older-3c4d.js`);
    expect(missing.status).toBe(404);
    expect(missing.headers.get("cache-control")).toBeNull();
  });
});
