/** The Content-Security-Policy: the page runs only its own files, and the browser enforces it. */
import { expect, test } from "./fixtures.ts";

test("sends a strict Content-Security-Policy with the page and each of its files", async ({
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

test("sends requests to no other host", async ({ corridor, page, relay }) => {
  const hosts = new Set<string>();
  page.on("request", (request) => hosts.add(new URL(request.url()).host));
  await corridor.reload();
  await corridor.selectDriver("Remote");
  await expect(corridor.connectionStatus).toHaveText("Waiting for a script");
  await corridor.share.click();
  await expect(corridor.dialog("Share this maze")).toBeVisible();
  expect([...hosts]).toEqual([new URL(relay).host]);
});

test("runs no script that is injected into the page", async ({ browser }) => {
  // Not an openWindow fixture: this test expects violations.
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
    const attempt = (inject: () => void): void => {
      try {
        inject();
      } catch {
        // Blocked, as expected.
      }
    };
    attempt(() => button.setAttribute("onclick", "window.marks.handler = true"));
    document.body.append(script, button);
    button.click();
    attempt(() => (button.innerHTML = '<img src="x" onerror="window.marks.markup = true">'));
    if (button.childElementCount > 0) marks.markup = true;
    // The evaluation that runs this line may itself use eval. A separate task of the page may not.
    await new Promise((resolve) => setTimeout(resolve));
    try {
      // oxlint-disable-next-line no-new-func, typescript/no-implied-eval -- its refusal is the test
      new Function("window.marks.evaluated = true")();
    } catch {
      // Blocked, as expected.
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
    const foreign = [
      bytes,
      "data:text/javascript,1",
      "/api/v1/mazes/AAAAAAAAAAAA",
      `${origin}/assets/../api/v1/mazes/x.js`,
      "https://evil.example/assets/x.js",
    ];
    return { own: isStarted("/sw.js"), foreign: foreign.filter(isStarted) };
  }, relay);
  expect(started).toEqual({ own: true, foreign: [] });
  await context.close();
});

test("causes no violation on the documentation and check pages", async ({ page }) => {
  // The page fixture collects errors: a violation fails the test.
  await page.goto("/docs");
  await expect(page.getByRole("heading", { level: 1 })).toBeVisible();
  await page.goto("/check");
  await expect(page.getByText(/worker/i).first()).toBeVisible();
});
