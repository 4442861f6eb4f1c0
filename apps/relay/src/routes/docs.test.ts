import { describe, expect, it } from "vitest";
import { startTestRelay } from "../testing/test-relay.ts";

describe("/docs", () => {
  it("is a page of its own under the strict policy, with everything that it loads", async () => {
    const { origin } = await startTestRelay();
    const page = await fetch(`${origin}/docs`);
    expect(page.headers.get("content-type")).toMatch(/^text\/html/);
    const policy = page.headers.get("content-security-policy") ?? "";
    expect(policy).toContain("script-src 'self'");
    expect(policy).not.toMatch(/unsafe/);
    expect(policy).toContain("require-trusted-types-for 'script';trusted-types default dompurify");
    const html = await page.text();
    expect(html).toContain("The life of a command");
    const files = [...html.matchAll(/(?:src|href)="(\/docs\/[^"]+)"/g)].map(([, path]) => path);
    expect(files).toHaveLength(4);
    for (const path of files) {
      const file = await fetch(origin + path);
      expect(file.status).toBe(200);
      expect((await file.text()).length).toBeGreaterThan(300);
      expect(file.headers.get("content-type")).toMatch(/^text\/(?:css|javascript)/);
    }
  });

  it.each(["/docs/package.json", "/docs/../package.json", "/docs/index.html"])(
    "serves nothing else: %s",
    async (path) => {
      const { origin } = await startTestRelay();
      expect((await fetch(origin + path)).status).toBe(404);
    },
  );
});
