import { describe, expect, it } from "vitest";
import { problemKinds } from "../../platform/errors/problem-kinds.ts";
import { startTestRelay } from "../../testing/test-relay.ts";

/** Crawls all pages that /docs links to. Returns their HTML. */
async function site(origin: string): Promise<Map<string, string>> {
  const pages = new Map<string, string>();
  const waiting = ["/docs"];
  for (let path = waiting.pop(); path !== undefined; path = waiting.pop()) {
    if (pages.has(path)) continue;
    const answer = await fetch(origin + path);
    expect({ path, status: answer.status }).toEqual({ path, status: 200 });
    const html = await answer.text();
    pages.set(path, html);
    if (!/^\/(?:docs|problems)/.test(path)) continue;
    waiting.push(...linksIn(html).flatMap(([to]) => (to === "" || isBuilt(to) ? [] : to)));
  }
  return pages;
}

/** Whether a file exists only after `npm run build`. The built files have tests of their own. */
function isBuilt(path: string): boolean {
  return ["/", "/corridor.js", "/corridor-cli.mjs"].includes(path);
}

/** Path and fragment of every internal link. */
function linksIn(html: string): [string, string][] {
  return [...html.matchAll(/(?:href|src)="([/#][^"]*)"/g)].map(([, link = ""]) => {
    const [path = "", fragment = ""] = link.split("#");
    return [path, fragment];
  });
}

describe("the documentation", () => {
  it("has a page for every kind of problem, at the URL that `type` names", async () => {
    const { origin } = await startTestRelay();
    const refused = await fetch(`${origin}/api/v1/robots/none/sensors`);
    const { type } = (await refused.json()) as { type: string };
    expect((await fetch(new URL(type, refused.url))).status).toBe(200);
    for (const [kind, { title, fix }] of Object.entries(problemKinds)) {
      const page = await fetch(`${origin}/problems/${kind}`);
      expect(page.status).toBe(200);
      expect(page.headers.get("content-type")).toMatch(/^text\/html/);
      const html = await page.text();
      expect(html).toContain(title);
      for (const heading of ["What happened", "Why", "What to do"]) expect(html).toContain(heading);
      expect(html.split("<li>")).toHaveLength(fix.length + 1);
    }
    expect((await fetch(`${origin}/problems/no-such-kind`)).status).toBe(404);
  });

  it("has no broken link or fragment", async () => {
    const { origin } = await startTestRelay();
    const pages = await site(origin);
    expect(pages.size).toBeGreaterThan(Object.keys(problemKinds).length);
    for (const [path, html] of pages) {
      if (!/^\/(?:docs|problems)(?:\/[\w-]+)?$/.test(path)) continue;
      for (const [to, fragment] of linksIn(html)) {
        if (fragment === "") continue;
        const target = pages.get(to === "" ? path : to) ?? "";
        const link = { path, to, fragment };
        expect({ ...link, isThere: target.includes(`id="${fragment}"`) }).toEqual({
          ...link,
          isThere: true,
        });
      }
    }
  });

  it("mentions only existing checks of the conformance kit in the pages for hosts", async () => {
    const { origin } = await startTestRelay();
    const [hosts = "", promises = ""] = await Promise.all(
      ["/docs/hosts", "/docs/promises"].map(async (path) => (await fetch(origin + path)).text()),
    );
    const cells = [...hosts.matchAll(/<td>((?:<code>[a-z-]+<\/code>(?:, )?)+)<\/td><\/tr>/g)];
    const ids = cells.flatMap(([, cell = ""]) => [...cell.matchAll(/<code>[a-z-]+<\/code>/g)]);
    expect(ids.length).toBeGreaterThan(10);
    for (const [id] of ids) expect(promises).toContain(`<tr><td>${id}</td>`);
  });

  it("is served under the strict content security policy with all of its files", async () => {
    const { origin } = await startTestRelay();
    const page = await fetch(`${origin}/docs/try`);
    const policy = page.headers.get("content-security-policy") ?? "";
    expect(policy).toContain("script-src 'self'");
    expect(policy).not.toMatch(/unsafe/);
    expect(policy).toContain("require-trusted-types-for 'script';trusted-types default dompurify");
    const html = await page.text();
    const files = [...html.matchAll(/(?:src|href)="(\/docs\/[^"]+\.\w+)"/g)].map(
      ([, path]) => path,
    );
    expect(files).toHaveLength(6);
    for (const path of files) {
      const file = await fetch(origin + path);
      expect(file.headers.get("content-type")).toMatch(/^text\/(?:css|javascript)/);
    }
  });

  it.each([
    "/docs/package.json",
    "/docs/../package.json",
    "/docs/index.html",
    "/docs/pages/quickstart.md",
  ])("serves nothing else: %s", async (path) => {
    const { origin } = await startTestRelay();
    expect((await fetch(origin + path)).status).toBe(404);
  });
});
