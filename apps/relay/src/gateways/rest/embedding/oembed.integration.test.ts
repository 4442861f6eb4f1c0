import { problemSchema, shortLinkSchema } from "@corridor/protocol";
import { describe, expect, it } from "vitest";
import { lesson, maze, program, project } from "../../../platform/testing/sample-documents.ts";
import { startTestRelay, type TestRelay } from "../../../testing/test-relay.ts";
import { oembedSchema } from "./oembed.ts";

async function store({ origin }: TestRelay, document: unknown): Promise<string> {
  const headers = { "Content-Type": "application/json" };
  const body = JSON.stringify(document);
  const answer = await fetch(`${origin}/api/v1/mazes`, { method: "POST", headers, body });
  return shortLinkSchema.parse(await answer.json()).address;
}

async function ask({ origin }: TestRelay, query: Record<string, string>): Promise<Response> {
  return fetch(`${origin}/api/v1/oembed?${new URLSearchParams(query)}`);
}

describe("the description of a short link for embedding sites", () => {
  it.each([
    { name: "a maze", document: maze, title: maze.name },
    { name: "a program", document: program, title: program.name },
    { name: "a maze with a program", document: project, title: project.maze.name },
    { name: "a lesson", document: lesson, title: lesson.name },
    { name: "a maze without a name", document: { ...maze, name: "" }, title: "Corridor" },
  ])("has a frame with $name", async ({ document, title }) => {
    const relay = await startTestRelay();
    const url = await store(relay, document);
    const answer = await ask(relay, { url, format: "json" });
    expect(answer.headers.get("access-control-allow-origin")).toBe("*");
    const described = oembedSchema.parse(await answer.json());
    expect(described).toMatchObject({ type: "rich", title, provider_url: relay.origin });
    const { pathname } = new URL(url);
    expect(described.html).toContain(`src="${relay.origin}/embed${pathname}"`);
    expect(described.html).toContain(`width="${described.width}"`);
  });

  it("has at most the size that the site asks for, and the language of the link", async () => {
    const relay = await startTestRelay();
    const url = await store(relay, maze);
    const answer = await ask(relay, { url: `${url}?lang=de`, maxwidth: "400", maxheight: "9999" });
    const { width, height, html } = oembedSchema.parse(await answer.json());
    expect(width).toBe(400);
    expect(height).toBeGreaterThan(400);
    expect(html).toMatch(/\/embed\/m\/\w+\?lang=de"/);
  });

  it("shows a name with HTML as text", async () => {
    const relay = await startTestRelay();
    const name = '"><script>alert(1)</script>';
    const answer = await ask(relay, { url: await store(relay, { ...maze, name }) });
    const { html, title } = oembedSchema.parse(await answer.json());
    expect(title).toBe(name);
    expect(html).not.toContain("<script");
  });

  it.each([
    { query: {}, path: "url" },
    { query: { url: "" }, path: "url" },
    { query: { url: "x".repeat(301) }, path: "url" },
    { query: { url: "https://a.example/m/BCDF", maxwidth: "0" }, path: "maxwidth" },
    { query: { url: "https://a.example/m/BCDF", maxheight: "1e3" }, path: "maxheight" },
    { query: { url: "https://a.example/m/BCDF", format: "xml" }, path: "format" },
  ])("names the wrong part of a request: $query", async ({ query, path }) => {
    const answer = await ask(await startTestRelay(), query);
    expect(answer.status).toBe(400);
    const problem = problemSchema.parse(await answer.json());
    expect(problem.errors).toMatchObject([{ path }]);
  });

  it("names JSON to a site that asks for XML", async () => {
    const answer = await ask(await startTestRelay(), {
      url: "https://a.example/m/B",
      format: "xml",
    });
    const { detail } = problemSchema.parse(await answer.json());
    expect(detail).toContain("format: found 'xml', expected 'json', the only format");
  });

  it.each([
    "https://a.example/m/BCDF",
    "no address",
    "ORIGIN/m/BBBB",
    "ORIGIN/",
    "ORIGIN/teach",
    "ORIGIN/m/..%2Fr",
    "ORIGIN/r/AAAAAAAAAAAAAAAAAAAAAA",
    "javascript:alert(1)",
  ])("does not exist for other addresses: %s", async (url) => {
    const relay = await startTestRelay();
    const answer = await ask(relay, { url: url.replace("ORIGIN", relay.origin) });
    expect(answer.status).toBe(404);
    expect(problemSchema.parse(await answer.json()).type).toBe("/problems/no-document");
  });
});
