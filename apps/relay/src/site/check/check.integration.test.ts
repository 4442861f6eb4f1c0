import { describe, expect, it } from "vitest";
import { WebSocket } from "ws";
import { checkWords } from "./check-words.ts";
import { startTestRelay } from "../../testing/test-relay.ts";

const languages = [...checkWords];
const english = checkWords.get("en") ?? {};

describe("/check", () => {
  it("is a self-contained page under the strict content security policy", async () => {
    const { origin } = await startTestRelay();
    const page = await fetch(`${origin}/check`);
    expect(page.headers.get("content-security-policy")).not.toMatch(/unsafe/);
    const html = await page.text();
    expect(html).toContain(english["title"]);
    expect(html).toContain(new URL(origin).host);
    expect(html).not.toContain("{{");
    for (const name of ["check.css", "check.js", "probes.js", "check.worker.js"]) {
      const file = await fetch(`${origin}/check/${name}`);
      expect(file.status).toBe(200);
      expect((await file.text()).length).toBeGreaterThan(30);
    }
    expect((await fetch(`${origin}/check/words/en.json`)).status).toBe(404);
  });

  it.each([
    { query: "", accept: "de-DE,de;q=0.9,en;q=0.8", lang: "de", dir: "ltr" },
    { query: "", accept: "zh-CN", lang: "zh-Hans", dir: "ltr" },
    { query: "", accept: "nl", lang: "en", dir: "ltr" },
    { query: "?lang=ar", accept: "de", lang: "ar", dir: "rtl" },
    { query: "?lang=<b>", accept: "fr", lang: "fr", dir: "ltr" },
  ])("is in $lang if the browser accepts $accept and the query is $query", async (wanted) => {
    const { origin } = await startTestRelay();
    const headers = { "Accept-Language": wanted.accept };
    const html = await (await fetch(`${origin}/check${wanted.query}`, { headers })).text();
    expect(html).toContain(`<html lang="${wanted.lang}" dir="${wanted.dir}">`);
    expect(html).toContain(checkWords.get(wanted.lang)?.["title"]);
  });

  it.each(languages)("has every text in %s", (_language, words) => {
    expect(Object.keys(words)).toEqual(Object.keys(english));
    expect(words["intro"]).toContain("{{host}}");
    for (const text of Object.values(words)) expect(text.trim()).not.toBe("");
  });

  it("echoes a request", async () => {
    const { origin } = await startTestRelay();
    const body = JSON.stringify({ text: "ä" });
    const headers = { Authorization: "Bearer x", "Content-Type": "application/json" };
    const sent = await fetch(`${origin}/check/echo`, { method: "POST", headers, body });
    expect(await sent.json()).toEqual({ method: "POST", authorization: "Bearer x", body });
    const removed = await fetch(`${origin}/check/echo`, { method: "DELETE" });
    expect(await removed.json()).toMatchObject({ method: "DELETE", authorization: null });
    const large = await fetch(`${origin}/check/echo`, {
      method: "POST",
      headers,
      body: "x".repeat(9_000),
    });
    expect(large.status).toBe(413);
  });

  it("waits for the requested time, within limits", async () => {
    const { origin } = await startTestRelay();
    expect(await (await fetch(`${origin}/check/wait?seconds=0.1`)).json()).toEqual({ waited: 0.1 });
    expect((await fetch(`${origin}/check/wait?seconds=600`)).status).toBe(400);
    expect((await fetch(`${origin}/check/wait`)).status).toBe(400);
  });

  it("streams events one by one, and sends a compressed response", async () => {
    const { origin } = await startTestRelay();
    const events = await (await fetch(`${origin}/check/events`)).text();
    expect(events.match(/data: \d/g)).toHaveLength(5);
    const compressed = await fetch(`${origin}/check/compressed`);
    expect(compressed.headers.get("content-encoding")).toBe("gzip");
    expect(await compressed.text()).toBe("Corridor ".repeat(500));
  });

  it("echoes on a WebSocket, for its own origin only", async () => {
    const { origin } = await startTestRelay();
    const url = `${origin.replace("http", "ws")}/check/socket`;
    const socket = new WebSocket(url);
    const received = await new Promise((resolve) => {
      socket.on("open", () => socket.send("forward"));
      socket.on("message", (data: Buffer) => resolve(data.toString()));
    });
    expect(received).toBe("forward");
    socket.terminate();
    const foreign = new WebSocket(url, { headers: { Origin: "https://other.example" } });
    const status = await new Promise((resolve) => {
      foreign.on("unexpected-response", (_request, answer) => resolve(answer.statusCode));
    });
    expect(status).toBe(403);
  });
});
