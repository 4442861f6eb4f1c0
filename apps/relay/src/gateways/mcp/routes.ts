/**
 * The Model Context Protocol for AI agents: Streamable HTTP without sessions. Each request is a POST
 * with one message, and its answer is JSON. No state remains between requests, so that any relay
 * behind a balancer answers them.
 */
import { createAgent } from "@corridor/agent";
import { MAX_FRAME_BYTES, protocolClients, type RefusedError } from "@corridor/protocol";
import { Router, type Request, type Response } from "express";
import { z } from "zod";
import { methodNotAllowed } from "../../platform/http/fallbacks.ts";
import { onClose } from "../../platform/http/on-close.ts";
import { bodyReader } from "../../platform/http/reading.ts";
import type { RequestGuard } from "../../platform/http/request-guard.ts";
import { Refusal } from "../../platform/errors/problems.ts";
import type { RobotRegistry } from "../../robots/registry.ts";
import { RelayPort } from "../../robots/relay-port.ts";
import { authoriseGateway, requestConnection } from "../requests/gateway-requests.ts";
import { answerMessage } from "./answer-message.ts";

export const MCP_PATH = "/r/:id/mcp";

const EXAMPLE = '{"jsonrpc":"2.0","id":1,"method":"tools/list"}';
const idError = "a text or a whole number";

/** A request or a notification. Servers without requests of their own receive no results. */
const messageSchema = z.strictObject(
  {
    jsonrpc: z.literal("2.0", { error: '"2.0"' }),
    id: z.union([z.string({ error: idError }), z.int({ error: idError })]).optional(),
    method: z.string({ error: "a method, such as tools/list" }),
    params: z.looseObject({}, { error: "an object" }).optional(),
  },
  { error: "one message: an object, no list" },
);

const readMessage = bodyReader(messageSchema, "Invalid message.", {
  limit: MAX_FRAME_BYTES,
  example: EXAMPLE,
});

/** @param onRefused called for each refusal inside an answer */
export function mcpRoutes(
  registry: RobotRegistry,
  guard: RequestGuard,
  onRefused: (error: RefusedError) => void,
): Router {
  const router = Router();
  const answer = async (
    request: Request<{ id: string; key?: string }>,
    response: Response,
  ): Promise<void> => {
    const { id, key = null } = request.params;
    const grant = await authoriseGateway(registry, request, response, {
      id,
      key,
      use: key === null ? undefined : "url",
      verb: "read",
      client: protocolClients.mcp,
    });
    const message = await readMessage(request, response);
    // The client may have disconnected during authorisation.
    if (response.closed) return;
    const agent = createAgent(new RelayPort(grant, requestConnection), registry.clock, onRefused);
    onClose(response, () => agent.close());
    await answerMessage(agent, message, request, response);
  };
  for (const path of [MCP_PATH, `${MCP_PATH}/:key`]) {
    router
      .route(path)
      .all((request, response, next) => {
        checkOrigin(guard, request, response);
        next();
      })
      .options((_request, response) => {
        response
          .set({
            "Access-Control-Allow-Methods": "POST",
            "Access-Control-Allow-Headers":
              "Authorization, Content-Type, MCP-Protocol-Version, Mcp-Method, Mcp-Name, Mcp-Session-Id, Script-Name",
            "Access-Control-Max-Age": "86400",
          })
          .status(204)
          .end();
      })
      .post(answer)
      .all(methodNotAllowed("POST"));
  }
  return router;
}

/**
 * Servers of this protocol must refuse pages of other sites, because a page could reach a server on
 * the machine of its visitor.
 * @throws Refusal forbidden
 */
function checkOrigin(guard: RequestGuard, request: Request, response: Response): void {
  if (!guard.isOwnOrLocal(request)) {
    throw new Refusal(
      "forbidden",
      "Pages of other sites cannot use this URL. Use it in a program, or in a page on localhost.",
    );
  }
  const { origin } = request.headers;
  response.set({ "Cache-Control": "no-store", Vary: "Origin" });
  if (origin !== undefined) response.set("Access-Control-Allow-Origin", origin);
}
