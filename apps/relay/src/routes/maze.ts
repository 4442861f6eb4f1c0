/** The maze that a robot is in: its page gives it, and whoever looks on reads it. */
import { mazeSchema } from "@corridor/maze";
import { MAX_DOCUMENT_BYTES } from "@corridor/protocol";
import { Router } from "express";
import { z } from "zod";
import { Refusal } from "../problems.ts";
import type { SessionHub } from "../sessions/session-hub.ts";
import { methodNotAllowed } from "./fallbacks.ts";
import { hearScript } from "./hear-script.ts";
import { jsonText, readBearer, readBody } from "./reading.ts";

/** The header of who has the maze already. */
export const ifNoneMatchHeader = z.object({
  "If-None-Match": z.string().optional().describe("the `ETag` of the maze that is known already"),
});

export function mazeRoutes(hub: SessionHub): Router {
  const router = Router();
  router
    .route("/robots/:id/maze")
    .get(async (request, response) => {
      const { session } = await hearScript(hub, request, response, "look");
      const kept = await session.mazes.read();
      if (kept === null) {
        throw new Refusal(
          "no-maze",
          "The robot's page has not told its maze, or it is too large. Ask again once the page is connected.",
        );
      }
      const tag = entityTag(kept.version);
      response.set("ETag", tag);
      if (isKnown(request.get("If-None-Match"), tag)) return void response.status(304).end();
      response.type("json").send(kept.text);
    })
    .put(
      // Who may not is told so before the body is read.
      async (request, _response, next) => {
        await hub.authorise(request.params.id, readBearer(request), "host");
        next();
      },
      jsonText(MAX_DOCUMENT_BYTES),
      async (request, response) => {
        const { session } = await hub.authorise(request.params.id, readBearer(request), "host");
        const maze = readBody(request, mazeSchema, MAX_DOCUMENT_BYTES, "The maze is wrong.");
        const version = await session.mazes.keep(maze);
        response.status(204).set("ETag", entityTag(version)).end();
      },
    )
    .all(methodNotAllowed("GET, PUT"));
  return router;
}

function entityTag(version: string): string {
  return `"${version}"`;
}

/** A proxy that compresses marks the tag as weak. */
function isKnown(header: string | undefined, tag: string): boolean {
  return (header ?? "").split(",").some((each) => each.trim().replace(/^W\//, "") === tag);
}
