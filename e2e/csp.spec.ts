/** The page runs nothing but its own files, and the browser is told to see to it. */
import { expect, test } from "./fixtures.ts";

test("gets a strict Content-Security-Policy with the page and each of its files", async ({
  page,
}) => {
  const policies = new Map<string, string>();
  page.on("response", (response) => {
    const { pathname } = new URL(response.url());
    policies.set(pathname, response.headers()["content-security-policy"] ?? "none");
  });
  await page.goto("/");
  await expect(page.getByText(/^Robot at /)).toBeVisible();
  const paths = [...policies.keys()];
  expect(paths.some((path) => path.startsWith("/assets/simulator.worker-"))).toBe(true);
  expect(paths.length).toBeGreaterThan(4);
  for (const [path, policy] of policies) {
    expect(policy, path).toContain("default-src 'self'");
    expect(policy, path).toContain("script-src 'self'");
    expect(policy, path).toContain("style-src 'self'");
    expect(policy, path).toContain("worker-src 'self'");
    expect(policy, path).toContain("manifest-src 'self'");
    expect(policy, path).toContain("object-src 'none'");
    expect(policy, path).toContain("frame-ancestors 'none'");
    expect(policy, path).toContain("require-trusted-types-for 'script'");
    expect(policy, path).toContain("trusted-types default");
    expect(policy, path).not.toMatch(/unsafe-inline|unsafe-eval|\*|https?:/);
  }
});

test("asks no other host for anything", async ({ corridor, page, relay }) => {
  const hosts = new Set<string>();
  page.on("request", (request) => hosts.add(new URL(request.url()).host));
  await corridor.reload();
  await corridor.selectDriver("Remote");
  await expect(corridor.connectionStatus).toHaveText("Waiting for a script");
  await corridor.share.click();
  await expect(corridor.dialog("Share this maze")).toBeVisible();
  expect([...hosts]).toEqual([new URL(relay).host]);
});

test("runs no script that was smuggled into the page", async ({ browser }) => {
  // Not a watched window: these very violations are wanted.
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto("/");
  await expect(page.getByText(/^Robot at /)).toBeVisible();
  const ran = await page.evaluate(async () => {
    const marks = { inline: false, handler: false, markup: false, evaluated: false };
    Object.assign(window, { marks });
    const script = document.createElement("script");
    script.append("window.marks.inline = true");
    const button = document.createElement("button");
    const attempt = (smuggle: () => void): void => {
      try {
        smuggle();
      } catch {
        // Refused, as it should be.
      }
    };
    attempt(() => button.setAttribute("onclick", "window.marks.handler = true"));
    document.body.append(script, button);
    button.click();
    attempt(() => (button.innerHTML = '<img src="x" onerror="window.marks.markup = true">'));
    if (button.childElementCount > 0) marks.markup = true;
    // The tools that run this line may evaluate texts; the page itself, in a task of its own, may
    // not.
    await new Promise((resolve) => setTimeout(resolve));
    try {
      // oxlint-disable-next-line no-new-func, typescript/no-implied-eval -- its refusal is the test
      new Function("window.marks.evaluated = true")();
    } catch {
      // Refused, as it should be.
    }
    return marks;
  });
  expect(ran).toEqual({ inline: false, handler: false, markup: false, evaluated: false });
  await context.close();
});

test("starts no worker but its own", async ({ browser, relay }) => {
  const context = await browser.newContext();
  const page = await context.newPage();
  await page.goto("/");
  await expect(page.getByText(/^Robot at /)).toBeVisible();
  const started = await page.evaluate((origin) => {
    const isStarted = (address: string): boolean => {
      try {
        new Worker(address).terminate();
        return true;
      } catch {
        return false;
      }
    };
    const bytes = URL.createObjectURL(new Blob(["1"], { type: "text/javascript" }));
    const strangers = [
      bytes,
      "data:text/javascript,1",
      "/api/v1/mazes/AAAAAAAAAAAA",
      `${origin}/assets/../api/v1/mazes/x.js`,
      "https://evil.example/assets/x.js",
    ];
    return { own: isStarted("/sw.js"), strangers: strangers.filter(isStarted) };
  }, relay);
  expect(started).toEqual({ own: true, strangers: [] });
  await context.close();
});

test("is at home under its policy on the pages beside it", async ({ page }) => {
  // The window is watched: a violation fails the test.
  await page.goto("/docs");
  await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
  await page.goto("/check");
  await expect(page.getByText(/worker/i).first()).toBeVisible();
});
