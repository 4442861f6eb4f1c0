/**
 * Passes one message to the MCP server of a robot, and writes its answer. Clients of 2026-07-28 send
 * complete requests; clients of 2025 open with `initialize` and need no session afterwards.
 */
import type { Agent } from "@corridor/agent";
import {
  createMcpHandler,
  isLegacyRequest,
  WebStandardStreamableHTTPServerTransport,
} from "@modelcontextprotocol/server";
import type { Request as HttpRequest, Response as HttpResponse } from "express";
import { closeSignal } from "../../platform/http/on-close.ts";

/** Headers that the protocol reads. */
const headerNames = ["mcp-protocol-version", "mcp-method", "mcp-name"] as const;

/** @param message the parsed body */
export async function answerMessage(
  agent: Agent,
  message: unknown,
  request: HttpRequest,
  response: HttpResponse,
): Promise<void> {
  const webRequest = webRequestOf(request, response);
  const answer = (await isLegacyRequest(webRequest, message))
    ? await answerLegacy(agent, message, webRequest)
    : await answerModern(agent, message, webRequest);
  const text = await answer.text();
  if (response.closed) return;
  response.status(answer.status);
  if (text === "") return void response.end();
  response.type("application/json").send(text);
}

/** The library reads requests of the web. Its URL is never read, and a path may contain a key. */
function webRequestOf(request: HttpRequest, response: HttpResponse): Request {
  const headers = new Headers({
    "Content-Type": "application/json",
    // Answers are always JSON, whatever else a client accepts.
    Accept: "application/json, text/event-stream",
  });
  for (const name of headerNames) {
    const value = request.get(name);
    if (value !== undefined) headers.set(name, value);
  }
  const signal = closeSignal(response);
  return new Request("http://relay/mcp", { method: "POST", headers, signal });
}

async function answerLegacy(agent: Agent, message: unknown, request: Request): Promise<Response> {
  const transport = new WebStandardStreamableHTTPServerTransport({ enableJsonResponse: true });
  await agent.server.connect(transport);
  try {
    return await transport.handleRequest(request, { parsedBody: message });
  } finally {
    await transport.close();
  }
}

async function answerModern(agent: Agent, message: unknown, request: Request): Promise<Response> {
  // No stream: tools never change, so there is nothing to subscribe to.
  const handler = createMcpHandler(() => agent.server, { legacy: "reject", maxSubscriptions: 0 });
  try {
    return await handler.fetch(request, { parsedBody: message });
  } finally {
    await handler.close();
  }
}
