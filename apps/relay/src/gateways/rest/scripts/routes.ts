/** Scripts of a robot, for its owner: list, block, unblock, pause all, permit resets. */
import {
  scriptIdSchema,
  scriptRefSchema,
  type ScriptList,
  type BlockedScript,
} from "@corridor/protocol";
import { Router, type Request, type Response } from "express";
import { z } from "zod";
import { keyId } from "../../../platform/keys.ts";
import type { ScriptAccess } from "../../../robots/access/callers.ts";
import type { RobotRegistry } from "../../../robots/registry.ts";
import { methodNotAllowed } from "../../../platform/http/fallbacks.ts";
import { bodyReader, read, readBearer } from "../../../platform/http/reading.ts";

/** The id of a script, as the last segment of a path. */
export const scriptPath = z.object({ scriptId: scriptIdSchema.describe("id of the script") });

const readScript = bodyReader(scriptRefSchema, "Invalid script.");

export function scriptRoutes(registry: RobotRegistry): Router {
  const router = Router();

  router
    .route("/robots/:id/scripts")
    .get(async (request, response) => {
      const { robot } = await registry.authorise(
        request.params.id,
        readBearer(request),
        "moderate",
      );
      const { scriptAccess: access, scripts } = robot;
      const { isPaused: paused, mayReset } = access;
      response.json({ paused, mayReset, scripts } satisfies ScriptList);
    })
    .all(methodNotAllowed("GET"));

  /** A setting of the owner: PUT switches it on, DELETE off. */
  function switchRoute(
    path: string,
    change: (access: ScriptAccess, isOn: boolean) => Promise<void>,
  ): void {
    const handle =
      (isOn: boolean) =>
      async (request: Request<{ id: string }>, response: Response): Promise<void> => {
        const { robot } = await registry.authorise(
          request.params.id,
          readBearer(request),
          "moderate",
        );
        await change(robot.scriptAccess, isOn);
        response.status(204).end();
      };
    router.route(path).put(handle(true)).delete(handle(false)).all(methodNotAllowed("PUT, DELETE"));
  }

  switchRoute("/robots/:id/pause", async (access, isOn) => access.pause(isOn));
  switchRoute("/robots/:id/script-reset", async (access, isOn) => access.permitReset(isOn));

  router
    .route("/robots/:id/blocked")
    .post(async (request, response) => {
      const { robot } = await registry.authorise(
        request.params.id,
        readBearer(request),
        "moderate",
      );
      const script = await robot.scriptAccess.block(await readScript(request, response));
      const blocked: BlockedScript = { ...script, driver: keyId(script.driver) };
      response
        .status(201)
        .location(`/api/v1/robots/${robot.id}/blocked/${script.id}`)
        .json(blocked);
    })
    .all(methodNotAllowed("POST"));

  router
    .route("/robots/:id/blocked/:scriptId")
    .delete(async (request, response) => {
      const { robot } = await registry.authorise(
        request.params.id,
        readBearer(request),
        "moderate",
      );
      const { scriptId } = read(scriptPath, { scriptId: request.params.scriptId }, "Invalid path.");
      await robot.scriptAccess.unblock(scriptId);
      response.status(204).end();
    })
    .all(methodNotAllowed("DELETE"));

  return router;
}
