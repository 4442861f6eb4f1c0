import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import { describe, expect, it } from "vitest";
import { startTestRelay, testFolder } from "../../testing/test-relay.ts";

function builtWeb(): string {
  const webRoot = testFolder();
  mkdirSync(join(webRoot, "dist"));
  writeFileSync(join(webRoot, "dist", "index.html"), "<title>Corridor</title>");
  return webRoot;
}

function framing({ headers }: Response): { option: string | null; ancestors: string | null } {
  const policy = headers.get("content-security-policy") ?? "";
  return {
    option: headers.get("x-frame-options"),
    ancestors: /frame-ancestors ([^;]*)/.exec(policy)?.[1] ?? null,
  };
}

describe("showing a page in a frame of another site", () => {
  it("is possible for /embed only", async () => {
    const { origin } = await startTestRelay({ webRoot: builtWeb() });
    for (const path of ["/embed", "/embed/m/BCDF", "/embed?lang=de"]) {
      const answer = await fetch(origin + path);
      expect([path, answer.status]).toEqual([path, 200]);
      expect(framing(answer)).toEqual({ option: null, ancestors: null });
      const policy = answer.headers.get("content-security-policy");
      expect(policy).toContain("default-src 'self'");
      expect(policy).toContain("require-trusted-types-for 'script'");
    }
    const others = ["/", "/m/BCDF", "/r/A", "/teach", "/join", "/docs", "/check", "/healthz"];
    for (const path of [...others, "/embed/x", "/embed/m/", "/embedded", "/api/v1/oembed"]) {
      const answer = await fetch(origin + path);
      expect([path, framing(answer)]).toEqual([path, { option: "DENY", ancestors: "'none'" }]);
    }
  });

  it("can be restricted to some sites", async () => {
    const config = { embedOrigins: ["https://moodle.example.org", "https://a.example"] };
    const { origin } = await startTestRelay({ webRoot: builtWeb(), config });
    const answer = await fetch(`${origin}/embed/m/BCDF`);
    const ancestors = "https://moodle.example.org https://a.example";
    expect(framing(answer)).toEqual({ option: null, ancestors });
  });
});

describe("the page of a short link", () => {
  it("names its description for embedding sites", async () => {
    const { origin } = await startTestRelay({ webRoot: builtWeb() });
    const answer = await fetch(`${origin}/m/BCDF`);
    const target = `${origin}/api/v1/oembed?url=${encodeURIComponent(`${origin}/m/BCDF`)}`;
    expect(answer.headers.get("link")).toBe(
      `<${target}>; rel="alternate"; type="application/json+oembed"`,
    );
    for (const path of ["/m/%22%3E", "/", "/teach"]) {
      expect((await fetch(origin + path)).headers.get("link")).toBeNull();
    }
  });
});
